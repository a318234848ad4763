//! Whole paths from the eye to a light, with all the values that any way to find them needs at their vertices, in f64.

use vkpt::prepared::MaterialKind;
use vkpt::reference::integrator::path::begin_path;
use vkpt::reference::math::{Vec3, dot3};
use vkpt::reference::path::SampleId;
use vkpt::reference::path::blocks::Origin;
use vkpt::reference::path::extend::extend;
use vkpt::reference::path::trace::extend_ray;
use vkpt::reference::path::vertex::path_vertex;
use vkpt::reference::world::World;
use vkpt::render::chain::{Bounce, Chain, End};
use vkpt::settings::Settings;

/// The path of a sample, if it scatters at least once and then finds a light.
pub fn chain(world: &World<f64>, settings: &Settings, id: SampleId) -> Option<Chain> {
    let mut path = begin_path(world, settings, id).path;
    let eye = path.ray.o;
    let mut bounces: Vec<Bounce<f64>> = Vec::new();
    let mut drawn = Vec::new();
    let mut rays = 0;
    loop {
        let (hit, distance) = extend_ray(world, settings, &mut path, &mut rays);
        let v = path_vertex(world, settings, path.ray, hit?, distance, Vec3::one());
        let wo = -path.ray.d;
        if let Some(light) = world.light_of(v.shape) {
            let end = End::Point {
                light,
                prim: v.prim,
                p: v.p,
                cosine: dot3(wo, v.ng).abs(),
            };
            let chain = Chain::new(world, settings, eye, &bounces, end)?;
            for (node, pdf) in chain.nodes.iter().zip(&drawn) {
                // Directions are drawn with the densities that the weights see, except for the half vector's rounding error.
                assert!(
                    node.delta || f64::abs(node.onwards / pdf - 1.0) < 1e-6,
                    "{} for {pdf}",
                    node.onwards
                );
            }
            return Some(chain);
        }
        if v.interaction.material.kind == MaterialKind::Black {
            return None;
        }
        if !extend(settings, Origin::Eye, &mut path, &v, id).alive {
            return None;
        }
        drawn.push(path.pdf);
        bounces.push(Bounce {
            v,
            wo,
            wi: path.ray.d,
            delta: path.delta,
        });
    }
}
