//! Rays that start on a solid: out, never to meet it again; in, always to find the way out.

use vkpt::reference::math::{Real, Vec3, dot3, vec3};
use vkpt::reference::shape::{
    Cuboid, Cylinder, Hit, Ray, START_ELSEWHERE, START_INSIDE, START_OUTSIDE, Sphere, Surface,
    Target, box_hit, box_surface, cylinder_hit, cylinder_surface, nearest_boxes, nearest_cylinders,
    nearest_spheres, no_hit, sphere_hit, sphere_surface,
};

use super::random::Random;
use super::solids::some_cylinder;

const FAR: f32 = 3.0e38;
const N: usize = 20_000;
const SCALES: [f64; 5] = [1e-5, 1e-2, 1.0, 1e3, 1e5];

/// A solid, found by a ray and left again.
trait Solid {
    fn nearest(&self, ray: Ray<f32>) -> Hit<f32>;
    fn surface(&self, ray: Ray<f32>, hit: Hit<f32>) -> Surface<f32>;
}

impl Solid for Sphere<f32> {
    fn nearest(&self, ray: Ray<f32>) -> Hit<f32> {
        nearest_spheres(&[*self], ray, Target::none(), no_hit(FAR))
    }
    fn surface(&self, ray: Ray<f32>, hit: Hit<f32>) -> Surface<f32> {
        sphere_surface(ray, hit, self)
    }
}

impl Solid for Cuboid<f32> {
    fn nearest(&self, ray: Ray<f32>) -> Hit<f32> {
        nearest_boxes(&[*self], ray, Target::none(), no_hit(FAR))
    }
    fn surface(&self, ray: Ray<f32>, hit: Hit<f32>) -> Surface<f32> {
        box_surface(ray, hit, self)
    }
}

impl Solid for Cylinder<f32> {
    fn nearest(&self, ray: Ray<f32>) -> Hit<f32> {
        nearest_cylinders(&[*self], ray, Target::none(), no_hit(FAR))
    }
    fn surface(&self, ray: Ray<f32>, hit: Hit<f32>) -> Surface<f32> {
        cylinder_surface(ray, hit, self)
    }
}

fn solids(random: &mut Random, scale: f64) -> Vec<Box<dyn Solid>> {
    let lo = random.point::<f32>(scale);
    let size = random.point::<f32>(0.4 * scale) + Vec3::splat(0.5 * scale as f32);
    vec![
        Box::new(Sphere {
            centre: random.point(scale),
            radius: scale as f32,
            shape: 0,
        }),
        Box::new(Cuboid {
            lo,
            hi: lo + size,
            shape: 0,
        }),
        Box::new(some_cylinder(random, scale)),
    ]
}

/// Follows a ray through a solid for several bounces within it and then out, into all directions.
#[test]
fn inside_always_finds_a_way_out_and_outside_never_returns() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        for solid in solids(&mut random, scale) {
            for _ in 0..N {
                let mut ray = Ray::new(random.point(3.0 * scale), random.direction());
                let mut hit = solid.nearest(ray);
                let mut bounces = 0;
                while hit.shape == 0 && bounces < 4 {
                    let s = solid.surface(ray, hit);
                    let d: Vec3<f32> = random.direction();
                    let out = dot3(d, s.ng) > 0.0;
                    let start = if out { START_OUTSIDE } else { START_INSIDE };
                    ray = Ray {
                        o: s.p,
                        d,
                        shape: 0,
                        prim: hit.prim,
                        start,
                        t_self: 0.0,
                        ..Ray::new(vec3(0.0, 0.0, 0.0), d)
                    };
                    hit = solid.nearest(ray);
                    assert_eq!(hit.shape == 0, !out, "{ray:?} → {hit:?}");
                    assert!(out || hit.t >= 0.0);
                    bounces += 1;
                }
            }
        }
    }
}

#[test]
fn the_chord_of_a_sphere_is_twice_the_cosine() {
    let mut random = Random(7);
    for _ in 0..N {
        let n: Vec3<f64> = random.direction();
        let d: Vec3<f64> = random.direction();
        let cos = dot3(n, d);
        let t = sphere_hit(n * 2.0, d, Vec3::zero(), 2.0, START_INSIDE);
        let chord = if cos < 0.0 { -4.0 * cos } else { 0.0 };
        assert!((t - chord).abs() <= 1e-14, "{t} {chord}");
    }
}

