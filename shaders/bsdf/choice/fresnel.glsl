// Choice of lobe by Fresnel's share.
// Twin of src/reference/bsdf/choice/fresnel.rs. Fills the slot <choice>.

// uses: constants/material_kind, math/vec, sampler/chance, bsdf/interaction, <fresnel>

// p_d = kd/(kd + 1) of a transmissive material, kd the mean of Kd, where reflection and refraction share the 1.
// Opaque: kd/(kd + S), S the mean of F(wo.N), kept within [0.1, 0.9] where both lobes exist.
float diffuse_probability(Interaction at) {
    float kd = at.material.kd_mean;
    bool opaque = at.material.kind < KIND_ROUGH_DIELECTRIC;
    float specular = opaque ? mean3(fresnel(at, at.wo.z)) : 1.0;
    float share = kd / (kd + specular);
    float kept = min2(max2(share, 0.1), 0.9);
    // 0/0 if S has vanished too
    return kd > 0.0 ? (opaque ? kept : chance(share)) : 0.0;
}

// R = the mean of F(c), rounded to a probability that can be drawn; 1 for opaque materials.
float reflect_probability(Interaction at, float c, float f_mean) {
    return at.material.kind < KIND_ROUGH_DIELECTRIC ? 1.0 : chance(f_mean);
}
