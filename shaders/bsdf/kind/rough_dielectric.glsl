// A rough interface between two media, and Kd on wo's side.
// Twin of src/reference/bsdf/kind/rough_dielectric.rs.

// uses: constants/lobe, bsdf/interaction, bsdf/sample, bsdf/facet, bsdf/reflection, bsdf/refraction, bsdf/transmission, bsdf/rough
// uses: <diffuse>

// Value and density of wi whose micro-normal is m.
BsdfValue rough_dielectric_at(Interaction at, vec3 wi, vec3 m) {
    Facet x = facet(at, wi, m);
    BsdfValue r = reflection_lobe(at, wi, x);
    BsdfValue t = transmission_lobe(at, wi, x);
    bool same_side = wi.z > 0.0;
    vec3 value = same_side ? r.value : t.value;
    float pdf = same_side ? r.pdf : t.pdf;
    return with_diffuse(at, wi, BsdfValue(value, pdf));
}

BsdfSample rough_dielectric_sample(Interaction at, BsdfRandom random) {
    RoughDraw draw = rough_draw(at, random);
    bool diffuse = draw.diffuse;
    bool reflects = rough_reflects(at, draw, random);
    vec3 leaving = reflects ? reflect_about(at.wo, draw.m, draw.c) : refract_about(at, draw.m, draw.c);
    vec3 wi = diffuse ? diffuse_direction(random.d) : leaving;
    vec3 m = diffuse ? reflection_half_vector(at.wo, wi) : draw.m;
    bool right_side = reflects ? wi.z > 0.0 : wi.z < 0.0;
    bool valid = diffuse || (draw.c > 0.0 && right_side);
    uint lobe = reflects ? LOBE_REFLECTION : LOBE_TRANSMISSION;
    return sample_or_none(valid, wi, rough_dielectric_at(at, wi, m), diffuse ? LOBE_DIFFUSE : lobe);
}

BsdfValue rough_dielectric_eval(Interaction at, vec3 wi) {
    bool same_side = wi.z > 0.0;
    vec3 m = same_side ? reflection_half_vector(at.wo, wi) : transmission_half_vector(at, wi);
    return rough_dielectric_at(at, wi, m);
}
