//! A light picked among many by its importance in the tree; twin of `shaders/integrator/path/pick/tree.glsl`.

use super::candidate::{Candidate, Weigh, candidate};
use crate::prepared::MaterialKind;
use crate::reference::light::tree::{all_tickets, tree_choice};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::vertex::Vertex;
use crate::reference::sampler::unit_float;
use crate::reference::world::World;
use crate::settings::Settings;

/// The normal on whose side a vertex can be lit; 0 if light may come from both.
pub fn lit_side<F: Real>(v: &Vertex<F>) -> Vec3<F> {
    if v.interaction.material.kind < MaterialKind::RoughDielectric {
        v.facing
    } else {
        Vec3::zero()
    }
}

/// The light that the tree picks, and a point of it; `None` where none can contribute.
pub fn pick_in_tree<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &Subpath<F>,
    v: &Vertex<F>,
    u: [u32; 4],
    weigh: &impl Weigh<F>,
) -> Option<Candidate<F>> {
    let choice = tree_choice(&world.light_nodes, v.p, lit_side(v), all_tickets(u));
    let point = [unit_float(u[2]), unit_float(u[3])];
    (choice.pmf > F::zero()).then(|| {
        let light = choice.light as usize;
        candidate(
            world,
            settings,
            path,
            v,
            light,
            choice.pmf,
            u[1] >> 8,
            point,
            weigh,
        )
    })
}
