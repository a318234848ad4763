// Russian roulette with the same survival probability at every bounce, as in the course.
// uses: path/roulette/long

float roulette_survival(vec3 throughput, float eta_scale, uint bounce) {
    return long_path_survival(ROULETTE, bounce);
}
