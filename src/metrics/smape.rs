//! Symmetric mean absolute percentage error, as used for renderings: Vogels et al., Denoising with Kernel Prediction
//! and Asymmetric Loss Functions, SIGGRAPH 2018, section on the loss.
//!
//! In statistics the same name means twice as much (|x|/2 + |r|/2 in the denominator), given in percent.

/// Added to the denominator, so that black on black is 0 and not 0/0; the value of Vogels et al.
const EPSILON: f64 = 0.01;

/// |x − r|/(|x| + |r| + ε), ε = 0.01; in [0, 1), symmetric in x and r.
pub fn symmetric_error(x: f64, r: f64) -> f64 {
    (x - r).abs() / (x.abs() + r.abs() + EPSILON)
}
