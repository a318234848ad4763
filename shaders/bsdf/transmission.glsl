// The refracted lobe E_t. Equation numbers are those of Walter et al. 2007.
// Twin of src/reference/bsdf/transmission.rs.

// uses: math/vec, bsdf/interaction, bsdf/sample, bsdf/snell, bsdf/facet, bsdf/refraction, <scaling>

// m = +-normalize(eta wo + wi) with mz > 0 (eq. 16; the sign makes it right for ior < 1 too)
vec3 transmission_half_vector(Interaction at, vec3 wi) {
    vec3 m = normalize3(at.wo * at.eta + wi);
    return m.z < 0.0 ? -m : m;
}

// d omega_m / d omega_i = |ci|/(ci + eta c)^2 (eq. 17), ci = wi.m
float transmission_jacobian(Interaction at, float c) {
    float k = bend(at, c);
    return refracted_cosine(at, c) / (k * k);
}

// Light that the facet transmits, without the Jacobian and without eta^2: D G (1 - F) c/wo.z, times A(t).
vec3 transmitted(Interaction at, Facet x) {
    return (vec3(1.0) - x.f) * at.attenuation * (x.dg * x.c);
}

// value |N.wi| = D G (1 - F) c J/wo.z (eq. 21), times eta^2 after J for radiance; density pm (1 - R) J.
BsdfValue transmission_lobe(Interaction at, vec3 wi, Facet x) {
    float jacobian = transmission_jacobian(at, x.c);
    vec3 value = transmitted(at, x) * jacobian * transmission_scale(at.eta);
    float pdf = x.pm * (1.0 - x.p_reflect) * jacobian;
    return value_if(x.c > 0.0 && x.ci < 0.0 && at.wo.z > 0.0 && wi.z < 0.0, BsdfValue(value, pdf));
}
