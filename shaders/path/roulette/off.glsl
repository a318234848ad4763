// No roulette except for paths that would never end.
// uses: path/roulette/long

float roulette_survival(vec3 throughput, float eta_scale, uint bounce) {
    return long_path_survival(1.0, bounce);
}
