//! The visible part of a surface's facets, by quadrature: the energy that the model gains or loses there.
//!
//! Smith's G1 is what makes G1(wo)/wo.z ∫ D(m) max(0, wo·m) dm 1 (Heitz, Understanding the Masking-Shadowing Function in
//! Microfacet-Based BRDFs, JCGT 2014, eq. 16). GGX has Smith's own; Beckmann's rational one is within 3.1e-3 of it, and
//! Phong's is far from it.

use std::f64::consts::{PI, TAU};

use statrs::function::gamma::ln_gamma;
use vkpt::settings::Distribution;

/// Smith's masking as the model has it, z = cos θ > 0: Walter et al. 2007, eqs. 34 and 27 (rational).
pub fn g1(distribution: Distribution, width: f64, z: f64) -> f64 {
    let x = z / (width * ((1.0 - z) * (1.0 + z)).sqrt());
    match distribution {
        Distribution::Ggx => 2.0 / (1.0 + x.recip().hypot(1.0)),
        _ if x < 1.6 => x * (3.535 + 2.181 * x) / (1.0 + x * (2.276 + 2.577 * x)),
        _ => 1.0,
    }
}

/// The most that G1 comes to: the rational one is above 1 between x = 1.548 and 1.6, most at 1.589, by 6.14e-5.
pub fn most_g1(distribution: Distribution) -> f64 {
    match distribution {
        Distribution::Ggx => 1.0,
        Distribution::Beckmann | Distribution::Phong => 1.0 + 6.2e-5,
    }
}

/// (sin θ, cos θ) of the micro-normal beyond which a share `rest` of D(m)·(m·N) lies: Walter et al. 2007, eqs. 28, 35; Phong's
/// cos θ = rest^(1/(α_p + 2)), 1/(α_p + 2) = width²/2.
fn micro_normal(distribution: Distribution, width: f64, rest: f64) -> (f64, f64) {
    let tan = match distribution {
        Distribution::Ggx => width * ((1.0 - rest) / rest).sqrt(),
        Distribution::Beckmann => width * (-rest.ln()).sqrt(),
        Distribution::Phong => {
            let ln_cos = rest.ln() * width * width / 2.0;
            return ((-(2.0 * ln_cos).exp_m1()).sqrt(), ln_cos.exp());
        }
    };
    (tan / tan.hypot(1.0), 1.0 / tan.hypot(1.0))
}

/// ∫ max(0, wo·m) dφ about N, for wo = (s, 0, z) and m at (sin, cos).
fn seen((s, z): (f64, f64), (sin, cos): (f64, f64)) -> f64 {
    let (flat, steep) = (z * cos, s * sin);
    if flat >= steep {
        return TAU * flat;
    }
    let half = (-flat / steep).acos();
    2.0 * (flat * half + steep * half.sin())
}

/// G1(wo)/wo.z ∫ D(m) max(0, wo·m) dm, z = wo.z.
pub fn facets(distribution: Distribution, width: f64, z: f64) -> f64 {
    const NODES: u32 = 1 << 12;
    let s = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    // Over the share v² of D(m)·(m·N) that lies beyond m, v uniform: D(m) dm = 2v dv dφ/(2π cos θ). So the integrand is
    // bounded, where 1/cos θ alone has a root at the horizon.
    let node = |i: u32| {
        let v = (f64::from(i) + 0.5) / f64::from(NODES);
        let m = micro_normal(distribution, width, v * v);
        seen((s, z), m) * 2.0 * v / (TAU * m.1)
    };
    let sum: f64 = (0..NODES).map(node).sum();
    g1(distribution, width, z) / z * sum / f64::from(NODES)
}

/// By how much the weights of visible normals may be above their mean, apart from G1(wi): Phong's law has that much more
/// than its visible facets, √(2π/(k + ½)) for ∫ cosᵏ along the plane of incidence, k = α_p + 1, and across it, k = α_p + 2
/// (model.md, "Visible micro-normals").
pub fn excess(distribution: Distribution, width: f64) -> f64 {
    let alpha = 2.0 / (width * width) - 2.0;
    // ∫ cosᵏ over (−π/2, π/2) is √π Γ((k + 1)/2)/Γ(k/2 + 1)
    let share = |k: f64| {
        let ln_integral = 0.5 * PI.ln() + ln_gamma((k + 1.0) / 2.0) - ln_gamma(k / 2.0 + 1.0);
        (TAU / (k + 0.5)).sqrt() / ln_integral.exp()
    };
    match distribution {
        // beyond, the rest of it is lost in the logarithms
        Distribution::Phong if alpha < 1e4 => share(alpha + 1.0) * share(alpha + 2.0),
        Distribution::Phong => 1.0 + 1e-8,
        Distribution::Ggx | Distribution::Beckmann => 1.0,
    }
}
