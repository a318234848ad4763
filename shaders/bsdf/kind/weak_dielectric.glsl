// A rough interface that hardly refracts, alpha |n - 1| < 1e-5.
// Twin of src/reference/bsdf/kind/weak_dielectric.rs.
// The transmitted lobe is so narrow that f32 cannot resolve its density at a given direction. It is drawn like that of
// any rough interface, but counts as a delta lobe: its weight needs no Jacobian, and it is not connected to lights.
// Reflection is the rough one, with a density.

// uses: constants/lobe, bsdf/interaction, bsdf/sample, bsdf/facet, bsdf/reflection, bsdf/refraction, bsdf/transmission, bsdf/rough
// uses: <diffuse>, <scaling>

// Transmission through the micro-normal m: D G (1 - F) c/wo.z, times eta^2 for radiance, over pm (1 - R), each per solid angle of m.
BsdfSample weak_dielectric_transmission(Interaction at, vec3 wi, vec3 m) {
    Facet x = facet(at, wi, m);
    float p_m = facet_probability(at);
    float pdf = p_m * x.pm * (1.0 - x.p_reflect);
    vec3 value = transmitted(at, x) * transmission_scale(at.eta);
    bool valid = x.c > 0.0 && at.wo.z > 0.0 && wi.z < 0.0;
    return sample_or_none(valid, wi, BsdfValue(value, pdf), LOBE_TRANSMISSION | LOBE_DELTA);
}

BsdfSample weak_dielectric_sample(Interaction at, BsdfRandom random) {
    RoughDraw draw = rough_draw(at, random);
    bool reflects = rough_reflects(at, draw, random);
    BsdfSample s;
    if (draw.diffuse || reflects) {
        s = rough_reflection_sample(at, draw, random);
    } else {
        s = weak_dielectric_transmission(at, refract_about(at, draw.m, draw.c), draw.m);
    }
    return s;
}

BsdfValue weak_dielectric_eval(Interaction at, vec3 wi) {
    return rough_reflection_at(at, wi, reflection_half_vector(at.wo, wi));
}
