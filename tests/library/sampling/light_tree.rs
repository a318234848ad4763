//! The tree of lights: probabilities that add up, choices with their frequencies, no emitter lost.

use glam::DVec3;
use vkpt::prepared::{LightKind, Prepared};
use vkpt::reference::light::tree::descent::first_child_share;
use vkpt::reference::light::tree::tickets::refilled;
use vkpt::reference::light::tree::{Tickets, all_tickets, tree_choice, tree_pmf};
use vkpt::reference::math::{Real, Vec3};
use vkpt::reference::sampler::random::sampler_block;
use vkpt::reference::world::World;
use vkpt::settings::Settings;

use super::ALPHA;
use crate::common::render::prepared;
use crate::common::scenes::MANY;
use crate::common::stats::{chi_square, sidak};

/// Points about the scene, each with a normal, or none.
fn places() -> Vec<[DVec3; 2]> {
    let u = |k: u32, p: f64| (p.sqrt() * f64::from(k)).fract() * 2.0 - 1.0;
    let vector = |k, [a, b, c]: [f64; 3]| DVec3::new(u(k, a), u(k, b), u(k, c));
    let place = |k| {
        let n = vector(k, [7.0, 11.0, 13.0]).normalize();
        [vector(k, [2.0, 3.0, 5.0]), n * f64::from(k % 3).min(1.0)]
    };
    (1..100).map(place).collect()
}

fn scene() -> Prepared {
    let scene = prepared(MANY, &Settings::default());
    assert!(scene.lights.len() > 16, "{}", scene.lights.len());
    scene
}

fn pmfs<F: Real>(world: &World<F>, [p, n]: [DVec3; 2]) -> Vec<F> {
    let pmf = |&trail: &u32| tree_pmf(&world.light_nodes, trail, Vec3::new(p), Vec3::new(n));
    world.light_trails.iter().map(pmf).collect()
}

/// The probability of a way down that ends at two nodes neither of which can emit to the receiver, way by way: the halves of a
/// node need not keep the bound of its ball.
fn nowhere<F: Real>(world: &World<F>, [p, n]: [DVec3; 2]) -> f64 {
    below(world, 0, all_tickets([0; 4]), [p, n].map(Vec3::new))
}

fn below<F: Real>(world: &World<F>, i: u32, t: Tickets, [p, n]: [Vec3<F>; 2]) -> f64 {
    let nodes = &world.light_nodes;
    if nodes[i as usize].leaf == 1 {
        return 0.0;
    }
    let share = first_child_share(nodes, i, t.count, p, n);
    if share == u32::MAX {
        return 1.0;
    }
    let ways = [(i + 1, share), (nodes[i as usize].child, t.count - share)];
    let ways = ways.into_iter().filter(|(_, count)| *count > 0);
    ways.map(|(child, count)| {
        let chance = f64::from(count) / f64::from(t.count);
        chance * below(world, child, refilled(Tickets { count, ..t }), [p, n])
    })
    .sum()
}

/// In f32 within 2⁻²⁰: the rounding of up to six quotients and of their products.
#[test]
fn the_probabilities_of_all_lights_and_of_none_add_up() {
    let scene = scene();
    let (single, double) = (World::<f32>::new(&scene), World::<f64>::new(&scene));
    for place in places() {
        let sum = pmfs(&double, place).iter().sum::<f64>() + nowhere(&double, place);
        assert!((sum - 1.0).abs() < 1e-12, "{place:?}: {sum}");
        let sum: f64 = pmfs(&single, place).iter().map(|&x| f64::from(x)).sum();
        let sum = sum + nowhere(&single, place);
        assert!((sum - 1.0).abs() < 2f64.powi(-20), "{place:?}: {sum}");
    }
}

/// A drawn light has the probability that `tree_pmf` gives it, to the bit, and is drawn as often.
#[test]
fn lights_are_drawn_as_often_as_their_probabilities_say() {
    const SAMPLES: u32 = 100_000;
    let world = World::<f32>::new(&scene());
    let places: Vec<_> = places().into_iter().step_by(16).collect();
    let level = sidak(ALPHA, places.len());
    for (k, place) in (0..).zip(places) {
        let pmfs = pmfs(&world, place);
        let mut counts = vec![0; pmfs.len() + 1];
        for sample in 0..SAMPLES {
            let tickets = all_tickets(sampler_block(k, sample, 3, 1));
            let [p, n] = place.map(Vec3::new);
            let c = tree_choice(&world.light_nodes, p, n, tickets);
            if c.pmf > 0.0 {
                assert_eq!(c.pmf, pmfs[c.light as usize], "light {}", c.light);
                counts[c.light as usize] += 1;
            } else {
                counts[pmfs.len()] += 1;
            }
        }
        let n = f64::from(SAMPLES);
        let mut expected: Vec<f64> = pmfs.iter().map(|&p| f64::from(p) * n).collect();
        expected.push(n - expected.iter().sum::<f64>());
        let p = chi_square(&counts, &expected);
        assert!(p > level, "place {k}: p = {p:e}");
        // the comparator detects a twentieth of the choices going to another light
        expected.iter_mut().for_each(|e| *e *= 0.95);
        expected[(0..pmfs.len()).max_by_key(|&i| counts[i]).expect("lights")] += 0.05 * n;
        assert!(chi_square(&counts, &expected) < level, "place {k}");
    }
}

/// Within reach is a ball of which some part is above the horizon of p; out of reach is one that is all below.
#[test]
fn lights_that_can_shine_are_within_reach_and_those_below_the_horizon_not() {
    let scene = scene();
    let world = World::<f32>::new(&scene);
    let (mut seen, mut hidden) = (0, 0);
    let balls = (scene.lights.iter().enumerate()).filter(|(_, l)| l.kind == LightKind::Sphere);
    let balls: Vec<_> = balls
        .map(|(i, light)| (i, &scene.primitives.spheres[light.first as usize]))
        .collect();
    for [p, n] in places().into_iter().filter(|[_, n]| *n != DVec3::ZERO) {
        let pmfs = pmfs(&world, [p, n]);
        for (i, ball) in &balls {
            let top = (ball.centre - p).dot(n) + ball.radius;
            if top > 1e-4 {
                assert!(pmfs[*i] > 0.0, "light {i} from {p} {n}");
                seen += 1;
            } else if top < -1e-4 {
                assert_eq!(pmfs[*i], 0.0, "light {i} from {p} {n}");
                hidden += 1;
            }
        }
    }
    assert!(seen > 100 && hidden > 100, "{seen} {hidden}");
}
