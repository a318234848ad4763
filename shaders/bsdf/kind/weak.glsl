// A rough interface that hardly refracts, alpha |n - 1| < 1e-5.
// Twin of src/reference/bsdf/kind/weak.rs.
// The transmitted lobe is so narrow that f32 cannot tell its density at a given direction. It is drawn as
// that of any rough interface, but counts as a delta lobe: its weight needs no Jacobian, and it is not connected
// to lights. Reflection is the rough one, with a density.

// uses: math/vec, bsdf/interaction, bsdf/sample, bsdf/facet, bsdf/reflection, bsdf/refraction, bsdf/transmission
// uses: <fresnel>, <choice>, <normals>, <diffuse>

// Value and density of wi on wo's side, whose micro-normal is m.
BsdfValue weak_at(Interaction at, vec3 wi, vec3 m) {
    Facet x = facet(at, wi, m);
    return with_diffuse(at, wi, reflection_lobe(at, wi, x));
}

// Transmission through the micro-normal m: D G (1 - F) c/wo.z over pm (1 - R), each per solid angle of m.
BsdfSample weak_transmission(Interaction at, vec3 wi, vec3 m) {
    Facet x = facet(at, wi, m);
    float p_m = facet_probability(at);
    float pdf = p_m * x.pm * (1.0 - x.p_reflect);
    bool valid = x.c > 0.0 && at.wo.z > 0.0 && wi.z < 0.0;
    return sample_or_none(valid, wi, BsdfValue(transmitted(at, x), pdf), LOBE_TRANSMISSION | LOBE_DELTA);
}

BsdfSample weak_sample(Interaction at, float u_lobe, float u_reflect, vec2 u_m, vec2 u_d) {
    bool diffuse = diffuse_chosen(at, u_lobe);
    vec3 drawn = normals_sample(at, u_m);
    float c = dot3(at.wo, drawn);
    float f_mean = mean3(fresnel(at, c));
    bool reflects = u_reflect < reflect_probability(at, c, f_mean);
    BsdfSample s;
    if (diffuse || reflects) {
        vec3 wi = diffuse ? diffuse_direction(u_d) : reflect_about(at.wo, drawn, c);
        vec3 m = diffuse ? reflection_half_vector(at.wo, wi) : drawn;
        bool valid = (diffuse || c > 0.0) && wi.z > 0.0;
        uint lobe = diffuse ? LOBE_DIFFUSE : LOBE_REFLECTION;
        s = sample_or_none(valid, wi, weak_at(at, wi, m), lobe);
    } else {
        s = weak_transmission(at, refract_about(at, drawn, c), drawn);
    }
    return s;
}

BsdfValue weak_eval(Interaction at, vec3 wi) {
    return weak_at(at, wi, reflection_half_vector(at.wo, wi));
}
