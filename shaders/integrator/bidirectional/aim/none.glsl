// Nothing gathers light: light paths start about the light's normal. Fills the slot <aim>.
// uses: math/frame, bsdf/diffuse/lambert

vec3 aimed_direction(vec3 p, vec3 n, float choice, vec2 u) {
    return to_world(frame_about(n), cosine_lobe(u));
}

float aimed_density(vec3 p, vec3 d, float cosine) {
    return 0.3183098861837907;
}
