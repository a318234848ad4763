//! Nearly the visible normals of Phong; twin of `shaders/bsdf/normals/visible/phong.glsl`.
//!
//! Let m lean by η across the plane of incidence and by ψ along it: m·N = cos η cos ψ, dm = cos η dη dψ. The density of
//! Phong's facets as `wo` sees them is then a product,
//!
//! cosⁿ(m·N) wo·m dm = cosⁿ⁺² η dη · (cos θ cosⁿ⁺¹ ψ + sin θ cosⁿ ψ sin ψ) dψ,
//!
//! whose last term has an integral, −cosⁿ⁺¹ ψ/(n + 1). A power of a cosine is nearly a Gaussian of x = ±√(−κ ln cos ψ)
//! (Wallace, Bounds on Normal Approximations to Student's and the Chi-Square Distributions, 1959): for κ = k + ½
//!
//! e^(−x²) dx = √(κ/2) h(ψ) cosᵏ ψ dψ, h² = sinh y/y, y = −ln cos ψ.
//!
//! sinh y ≥ y, so h ≥ 1: the density drawn here, h(η) (cos θ cosⁿ⁺¹ ψ h(ψ) + sin θ cosⁿ ψ sin ψ), is nowhere less than
//! the visible one, and no weight is above its mean, (model's gain) · G1(wi), by more than the ratio of the integrals.
//! That is at most that of √(2π/κ) to ∫ cosᵏ ψ dψ for k = n + 1, times that for n + 2: 1.033 for n = 0, 1.0142 for 1,
//! 1.0026 for 5, 1.0009 for 10.

use super::incidence::{above_zero, incidence, incidence_from_frame, incidence_to_frame};
use super::slope::{SlopeLaw, slope_law, slope_sample, slope_share};
use crate::reference::bsdf::distribution::phong::phong_d;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::math::{Real, Vec3, dot3, min2, normalize3, vec3};

/// κ of the lean along the plane of incidence, k = α_p + 1.
pub fn phong_along<F: Real>(alpha: F) -> F {
    alpha + F::new(1.5)
}

/// κ of the lean across it, k = α_p + 2.
pub fn phong_across<F: Real>(alpha: F) -> F {
    alpha + F::new(2.5)
}

/// x of the lean along the plane, of density cos θ cosⁿ⁺¹ ψ h(ψ) + sin θ cosⁿ ψ sin ψ in ψ: p = cos θ √(π/2κ), r = sin θ/(n + 1),
/// cosⁿ⁺¹ ψ = e^(−(1 − γ)x²) with γ = 1/(2κ). `wo` sees down to cos ψ = sin θ, −ln sin θ = ½ ln(1 + cot² θ).
pub fn phong_law<F: Real>(wo: Vec3<F>, sine: F, alpha: F) -> SlopeLaw<F> {
    let half = F::new(0.5);
    let kappa = phong_along(alpha);
    let up = wo.z.abs();
    let p = up * (F::new(std::f64::consts::FRAC_PI_2) / kappa).sqrt();
    let cot = up / sine;
    let limit = (half * kappa * F::log1p(cot * cot)).sqrt();
    slope_law(p, sine / (alpha + F::one()), half / kappa, limit)
}

/// Sine and cosine of the lean at x.
pub fn phong_lean<F: Real>(x: F, kappa: F) -> (F, F) {
    let y = x * x / kappa;
    let sine = (-F::expm1(-(y + y))).sqrt();
    (if x < F::zero() { -sine } else { sine }, F::exp(-y))
}

/// h = √(sinh y/y) of the lean whose tangent squared is `t2`: y = ½ ln(1 + t2), sinh y = t2/(2√(1 + t2)).
pub fn phong_excess<F: Real>(t2: F) -> F {
    // beyond, a Phong lobe has no facets, and squares overflow
    let t2 = min2(t2, F::new(1e30));
    let h = (t2 / ((F::one() + t2).sqrt() * F::log1p(t2))).sqrt();
    if t2 > F::zero() { h } else { F::one() }
}

/// A micro-normal with the density of [`visible_phong_pdf`].
pub fn visible_phong_sample<F: Real>(at: &Interaction<F>, u: [F; 2]) -> Vec3<F> {
    let alpha = at.material.alpha;
    let plane = incidence(at.wo);
    let along = slope_sample(phong_law(at.wo, plane.sine, alpha), u[0]);
    let (sin_psi, cos_psi) = phong_lean(along, phong_along(alpha));
    let across = F::erfc_inverse(F::new(2.0) * above_zero(u[1]));
    let (sin_eta, cos_eta) = phong_lean(across, phong_across(alpha));
    let m = vec3(cos_eta * sin_psi, sin_eta, cos_eta * cos_psi);
    normalize3(incidence_to_frame(plane, m))
}

/// D(m) h(η) (wo.z m.z h(ψ) + sin θ m.x) 2π/(n + 2)/(√(2π/κ) G(−limit)), m.x along the plane of incidence.
pub fn visible_phong_pdf<F: Real>(at: &Interaction<F>, m: Vec3<F>) -> F {
    let alpha = at.material.alpha;
    let plane = incidence(at.wo);
    let law = phong_law(at.wo, plane.sine, alpha);
    let whole = slope_share(law, -law.limit).share;
    let v = incidence_from_frame(plane, m);
    let h_psi = phong_excess(v.x * v.x / (v.z * v.z));
    let h_eta = phong_excess(v.y * v.y / (v.x * v.x + v.z * v.z));
    let c = at.wo.z * v.z * h_psi + plane.sine * v.x;
    // 2π/√(2π/κ) = √(2πκ)
    let scale = (F::new(std::f64::consts::TAU) * phong_across(alpha)).sqrt()
        / ((alpha + F::new(2.0)) * whole);
    let pdf = phong_d(m, alpha) * h_eta * c * scale;
    if dot3(at.wo, m) > F::zero() {
        pdf
    } else {
        F::zero()
    }
}
