//! The limits of the model for α → 0 and ior → 1, and the kinds that replace it there; energy.

use vkpt::reference::bsdf::bsdf_sample;
use vkpt::reference::bsdf::distribution::distribution_g1;
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::settings::Distribution;

use super::support::albedo::{Comparison, albedo, usual};
use super::support::random::random;
use super::support::surface::{dielectric, direction, parameter, seen};
use crate::common::table::Table;

/// α → 0: the rough interface, and the smooth one that replaces it below the limit (model.md,
/// "Limits of width and index").
#[test]
fn alpha_to_zero() {
    let table = Table::open("alpha_to_zero.csv");
    let mut all = Comparison::default();
    for (i, row) in table.rows().enumerate() {
        let (d, alpha) = (row.distribution(), row.number("alpha"));
        let wo = direction(row.number("cos"), 0.3);
        let at = |width: f64| seen(&dielectric(d, parameter(d, width), 1.5), row.outside(), wo);
        let [r, t] = albedo(&usual(), &at(alpha), i as u64);
        let smooth = at(0.0);
        for (name, rough, reflect) in [("R", r, 0.0), ("T", t, 1.0 - f64::EPSILON)] {
            all.add(format!("{name}, row {i}"), rough, row.number(name));
            let s = bsdf_sample(&usual(), &smooth, random(0.5, reflect, [0.5; 2], [0.5; 2]));
            let f = fresnel(&smooth, wo.z).x;
            let share = if name == "R" { f } else { 1.0 - f };
            let expected = row.number(&format!("{name}_smooth"));
            assert!(
                (s.weight.x * share - expected).abs() < 1e-12,
                "{name}, smooth, row {i}"
            );
        }
    }
    all.assert_holds();
}

/// ior → 1: T goes to G1(wo), through the rough interface and the weak one alike (model.md,
/// "Limits of width and index").
#[test]
fn ior_to_one() {
    let table = Table::open("ior_to_one.csv");
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
    all.assert_holds();
}

/// R + T ≤ 1 for GGX, and for Beckmann up to the 3.2e-3 of its rational G1 (model.md, "Energy").
#[test]
fn rough_interfaces_gain_no_energy() {
    let mut least = 1.0f64;
    for (d, excess) in [(Distribution::Ggx, 0.0), (Distribution::Beckmann, 3.2e-3)] {
        for (i, alpha) in [0.05, 0.2, 0.5, 1.0].into_iter().enumerate() {
            for ior in [1.1, 1.5, 2.5, 1.0 / 1.5] {
                for (outside, cosine) in [true, false].into_iter().zip([0.05, 0.4]) {
                    let m = dielectric(d, alpha, ior);
                    let at = seen(&m, outside, direction(cosine, 0.3));
                    let [r, t] = albedo(&usual(), &at, i as u64);
                    let (sum, error) = (r.mean + t.mean, r.error + t.error);
                    assert!(
                        sum - 4.0 * error <= 1.0 + excess,
                        "{d:?} {alpha} {ior}: {sum}"
                    );
                    least = least.min(sum);
                }
            }
        }
    }
    // rough glass loses much to facets that hide each other
    assert!(least < 0.7, "{least}");
}
