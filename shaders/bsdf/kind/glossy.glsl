// Opaque: a rough reflection, and Kd.
// Twin of src/reference/bsdf/kind/glossy.rs.

// uses: bsdf/interaction, bsdf/sample, bsdf/reflection, bsdf/rough

BsdfSample glossy_sample(Interaction at, BsdfRandom random) {
    return rough_reflection_sample(at, rough_draw(at, random), random);
}

BsdfValue glossy_eval(Interaction at, vec3 wi) {
    return rough_reflection_at(at, wi, reflection_half_vector(at.wo, wi));
}
