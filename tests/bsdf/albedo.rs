//! Check 5 and the tables of energies: mean weights of samples against quadratures that others made.

use std::f64::consts::LN_2;

use glam::DVec3;
use vkpt::reference::bsdf::choice::reflect_probability;
use vkpt::reference::bsdf::distribution::{distribution_d, distribution_g1};
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::normals::{normals_pdf, normals_sample};
use vkpt::reference::bsdf::{Interaction, bsdf_sample};
use vkpt::reference::math::{dot3, max2, mean3};
use vkpt::settings::{Distribution, LobeChoice, Normals, Settings};

use crate::support::rqmc::{Estimate, estimate};
use crate::support::statistics::sidak;
use crate::support::surface::{dielectric, direction, estimator, opaque, parameter, seen};
use crate::support::table::Table;

/// Of a whole family.
const LEVEL: f64 = 0.01;
/// Error that the tables admit, 1e-6, and what an event has that none of 2¹⁶ points need to have met (3/2¹⁶).
const UNCERTAINTY: f64 = 5e-5;
const POINTS: usize = 2048;

/// Without radiance scaling, as the tables are.
fn flux(lobe: LobeChoice, normals: Normals) -> Settings {
    let mut settings = estimator(lobe, normals);
    settings.model.radiance_scaling = false;
    settings
}

fn usual() -> Settings {
    flux(LobeChoice::Fresnel, Normals::Visible)
}

/// What one micro-normal sends to wo's side, and to the other: the weights of the two samples through it, each
/// times the probability that it is drawn.
fn split(settings: &Settings, at: &Interaction<f64>, u: [f64; 2]) -> [f64; 2] {
    let c = dot3(at.wo, normals_sample(settings, at, u));
    let reflect = reflect_probability(settings, at, c, mean3(fresnel(at, c)));
    let sample = |u_reflect| bsdf_sample(settings, at, 0.5, u_reflect, u, [0.5; 2]);
    // below R, whatever it is, and above
    let (near, far) = (sample(0.0), sample(1.0 - f64::EPSILON));
    let transmitted = if far.wi.z < 0.0 { far.weight.x } else { 0.0 };
    [near.weight.x * reflect, transmitted * (1.0 - reflect)]
}

/// Directional albedo: what is reflected, and what is transmitted.
fn albedo(settings: &Settings, at: &Interaction<f64>, seed: u64) -> [Estimate; 2] {
    estimate(POINTS, seed, |u: [f64; 2]| split(settings, at, u))
}

/// Estimates and the numbers of a table, by name.
#[derive(Default)]
struct Comparison(Vec<(String, Estimate, f64)>);

