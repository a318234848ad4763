// Beckmann; alpha is the width, in (0, 1].
// Twin of src/reference/bsdf/distribution/beckmann.rs.

// uses: math/elementary/exp, math/elementary/log1p, bsdf/distribution/micro_normal, bsdf/distribution/rational_g1

// D = exp(-(mx^2 + my^2)/(mz^2 alpha^2))/(pi alpha^2 mz^4) (Walter et al. 2007, eq. 25).
float beckmann_d(vec3 m, float alpha) {
    float alpha2 = alpha * alpha;
    float s2 = m.x * m.x + m.y * m.y;
    float z2 = m.z * m.z;
    float d = exp(-(s2 / (z2 * alpha2))) / (3.1415927 * alpha2 * (z2 * z2));
    // at mz = 1e-6 the exponential has long been 0, and mz^4 does not yet vanish: 0, and not 0/0
    return m.z > 1e-6 ? d : 0.0;
}

// The rational G1 of width alpha.
float beckmann_g1(vec3 v, float alpha) {
    return rational_g1(v, alpha);
}

// A micro-normal from D(m) mz: tan^2 theta = -alpha^2 ln(1 - u) (Walter et al. 2007, eq. 28).
vec3 beckmann_sample(float alpha, vec2 u) {
    return micro_normal_at_tan2(-(alpha * alpha * log1p(-u.x)), u.y);
}
