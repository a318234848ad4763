//! Directional albedos, and their comparison with tables.

use vkpt::reference::bsdf::choice::reflect_probability;
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::normals::normals_sample;
use vkpt::reference::bsdf::{Interaction, bsdf_sample};
use vkpt::reference::math::{dot3, mean3};
use vkpt::settings::{LobeChoice, Normals, Settings};

use super::random::random;
use super::rqmc::{Estimate, estimate};
use super::statistics::sidak;
use super::surface::estimator;

/// Of a whole family.
pub const LEVEL: f64 = 0.01;
/// Error that the tables admit, 1e-6, and what an event has that none of 2¹⁶ points need to have met (3/2¹⁶).
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

/// What one micro-normal sends to wo's side, and to the other: the weights of the two samples through it, each
/// times the probability that it is drawn.
pub fn split(settings: &Settings, at: &Interaction<f64>, u: [f64; 2]) -> [f64; 2] {
    let c = dot3(at.wo, normals_sample(settings, at, u));
    let reflect = reflect_probability(settings, at, c, mean3(fresnel(at, c)));
    let sample = |u_reflect| bsdf_sample(settings, at, random(0.5, u_reflect, u, [0.5; 2]));
    // below R, whatever it is, and above
    let (near, far) = (sample(0.0), sample(1.0 - f64::EPSILON));
    let transmitted = if far.wi.z < 0.0 { far.weight.x } else { 0.0 };
    [near.weight.x * reflect, transmitted * (1.0 - reflect)]
}

/// Directional albedo: what is reflected, and what is transmitted.
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
    /// What is rejected, if all expectations were `factor` times what they are.
    pub fn rejected(&self, factor: f64) -> Vec<String> {
        let least = sidak(LEVEL, self.0.len());
        let bad = |(_, e, x): &&(String, Estimate, f64)| e.p_value(factor * x, UNCERTAINTY) < least;
        let text = |(name, e, x): &(String, Estimate, f64)| {
            format!("{name}: {} ± {:.1e}, not {x}", e.mean, e.error)
        };
        self.0.iter().filter(bad).map(text).collect()
    }
    /// Holds, and would not with expectations one percent off in most of them.
    pub fn assert_holds(&self) {
        let bad = self.rejected(1.0);
        assert!(
            bad.is_empty(),
            "{} of {}:\n{}",
            bad.len(),
            self.0.len(),
            bad.join("\n")
        );
        let (seen, all) = (self.rejected(1.01).len(), self.0.len());
        assert!(
            10 * seen > 9 * all,
            "an error of 1 % is seen in {seen} of {all} only"
        );
    }
}
