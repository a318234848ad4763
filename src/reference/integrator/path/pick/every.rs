//! A light picked among few by its contribution; twin of `shaders/integrator/path/pick/every.glsl`.

use super::candidate::{Candidate, Weigh, candidate};
use crate::reference::math::finite::is_finite;
use crate::reference::math::{Real, mean3};
use crate::reference::path::Subpath;
use crate::reference::path::vertex::Vertex;
use crate::reference::sampler::unit_float;
use crate::reference::world::World;
use crate::settings::Settings;

/// Every light gets a point, from the same numbers shifted by multiples of the golden ratio, so that each light's points are
/// spread as the sampler's are. One of the candidates is kept with the probability w/W, where W is the sum of all w, and
/// represents all by the factor W/w (Talbot et al., Importance Resampling for Global Illumination, EGSR 2005, section 3, with
/// every light sampled once; one pass: Chao, A General Purpose Unequal Probability Sampling Plan, Biometrika 69(3), 1982).
pub fn pick_every<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &Subpath<F>,
    v: &Vertex<F>,
    u: [u32; 4],
    weigh: &impl Weigh<F>,
) -> Option<Candidate<F>> {
    let (zero, one) = (F::zero(), F::one());
    let mut kept = None;
    let mut choice: F = unit_float(u[0]);
    let (mut total, mut own) = (zero, zero);
    for light in 0..world.lights.len() {
        let turned = |word: u32| word.wrapping_add((light as u32).wrapping_mul(0x9e37_79b9));
        let point = [unit_float(turned(u[2])), unit_float(turned(u[3]))];
        let c = candidate(
            world,
            settings,
            path,
            v,
            light,
            one,
            turned(u[1]) >> 8,
            point,
            weigh,
        );
        let w = mean3(c.contribution);
        total += w;
        // The share of this one among those so far. The rest of the number is uniform again.
        let share = w / total;
        let takes = choice < share;
        if w > zero {
            choice = if takes {
                choice / share
            } else {
                (choice - share) / (one - share)
            };
        }
        if takes || !is_finite(w) {
            own = w;
            kept = Some(c);
        }
    }
    kept.map(|c| Candidate {
        contribution: c.contribution * (total / own),
        ..c
    })
}
