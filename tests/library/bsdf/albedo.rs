//! Mean weights of samples against quadratures that others made (model.md, "Albedo of one interface").

use std::f64::consts::LN_2;

use glam::DVec3;
use vkpt::reference::bsdf::distribution::{distribution_d, distribution_g1};
use vkpt::reference::bsdf::normals::{normals_pdf, normals_sample};
use vkpt::reference::math::{dot3, max2};
use vkpt::settings::{Distribution, LobeChoice, Normals};

use super::support::albedo::{Comparison, LEVEL, POINTS, albedo, flux, split, usual};
use super::support::rqmc::estimate;
use super::support::surface::{dielectric, direction, opaque, seen};
use crate::common::table::Table;

#[test]
fn rough_dielectrics() {
    let table = Table::open("albedo_dielectric.csv");
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
    let table = Table::open("multiscatter_loss.csv");
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
            let [r, both] = estimate(4 * POINTS, i as u64, |[z2, x, y]: [f64; 3]| {
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
    let table = Table::open("weak_normalisation.csv");
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