#[test]
fn a_start_in_the_plane_of_another_face_is_not_stopped_there() {
    let (lo, hi) = (Vec3::<f32>::zero(), Vec3::one());
    let slanted = |z: f32| vec3(0.6, 0.0, z);
    // Next to the box, in the plane of its top, downwards: its side is hit, not its top.
    let beside = vec3(-1.0, 0.5, 1.0);
    let hit = box_hit(beside, vec3(0.8, 0.0, -0.6), lo, hi, START_ELSEWHERE);
    assert_eq!((hit.t, hit.face), (1.25, 0));
    // On its top, upwards: nothing. Downwards: the next hit after the start is the way out.
    let on_top = vec3(0.25, 0.5, 1.0);
    assert_eq!(
        box_hit(on_top, slanted(0.8), lo, hi, START_ELSEWHERE).t,
        -1.0
    );
    assert_eq!(
        box_hit(on_top, slanted(-0.8), lo, hi, START_ELSEWHERE).t,
        1.25
    );
    // Sliding along a face's plane, within or next to the face: a miss, and no NaN.
    let x = vec3(1.0, 0.0, 0.0);
    for o in [beside, on_top, vec3(-1.0, 0.0, 0.5), vec3(-1.0, 0.0, 0.0)] {
        assert_eq!(box_hit(o, x, lo, hi, START_ELSEWHERE).t, -1.0, "{o:?}");
    }
    // Between the planes it hits.
    let middle = vec3(-1.0, 0.5, 0.5);
    assert_eq!(box_hit(middle, x, lo, hi, START_ELSEWHERE).t, 1.0);
}

#[test]
fn rays_along_the_axis_of_a_cylinder() {
    let c = Cylinder::<f32> {
        base: Vec3::zero(),
        u: vec3(1.0, 0.0, 0.0),
        v: vec3(0.0, 1.0, 0.0),
        w: vec3(0.0, 0.0, 1.0),
        height: 2.0,
        radius: 1.0,
        shape: 0,
    };
    let up = vec3(0.0, 0.0, 1.0);
    let hit = |x: f32, z: f32, start, part| {
        let h = cylinder_hit(vec3(x, 0.0, z), up, &c, start, part);
        (h.t, h.part)
    };
    assert_eq!(hit(0.0, -1.0, START_ELSEWHERE, 0), (1.0, 1));
    assert_eq!(hit(0.5, 1.0, START_ELSEWHERE, 0), (1.0, 2));
    assert_eq!(hit(1.5, -1.0, START_ELSEWHERE, 0).0, -1.0);
    assert_eq!(
        hit(1.0, -1.0, START_ELSEWHERE, 0).0,
        -1.0,
        "sliding along the side"
    );
    assert_eq!(hit(0.5, 0.0, START_INSIDE, 1), (2.0, 2));
    assert_eq!(hit(0.5, 0.0, START_OUTSIDE, 1).0, -1.0);
    // From the side inwards, square to the axis: one diameter.
    let across = cylinder_hit(
        vec3(1.0, 0.0, 1.0),
        vec3(-1.0, 0.0, 0.0),
        &c,
        START_INSIDE,
        0,
    );
    assert_eq!((across.t, across.part), (2.0, 0));
}

/// A ball that touches a table: a ray that starts on the table next to the point of contact sees the ball.
#[test]
fn no_offset_skips_a_shape_that_touches() {
    for k in 1..=20 {
        // A point of the plane z = 0 at x from the contact, straight up: t = 1 − √(1 − x²) ≈ x²/2.
        let x = 2f64.powi(-k);
        let o = vec3(x as f32, 0.0, 0.0);
        let t = sphere_hit(
            o,
            vec3(0.0, 0.0, 1.0),
            vec3(0.0, 0.0, 1.0),
            1.0,
            START_ELSEWHERE,
        );
        let exact = x * x / (1.0 + (1.0 - x * x).sqrt());
        // |oc| is rounded to half an ulp of 1, so t is known to as much; nearer the start counts as inside.
        let known = 2.0 / 16_777_216.0;
        assert!(
            (t.f64() - exact).abs() <= known || exact < known,
            "{x}: {t} {exact}"
        );
    }
}
