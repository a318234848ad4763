// The exponential function, and the reduction that it shares with expm1.
// Twin of src/reference/math/elementary/exp.rs, which states error bounds and sources.
// Replaces GLSL's own exp (allowed by the specification, section 8), whose accuracy is up to the driver.

// uses: math/vec

// 2^k for whole k in -126 ... 127.
// k + 127 + 1.5 2^23 has k + 127 in its low bits: shifted, they are the exponent.
float pow2(float k) {
    return uintBitsToFloat(floatBitsToUint(k + 12583039.0) << 23u);
}

// y 2^k for whole k in -254 ... 254, in two steps because 2^k alone may be out of range.
float scale_by_pow2(float y, float k) {
    float half_k = floor(k * 0.5);
    return y * pow2(half_k) * pow2(k - half_k);
}

// (k, r, q) with e^x = 2^k (1 + r + q), k whole, |r| <= ln(2)/2, |x| <= 104.
// x = k ln 2 + r + c, where c is the rounding error of r, and
// q = e^(r+c) - 1 - r = r^2 E(r) + c (1 + r).
vec3 exp_reduce(float x) {
    float k = floor(x * 1.442695 + 0.5);
    // ln 2 in two parts; the first has 15 bits, so that k times it is exact.
    float hi = x - k * 0.69314575;
    float lo = k * 1.4286068e-6;
    float r = hi - lo;
    float c = (hi - r) - lo;
    float e = 0.041666478 + r * (0.0083335675 + r * (0.0013933708 + r * 0.00019742562));
    float q = r * r * (0.5 + r * (0.16666666 + r * e)) + c * (1.0 + r);
    return vec3(k, r, q);
}

// e^x: denormal results are rounded once, 0 below -103.97, infinite above 88.72.
float exp(float x) {
    // Past these ends the result is 0 or infinite; between them k fits scale_by_pow2.
    vec3 krq = exp_reduce(min2(max2(x, -104.0), 89.0));
    // 1 + r + q, with the rounding error of 1 + r added back
    float h = 1.0 + krq.y;
    return scale_by_pow2(h + ((krq.y - (h - 1.0)) + krq.z), krq.x);
}
