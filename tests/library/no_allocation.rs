//! A path takes no memory: nothing in its loop allocates, on paths of any length and hits of any kind.

use std::path::Path;

use allocation_counter::measure;
use vkpt::prepared::Prepared;
use vkpt::reference::integrator::path::record::Silent;
use vkpt::reference::integrator::path::trace_path;
use vkpt::reference::math::Real;
use vkpt::reference::path::SampleId;
use vkpt::reference::world::World;
use vkpt::settings::{Roulette, Settings};

use crate::common::render::{prepared, prepared_file};
use crate::common::scenes::{SMOOTH, TABLE, WIDE};

/// Two mirrors that face each other, in a box of light: a path between them lasts for a thousand bounces and more.
const MIRRORS: &str = "screen 8 8
camera 0 0 0 .01
light 1 1 1
box -9 -9 -9 1 18 18
brdf 0 0 0 1 1 1 0
box -5 -5 -4 10 10 1
box -5 -5 3 10 10 1
";

/// Scenes that are searched one primitive after another and through the hierarchy, of every kind of shape, material
/// and light but a mesh of light.
fn scenes(settings: &Settings) -> Vec<Prepared> {
    let mesh = prepared_file(Path::new("scenes/glass-mesh.txt"), settings, None);
    let mut all: Vec<_> = [TABLE, SMOOTH, WIDE, MIRRORS]
        .map(|text| prepared(text, settings))
        .into();
    all.push(mesh);
    assert_eq!(all.len(), 5);
    all
}

/// Follows paths all over the picture; the number of bounces of the longest, at least.
fn follow<F: Real>(world: &World<F>, settings: &Settings, height: u32) -> u64 {
    let mut most = 0;
    for i in 0..400 {
        let (column, row) = (i * 7 % world.width, i * 13 % height);
        let id = SampleId {
            column,
            row,
            pixel: row * world.width + column,
            sample: i,
            seed: 3,
        };
        most = most.max(trace_path(world, settings, id, &mut Silent).rays);
    }
    most
}

/// Allocations of paths in each scene, and the most rays that a path took.
fn allocations<F: Real>(settings: &Settings, planted: bool) -> (u64, u64) {
    let (mut count, mut longest) = (0, 0);
    for scene in scenes(settings) {
        let world = World::<F>::new(&scene);
        let info = measure(|| {
            longest = longest.max(follow(&world, settings, scene.camera.height));
            if planted {
                std::hint::black_box(Box::new(1u8));
            }
        });
        count += info.count_total;
    }
    (count, longest)
}

#[test]
fn paths_allocate_nothing() {
    let mut off = Settings::default();
    off.estimator.roulette = Roulette::Off;
    for settings in [Settings::default(), Settings::handout(), off] {
        assert_eq!(allocations::<f32>(&settings, false).0, 0, "{settings:?}");
        assert_eq!(allocations::<f64>(&settings, false).0, 0, "{settings:?}");
    }
    let (_, longest) = allocations::<f32>(&off, false);
    assert!(longest > 1000, "no path of a thousand bounces: {longest}");
}

#[test]
fn one_allocation_is_noticed() {
    let (count, _) = allocations::<f32>(&Settings::default(), true);
    assert_eq!(count, 5, "one in each scene");
}
