// Absorption on every segment of a path inside a medium, shadow rays too.
// uses: constants/none, path/medium/beer

vec3 stretch_transmittance(uint medium, float t) {
    vec3 transmittance = vec3(1.0);
    if (medium != NONE) {
        transmittance = beer3(materials[medium].sigma, t);
    }
    return transmittance;
}

vec3 term_attenuation(uint material, bool outside, float t) {
    return vec3(1.0);
}
