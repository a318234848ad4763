// The sum of one pixel's samples, which keeps counting where a plain sum stagnates.
// Twin of src/reference/film/pixel_sum.rs.

// uses:

// A sum in two parts: sum is the whole rounded to the scalar, comp the rounding error.
// The samples are added one at a time, in the order of their index.
struct PixelSum {
    vec3 sum;
    vec3 comp;
};

// Whether every component is below 2^96: 2^32 of them, the most that a pixel may have, add up to less than 2^128, where
// floats end. Tested on the bits, independently of how a driver treats NaN and infinity.
bool is_summable(vec3 x) {
    uvec3 bits = floatBitsToUint(x) & uvec3(0x7fffffffu);
    return bits.x < 0x6f800000u && bits.y < 0x6f800000u && bits.z < 0x6f800000u;
}

// The sum with one more sample, summable and >= -sum/2 in each channel. Relative error of an addition: below 3 2^-48.
PixelSum film_add(PixelSum pixel, vec3 x) {
    // s + err = sum + x exactly: Knuth, The Art of Computer Programming 2, 4.2.2, theorem B (2Sum)
    vec3 s = pixel.sum + x;
    vec3 y = s - pixel.sum;
    vec3 err = (pixel.sum - (s - y)) + (x - y);
    // Both parts normalised again, or comp would itself stagnate at 2^24: sum + comp = s + low exactly, |s| >= |low|:
    // Dekker, A Floating-Point Technique, 1971 (Fast2Sum)
    vec3 low = pixel.comp + err;
    vec3 sum = s + low;
    return PixelSum(sum, low - (sum - s));
}

// The mean of n samples, n >= 1. comp is less than half a unit of sum and does not change it.
vec3 film_mean(PixelSum pixel, uint n) {
    return pixel.sum / float(n);
}
