// The diffuse lobe next to others.
// Twin of src/reference/bsdf/diffuse/mixed.rs. Fills the slot <diffuse>.

// uses: bsdf/interaction, bsdf/sample, bsdf/diffuse/lambert, <choice>

// Whether the uniform number u chooses the diffuse lobe.
bool diffuse_chosen(Interaction at, float u) {
    return u < diffuse_probability(at);
}

// A direction of the diffuse lobe.
vec3 diffuse_direction(vec2 u) {
    return cosine_lobe(u);
}

// Probability p_m of the lobes that have a micro-normal.
float facet_probability(Interaction at) {
    return 1.0 - diffuse_probability(at);
}

// The diffuse lobe and `rest`, the lobes with a micro-normal: values add up, densities by the lobes' shares.
BsdfValue with_diffuse(Interaction at, vec3 wi, BsdfValue rest) {
    float p_d = diffuse_probability(at);
    BsdfValue diffuse = lambert_lobe(at, wi);
    return BsdfValue(diffuse.value + rest.value, p_d * diffuse.pdf + (1.0 - p_d) * rest.pdf);
}
