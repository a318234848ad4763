// Kd alone.
// Twin of src/reference/bsdf/kind/diffuse.rs.

// uses: bsdf/interaction, bsdf/sample, bsdf/diffuse/lambert

BsdfSample diffuse_sample(Interaction at, float u_lobe, float u_reflect, vec2 u_m, vec2 u_d) {
    vec3 wi = cosine_lobe(u_d);
    return sample_or_none(true, wi, lambert_lobe(at, wi), LOBE_DIFFUSE);
}

BsdfValue diffuse_eval(Interaction at, vec3 wi) {
    return lambert_lobe(at, wi);
}
