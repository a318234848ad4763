// Choice of lobe by |Kd| : |Ks| : |Kt|, as in the hand-out.
// Twin of src/reference/bsdf/choice/norms.rs. Fills the slot <choice>.

// uses: sampler/chance, bsdf/interaction, bsdf/snell

// p_d = |Kd|/(|Kd| + |Ks| + |Kt|), rounded to a probability that can be drawn
float diffuse_probability(Interaction at) {
    return chance(at.material.p_d);
}

// R = |Ks|/(|Ks| + |Kt|), which is 1 for opaque materials; 1 where refraction is not possible.
float reflect_probability(Interaction at, float c, float f_mean) {
    return total_reflection(at, c) ? 1.0 : at.material.p_r;
}
