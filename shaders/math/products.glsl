// Differences of products without cancellation.
// Twin of src/reference/math/products.rs.

// uses:

// 2^12 + 1, which splits a number of 24 bits into halves.
const float SPLIT = 4097.0;

// A number as the sum of two with half as many bits each.
struct Halves {
    float hi;
    float lo;
};

// a = hi + lo, exactly. Dekker, A Floating-Point Technique for Extending the Available Precision, Numerische Mathematik
// 18, 1971 (Veltkamp's splitting).
Halves halves(float a) {
    float c = SPLIT * a;
    float hi = c - (c - a);
    return Halves(hi, a - hi);
}

// a b - p, exactly, where p is a b rounded (Dekker 1971).
float product_error(Halves a, Halves b, float p) {
    return a.lo * b.lo - (p - a.hi * b.hi - a.lo * b.hi - a.hi * b.lo);
}

// a b - c d, with a relative error of at most 2u + O(u²), u half an ulp of 1: the sign is always right, and 0 only if
// the products are equal. Exchanging the products negates it exactly.
//
// Cornea, Harrison, Tang, Scientific Computing on Itanium-based Systems, 2002; the bound: Jeannerod, A Radix-Independent
// Error Analysis of the Cornea-Harrison-Tang Method, ACM TOMS 42(3), 2016. Holds for products that are 0 or of a size
// within 1e-28 ... 1e30, so that their errors do not underflow and no half overflows.
float difference_of_products(float a, float b, float c, float d) {
    float p = a * b;
    float q = c * d;
    float ep = product_error(halves(a), halves(b), p);
    float eq = product_error(halves(c), halves(d), q);
    return (p - q) + (ep - eq);
}