impl Comparison {
    fn add(&mut self, name: String, found: Estimate, expected: f64) {
        self.0.push((name, found, expected));
    }
    /// What is rejected, if all expectations were `factor` times what they are.
    fn rejected(&self, factor: f64) -> Vec<String> {
        let least = sidak(LEVEL, self.0.len());
        let bad = |(_, e, x): &&(String, Estimate, f64)| e.p_value(factor * x, UNCERTAINTY) < least;
        let text = |(name, e, x): &(String, Estimate, f64)| {
            format!("{name}: {} ± {:.1e}, not {x}", e.mean, e.error)
        };
        self.0.iter().filter(bad).map(text).collect()
    }
    /// Holds, and would not with expectations one percent off in most of them.
    fn assert_holds(&self) {
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

#[test]
fn rough_dielectrics() {
    let Some(table) = Table::open("albedo_dielectric.csv") else {
        return;
    };
    let mut all = Comparison::default();
    // the erf form of Beckmann's G1 is not this model's
    for (i, row) in table
        .rows()
        .filter(|r| r.text("D") != "beckmann_erf")
        .enumerate()
    {
        let (d, param) = (row.distribution(), row.number("param"));
        let wo = direction(row.number("cos"), i as f64);
        let at = seen(&dielectric(d, param, row.number("ior")), row.outside(), wo);
        for lobe in [LobeChoice::Fresnel, LobeChoice::Norms] {
            let mut settings = flux(lobe, Normals::Visible);
            let mut at = at;
            at.material.p_r = 0.4;
            let [r, t] = albedo(&settings, &at, i as u64);
            all.add(format!("R, row {i}, {lobe:?}"), r, row.number("R"));
            all.add(format!("T, row {i}, {lobe:?}"), t, row.number("T"));
            settings.model.radiance_scaling = true;
            let [_, scaled] = albedo(&settings, &at, i as u64);
            let unscaled = scaled.mean / (at.eta * at.eta);
            assert!((unscaled - t.mean).abs() < 1e-12, "η² in row {i}");
        }
        let mirror = seen(&opaque(d, param, DVec3::ZERO, DVec3::ONE), true, wo);
        let [r, _] = albedo(&usual(), &mirror, i as u64);
        all.add(format!("F = 1, row {i}"), r, row.number("R_F1"));
    }
    all.assert_holds();
}

#[test]
fn ggx_of_width_one_reflects_1_minus_ln_2() {
    let m = opaque(Distribution::Ggx, 1.0, DVec3::ZERO, DVec3::ONE);
    let at = seen(&m, true, direction(1.0, 0.0));
    for normals in [Normals::Visible, Normals::Distribution] {
        let settings = flux(LobeChoice::Fresnel, normals);
        let [r] = estimate(16 * POINTS, 1, |u: [f64; 2]| [split(&settings, &at, u)[0]]);
        assert!(
            r.error < 2e-5 && r.p_value(1.0 - LN_2, 0.0) > LEVEL,
            "{r:?}, {normals:?}"
        );
        assert!(r.p_value(1.001 * (1.0 - LN_2), 0.0) < 1e-6);
    }
}

#[test]
fn energy_that_single_scattering_loses() {
    let Some(table) = Table::open("multiscatter_loss.csv") else {
        return;
    };
    let mut all = Comparison::default();
    for (i, row) in table.rows().enumerate() {
        let (d, alpha) = (row.distribution(), row.number("alpha"));
        let metal = opaque(d, alpha, DVec3::ZERO, DVec3::ONE);
        for cosine in ["0.1", "0.3", "0.5", "0.8", "1"] {
            let z = cosine.parse().expect("a number");
            let at = seen(&metal, true, direction(z, 0.3));
            let [r, _] = albedo(&usual(), &at, i as u64);
            all.add(
                format!("F = 1, row {i}, cos {cosine}"),
                r,
                row.number(&format!("E_F1_cos{cosine}")),
            );
        }
        for side in ["outside", "inside"] {
            let glass = dielectric(d, alpha, 1.5);
            // over the hemisphere of wo, by its cosine
            let [r, both] = estimate(POINTS, i as u64, |[z2, x, y]: [f64; 3]| {
                let at = seen(&glass, side == "outside", direction((1.0 - z2).sqrt(), 0.3));
                let [r, t] = split(&usual(), &at, [x, y]);
                [r, r + t]
            });
            all.add(
                format!("R, row {i}, {side}"),
                r,
                row.number(&format!("R_avg_{side}")),
            );
            all.add(
                format!("R + T, row {i}, {side}"),
                both,
                row.number(&format!("RT_avg_{side}")),
            );
        }
    }
    all.assert_holds();
}

/// ∫ D G1(wo) max(wo·m, 0)/cos over m, which is 1 for a true Smith pair; Phong's is above.
#[test]
fn weak_normalisation() {
    let Some(table) = Table::open("weak_normalisation.csv") else {
        return;
    };
    let mut all = Comparison::default();
    for (i, row) in table
        .rows()
        .filter(|r| r.text("D") != "beckmann_erf")
        .enumerate()
    {
        let metal = opaque(
            row.distribution(),
            row.number("param"),
            DVec3::ZERO,
            DVec3::ONE,
        );
        for cosine in ["0.02", "0.1", "0.3", "0.6", "0.9"] {
            let at = seen(
                &metal,
                true,
                direction(cosine.parse().expect("a number"), 0.3),
            );
            let [normal] = estimate(2 * POINTS, i as u64, |u: [f64; 2]| {
                let m = normals_sample(&usual(), &at, u);
                let c = max2(dot3(at.wo, m), 0.0);
                let pm = normals_pdf(&usual(), &at, m);
                let visible =
                    distribution_d(&at.material, m) * distribution_g1(&at.material, at.wo) * c
                        / at.wo.z;
                [if pm > 0.0 { visible / pm } else { 0.0 }]
            });
            all.add(
                format!("I, row {i}, cos {cosine}"),
                normal,
                row.number(&format!("I_{cosine}")),
            );
            let [r, _] = albedo(&usual(), &at, i as u64);
            all.add(
                format!("F = 1, row {i}, cos {cosine}"),
                r,
                row.number(&format!("E_F1_{cosine}")),
            );
        }
    }
    all.assert_holds();
}

/// Check 8, α → 0: the rough interface, and the smooth one that stands in for it below the limit.
#[test]
fn alpha_to_zero() {
    let Some(table) = Table::open("alpha_to_zero.csv") else {
        return;
    };
    let mut all = Comparison::default();
    for (i, row) in table.rows().enumerate() {
        let (d, alpha) = (row.distribution(), row.number("alpha"));
        let wo = direction(row.number("cos"), 0.3);
        let at = |width: f64| seen(&dielectric(d, parameter(d, width), 1.5), row.outside(), wo);
        let [r, t] = albedo(&usual(), &at(alpha), i as u64);
        let smooth = at(0.0);
        for (name, rough, reflect) in [("R", r, 0.0), ("T", t, 1.0 - f64::EPSILON)] {
            all.add(format!("{name}, row {i}"), rough, row.number(name));
            let s = bsdf_sample(&usual(), &smooth, 0.5, reflect, [0.5; 2], [0.5; 2]);
            let f = fresnel(&smooth, wo.z).x;
            let share = if name == "R" { f } else { 1.0 - f };
            let expected = row.number(&format!("{name}_smooth"));
            assert!(
                (s.weight.x * share - expected).abs() < 1e-12,
                "{name}, smooth, row {i}"
            );
        }
    }
    let bad = all.rejected(1.0);
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

/// Check 8, ior → 1: T goes to G1(wo), through the rough interface and the weak one alike.
#[test]
fn ior_to_one() {
    let Some(table) = Table::open("ior_to_one.csv") else {
        return;
    };
    let mut all = Comparison::default();
    for (i, row) in table.rows().enumerate() {
        let wo = direction(row.number("cos"), 0.3);
        let m = dielectric(Distribution::Ggx, row.number("alpha"), row.number("n"));
        let at = seen(&m, true, wo);
        let g1 = distribution_g1(&at.material, wo);
        assert!((g1 - row.number("G1_wo")).abs() < 1e-12, "G1, row {i}");
        let [r, t] = albedo(&usual(), &at, i as u64);
        all.add(format!("T, row {i}, {:?}", m.kind), t, row.number("T"));
        assert!((r.mean - row.number("R")).abs() < 6.0 * r.error + 1e-3 * row.number("R"));
    }
    let bad = all.rejected(1.0);
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}
