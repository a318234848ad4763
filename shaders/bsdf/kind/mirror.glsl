// Opaque: a perfect mirror, and Kd.
// Twin of src/reference/bsdf/kind/mirror.rs.

// uses: constants/lobe, bsdf/interaction, bsdf/sample, <fresnel>, <diffuse>

// The mirror has no density: Kd alone.
BsdfValue mirror_eval(Interaction at, vec3 wi) {
    return with_diffuse(at, wi, no_value());
}

BsdfSample mirror_sample(Interaction at, BsdfRandom random) {
    bool diffuse = diffuse_chosen(at, random.lobe);
    vec3 wi = diffuse ? diffuse_direction(random.d) : vec3(-at.wo.x, -at.wo.y, at.wo.z);
    BsdfValue scattered = mirror_eval(at, wi);
    vec3 value = diffuse ? scattered.value : fresnel(at, at.wo.z);
    float pdf = diffuse ? scattered.pdf : facet_probability(at);
    uint lobe = diffuse ? LOBE_DIFFUSE : LOBE_REFLECTION | LOBE_DELTA;
    return sample_or_none(wi.z > 0.0, wi, BsdfValue(value, pdf), lobe);
}
