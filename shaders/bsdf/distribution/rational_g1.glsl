// Masking of Beckmann and Phong.
// Twin of src/reference/bsdf/distribution/rational_g1.rs.

// uses:

// The rational fit to Beckmann's G1 (Schlick 1994; Walter et al. 2007, eq. 27), within 3.1e-3 of the erf form.
// x = z/(alpha s), z = |v.z|, s^2 = vx^2 + vy^2: G1 = x(3.535 + 2.181x)/(1 + x(2.276 + 2.577x)), 1 from x = 1.6 on.
float rational_g1(vec3 v, float alpha) {
    float z = abs(v.z);
    float s = alpha * sqrt(v.x * v.x + v.y * v.y);
    float x = z / s;
    float fit = x * (3.535 + 2.181 * x) / (1.0 + x * (2.276 + 2.577 * x));
    // compared before the division, whose divisor is 0 for v = N
    return z >= 1.6 * s ? 1.0 : fit;
}
