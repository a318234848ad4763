//! Symmetric mean absolute percentage error, as renderings are compared with it: Vogels et al., Denoising with
//! Kernel Prediction and Asymmetric Loss Functions, SIGGRAPH 2018, section on the loss.
//!
//! Statistics know the same name for twice as much (|x|/2 + |r|/2 below the line) and for percent of it.

/// Added below the line, so that black on black is 0 and not 0/0; the value of Vogels et al.
const EPSILON: f64 = 0.01;

/// |x − r|/(|x| + |r| + ε), ε = 0.01; in [0, 1), the same with x and r exchanged.
pub fn symmetric_error(x: f64, r: f64) -> f64 {
    (x - r).abs() / (x.abs() + r.abs() + EPSILON)
}
