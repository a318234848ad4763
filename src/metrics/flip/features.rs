//! Edges and points that only one of two pictures has (FLIP, feature pipeline).

use super::plane::Plane;

/// The width of the eye's feature detectors, in degrees: w.
const WIDTH: f64 = 0.082;
/// The exponent that emphasises small differences: q_f.
const EXPONENT: f64 = 0.5;

/// The difference of two pictures' features, from their achromatic channels Y of YCxCz; in [0, 1].
pub fn map(test: &Plane, reference: &Plane, pixels_per_degree: f64) -> Plane {
    let detectors = Detectors::new(pixels_per_degree);
    let (test, reference) = (detectors.features(test), detectors.features(reference));
    let edges = test.edges.zip(&reference.edges, |a, b| (a - b).abs());
    let points = test.points.zip(&reference.points, |a, b| (a - b).abs());
    // ΔE_f = (1/√2 · max(|‖e_r‖ − ‖e_t‖|, |‖p_r‖ − ‖p_t‖|))^q_f
    let difference = |edge: f64, point: f64| {
        (edge.max(point) / std::f64::consts::SQRT_2)
            .powf(EXPONENT)
            .min(1.0)
    };
    edges.zip(&points, difference)
}

/// The strength of edges and of points in each pixel.
struct Features {
    edges: Plane,
    points: Plane,
}

/// A Gaussian and its derivatives along one axis, at integer pixels.
struct Detectors {
    /// Sums to 1.
    gauss: Vec<f64>,
    /// First derivative; its positive values sum to 1, its negative ones to −1.
    slope: Vec<f64>,
    /// Second derivative, scaled the same way.
    bend: Vec<f64>,
}

impl Detectors {
    fn new(pixels_per_degree: f64) -> Self {
        // The Gaussian has the standard deviation σ = w/2 in degrees.
        let sigma = 0.5 * WIDTH * pixels_per_degree;
        let radius = (3.0 * sigma).ceil() as i32;
        let along = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let g = |x: f64| (-x * x / (2.0 * sigma * sigma)).exp();
            (-radius..=radius)
                .map(|i| f(f64::from(i)) * g(f64::from(i)))
                .collect()
        };
        Self {
            gauss: normalised(&along(&|_| 1.0)),
            // G' ∝ −x G, G'' ∝ (x²/σ² − 1) G
            slope: normalised(&along(&|x| -x)),
            bend: normalised(&along(&|x| x * x / (sigma * sigma) - 1.0)),
        }
    }

    fn features(&self, achromatic: &Plane) -> Features {
        // Y of YCxCz in [0, 1]: the relative luminance (Y + 16)/116.
        let luminance = achromatic.map(|y| (y + 16.0) / 116.0);
        let smooth_rows = luminance.along_rows(&self.gauss);
        let across = |kernel: &[f64]| luminance.along_rows(kernel).along_columns(&self.gauss);
        let down = |kernel: &[f64]| smooth_rows.along_columns(kernel);
        let norm = |x: f64, y: f64| (x * x + y * y).sqrt();
        Features {
            edges: across(&self.slope).zip(&down(&self.slope), norm),
            points: across(&self.bend).zip(&down(&self.bend), norm),
        }
    }
}

/// The kernel with its positive values scaled to sum to 1 and its negative ones to −1.
fn normalised(kernel: &[f64]) -> Vec<f64> {
    let sum = |sign: f64| kernel.iter().map(|v| (sign * v).max(0.0)).sum::<f64>();
    let (positive, negative) = (sum(1.0), sum(-1.0));
    let scaled = |&v: &f64| v / if v > 0.0 { positive } else { negative };
    kernel.iter().map(scaled).collect()
}
