//! Where two vertices may be arbitrarily close, no sample is large: 1/d² is bounded by the weights.
//!
//! A way of density p contributes F p/Σp² ≤ F/(2 q), half of the contribution of a connection to the light, of density q, for
//! the same path alone. From a diffuse vertex that is ρ L cos θ Ω/π at most, Ω the solid angle of a ball of light.

use vkpt::reference::integrator::bidirectional::record::Silent;
use vkpt::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use vkpt::reference::math::Vec3;
use vkpt::reference::world::World;
use vkpt::settings::{Roulette, Settings};

use super::{samples, whole};
use crate::common::render::prepared;

/// Kd of every surface, and the light's radiance.
const KD: f64 = 0.8;
const RADIANCE: f64 = 10.0;
const DEPTH: u32 = 3;

/// The corner of a room, which is the inside of a box; a ball of light hangs 2 above its floor.
const CORNER: &str = "screen 16 16
camera -2 -2 2 .05 z 135 x 54.7
light 10 10 10
sphere 0 0 2 .5
brdf .8 .8 .8 0 0 0 1
box -4 -4 0 8 8 8
";

/// A ball of light on the floor of the same room.
const TOUCHING: &str = "screen 16 16
camera -2 -2 1 .3 z -45 x 75
light 10 10 10
sphere 0 0 .5 .5
brdf .8 .8 .8 0 0 0 1
box -4 -4 0 8 8 8
";

/// The largest value that any sample or splat has, over 400 samples a pixel.
fn largest(text: &str, ways: Ways) -> f64 {
    let mut settings = Settings::default();
    settings.model.max_depth = Some(DEPTH);
    settings.estimator.roulette = Roulette::Off;
    let prepared = prepared(text, &settings);
    let world = World::<f32>::new(&prepared);
    let adjoint = settings.adjoint();
    let transport = Transport {
        world: &world,
        settings: &settings,
        adjoint: &adjoint,
        ways,
    };
    let window = whole(&prepared);
    let mut most = 0.0;
    for id in samples(&prepared, 400, 3) {
        let mut largest = |value: Vec3<f32>| {
            assert!(value.x.is_finite());
            most = f64::max(most, value.x.into());
        };
        let (radiance, _) = trace_bidirectional(transport, window, id, &mut Silent, &mut |splat| {
            largest(splat.value)
        });
        radiance.into_iter().for_each(largest);
    }
    most
}

/// The bound of a sample: at each of [`DEPTH`] vertices one connection to the light in full, and half as much for each of two
/// vertices that are joined to it, and for a path that continues to the light.
fn bound(solid_angle: f64) -> f64 {
    let connection = KD * RADIANCE * solid_angle / std::f64::consts::PI;
    f64::from(DEPTH) * (1.0 + 3.0 / 2.0) * connection
}

#[test]
fn no_sample_is_large_in_the_corner_of_a_room() {
    // The ball's middle is 2 above the floor, the nearest wall.
    let sine = 0.5 / 2.0f64;
    let bound = bound(std::f64::consts::TAU * (1.0 - (1.0 - sine * sine).sqrt()));
    let all = largest(CORNER, Ways::All);
    let joined = largest(CORNER, Ways::Only { light: 2, eye: 2 });
    println!("largest {all:.1}, bound {bound:.1}; without weights {joined:.1}");
    assert!(all <= bound, "{all}");
    // Without weights, the contribution of two vertices that meet in the corner has no bound.
    assert!(joined > 10.0 * bound, "{joined}");
}

#[test]
fn no_sample_is_large_where_a_light_touches_the_floor() {
    // and the eye may see the ball.
    let bound = bound(std::f64::consts::TAU) + RADIANCE;
    let all = largest(TOUCHING, Ways::All);
    println!("largest {all:.1}, bound {bound:.1}");
    assert!(all <= bound, "{all}");
}
