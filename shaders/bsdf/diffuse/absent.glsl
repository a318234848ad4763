// No material has a diffuse lobe next to others: bsdf/diffuse/mixed with Kd = 0, to the bit.
// Fills the slot <diffuse>.

// uses: bsdf/interaction, bsdf/sample

bool diffuse_chosen(Interaction at, float u) {
    return false;
}

vec3 diffuse_direction(vec2 u) {
    return vec3(0.0, 0.0, 1.0);
}

float facet_probability(Interaction at) {
    return 1.0;
}

BsdfValue with_diffuse(Interaction at, vec3 wi, BsdfValue rest) {
    return rest;
}
