// Slopes of visible micro-normals along the plane of incidence.
// Twin of src/reference/bsdf/normals/visible/slope.rs, which has the formulas and their sources.

// uses: math/vec, math/elementary/exp, math/elementary/log1p, math/elementary/erfc, math/elementary/erfc_inverse
// uses: bsdf/normals/visible/incidence

// G(t) = p erfc t + r e^(-(1 - gamma) t^2), over t >= -limit.
struct SlopeLaw {
    float p;
    float r;
    // In [0, 1/3].
    float gamma;
    // At least 0.
    float limit;
};

// A law whose limit is clamped to where the Gaussian is: beyond 4.5 widths lie 2e-10 of it.
SlopeLaw slope_law(float p, float r, float gamma, float limit) {
    return SlopeLaw(p, r, gamma, min2(limit, 4.5));
}

// G(t) and its parts.
struct SlopeShare {
    // G(t)
    float share;
    float erfc;
    // e^(-t^2)
    float gauss;
    // q e^(gamma t^2)
    float tilt;
};

// G(t).
SlopeShare slope_share(SlopeLaw law, float t) {
    ErfcGauss g = erfc_gauss(t);
    // compilers drop this where gamma is the constant 0
    float grown = law.gamma == 0.0 ? 1.0 : exp(law.gamma * (t * t));
    return SlopeShare(
        law.p * g.erfc + law.r * (g.gauss * grown), g.erfc, g.gauss, 1.7724539 * law.r * (1.0 - law.gamma) * grown);
}

// A slope near the one with G(t) = u G(-limit); whole is G(-limit).
// Where visibility matters, it is right at both ends and where q -> infinity: with s^2 = -ln u, t = s - limit/(1 + c s), c
// such that 1 - G/G(-limit) begins as s^2 does. Elsewhere it is a Gaussian's, cut off at -limit, then moved and narrowed to
// the first two moments of (1 + t q/p) e^(-t^2); but next to a limit that is not dark, where few facets are left, it is
// one for uniform brightness.
float slope_start(SlopeLaw law, SlopeShare whole, float u) {
    float s = sqrt(-log1p(u - 1.0));
    float limit = law.limit;
    float w = 1.7724539 * whole.erfc / whole.gauss;
    float c = w / (1.0 + sqrt(1.0 + limit * w));
    float seen = s - limit / (1.0 + c * s);
    float tilt = 1.7724539 * law.r * (1.0 - law.gamma) / law.p;
    float x = erfc_inverse(u * whole.erfc);
    float moved = x + tilt * (0.5 - 0.25 * tilt * x);
    // over the density at -limit
    float dark = law.p - limit * whole.tilt;
    float rest = (1.0 - u) * whole.share / (1.1283792 * whole.gauss * dark);
    bool next = rest > 0.0 && rest < 0.1;
    float narrow = next ? rest - limit : max2(moved, 0.1 - limit);
    return tilt > 0.4 ? seen : narrow;
}

// One step of Householder's method of third order (1970) from t towards G = goal: the error is raised to its fourth
// power. -limit is not passed, nor approached or left by more than a factor of 8.
float slope_step(SlopeLaw law, float goal, float t) {
    SlopeShare at = slope_share(law, t);
    float h = law.gamma * (t * t);
    // -dG/dt sqrt(pi)/2 e^(t^2), its first and second derivative over itself
    float seen = law.p + t * at.tilt;
    float first = at.tilt * (1.0 + 2.0 * h) / seen;
    float second = law.gamma * at.tilt * t * (6.0 + 4.0 * h) / seen;
    // Newton's step, G''/G' and G'''/G'
    float newton = (goal - at.share) / (1.1283792 * at.gauss * seen);
    float bent = first - 2.0 * t;
    float twisted = 2.0 * (2.0 * t * t - 1.0) - 4.0 * t * first + second;
    float change = newton * (1.0 - 0.5 * bent * newton)
        / (1.0 - bent * newton + twisted * newton * newton * 0.16666667);
    float from_limit = t + law.limit;
    float kept = max2(t - change, 0.125 * from_limit - law.limit);
    return min2(min2(kept, 8.0 * from_limit - law.limit), 5.0);
}

// A slope that is exceeded with probability u, within 3e-7 of the probability.
float slope_sample(SlopeLaw law, float u) {
    SlopeShare whole = slope_share(law, -law.limit);
    float v = above_zero(u);
    float goal = v * whole.share;
    float t = slope_step(law, goal, slope_start(law, whole, v));
    return slope_step(law, goal, slope_step(law, goal, t));
}
