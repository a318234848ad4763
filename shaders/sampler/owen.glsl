// Owen scrambling by a hash.
// Twin of src/reference/sampler/owen.rs.

// uses:

// Flips each binary digit of a number in [0, 1) or not, by a hash of the digits before it. Bit 0 is the first digit
// after the point: sums and products carry to later digits only, and an even factor excludes a digit from its own hash.
// Laine & Karras, Stratified Sampling for Stochastic Transparency, EGSR 2011; Burley, Practical Hash-based
// Owen Scrambling, JCGT 9(4), 2020; constants of Vegdahl, Building a Better LK Hash, 2021.
uint owen_scramble(uint digits, uint seed) {
    uint x = digits ^ (digits * 0x3d20adeau);
    x = (x + seed) * ((seed >> 16u) | 1u);
    x = x ^ (x * 0x05526c56u);
    return x ^ (x * 0x53a22864u);
}
