// From words to numbers.
// Twin of src/reference/sampler/unit_float.rs.

// uses:

// The upper 24 bits of x as a number in [0, 1 - 2^-24], exact: x / 2^32 would round up to 1.
float unit_float(uint x) {
    return float(x >> 8u) * 5.960464477539063e-8;
}
