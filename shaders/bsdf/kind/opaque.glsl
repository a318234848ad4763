// Opaque: a rough reflection, and Kd.
// Twin of src/reference/bsdf/kind/opaque.rs.

// uses: bsdf/interaction, bsdf/sample, bsdf/reflection, bsdf/rough

BsdfSample opaque_sample(Interaction at, float u_lobe, float u_reflect, vec2 u_m, vec2 u_d) {
    return rough_reflection_sample(at, rough_draw(at, u_lobe, u_m), u_d);
}

BsdfValue opaque_eval(Interaction at, vec3 wi) {
    return rough_reflection_at(at, wi, reflection_half_vector(at.wo, wi));
}
