// Sobol's sequence in four dimensions, without tables: dimension 0 has the digits of the index itself.
// Twin of src/reference/sampler/sobol_digits.rs, which says why this is Sobol's sequence.
//
// Bit 0 is the first binary digit after the point of a coordinate, and the last one of the index. The index is a
// polynomial over GF(2), bit k the coefficient of x^k; a coordinate has its digits in base p, a primitive polynomial.

// uses:

// p = x + 1: quotients and remainders by p^16 = x^16 + 1, those by p^8, ...
uint sobol_digits_1(uint index) {
    uint x = index ^ (index >> 16u);
    x ^= (x >> 8u) & 0x00ff00ffu;
    x ^= (x >> 4u) & 0x0f0f0f0fu;
    x ^= (x >> 2u) & 0x33333333u;
    return x ^ ((x >> 1u) & 0x55555555u);
}

// p = x^2 + x + 1: by p^8 = x^16 + x^8 + 1, by p^4, p^2, p, the last together with m = 1, 3.
uint sobol_digits_2(uint index) {
    uint x = index ^ ((index >> 8u) & 0x00ffff00u);
    x ^= (x >> 16u) & 0x000000ffu;
    x ^= (x >> 4u) & 0x0ff00ff0u;
    x ^= (x >> 8u) & 0x000f000fu;
    x ^= (x >> 2u) & 0x3c3c3c3cu;
    x ^= (x >> 4u) & 0x03030303u;
    return x ^ ((x >> 1u) & 0x33333333u) ^ ((x >> 3u) & 0x11111111u);
}

// p = x^3 + x + 1: by p^8 = x^24 + x^8 + 1, by p^4, p^2, p; then m = 1, 3, 1.
uint sobol_digits_3(uint index) {
    uint x = index ^ (index >> 24u) ^ ((index >> 16u) & 0x0000ff00u);
    x ^= (x >> 8u) & 0x0000ff00u;
    x ^= ((x >> 12u) & 0x00000fffu) ^ ((x >> 8u) & 0x000000f0u);
    x ^= (x >> 4u) & 0xf00f00f0u;
    x ^= ((x >> 6u) & 0x3f03f03fu) ^ ((x >> 4u) & 0x0c00c00cu);
    x ^= (x >> 2u) & 0x0c30c30cu;
    x ^= ((x >> 3u) & 0x071c71c7u) ^ ((x >> 2u) & 0x02082082u);
    return x ^ ((x >> 1u) & 0x49249249u);
}
