// Choice of a triangle within a mesh, from the part of triangle_cdf that begins at `cdf`.
// Twin of cdf_choice and cdf_probability in src/reference/light/choice.rs.

// uses: math/steps

// The triangle, from 0, with triangle_cdf[cdf + i] <= u24 < triangle_cdf[cdf + i + 1], for u24 < 2^24.
uint triangle_choice(uint cdf, uint count, uint u24) {
    uint low = 0u;
    uint high = count;
    while (high - low > 1u) {
        loop_steps += 1u;
        uint middle = (low + high) / 2u;
        bool below = triangle_cdf[cdf + middle] <= u24;
        low = below ? middle : low;
        high = below ? high : middle;
    }
    return low;
}

// The probability of that choice, exact.
float triangle_pmf(uint cdf, uint i) {
    return float(triangle_cdf[cdf + i + 1u] - triangle_cdf[cdf + i]) * 5.9604644775390625e-8;
}
