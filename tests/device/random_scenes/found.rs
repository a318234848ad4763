//! Failures that random scenes have found, shrunk: each a separate test.

use vkpt::settings::{Connect, Settings};

use super::case::Case;
use super::interface::{Interface, excess};
use super::samples::{By, COMPOSED, made};
use super::sound::broken;

/// A ball of rough glass whose index is 1e17, seen from within: n² came to infinity before the Jacobian, which is about
/// n⁻², made it small again.
#[test]
fn radiance_out_of_the_densest_glass_is_finite() {
    let case = Case {
        text: "screen 2 2\ncamera 0 0 0.1  0.2\nbackground 0 0 0\n\
               brdf 0 0 0  0 0 0  1e-4  1 1 1  143223279273723710\nbox 0 0 1e-7  0.5 0.5 0.01\n"
            .to_owned(),
        settings: Settings::default(),
        seed: 65_974_912,
    };
    for by in [By::References, COMPOSED] {
        let all = made(by, &case, &case.prepared(), 8);
        assert_eq!(all.and_then(|all| broken(&all, false)), None);
    }
}

/// All but a thousandth is reflected, as far as f32 resolves: (1 − F)/(1 − F̄) was 1.00007, F̄ being F but for a rounding.
#[test]
fn transmission_of_grey_glass_near_total_reflection_weighs_1() {
    let mut settings = Settings::default();
    settings.model.radiance_scaling = false;
    settings.estimator.connect = Connect::Bsdf;
    let brdf = "fresnel exact\nbrdf 0 0 0  0 0 0  0  1 1 1  879914278514717.3";
    let interface = Interface::of(false, 1.0, brdf, settings, 0);
    let prepared = interface.case.prepared();
    let limits = interface.limits(&prepared).expect("glass");
    let all = made(By::References, &interface.case, &prepared, 128).expect("the references");
    assert_eq!(excess(&limits, &all, &interface.case.settings, 1e-6), None);
}

/// If a radius is below the resolution of single precision, a path left a solid as if it entered it again; at an index-matched
/// interface, for ever.
#[test]
fn no_path_is_endless_where_a_radius_is_not_resolved() {
    for (eye, shape) in [
        ("1e-23 2e-23 4e-23", "sphere 0 0 0  3e-24"),
        ("0 1e-22 .5", "cylinder 0 0 -1  0 0 2  3e-24"),
    ] {
        let case = Case {
            text: format!(
                "screen 8 8\ncamera {eye}  .3\nbackground 1 1 1\nbrdf 0 0 0  0 0 0  0  1 1 1  1\n\
                 {shape}\nsphere 3 0 0  .5\nsphere -3 0 0  .5\n"
            ),
            settings: Settings::default(),
            seed: 0,
        };
        for by in [By::References, COMPOSED] {
            let all = made(by, &case, &case.prepared(), 16);
            assert_eq!(all.and_then(|all| broken(&all, false)), None);
        }
    }
}
