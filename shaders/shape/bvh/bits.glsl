// Positions and counts of bits in small masks.

// uses:

// Index of the highest bit of a mask 1 ... 2^24 - 1: the exponent of the exactly converted number. A driver without an
// instruction for it runs findMSB lane by lane.
uint highest_bit(uint mask) {
    return (floatBitsToUint(float(int(mask))) >> 23u) - 127u;
}
