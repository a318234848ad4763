// A micro-normal from its angles.
// Twin of src/reference/bsdf/distribution/micro_normal.rs.

// uses: math/vec, math/elementary/sincos

// The micro-normal at (sin theta, cos theta) and azimuth phi = 2 pi u.
vec3 micro_normal(float sin_theta, float cos_theta, float u) {
    vec2 phi = sincos_2pi(u);
    return normalize3(vec3(sin_theta * phi.y, sin_theta * phi.x, cos_theta));
}

// The micro-normal at tan^2 theta = t2 and azimuth phi = 2 pi u.
// cos theta = 1/sqrt(1 + tan^2 theta), sin theta = tan theta cos theta: a small angle keeps all its digits.
vec3 micro_normal_at_tan2(float t2, float u) {
    float cos_theta = 1.0 / sqrt(1.0 + t2);
    return micro_normal(sqrt(t2) * cos_theta, cos_theta, u);
}
