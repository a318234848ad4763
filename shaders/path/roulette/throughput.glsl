// Russian roulette on throughput, from the third bounce, with the radiance scale eta² divided out: in glass of
// index n throughput is n² smaller without being worth less.
// uses: math/vec, path/roulette/long

float roulette_survival(vec3 throughput, float eta_scale, uint bounce) {
    float survival = bounce < 2u ? 1.0 : min2(1.0, max_component(throughput) / eta_scale);
    return long_path_survival(survival, bounce);
}
