//! Relative mean squared error (Rousselle, Knaus and Zwicker, Adaptive Sampling and Reconstruction using Greedy
//! Error Minimization, SIGGRAPH Asia 2011).

/// Added to r², so that a black reference does not divide by 0 (as Kalantari, Bako and Sen, A Machine Learning Approach
/// for Filtering Monte Carlo Noise, SIGGRAPH 2015). It makes 0.1 the radiance below which errors count as absolute
/// ones: pictures are compared at about the exposure at which they are viewed.
pub const EPSILON: f64 = 0.01;

/// (x − r)²/(r² + ε), ε = 0.01.
pub fn relative_squared_error(x: f64, r: f64) -> f64 {
    relative((x - r) * (x - r), r)
}

/// A squared error (or another estimate of its mean) relative to r: square/(r² + ε).
pub fn relative(square: f64, r: f64) -> f64 {
    square / (r * r + EPSILON)
}
