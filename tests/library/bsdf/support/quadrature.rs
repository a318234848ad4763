//! Adaptive Gauss–Legendre quadrature.

/// Nodes in one direction of one cell.
const N: usize = 8;

/// Nodes and weights of Gauss–Legendre on [−1, 1], by Newton's method on the Legendre polynomial.
fn nodes() -> [(f64, f64); N] {
    std::array::from_fn(|i| {
        let mut x = ((i as f64 + 0.75) / (N as f64 + 0.5) * std::f64::consts::PI).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut p, mut before) = (1.0, 0.0);
            for k in 0..N {
                let k = k as f64;
                (p, before) = (((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0), p);
            }
            slope = N as f64 * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// ∫ f over an interval, in `parts` equal parts.
pub fn integrate(range: [f64; 2], parts: usize, f: impl Fn(f64) -> f64) -> f64 {
    let half = (range[1] - range[0]) / (2 * parts) as f64;
    let part = |i: usize| {
        let middle = range[0] + (2 * i + 1) as f64 * half;
        nodes()
            .iter()
            .map(|(x, w)| w * half * f(middle + half * x))
            .sum::<f64>()
    };
    (0..parts).map(part).sum()
}

/// The rectangle [x.0, x.1] × [y.0, y.1].
type Rect = [[f64; 2]; 2];

/// Integrates over rectangles.
pub struct Quadrature {
    nodes: [(f64, f64); N],
    tolerance: f64,
}

impl Quadrature {
    /// `tolerance`: of each call of [`integrate`](Self::integrate).
    pub fn new(tolerance: f64) -> Self {
        Self {
            nodes: nodes(),
            tolerance,
        }
    }

    /// ∫ f over a rectangle, which is first cut into `cuts`² cells so that narrow peaks are seen.
    pub fn integrate(&self, rect: Rect, cuts: usize, f: &impl Fn(f64, f64) -> f64) -> f64 {
        let tolerance = self.tolerance / (cuts * cuts) as f64;
        let cell = |k: usize| {
            let cell = part(rect, cuts, k);
            self.refined(cell, self.cell(cell, f), tolerance, 8, f)
        };
        (0..cuts * cuts).map(cell).sum()
    }

    fn refined(
        &self,
        rect: Rect,
        coarse: f64,
        tolerance: f64,
        depth: u32,
        f: &impl Fn(f64, f64) -> f64,
    ) -> f64 {
        if coarse == 0.0 {
            return 0.0;
        }
        let quarters: [Rect; 4] = std::array::from_fn(|k| part(rect, 2, k));
        let values = quarters.map(|q| self.cell(q, f));
        let fine: f64 = values.iter().sum();
        if depth == 0 || (fine - coarse).abs() <= tolerance {
            return fine;
        }
        let finer = |k: usize| self.refined(quarters[k], values[k], tolerance / 2.0, depth - 1, f);
        (0..4).map(finer).sum()
    }

    /// One tensor rule; 0 where the function is nothing to speak of.
    fn cell(&self, rect: Rect, f: &impl Fn(f64, f64) -> f64) -> f64 {
        let [[x0, x1], [y0, y1]] = rect;
        let (hx, hy) = (0.5 * (x1 - x0), 0.5 * (y1 - y0));
        let mut sum = 0.0;
        for (x, wx) in self.nodes {
            for (y, wy) in self.nodes {
                sum += wx * wy * f(x0 + hx * (1.0 + x), y0 + hy * (1.0 + y));
            }
        }
        let integral = sum * hx * hy;
        if integral.abs() < 1e-3 * self.tolerance / 100.0 {
            0.0
        } else {
            integral
        }
    }
}

/// Cell k of cuts².
fn part(rect: Rect, cuts: usize, k: usize) -> Rect {
    let axis = |[a, b]: [f64; 2], i: usize| {
        let at = |j: usize| a + (b - a) * j as f64 / cuts as f64;
        [at(i), at(i + 1)]
    };
    [axis(rect[0], k % cuts), axis(rect[1], k / cuts)]
}

#[test]
fn quadrature_finds_known_integrals() {
    let q = Quadrature::new(1e-9);
    // a Gauss peak of width 0.01 in the middle of the square
    let peak = |x: f64, y: f64| (-((x - 0.4).powi(2) + (y - 0.6).powi(2)) / 1e-4).exp();
    let volume = q.integrate([[0.0, 1.0], [0.0, 1.0]], 5, &peak);
    assert!((volume / (std::f64::consts::PI * 1e-4) - 1.0).abs() < 1e-6);
    assert!((integrate([0.0, 2.0], 3, f64::exp) - 2f64.exp_m1()).abs() < 1e-13);
}
