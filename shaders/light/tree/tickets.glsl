// A lottery: a choice that is subdivided repeatedly, with probabilities that are ratios of whole numbers.
// Twin of src/reference/light/tree/tickets.rs.
// uses:

// `drawn` is one of `count` tickets, each as likely as the others. So the probability of a choice is exact, and the
// rest of the random number after it is uniform again.
struct Tickets {
    uint drawn;
    uint count;
    // Random bits not yet used, taken eight at a time, and how often.
    uint spare;
    uint spares;
};

// The tickets of a block of random numbers: 31 bits of the first, and the bits of the others from which no point is drawn.
Tickets all_tickets(uvec4 u) {
    uint spare = (u.y & 255u) | ((u.z & 255u) << 8u) | ((u.w & 255u) << 16u);
    return Tickets(u.x >> 1u, 0x80000000u, spare, 3u);
}

// 256 tickets in place of each, once fewer than 2^23 are left: a share of them is then as fine as a float.
Tickets refilled(Tickets t) {
    bool few = t.count < 0x800000u && t.spares > 0u;
    uint drawn = (t.drawn << 8u) | (t.spare & 255u);
    return Tickets(few ? drawn : t.drawn, few ? t.count << 8u : t.count, few ? t.spare >> 8u : t.spare,
                   few ? t.spares - 1u : t.spares);
}

// How many of `count` tickets fall to the first of two, for weights a and b that are not both 0: in proportion, but at
// least one to each whose weight is not 0, as long as there are two.
uint first_share(uint count, float a, float b) {
    uint share = uint(a / (a + b) * float(count));
    share = a > 0.0 && share == 0u ? 1u : share;
    // among 2^24 tickets or more, a float may lose some: the first gets all if the second has no weight
    return b > 0.0 ? (share < count ? share : count - 1u) : count;
}
