//! The density of a light path's first point, computed from another point.

use vkpt::reference::math::Vec3;
use vkpt::reference::world::World;
use vkpt::settings::Settings;

use crate::common::meshes::cube;
use crate::common::render::prepared;
use crate::shape::random::Random;

/// A light of each shape, far from one another.
fn lights(cube: &std::path::Path) -> World<f64> {
    let text = format!(
        "screen 4 4
camera 0 -30 0 .5 x 90
light 1 2 3
sphere 0 0 0 .7
box 5 0 0 1 2 3
cylinder 10 0 0 .3 .4 2 .6
mesh {} 15 0 0 1.5
",
        cube.display()
    );
    World::new(&prepared(&text, &Settings::default()))
}

/// Seen from outside it is the density that the point was drawn with; from inside, and at the back of a face, 0.
#[test]
fn it_is_the_density_that_points_are_drawn_with() {
    let cube = cube();
    let world = lights(cube.path());
    let mut random = Random(11);
    for light in 0..4 {
        for _ in 0..500 {
            let u24 = (random.bits() >> 40) as u32;
            let e = world.light_emission(light, u24, [random.unit(), random.unit()]);
            let seen_from = |offset: f64, wi: Vec3<f64>| {
                world.emission_pdf(light, e.p + e.n * offset, e.prim, wi)
            };
            assert_eq!(seen_from(0.3, -e.n), e.area_pdf, "light {light}");
            assert_eq!(seen_from(-1e-3, e.n), 0.0, "light {light}");
        }
    }
}
