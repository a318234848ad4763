//! The project's own elementary functions in `f32`; twins of `shaders/math/elementary/`.

/// Placeholder until the polynomials land.
pub fn sincos_2pi(u: f32) -> (f32, f32) {
    let (s, c) = (f64::from(u) * std::f64::consts::TAU).sin_cos();
    (s as f32, c as f32)
}
pub fn exp(x: f32) -> f32 {
    f64::from(x).exp() as f32
}
pub fn expm1(x: f32) -> f32 {
    f64::from(x).exp_m1() as f32
}
pub fn log1p(x: f32) -> f32 {
    f64::from(x).ln_1p() as f32
}
