//! Chains of internal reflections, as along the rim of a ball of glass: the variance of a product of weights.
//!
//! In a ball a chord meets the surface at the angle at which it left it, so that wo.z is all that a path remembers. Up to n
//! reflections, then light of radiance 1: V is the path's mean, S its second moment, U the second moment of one whose every
//! weight is the most that the model's energy asks for, of which S must stay below.

use vkpt::reference::bsdf::Interaction;
use vkpt::reference::math::mean3;
use vkpt::settings::{Distribution, LobeChoice, Normals};

use super::support::albedo::flux;
use super::support::moments::{Drawn, by_ggx, nodes, own, ways};
use super::support::surface::{DISTRIBUTIONS, dielectric, direction, parameter, seen};
use crate::common::facets::{excess, facets, most_g1};

/// Cosines at which chains are begun and continued.
const STATES: usize = 64;
const SIDE: u32 = 32;
const REFLECTIONS: usize = 1000;

/// Means over the samples of a vertex, to be applied to those of the rest of the path, by its cosine.
struct Step {
    /// Weights, their squares, and weights times the most that the energy asks for, of reflections from state to state.
    reflected: [Vec<[f64; STATES]>; 3],
    /// The same of the light that leaves.
    left: [[f64; STATES]; 3],
}

fn cosine(state: usize) -> f64 {
    (state as f64 + 0.5) / STATES as f64
}

/// The two states about a cosine, with their shares.
fn states(cosine: f64) -> [(usize, f64); 2] {
    let x = (cosine * STATES as f64 - 0.5).clamp(0.0, STATES as f64 - 1.0);
    let low = (x as usize).min(STATES - 2);
    let share = x - low as f64;
    [(low, 1.0 - share), (low + 1, share)]
}

type Draw = fn(&Interaction<f64>, [f64; 2]) -> Drawn;

fn step(distribution: Distribution, width: f64, draw: Draw) -> Step {
    let settings = flux(LobeChoice::Fresnel, Normals::Visible);
    let glass = dielectric(distribution, parameter(distribution, width), 1.5);
    let zero = || vec![[0.0; STATES]; STATES];
    let mut found = Step {
        reflected: [zero(), zero(), zero()],
        left: [[0.0; STATES]; 3],
    };
    for from in 0..STATES {
        let at = seen(&glass, false, direction(cosine(from), 0.4));
        let most = facets(distribution, width, cosine(from))
            * (1.0 + 1e-5)
            * most_g1(distribution)
            * excess(distribution, width);
        for [near, far] in nodes(SIDE).map(|u| ways(&settings, &at, draw(&at, u))) {
            let parts = |share: f64, weight: f64| {
                let share = share / f64::from(SIDE * SIDE);
                [
                    share * weight,
                    share * weight * weight,
                    share * weight * most,
                ]
            };
            for (k, x) in parts(near.probability, mean3(near.weight))
                .into_iter()
                .enumerate()
            {
                for (to, share) in states(near.wi.z) {
                    found.reflected[k][from][to] += x * share;
                }
            }
            for (k, x) in parts(far.probability, mean3(far.weight))
                .into_iter()
                .enumerate()
            {
                found.left[k][from] += x;
            }
        }
    }
    found
}

/// [V, S, U] by the state in which a chain begins, after each reflection.
fn chain(step: &Step) -> impl Iterator<Item = [[f64; STATES]; 3]> + '_ {
    let next = |now: &[[f64; STATES]; 3]| {
        let moment = |k: usize| {
            std::array::from_fn(|from| {
                let row: &[f64; STATES] = &step.reflected[k][from];
                let go_on: f64 = row.iter().zip(&now[k]).map(|(p, x)| p * x).sum();
                go_on + step.left[k][from]
            })
        };
        Some([moment(0), moment(1), moment(2)])
    };
    std::iter::successors(Some([[1.0; STATES]; 3]), next).take(REFLECTIONS + 1)
}

/// The largest S/U, and the largest relative variance S/V² − 1, over all chains and lengths.
fn worst(step: &Step) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for [v, s, u] in chain(step) {
        for i in 0..STATES {
            worst[0] = worst[0].max(s[i] / u[i]);
            worst[1] = worst[1].max(s[i] / (v[i] * v[i]) - 1.0);
        }
    }
    worst
}

fn chains_stay_within_the_energy(widths: &[f64]) {
    for distribution in DISTRIBUTIONS {
        for &width in widths {
            let [of_energy, variance] = worst(&step(distribution, width, own));
            assert!(
                of_energy <= 1.0,
                "{distribution:?}, {width}: S/U = {of_energy}"
            );
            assert!(variance < 4.0, "{distribution:?}, {width}: {variance}");
        }
    }
}

#[test]
fn variance_grows_no_faster_than_the_models_energy() {
    chains_stay_within_the_energy(&[0.1]);
}

#[test]
#[ignore = "seconds: every width"]
fn variance_grows_no_faster_than_the_models_energy_at_any_width() {
    chains_stay_within_the_energy(&[0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0]);
}

#[test]
fn chains_by_the_ggx_proposal_grow_without_end() {
    for distribution in [Distribution::Beckmann, Distribution::Phong] {
        for width in [0.02, 0.1] {
            let [of_energy, variance] = worst(&step(distribution, width, by_ggx));
            assert!(
                of_energy > 1e3,
                "{distribution:?} {width}: {of_energy}, {variance}"
            );
        }
    }
}
