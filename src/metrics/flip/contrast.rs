//! The eye's blur: filters of its contrast sensitivity in each opponent channel (FLIP, colour pipeline,
//! spatial filtering; the fit of Johnson and Fairchild, A top down description of S-CIELAB and CIEDE2000, 2003).

use std::f64::consts::PI;

use super::plane::{Opponent, Plane};

/// A term a·√(π/b)·exp(−π²x²/b) of a filter, x in degrees of the eye's field.
struct Term {
    a: f64,
    b: f64,
}

/// a and b from FLIP.
const ACHROMATIC: [Term; 1] = [Term { a: 1.0, b: 0.0047 }];
const RED_GREEN: [Term; 1] = [Term { a: 1.0, b: 0.0053 }];
const BLUE_YELLOW: [Term; 2] = [Term { a: 34.1, b: 0.04 }, Term { a: 13.5, b: 0.025 }];

/// The largest b: it determines the radius of all filters.
const WIDEST: f64 = 0.04;

/// The picture filtered by the eye's contrast sensitivity.
pub fn filter(picture: &Opponent, pixels_per_degree: f64) -> Opponent {
    Opponent {
        y: blurred(&picture.y, &ACHROMATIC, pixels_per_degree),
        cx: blurred(&picture.cx, &RED_GREEN, pixels_per_degree),
        cz: blurred(&picture.cz, &BLUE_YELLOW, pixels_per_degree),
    }
}

/// `plane` convolved with the sum of the terms, scaled to sum to 1. Each term is a product of a function of x and a
/// function of y, so the convolution is done along one axis and then the other.
fn blurred(plane: &Plane, terms: &[Term], pixels_per_degree: f64) -> Plane {
    let kernels: Vec<Vec<f64>> = terms.iter().map(|t| t.kernel(pixels_per_degree)).collect();
    // Σ_x Σ_y g(x) g(y) = (Σ_x g(x))² of each term, with the factor a·√(π/b) in front
    let weights = terms
        .iter()
        .zip(&kernels)
        .map(|(term, kernel)| term.a * (PI / term.b).sqrt() * kernel.iter().sum::<f64>().powi(2));
    let weights: Vec<f64> = weights.collect();
    let whole: f64 = weights.iter().sum();
    let parts = kernels.iter().zip(&weights).map(|(kernel, weight)| {
        let sum: f64 = kernel.iter().sum();
        let along: Vec<f64> = kernel.iter().map(|g| g / sum).collect();
        let down: Vec<f64> = along.iter().map(|g| g * weight / whole).collect();
        plane.along_rows(&along).along_columns(&down)
    });
    let parts: Vec<Plane> = parts.collect();
    let (first, rest) = (&parts[0], &parts[1..]);
    rest.iter()
        .fold(first.clone(), |sum, part| sum.zip(part, |a, b| a + b))
}

impl Term {
    /// exp(−π²x²/b) at pixel positions x, three standard deviations of the widest filter to either side.
    fn kernel(&self, pixels_per_degree: f64) -> Vec<f64> {
        // exp(−π²x²/b) has the standard deviation √(b/(2π²)) in degrees.
        let radius = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i32;
        let at = |i: i32| {
            let x = f64::from(i) / pixels_per_degree;
            (-PI * PI * x * x / self.b).exp()
        };
        (-radius..=radius).map(at).collect()
    }
}
