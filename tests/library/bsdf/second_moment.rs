//! The second moment of a weight, by quadrature: the variance that a path gains at a vertex (model.md,
//! "Visible micro-normals").
//!
//! With the choice of lobe by Fresnel, without eta², the mean over RGB of a weight is at most the energy that the model itself
//! gains there, times the excess of G1(wi) over 1 and, for Phong, that of its law over its facets.

use vkpt::reference::bsdf::Interaction;
use vkpt::settings::{Distribution, LobeChoice, Normals};

use super::support::albedo::flux;
use super::support::moments::{Drawn, Moments, by_ggx, moments, own};
use super::support::surface::{DISTRIBUTIONS, dielectric, direction, parameter, seen};
use crate::common::facets::{excess, facets, most_g1};

const WIDTHS: [f64; 8] = [0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0];
const INCIDENCES: u32 = 64;
/// Of the quadrature of the model's energy.
const QUADRATURE: f64 = 1e-5;

/// A distribution of a width, seen at a cosine from a side.
#[derive(Clone, Copy, Debug)]
struct Case {
    distribution: Distribution,
    width: f64,
    outside: bool,
    cos: f64,
}

impl Case {
    fn interaction(self) -> Interaction<f64> {
        let alpha = parameter(self.distribution, self.width);
        let glass = dielectric(self.distribution, alpha, 1.5);
        seen(&glass, self.outside, direction(self.cos, 0.4))
    }

    /// The energy that the model gains here: G1(wo)/wo.z ∫ D(m) max(0, wo·m) dm.
    fn gain(self) -> f64 {
        facets(self.distribution, self.width, self.cos) * (1.0 + QUADRATURE)
    }

    /// The most that a weight may be.
    fn most(self) -> f64 {
        self.gain() * most_g1(self.distribution) * excess(self.distribution, self.width)
    }

    fn found(self, draw: impl Fn(&Interaction<f64>, [f64; 2]) -> Drawn) -> Moments {
        let at = self.interaction();
        moments(&flux(LobeChoice::Fresnel, Normals::Visible), &at, draw)
    }

    /// Whether the weights of normals drawn by `draw` are as small as they should be.
    fn is_bounded(self, draw: impl Fn(&Interaction<f64>, [f64; 2]) -> Drawn) -> bool {
        let (found, most) = (self.found(draw), self.most());
        found.largest <= most && found.square <= most * found.mean && found.mean <= most
    }
}

fn cases(
    distribution: Distribution,
    widths: &[f64],
    stride: usize,
) -> impl Iterator<Item = Case> + '_ {
    let sides = widths.iter().flat_map(|w| [true, false].map(|s| (*w, s)));
    sides.flat_map(move |(width, outside)| {
        let cosine = |i: u32| (f64::from(i) + 0.5) / f64::from(INCIDENCES);
        (0..INCIDENCES).step_by(stride).map(move |i| Case {
            distribution,
            width,
            outside,
            cos: cosine(i),
        })
    })
}

fn all_are_bounded(stride: usize) {
    for distribution in DISTRIBUTIONS {
        for case in cases(distribution, &WIDTHS, stride) {
            assert!(
                case.is_bounded(own),
                "{case:?}: {:?}, {}",
                case.found(own),
                case.most()
            );
            // the claim: 4e-3 above the model's own energy, 3.3e-2 for Phong
            let promised = match distribution {
                Distribution::Phong => 1.033,
                _ => 1.0,
            };
            assert!(case.most() <= (promised + 4e-3) * case.gain(), "{case:?}");
        }
    }
}

#[test]
fn weights_are_bounded_by_the_models_energy() {
    all_are_bounded(9);
}

#[test]
#[ignore = "a minute: all 64 incidences"]
fn weights_are_bounded_by_the_models_energy_at_every_incidence() {
    all_are_bounded(1);
}

/// Normals of the GGX of the same width, as all distributions once had, have weights whose square means more than 1.
#[test]
fn the_ggx_proposal_is_rejected() {
    for distribution in [Distribution::Beckmann, Distribution::Phong] {
        let all: Vec<Case> = cases(distribution, &[0.1, 0.3], 9).collect();
        let bad = all.iter().filter(|c| !c.is_bounded(by_ggx)).count();
        assert_eq!(bad, all.len(), "{distribution:?}");
        let inside = Case {
            distribution,
            width: 0.1,
            outside: false,
            cos: 0.2,
        };
        let (once, now) = (inside.found(by_ggx).square, inside.found(own).square);
        assert!(once > 1.05 && now <= 1.0, "{distribution:?}: {once}, {now}");
    }
    // and GGX is its own
    let ggx = Case {
        distribution: Distribution::Ggx,
        width: 0.3,
        outside: false,
        cos: 0.2,
    };
    assert_eq!(ggx.found(by_ggx).square, ggx.found(own).square);
}
