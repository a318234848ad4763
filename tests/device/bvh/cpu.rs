//! The reference's hierarchy against brute force.

use glam::DVec3;
use vkpt::flat::bvh;
use vkpt::prepared::{NONE, Prepared, ShapeKind};
use vkpt::reference::accel::Accel;
use vkpt::reference::math::Real;
use vkpt::reference::shape::no_hit;
use vkpt::shape::Extent;

use super::brute::{World, bits, is_some_hit};
use super::rays::{Query, Rays};
use super::scenes;
use super::tree::ALL_KINDS;

/// All queries give the same bits, and enough of them hit something for that to mean much.
fn check<F: Real>(rays: u32) {
    for (name, prepared) in scenes::all() {
        let world = World::<F>::new(&prepared);
        let primitives = &world.primitives;
        let accel = Accel::build(primitives);
        let mut source = Rays::new(&prepared, 21);
        let mut hits = 0;
        for i in 0..rays {
            let q: Query<F> = source.next();
            let found = accel.nearest(primitives, q.ray, q.skip, no_hit(q.t_max));
            let expected = world.nearest(&q);
            assert_eq!(
                bits(found),
                bits(expected),
                "{name}, query {i}: {q:?}\n{found:?}\n{expected:?}"
            );
            let any = accel.any(primitives, q.ray, q.skip, no_hit(q.t_max));
            assert!(is_some_hit(any, expected), "{name}, query {i}: {any:?}");
            hits += u32::from(expected.shape != NONE);
        }
        println!("{name}: {hits} of {rays} hit");
        assert!(
            hits > rays / 10,
            "{name}: only {hits} of {rays} hit anything"
        );
    }
}

/// The basis of the padding: a reported hit, taken exactly, lies within 48 u R of its primitive's box.
#[test]
fn hits_lie_in_the_boxes_of_their_primitives() {
    for (name, prepared) in scenes::all() {
        let world = World::<f32>::new(&prepared);
        let reach = bvh::build(&prepared, &ALL_KINDS).reach;
        let mut source = Rays::new(&prepared, 22);
        let mut worst = 0.0f64;
        for _ in 0..5_000 {
            let q: Query<f32> = source.next();
            let hit = world.nearest(&q);
            if hit.shape == NONE {
                continue;
            }
            let b = primitive_bounds(&prepared, hit.shape, hit.prim);
            let o = q.ray.o.f64();
            let p = o + q.ray.d.f64() * f64::from(hit.t);
            let [lo, hi] = [b.lo, b.hi].map(|v| DVec3::from_array(v.map(f64::from)));
            let outside = (lo - p).max(p - hi).max_element();
            let largest = o.abs().max_element() + f64::from(reach);
            worst = worst.max(outside / (f64::from(f32::ULP) * largest));
        }
        println!("{name}: {worst:.1} u R");
        assert!(worst <= 48.0, "{name}: {worst} u R");
    }
}

fn primitive_bounds(prepared: &Prepared, shape: u32, prim: u32) -> Extent {
    let s = &prepared.shapes[shape as usize];
    let i = match s.kind {
        ShapeKind::Mesh => prim,
        _ => s.first,
    };
    Extent::around(prepared.primitives.get(s.kind, i as usize).extent_in_f32())
}

#[test]
fn f32_equals_brute_force() {
    check::<f32>(5_000);
}

#[test]
fn f64_equals_brute_force() {
    check::<f64>(5_000);
}

#[test]
#[ignore = "a minute"]
fn f32_equals_brute_force_at_length() {
    check::<f32>(1_000_000);
}
