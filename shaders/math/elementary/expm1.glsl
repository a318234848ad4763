// e^x - 1, accurate near 0.
// Twin of src/reference/math/elementary/expm1.rs, which states error bounds and sources.

// uses: math/vec, math/elementary/exp

// e^x - 1: -1 below -17.3, infinite above 88.72.
float expm1(float x) {
    // Past these ends the result is -1 or infinite.
    vec3 krq = exp_reduce(min2(max2(x, -18.0), 89.0));
    // 2^k ((1 - 2^-k) + r + q), with the rounding errors of both sums added back. The lower of the
    // two summands of b counts as 0 from k = 30 on: 2^-30 is below any rounding error of 1.
    float p = pow2(-min2(krq.x, 30.0));
    float b = 1.0 - p;
    float h = b + krq.y;
    float lost = ((1.0 - b) - p) + (krq.y - (h - b));
    return scale_by_pow2(h + (lost + krq.z), krq.x);
}
