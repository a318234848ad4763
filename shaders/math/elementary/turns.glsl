// The angle of a point of the plane, as a fraction of the full turn.
// Twin of src/reference/math/elementary/turns.rs, which states error bounds and sources.

// uses:

// atan(t)/2pi for |t| <= sqrt 2 - 1: t/2pi + t^3 P(t^2), relative error 2^-30; 1/2pi in two parts.
float fraction(float t) {
    float z = t * t;
    float p = 0.031828474 + z * (-0.022668049 + z * (0.016852837 + z * -0.009656654));
    return t * 0.15915494 + t * (6.420638e-9 + z * (-0.053051617 + z * p));
}

// The angle of (x, y) from the x axis, in turns, from -1/2 to 1/2: 0 at the origin. x and y below 2^126.
float turns(float y, float x) {
    float a = abs(x);
    float b = abs(y);
    float most = a > b ? a : b;
    float least = a > b ? b : a;
    // An eighth of a turn further where the angle within the octant is above a sixteenth: tan(pi/8) = sqrt 2 - 1.
    bool far = least > 0.41421357 * most;
    float divisor = far ? least + most : most;
    float t = (far ? least - most : least) / (most > 0.0 ? divisor : 1.0);
    float octant = (far ? 0.125 : 0.0) + fraction(t);
    float quadrant = b > a ? 0.25 - octant : octant;
    float half_turn = x < 0.0 ? 0.5 - quadrant : quadrant;
    return y < 0.0 ? -half_turn : half_turn;
}
