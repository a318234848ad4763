//! Points and normals of surfaces, on the surface as exactly as f32 allows.

use glam::DVec3;
use vkpt::reference::math::{Real, Vec3, dot3, vec3};
use vkpt::reference::shape::triangle::area::triangle_area;
use vkpt::reference::shape::{
    Cuboid, Hit, Ray, START_ELSEWHERE, Sphere, Triangle, box_hit, box_surface, cylinder_hit,
    cylinder_surface, normal, sphere_hit, sphere_surface, triangle_surface,
};

use super::random::Random;
use super::solids::some_cylinder;

const HALF_ULP: f64 = 1.0 / 16_777_216.0;
const SCALES: [f64; 5] = [1e-5, 1e-2, 1.0, 1e3, 1e5];
const N: usize = 20_000;

fn hit_of(t: f32, prim: u32) -> Hit<f32> {
    Hit {
        t,
        shape: 0,
        prim,
        uv: [0.0; 2],
    }
}

/// A point is rounded at the size of its coordinates, three times at most.
fn rounding(p: DVec3, size: f64) -> f64 {
    8.0 * HALF_ULP * (p.abs().max_element() + size)
}

#[test]
fn points_lie_on_spheres() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        let s = Sphere {
            centre: random.point::<f32>(scale),
            radius: scale as f32,
            shape: 0,
        };
        for _ in 0..N {
            let ray = Ray::new(random.point(100.0 * scale), random.direction());
            let t = sphere_hit(ray.o, ray.d, s.centre, s.radius, START_ELSEWHERE);
            if t > 0.0 {
                let at = sphere_surface(ray, hit_of(t, 0), &s);
                let out = at.p.f64() - s.centre.f64();
                assert!((out.length() - s.radius.f64()).abs() <= rounding(at.p.f64(), scale));
                let turned = (at.ng.f64() - out.normalize()).length();
                assert!(turned <= rounding(at.p.f64(), scale) / scale + 4.0 * HALF_ULP);
            }
        }
    }
}

#[test]
fn points_lie_on_boxes_to_the_bit() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        let lo: Vec3<f32> = random.point(scale);
        let hi = lo + random.point::<f32>(0.4 * scale) + Vec3::splat(0.5 * scale as f32);
        let b = Cuboid { lo, hi, shape: 0 };
        for _ in 0..N {
            let ray = Ray::new(random.point(3.0 * scale), random.direction());
            let hit = box_hit(ray.o, ray.d, lo, hi, START_ELSEWHERE);
            if hit.t > 0.0 {
                let at = box_surface(ray, hit_of(hit.t, hit.face), &b);
                let axis = (hit.face / 2) as usize;
                let plane = if hit.face % 2 == 1 { hi } else { lo };
                assert_eq!(at.p[axis], plane[axis]);
                assert!((0..3).all(|k| lo[k] <= at.p[k] && at.p[k] <= hi[k]));
                let outwards = if hit.face % 2 == 1 { 1.0 } else { -1.0 };
                assert_eq!(at.ng[axis], outwards);
                assert_eq!(dot3(at.ng, at.ng), 1.0);
            }
        }
    }
}

#[test]
fn points_lie_on_cylinders() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        let c = some_cylinder(&mut random, scale);
        for _ in 0..N {
            let ray = Ray::new(random.point(3.0 * scale), random.direction());
            let hit = cylinder_hit(ray.o, ray.d, &c, START_ELSEWHERE, 0);
            if hit.t > 0.0 {
                let at = cylinder_surface(ray, hit_of(hit.t, hit.part), &c);
                let v = at.p.f64() - c.base.f64();
                let z = v.dot(c.w.f64());
                let rho = (v - c.w.f64() * z).length();
                let slack = 2.0 * rounding(at.p.f64(), scale);
                let off = match hit.part {
                    0 => rho - c.radius.f64(),
                    1 => z,
                    _ => z - c.height.f64(),
                };
                assert!(off.abs() <= slack, "part {}: {off}", hit.part);
                assert!(rho <= c.radius.f64() + slack && z >= -slack);
                assert!(z <= c.height.f64() + slack);
                assert!((at.ng.f64().length() - 1.0).abs() <= 8.0 * HALF_ULP);
            }
        }
    }
}

#[test]
fn points_lie_on_triangles() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        for _ in 0..N {
            let v = [0; 3].map(|_| random.point::<f32>(scale));
            let (s, u) = (random.unit().sqrt(), random.unit());
            let uv = [(s * (1.0 - u)) as f32, (s * u) as f32];
            let at = triangle_surface(
                Hit {
                    uv,
                    ..hit_of(1.0, 0)
                },
                &Triangle { v, shape: 0 },
                None,
            );
            let [a, b, c] = v.map(Vec3::f64);
            let n = (b - a).cross(c - a);
            let off = n.dot(at.p.f64() - a) / n.length();
            // Seven roundings a coordinate (see `nearer`), three coordinates.
            assert!(off.abs() <= 7.0 * 3.0 * HALF_ULP * scale);
            // e₁ × e₂ of rounded edges: its error grows as the triangle gets thinner.
            let fat = n.length() / ((b - a).length() * (c - a).length());
            assert!((at.ng.f64() - n.normalize()).length() <= 8.0 * HALF_ULP / fat);
            assert_eq!(at.ns, at.ng);
        }
    }
}

#[test]
fn areas_keep_their_digits_at_every_scale() {
    for exponent in [-18, -9, 0, 9, 15] {
        let s = 10f64.powi(exponent);
        let v = [vec3(s, 0.0, 0.0), vec3(0.0, s, 0.0), vec3(0.0, 0.0, s)]
            .map(|v: Vec3<f64>| Vec3::<f32>::new(v.f64()));
        let a = triangle_area(v[0], v[1], v[2]);
        let exact = 0.75f64.sqrt() * s * s;
        assert!(
            (a.area.f64() / exact - 1.0).abs() <= 8.0 * HALF_ULP,
            "{s}: {a:?}"
        );
        assert!((a.ng.f64() - DVec3::splat(1.0 / 3f64.sqrt())).length() <= 4.0 * HALF_ULP);
    }
    let p: Vec3<f32> = vec3(1.0, 2.0, 3.0);
    let none = triangle_area(p, p, p);
    assert_eq!((none.area, none.ng), (0.0, vec3(0.0, 0.0, 1.0)));
}

#[test]
fn shading_normals_stay_on_the_geometric_side() {
    let z: Vec3<f64> = vec3(0.0, 0.0, 1.0);
    let x = vec3(1.0, 0.0, 0.0);
    let smooth = |n: Vec3<f64>| normal::interpolated_normal(n, x, n, [0.5, 0.25], z);
    // ½ x + ½ n
    let half = 0.5f64.sqrt();
    assert!((smooth(z) - vec3(half, 0.0, half)).f64().length() < 1e-15);
    assert!((smooth(-z) - vec3(-half, 0.0, half)).f64().length() < 1e-15);
    let none = Vec3::zero();
    assert_eq!(
        normal::interpolated_normal(none, none, none, [0.5, 0.25], z),
        z
    );
}
