// The inverse of erfc, which keeps the digits of either tail.
// Twin of src/reference/math/elementary/erfc_inverse.rs, which states error bounds and sources.

// uses: math/elementary/log1p

// M(w), 0 <= w <= 5.
float erfc_inverse_near(float w) {
    float v = w - 2.5;
    float highest = -3.5236558e-6 + v * (4.5993565e-7 + v * (2.818565e-8 + v * -8.234456e-9));
    float high = 0.00021857738 + v * (-4.9434735e-6 + v * highest);
    return 1.5014094 + v * (0.24664028 + v * (-0.0041776686 + v * (-0.0012527556 + v * high)));
}

// T(1/s), s >= sqrt(5).
float erfc_inverse_far(float s) {
    float v = 1.0 / s - 0.25;
    float high = -0.8650434 + v * (0.7420314 + v * (-3.9445274 + v * (5.177823 + v * 3.975362)));
    return 0.9599459 + v * (-0.19819804 + v * (0.08018991 + v * (0.5546486 + v * high)));
}

// The x with erfc x = z: infinite at 0, -infinite at 2, NaN outside [0, 2] and at -0.
// With y = 1 - z = erf x, w = -ln(1 - y^2) = -ln(z (2 - z)) and s = sqrt(w): x = y M(w) up to w = 5, and
// x = +-s T(1/s) beyond.
float erfc_inverse(float z) {
    float y = 1.0 - z;
    // z or 2 - z, which is exact
    float least = y < 0.0 ? 2.0 - z : z;
    // 1/z of a denormal z is infinite: 2^-64 is taken out.
    bool tiny = least < 5.421011e-20;
    float scaled = tiny ? least * 1.8446744e19 : least;
    // y^2 has lost 1 - y^2 near the ends, and 1/(z (2 - z)) - 1 has lost y^2 in the middle.
    bool middle = least > 0.5;
    float argument = middle ? -(y * y) : 1.0 / (scaled * (2.0 - least)) - 1.0;
    float l = log1p(argument);
    float w = (middle ? -l : l) + (tiny ? 44.36142 : 0.0);
    float s = sqrt(w);
    float x = w <= 5.0 ? y * erfc_inverse_near(w) : s * erfc_inverse_far(s);
    float with_sign = w > 5.0 && y < 0.0 ? -x : x;
    // a NaN
    return least < 0.0 ? sqrt(least) : with_sign;
}
