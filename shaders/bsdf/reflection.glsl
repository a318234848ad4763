// The reflected lobe E_r. Equation numbers are those of Walter et al. 2007.
// Twin of src/reference/bsdf/reflection.rs.

// uses: math/vec, bsdf/interaction, bsdf/sample, bsdf/snell, bsdf/facet

// wi = 2(wo.m)m - wo, c = wo.m (eq. 39; signed, unlike the hand-out's)
vec3 reflect_about(vec3 wo, vec3 m, float c) {
    return m * (2.0 * c) - wo;
}

// m = normalize(wo + wi) (eq. 13)
vec3 reflection_half_vector(vec3 wo, vec3 wi) {
    return normalize3(wo + wi);
}

// d omega_m / d omega_i = 1/(4c) (eq. 14)
float reflection_jacobian(float c) {
    return 1.0 / (4.0 * c);
}

// value |N.wi| = D G F/(4 wo.z) (eq. 20), density pm R/(4c); zero unless c, wo.z and wi.z > 0.
BsdfValue reflection_lobe(Interaction at, vec3 wi, Facet x) {
    vec3 value = reflected_share(at, x.c, x.f) * (0.25 * x.dg);
    float pdf = x.pm * x.p_reflect * reflection_jacobian(x.c);
    return value_if(x.c > 0.0 && at.wo.z > 0.0 && wi.z > 0.0, BsdfValue(value, pdf));
}
