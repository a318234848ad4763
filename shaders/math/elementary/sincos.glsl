// Sine and cosine of a fraction of the full turn.
// Twin of src/reference/math/elementary/sincos.rs, which states error bounds and sources.

// uses:

// (k, r) with 4u = k + r, k whole and |r| <= 1/2. No operation rounds.
vec2 quadrant(float u) {
    float t = 4.0 * u;
    float k = floor(t);
    float f = t - k;
    bool up = f > 0.5;
    return vec2(up ? k + 1.0 : k, up ? f - 1.0 : f);
}

// (sin, cos) of (k + r) quarter turns from those of r quarter turns, k in 0 ... 4.
vec2 rotate_by_quadrant(float k, float sin_r, float cos_r) {
    uint q = uint(k);
    bool odd = (q & 1u) != 0u;
    float s = odd ? cos_r : sin_r;
    float c = odd ? sin_r : cos_r;
    return vec2((q & 2u) != 0u ? -s : s, ((q + 1u) & 2u) != 0u ? -c : c);
}

// (sin 2 pi u, cos 2 pi u) for u in [0, 1].
vec2 sincos_2pi(float u) {
    vec2 kr = quadrant(u);
    float r = kr.y;
    float z = r * r;
    // sin(pi r / 2) = r + r (pi/2 - 1) + r^3 S(r^2), relative error 2^-27.9. r is exact, so only the smaller part of
    // the sum carries rounding errors; pi/2 - 1 in two parts.
    float s = r * (z * (-0.6459636 + z * (0.07968108 + z * -0.004603732)) + 1.5893255e-8);
    float sin_r = r + (r * 0.5707963 + s);
    // cos(pi r / 2) = 1 + r^2 C(r^2), error 2^-31
    float cos_r = 1.0 + z * (-1.2337005 + z * (0.25366855 + z * (-0.020855596 + z * 0.0008944864)));
    return rotate_by_quadrant(kr.x, sin_r, cos_r);
}
