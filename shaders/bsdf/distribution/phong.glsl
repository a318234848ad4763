// Phong; alpha is the exponent, >= 0.
// Twin of src/reference/bsdf/distribution/phong.rs.

// uses: math/elementary/exp, math/elementary/expm1, math/elementary/log1p, bsdf/distribution/micro_normal, bsdf/distribution/rational_g1

// D = (alpha + 2)/(2 pi) cos^alpha theta (Walter et al. 2007, eq. 30).
// ln cos theta is taken from sin^2 theta where that is small, ln(1 - s^2)/2, and from cos theta beyond,
// -ln(1 + (1 - z)/z): either is accurate where the other cancels.
float phong_d(vec3 m, float alpha) {
    float s2 = m.x * m.x + m.y * m.y;
    bool near = s2 < 0.5;
    float x = near ? -s2 : (1.0 - m.z) / m.z;
    float scale = near ? 0.5 : -1.0;
    float d = (alpha + 2.0) * 0.15915494 * exp(scale * alpha * log1p(x));
    // 1/mz overflows for smaller mz
    return m.z > 1e-30 ? d : 0.0;
}

// Beckmann's rational G1 for the width sqrt(2/(alpha + 2)).
float phong_g1(vec3 v, float width) {
    return rational_g1(v, width);
}

// A micro-normal from D(m) mz: cos theta = (1 - u)^(1/(alpha + 2)) (Walter et al. 2007, eq. 31).
// With e = 2 ln(1 - u)/(alpha + 2): sin^2 theta = 1 - exp(e), cos theta = exp(e/2).
vec3 phong_sample(float alpha, vec2 u) {
    float e = 2.0 * log1p(-u.x) / (alpha + 2.0);
    float sin_theta = sqrt(-expm1(e));
    return micro_normal(sin_theta, exp(0.5 * e), u.y);
}
