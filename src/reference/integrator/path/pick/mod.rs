//! The light that a vertex is connected to; twin of `shaders/integrator/path/pick/`.

pub mod candidate;
pub mod every;
pub mod tree;

pub use crate::layout::constants::lights::FEW_LIGHTS;
use crate::reference::light::tree::tree_pmf;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::vertex::Vertex;
use crate::reference::sampler::unit_float;
use crate::reference::world::World;
use crate::settings::{Lights, Settings};
use candidate::{Candidate, Weigh, candidate};
use every::pick_every;
use tree::{lit_side, pick_in_tree};

/// The ways to pick a light; a kernel contains one of them.
enum Pick {
    Power,
    Every,
    Tree,
}

fn how<F>(world: &World<F>, settings: &Settings) -> Pick {
    match (settings.estimator.lights, world.lights.len()) {
        (Lights::Power, _) | (_, 0..=1) => Pick::Power,
        (Lights::Contribution, n) if n <= FEW_LIGHTS as usize => Pick::Every,
        (Lights::Contribution, _) => Pick::Tree,
    }
}

/// A light, and a point of it; `None` where no light can illuminate the vertex.
pub fn pick<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &Subpath<F>,
    v: &Vertex<F>,
    u: [u32; 4],
    weigh: &impl Weigh<F>,
) -> Option<Candidate<F>> {
    match how(world, settings) {
        Pick::Power => {
            let light = world.light_choice(u[0] >> 8);
            let point = [unit_float(u[2]), unit_float(u[3])];
            let pmf = world.light_pmf(light);
            Some(candidate(
                world,
                settings,
                path,
                v,
                light,
                pmf,
                u[1] >> 8,
                point,
                weigh,
            ))
        }
        Pick::Every => pick_every(world, settings, path, v, u, weigh),
        Pick::Tree => pick_in_tree(world, settings, path, v, u, weigh),
    }
}

/// The normal that [`pick_probability`] needs of a vertex.
pub fn pick_normal<F: Real>(world: &World<F>, settings: &Settings, v: &Vertex<F>) -> Vec3<F> {
    match how(world, settings) {
        Pick::Tree => lit_side(v),
        Pick::Power | Pick::Every => Vec3::zero(),
    }
}

/// The average number of points of `light` that a connection draws, from a vertex at `p` of [`pick_normal`] `n`.
pub fn pick_probability<F: Real>(
    world: &World<F>,
    settings: &Settings,
    light: usize,
    p: Vec3<F>,
    n: Vec3<F>,
) -> F {
    match how(world, settings) {
        Pick::Power => world.light_pmf(light),
        Pick::Every => F::one(),
        Pick::Tree => tree_pmf(&world.light_nodes, world.light_trails[light], p, n),
    }
}
