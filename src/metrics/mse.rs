//! Mean squared error.

/// (x − r)²; in the square of radiance.
pub fn squared_error(x: f64, r: f64) -> f64 {
    (x - r) * (x - r)
}
