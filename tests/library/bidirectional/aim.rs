//! The direction that a light path sets out in is drawn with the density that the weights have of it.
//!
//! For any f, the mean of f/p over directions of density p is ∫f: π for the cosine of a hemisphere, and the solid angle for the
//! inside of a ball that is seen from outside.

use std::f64::consts::PI;

use vkpt::reference::integrator::bidirectional::aim::{aimed_density, aimed_direction};
use vkpt::reference::math::{Vec3, dot3, length3, vec3};
use vkpt::reference::world::Aim;

use crate::common::stats::{p_of_mean, sidak};
use crate::shape::random::Random;

const ALPHA: f64 = 1e-3;
const SAMPLES: usize = 40_000;

/// A ball far above the light and small, one near and large, one that the light is in, one half behind it.
fn aims() -> [Aim<f64>; 4] {
    let aim = |x, y, z, radius| Aim {
        centre: vec3(x, y, z),
        radius,
    };
    [
        aim(0.5, 0.2, 6.0, 0.2),
        aim(-1.0, 0.0, 1.5, 1.2),
        aim(0.1, 0.1, 0.1, 3.0),
        aim(3.0, 0.0, 0.2, 1.0),
    ]
}

/// f/p of as many directions, p by `density` of (d, cosine).
fn quotients(
    aims: &[Aim<f64>],
    f: impl Fn(Vec3<f64>) -> f64,
    density: impl Fn(Vec3<f64>, f64) -> f64,
) -> Vec<f64> {
    let (p, n) = (vec3(0.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0));
    let mut random = Random(5);
    let mut quotient = || {
        let (choice, u) = (random.unit(), [random.unit(), random.unit()]);
        let d = aimed_direction(aims, p, n, choice, u);
        let cosine = dot3(d, n);
        match cosine > 0.0 {
            true => f(d) / (density(d, cosine) * cosine),
            false => 0.0,
        }
    };
    (0..SAMPLES).map(|_| quotient()).collect()
}

/// Whether a direction from the light meets a ball.
fn meets(aim: &Aim<f64>, d: Vec3<f64>) -> bool {
    length3(aim.centre - d * dot3(aim.centre, d)) < aim.radius && dot3(aim.centre, d) > 0.0
}

fn least_p(aims: &[Aim<f64>], density: impl Fn(Vec3<f64>, f64) -> f64) -> f64 {
    let hemisphere = p_of_mean(&quotients(aims, |d| d.z, &density), PI, 1e-9);
    // The first two balls are wholly in front of the light.
    let balls = aims.iter().take(2).map(|aim| {
        let sine = aim.radius / length3(aim.centre);
        let solid_angle = 2.0 * PI * (1.0 - (1.0 - sine * sine).sqrt());
        let inside = |d| if meets(aim, d) { 1.0 } else { 0.0 };
        p_of_mean(&quotients(aims, inside, &density), solid_angle, 0.0)
    });
    balls.fold(hemisphere, f64::min)
}

#[test]
fn directions_are_drawn_with_their_density() {
    let origin = vec3(0.0, 0.0, 0.0);
    for count in 0..=4 {
        let all = aims();
        let aims = &all[..count];
        let p = least_p(aims, |d, c| aimed_density(aims, origin, d, c));
        println!("{count} balls: p = {p:.1e}");
        assert!(p > sidak(ALPHA, 15), "{count} balls: p = {p:e}");
    }
}

/// A density that forgets one of the balls, the half of each kind, or the cosine that aimed directions lack.
#[test]
fn wrong_densities_are_noticed() {
    let origin = vec3(0.0, 0.0, 0.0);
    let aims = aims();
    let forgetful = |d, c| aimed_density(&aims[1..], origin, d, c);
    let halved = |d, c| aimed_density(&aims, origin, d, c) * 0.5;
    let flat = |d, c: f64| aimed_density(&aims, origin, d, 1.0) / c;
    for p in [
        least_p(&aims, forgetful),
        least_p(&aims, halved),
        least_p(&aims, flat),
    ] {
        assert!(p < sidak(ALPHA, 15), "p = {p:e}");
    }
}
