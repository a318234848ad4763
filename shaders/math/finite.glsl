// Tests on bits, independent of how a driver treats NaN.

bool is_finite(float x) {
    return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u;
}

bool is_finite3(vec3 v) {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}

// 2^-126: smaller numbers lose digits, or are 0 on devices without denormals.
const float LEAST_NORMAL = 1.1754943508222875e-38;

// No component is positive; false if one is NaN, so that NaN is never taken for black.
bool is_black(vec3 v) {
    return v.x <= 0.0 && v.y <= 0.0 && v.z <= 0.0;
}

// Some component is NaN.
bool has_nan(vec3 v) {
    uvec3 bits = floatBitsToUint(v) & uvec3(0x7fffffffu);
    return bits.x > 0x7f800000u || bits.y > 0x7f800000u || bits.z > 0x7f800000u;
}
