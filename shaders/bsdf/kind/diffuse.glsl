// Kd alone.
// Twin of src/reference/bsdf/kind/diffuse.rs.

// uses: constants/lobe, bsdf/interaction, bsdf/sample, bsdf/diffuse/lambert

BsdfSample diffuse_sample(Interaction at, BsdfRandom random) {
    vec3 wi = cosine_lobe(random.d);
    return sample_or_none(true, wi, lambert_lobe(at, wi), LOBE_DIFFUSE);
}

BsdfValue diffuse_eval(Interaction at, vec3 wi) {
    return lambert_lobe(at, wi);
}
