// ln(1 + x), accurate near 0.
// Twin of src/reference/math/elementary/log1p.rs, which states error bounds and sources.

// uses:

// ln(1 + x): -infinity at -1, NaN below, infinite at infinity.
float log1p(float x) {
    // 1 + x = u + delta: u rounded, delta exact (Fast2Sum, the larger summand first)
    float u = 1.0 + x;
    float delta = x > 1.0 ? 1.0 - (u - x) : x - (u - 1.0);
    // u = 2^k (1 + f), sqrt(1/2) <= 1 + f < sqrt(2): the constant takes sqrt(1/2)'s bits to 1's, where the exponent changes.
    uint bits = floatBitsToUint(u) + 0x004afb0du;
    float k = float(int(bits >> 23u) - 127);
    float f = uintBitsToFloat((bits & 0x007fffffu) + 0x3f3504f3u) - 1.0;
    // ln(1 + f) = f + q, q = f^2 (f L(f) - 1/2), relative error 2^-30
    float l = -0.16667323 + f * (0.14220013 + f * (-0.12417663 + f * (0.118970476 + f * (-0.11608052 + f * 0.06645262))));
    float q = f * f * (f * (0.33333313 + f * (-0.2500002 + f * (0.20002067 + f * l))) - 0.5);
    // ln(1 + x) = k ln 2 + f + q + delta/u; ln 2 in two parts, the rounding error of the first sum added back.
    float hi = k * 0.69314575;
    float h = hi + f;
    float y = h + ((f - (h - hi)) + (q + (k * 1.4286068e-6 + delta / u)));
    // -1/sqrt(u) is -infinity for u = 0 and NaN below it.
    float finite = u > 0.0 ? y : -1.0 / sqrt(u);
    return u > 3.4028235e38 ? u : finite;
}
