// Nothing absorbs in this scene.

vec3 stretch_transmittance(uint medium, float t) {
    return vec3(1.0);
}

vec3 term_attenuation(uint material, bool outside, float t) {
    return vec3(1.0);
}
