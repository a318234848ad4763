// Absorption as in the hand-out: A(t) in E_t alone, where the path meets the inside of a surface.
// uses: path/medium/beer

vec3 stretch_transmittance(uint medium, float t) {
    return vec3(1.0);
}

vec3 term_attenuation(uint material, bool outside, float t) {
    vec3 attenuation = vec3(1.0);
    if (!outside) {
        attenuation = beer3(materials[material].sigma, t);
    }
    return attenuation;
}
