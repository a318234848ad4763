//! The angle of a point of the plane, as a fraction of the full turn.

/// The angle of (x, y) from the x axis, in turns, from −1/2 to 1/2: 0 at the origin. `x` and `y` below 2¹²⁶.
pub fn turns(y: f32, x: f32) -> f32 {
    let (a, b) = (x.abs(), y.abs());
    let most = if a > b { a } else { b };
    let least = if a > b { b } else { a };
    // An eighth of a turn further where the angle within the octant is above a sixteenth: tan(π/8) = √2 − 1.
    let far = least > 0.41421357 * most;
    let divisor = if far { least + most } else { most };
    let t = if far { least - most } else { least } / if most > 0.0 { divisor } else { 1.0 };
    let octant = (if far { 0.125 } else { 0.0 }) + fraction(t);
    let quadrant = if b > a { 0.25 - octant } else { octant };
    let half_turn = if x < 0.0 { 0.5 - quadrant } else { quadrant };
    if y < 0.0 { -half_turn } else { half_turn }
}

/// atan(t)/2π for |t| ≤ √2 − 1: t/2π + t³ P(t²), relative error 2⁻³⁰; 1/2π in two parts.
pub fn fraction(t: f32) -> f32 {
    let z = t * t;
    let p = 0.031828474 + z * (-0.022668049 + z * (0.016852837 + z * -0.009656654));
    t * 0.15915494 + t * (6.420638e-9 + z * (-0.053051617 + z * p))
}
