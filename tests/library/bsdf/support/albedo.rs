//! Directional albedos, and their comparison with tables.

use vkpt::reference::bsdf::choice::reflect_probability;
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::normals::normals_sample;
use vkpt::reference::bsdf::{Interaction, bsdf_sample, carried_mean};
use vkpt::reference::math::dot3;
use vkpt::settings::{LobeChoice, Normals, Settings};

use super::random::random;
use super::rqmc::{Estimate, estimate};
use super::statistics::sidak;
use super::surface::estimator;

/// Of a whole family.
pub const LEVEL: f64 = 0.01;
/// Error that the tables admit, 1e-6, and that of an event that 2¹⁶ points may all miss (3/2¹⁶).
pub const UNCERTAINTY: f64 = 5e-5;
pub const POINTS: usize = 2048;

/// Without radiance scaling, as the tables are.
pub fn flux(lobe: LobeChoice, normals: Normals) -> Settings {
    let mut settings = estimator(lobe, normals);
    settings.model.radiance_scaling = false;
    settings
}

pub fn usual() -> Settings {
    flux(LobeChoice::Fresnel, Normals::Visible)
}

/// The contribution of one micro-normal to wo's side, and to the other: the weights of the two samples through it, each times
/// the probability that it is drawn.
pub fn split(settings: &Settings, at: &Interaction<f64>, u: [f64; 2]) -> [f64; 2] {
    let c = dot3(at.wo, normals_sample(settings, at, u));
    let reflect = reflect_probability(settings, at, c, carried_mean(at, fresnel(at, c)));
    let sample = |u_reflect| bsdf_sample(settings, at, random(0.5, u_reflect, u, [0.5; 2]));
    // below R, at any value of it, and above
    let (near, far) = (sample(0.0), sample(1.0 - f64::EPSILON));
    let transmitted = if far.wi.z < 0.0 { far.weight.x } else { 0.0 };
    [near.weight.x * reflect, transmitted * (1.0 - reflect)]
}

/// Directional albedo: the reflected part, and the transmitted part.
pub fn albedo(settings: &Settings, at: &Interaction<f64>, seed: u64) -> [Estimate; 2] {
    estimate(POINTS, seed, |u: [f64; 2]| split(settings, at, u))
}

/// Estimates and the numbers of a table, by name.
#[derive(Default)]
pub struct Comparison(pub Vec<(String, Estimate, f64)>);

impl Comparison {
    pub fn add(&mut self, name: String, found: Estimate, expected: f64) {
        self.0.push((name, found, expected));
    }
    /// The rejected estimates.
    pub fn rejected(&self) -> Vec<String> {
        let least = sidak(LEVEL, self.0.len());
        let bad = |(_, e, x): &&(String, Estimate, f64)| e.p_value(*x, UNCERTAINTY) < least;
        let text = |(name, e, x): &(String, Estimate, f64)| {
            format!("{name}: {} ± {:.1e}, not {x}", e.mean, e.error)
        };
        self.0.iter().filter(bad).map(text).collect()
    }
    /// The same estimates, with expectations each of which is wrong: by 1 %, or by the resolution of this many points if that
    /// is more.
    fn planted(&self) -> Self {
        let wrong = |e: &Estimate, x: f64| x + (0.01 * x).max(resolution(e));
        let all = self.0.iter();
        Self(
            all.map(|(name, e, x)| (name.clone(), *e, wrong(e, *x)))
                .collect(),
        )
    }
    /// Passes, and every expectation, if planted, would be rejected.
    pub fn assert_holds(&self) {
        let (bad, planted) = (self.rejected(), self.planted().rejected());
        let all = self.0.len();
        assert!(
            bad.is_empty(),
            "{} of {all}:\n{}",
            bad.len(),
            bad.join("\n")
        );
        assert_eq!(
            planted.len(),
            all,
            "of the planted ones:\n{}",
            planted.join("\n")
        );
    }
}

/// The resolution of the points of a Kronecker sequence for an integral over two numbers, [`POINTS`] of them, and over three,
/// four times as many. They leave errors of some 1/[`POINTS`] times the variation of the integrand, over the root of the number
/// of shifts: 1e-4, of which the test needs five and the truth may take as much; over three numbers twice that.
fn resolution(e: &Estimate) -> f64 {
    if e.dimensions == 2 { 1e-3 } else { 2e-3 }
}
