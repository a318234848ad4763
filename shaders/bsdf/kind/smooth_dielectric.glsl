// A smooth interface between two media, and Kd on wo's side.
// Twin of src/reference/bsdf/kind/smooth_dielectric.rs.

// uses: constants/lobe, math/vec, bsdf/interaction, bsdf/sample, bsdf/snell, bsdf/refraction
// uses: <fresnel>, <choice>, <scaling>, <diffuse>

// The delta lobes: the micro-normal is N', F reflects, (1 - F) is refracted, times eta^2 for radiance, times A(t).
BsdfSample smooth_dielectric_delta(Interaction at, BsdfRandom random) {
    float c = at.wo.z;
    vec3 f = fresnel(at, c);
    float p_m = facet_probability(at);
    float p_r = reflect_probability(at, c, carried_mean(at, f));
    bool reflects = random.reflect < p_r;
    vec3 reflected = reflected_share(at, c, f);
    vec3 refracted = (vec3(1.0) - f) * at.attenuation * transmission_scale(at.eta);
    vec3 value = reflects ? reflected : refracted;
    float pdf = p_m * (reflects ? p_r : 1.0 - p_r);
    vec3 wi = reflects ? vec3(-at.wo.x, -at.wo.y, c) : refract_about_normal(at);
    bool right_side = reflects ? wi.z > 0.0 : wi.z < 0.0;
    uint lobe = reflects ? LOBE_REFLECTION : LOBE_TRANSMISSION;
    return sample_or_none(c > 0.0 && right_side, wi, BsdfValue(value, pdf), lobe | LOBE_DELTA);
}

// The smooth interface has no density: Kd alone.
BsdfValue smooth_dielectric_eval(Interaction at, vec3 wi) {
    return with_diffuse(at, wi, no_value());
}

BsdfSample smooth_dielectric_sample(Interaction at, BsdfRandom random) {
    BsdfSample s;
    if (diffuse_chosen(at, random.lobe)) {
        vec3 wi = diffuse_direction(random.d);
        s = sample_or_none(true, wi, smooth_dielectric_eval(at, wi), LOBE_DIFFUSE);
    } else {
        s = smooth_dielectric_delta(at, random);
    }
    return s;
}
