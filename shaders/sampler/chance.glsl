// The probability with which a uniform number is below p.
// Twin of src/reference/sampler/chance.rs.

// uses:

// Uniform numbers are multiples of 2^-24 (unit_float): u < p is true with the probability ceil(p 2^24) 2^-24. From p =
// 2^-12 on that is p to within a share of 2^-12, and p is returned; for rarer events it may be many times p. A division
// by it is then right on average, even for rare events.
float chance(float p) {
    float drawn = -floor(-p * 16777216.0) * 5.960464477539063e-8;
    return p < 0.000244140625 ? drawn : p;
}
