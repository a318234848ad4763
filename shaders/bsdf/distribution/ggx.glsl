// GGX; alpha is the width, in (0, 1].
// Twin of src/reference/bsdf/distribution/ggx.rs.

// uses: bsdf/distribution/micro_normal

// D = 1/(pi alpha^2 q^2), q = (mx^2 + my^2)/alpha^2 + mz^2 (Walter et al. 2007, eq. 33, without its tangent).
float ggx_d(vec3 m, float alpha) {
    float alpha2 = alpha * alpha;
    float s2 = m.x * m.x + m.y * m.y;
    float q = s2 / alpha2 + m.z * m.z;
    float d = 1.0 / (3.1415927 * alpha2 * (q * q));
    return m.z > 0.0 ? d : 0.0;
}

// G1 = 2z/(z + sqrt(z^2 + alpha^2 s^2)), z = |v.z|, s^2 = vx^2 + vy^2 (Walter et al. 2007, eq. 34).
float ggx_g1(vec3 v, float alpha) {
    float z = abs(v.z);
    float s2 = v.x * v.x + v.y * v.y;
    return 2.0 * z / (z + sqrt(z * z + alpha * alpha * s2));
}

// A micro-normal from D(m) mz: tan^2 theta = alpha^2 u/(1 - u) (Walter et al. 2007, eq. 35).
vec3 ggx_sample(float alpha, vec2 u) {
    return micro_normal_at_tan2(alpha * alpha * u.x / (1.0 - u.x), u.y);
}
