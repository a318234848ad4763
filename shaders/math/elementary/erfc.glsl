// The complement of the error function, which resolves small values where erf rounds to 1.
// Twin of src/reference/math/elementary/erfc.rs, which states error bounds and sources.

// uses: math/vec, math/products, math/elementary/exp

// erfc x, and the e^(-x^2) of which it is made.
struct ErfcGauss {
    float erfc;
    float gauss;
};

// e^(-x^2) for |x| <= 11, with the rounding error of the square, which alone would cost x^2 ulps.
float exp_minus_square(float x) {
    float square = x * x;
    Halves half_x = halves(x);
    float lost = product_error(half_x, half_x, square);
    float e = exp(-square);
    return e - e * lost;
}

// erfc x and e^(-x^2).
ErfcGauss erfc_gauss(float x) {
    // erf x = x S(x^2), |x| <= 1/2, relative error 2^-28
    float s = x * x;
    float small = 1.1283791 + s * (-0.3761229 + s * (0.11278182 + s * (-0.026508145 + s * 0.0042732772)));
    // erfc a = e^(-a^2) t E(t), t = 1/(1 + a/2), a >= 1/2, relative error 2^-25.8. Past 11 both results are 0.
    float a = min2(max2(x, -x), 11.0);
    float t = 1.0 / (1.0 + 0.5 * a);
    float r = t - 0.5;
    float high = -0.1719462 + r * (-0.10359114 + r * (0.09602483 + r * (0.05179929 + r * -0.06019629)));
    float e = 0.51079136 + r * (0.6871607 + r * (0.55894154 + r * (0.14576854 + r * high)));
    float gauss = exp_minus_square(a);
    float tail = gauss * (t * e);
    float large = x < 0.0 ? 2.0 - tail : tail;
    return ErfcGauss(a <= 0.5 ? 1.0 - x * small : large, gauss);
}

// erfc x = 2/sqrt(pi) times the integral of e^(-t^2) from x on: 2 below -3.9, denormal from 9.19 on, 0 above 10.06.
float erfc(float x) {
    return erfc_gauss(x).erfc;
}
