//! Meshes: no ray passes between triangles, none is caught by the surface that it leaves.

use glam::DVec3;
use vkpt::prepared::NONE;
use vkpt::reference::math::{Real, Vec3, dot3, vec3};
use vkpt::reference::shape::{
    FAR, Hit, Ray, START_INSIDE, START_OUTSIDE, Target, Triangle, nearest_triangles, no_hit,
    ray_shear, triangle_hit, triangle_self_distance, triangle_surface,
};

use super::random::Random;
use crate::common::icosphere::icosphere;

const HALF_ULP: f64 = 1.0 / 16_777_216.0;

/// A closed bumpy ball, star-shaped about its middle, of 320 triangles.
fn bumpy() -> Vec<[DVec3; 3]> {
    icosphere(4, 1)
}

/// The same without bumps: convex.
fn round() -> Vec<[DVec3; 3]> {
    bumpy()
        .into_iter()
        .map(|f| f.map(DVec3::normalize))
        .collect()
}

fn mesh(faces: &[[DVec3; 3]], place: impl Fn(DVec3) -> DVec3) -> Vec<Triangle<f32>> {
    faces
        .iter()
        .map(|f| Triangle {
            v: f.map(|p| Vec3::new(place(p))),
            shape: 0,
        })
        .collect()
}

/// The twelve triangles of the cube [−1, 1]³.
fn cube() -> Vec<[DVec3; 3]> {
    let mut faces = Vec::new();
    for axis in 0..3 {
        for s in [-1.0, 1.0] {
            let n = DVec3::AXES[axis] * s;
            let (u, v) = (DVec3::AXES[(axis + 1) % 3] * s, DVec3::AXES[(axis + 2) % 3]);
            faces.push([n - u - v, n + u - v, n + u + v]);
            faces.push([n - u - v, n + u + v, n - u + v]);
        }
    }
    faces
}

fn nearest(triangles: &[Triangle<f32>], ray: Ray<f32>) -> Hit<f32> {
    nearest_triangles(triangles, ray, Target::none(), no_hit(FAR as f32))
}

/// Rays at corners, at points of edges and at points of triangles, from within.
fn shots(triangles: &[Triangle<f32>], inner: f64, n: usize, seed: u64) -> Vec<Ray<f32>> {
    let mut random = Random(seed);
    let shot = |i| {
        let v = triangles[random.bits() as usize % triangles.len()]
            .v
            .map(Vec3::f64);
        let s = random.unit();
        let target = match i % 3 {
            0 => v[0],
            1 => v[0] + (v[1] - v[0]) * s,
            _ => v[0] + (v[1] - v[0]) * s + (v[2] - v[0]) * ((1.0 - s) * random.unit()),
        };
        let o: Vec3<f32> = random.point(inner);
        let d = Vec3::new((target - o.f64()).normalize());
        Ray::new(o, d)
    };
    (0..n).map(shot).collect()
}

/// How many of them the mesh does not stop.
fn leaks(triangles: &[Triangle<f32>], rays: &[Ray<f32>]) -> usize {
    let leaks = |ray: &&Ray<f32>| nearest(triangles, **ray).shape == NONE;
    rays.iter().filter(leaks).count()
}

/// A closed bumpy ball and a closed cube, small and large.
fn no_leaks(n: usize) {
    for scale in [1e-5, 1.0, 1e5] {
        for (faces, inner, seed) in [(bumpy(), 0.3, 1), (cube(), 0.99, 2)] {
            let mesh = mesh(&faces, |p| p * scale);
            let rays = shots(&mesh, inner * scale, n, seed);
            assert_eq!(leaks(&mesh, &rays), 0, "{} triangles × {scale}", mesh.len());
        }
    }
}

#[test]
fn no_ray_passes_between_triangles() {
    no_leaks(34_000);
}

#[test]
#[ignore = "ten million rays at 320 triangles each: minutes"]
fn no_ray_in_ten_million_passes_between_triangles() {
    no_leaks(3_400_000);
}

/// Axis-aligned rays through the exact diagonal and the corners of a face.
#[test]
fn axis_aligned_rays_meet_diagonals_and_corners() {
    let triangles = mesh(&cube(), |p| p);
    for i in -16..=16 {
        let x = i as f32 / 16.0;
        for y in [x, -x, 1.0, -1.0] {
            let hit = nearest(&triangles, Ray::new(vec3(x, y, -3.0), vec3(0.0, 0.0, 1.0)));
            assert_eq!((hit.shape, hit.t), (0, 2.0), "{x} {y}");
        }
    }
}

/// One triangle of 320 taken out. From the middle of a star-shaped ball each ray meets one triangle: those that met the one
/// that is missing must leak, and no other.
#[test]
fn a_leak_is_noticed() {
    let whole = mesh(&bumpy(), |p| p);
    let (missing, holed) = whole.split_last().expect("triangles");
    let rays = shots(&whole, 0.0, 34_000, 1);
    let met = |ray: &&Ray<f32>| nearest(&whole, **ray).prim as usize == holed.len();
    let through = rays.iter().filter(met).count();
    // 34,000/320 rays or so are aimed at it, a third each at its inside, its first corner and its first edge.
    assert!(through > 34_000 / 320 / 6, "{through} through {missing:?}");
    assert_eq!(leaks(holed, &rays), through);
}

/// Möller and Trumbore, Fast Minimum Storage Ray/Triangle Intersection, 1997, in f64: (t, u, v, |n·d|).
fn moller_trumbore(o: DVec3, d: DVec3, v: [DVec3; 3]) -> (f64, f64, f64, f64) {
    let (e1, e2, s) = (v[1] - v[0], v[2] - v[0], o - v[0]);
    let det = e1.dot(d.cross(e2));
    let q = s.cross(e1);
    let cos = (e1.cross(e2).normalize().dot(d)).abs();
    (
        e2.dot(q) / det,
        s.dot(d.cross(e2)) / det,
        d.dot(q) / det,
        cos,
    )
}

/// The error of f32 in the distance to a triangle, and in the weights of its corners.
///
/// Sheared coordinates are at most 4 roundings of numbers up to `away` off; the plane and the edges appear that far from
/// their place, seen under the cosine and in units of the least height.
fn rounding([a, b, c]: [DVec3; 3], away: f64, cos: f64) -> [f64; 2] {
    let slack = 8.0 * HALF_ULP * away / cos;
    let area = (b - a).cross(c - a).length();
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    [slack, slack * longest / area]
}

#[test]
fn distances_and_weights_are_exact_up_to_rounding() {
    let mut random = Random(3);
    let mut hits = 0;
    for i in 0..200_000 {
        let scale = [1e-5, 1e-2, 1.0, 1e3, 1e5][i % 5];
        let v = [0; 3].map(|_| random.point::<f32>(scale));
        let o = random.point::<f32>([1.0, 30.0][i % 2] * scale);
        let target =
            (v[0].f64() + v[1].f64() + v[2].f64()) / 3.0 + random.point::<f64>(scale).f64();
        let d = Vec3::<f32>::new((target - o.f64()).normalize());
        let hit = triangle_hit(o, ray_shear(d), v[0], v[1], v[2]);
        let (t, u, w, cos) = moller_trumbore(o.f64(), d.f64(), v.map(Vec3::f64));
        let [slack, blur] = rounding(v.map(Vec3::f64), scale + o.f64().length(), cos);
        let [a, b, c] = v.map(Vec3::f64);
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        let least = u.min(w).min(1.0 - u - w);
        if least > blur && t > slack {
            hits += 1;
            // The point is weighted from corners; a weight that is off moves it along the plane.
            let along = slack + 3.0 * blur * longest;
            assert!((hit.t.f64() - t).abs() <= along, "{hit:?} {t} ± {along}");
            assert!((hit.u.f64() - u).abs() <= 3.0 * blur && (hit.v.f64() - w).abs() <= 3.0 * blur);
            assert_eq!(hit.back, (b - a).cross(c - a).dot(d.f64()) > 0.0);
        } else if least < -blur || t < -slack {
            assert_eq!(hit.t, -1.0);
        }
    }
    assert!(hits > 20_000);
}

#[test]
fn degenerate_triangles_are_never_hit() {
    let mut random = Random(4);
    for _ in 0..100_000 {
        let (a, b) = (random.point::<f32>(1.0), random.point::<f32>(1.0));
        let o = random.point::<f32>(3.0);
        let on = a.f64() + (b.f64() - a.f64()) * random.unit();
        let shear = ray_shear(Vec3::<f32>::new((on - o.f64()).normalize()));
        for [p, q, r] in [[a, a, b], [a, b, a], [b, a, a], [a, a, a]] {
            assert_eq!(triangle_hit(o, shear, p, q, r).t, -1.0);
        }
    }
}

/// Starts all over triangles, within 1e-4, 1e-6 and 0 of an edge in turn; all directions, each third grazing.
fn departures(triangles: &[Triangle<f32>], n: usize, seed: u64) -> impl Iterator<Item = Ray<f32>> {
    let mut random = Random(seed);
    (0..n).map(move |i| {
        let prim = random.bits() as usize % triangles.len();
        let near = [1.0, 1e-4, 1e-6, 0.0][i % 4];
        let (v, u) = (random.unit() * near, random.unit());
        let uv = [(u * (1.0 - v)) as f32, v as f32];
        let hit = Hit {
            t: 1.0,
            shape: 0,
            prim: prim as u32,
            uv,
        };
        let s = triangle_surface(hit, &triangles[prim], None);
        let mut d: Vec3<f32> = random.direction();
        if i % 3 == 0 {
            let flat = d.f64() - s.ng.f64() * (d.f64().dot(s.ng.f64()) * (1.0 - 1e-4));
            d = Vec3::new(flat.normalize());
        }
        let outside = dot3(d, s.ng) > 0.0;
        let start = if outside { START_OUTSIDE } else { START_INSIDE };
        let t_self = triangle_self_distance(s.p, s.ng, d);
        Ray {
            o: s.p,
            d,
            shape: 0,
            prim: hit.prim,
            start,
            t_self,
            ..Ray::new(vec3(0.0, 0.0, 0.0), d)
        }
    })
}

/// The least distance of the ray's line from an edge of the triangle.
fn edge_distance(ray: Ray<f32>, triangle: &Triangle<f32>) -> f64 {
    let d = ray.d.f64().normalize();
    let across = |v: DVec3| v - d * v.dot(d);
    let v = triangle.v.map(|v| across(v.f64() - ray.o.f64()));
    let distance = |a: DVec3, b: DVec3| {
        let e = b - a;
        (a + e * (-a.dot(e) / e.length_squared()).clamp(0.0, 1.0)).length()
    };
    distance(v[0], v[1])
        .min(distance(v[1], v[2]))
        .min(distance(v[2], v[0]))
}

/// Whether a ray runs into the front of a triangle in whose plane it starts, past an edge of its own, all up to
/// rounding: it starts on both, and no arithmetic with rounded points can decide that it passes by.
fn touches(ray: Ray<f32>, own: &Triangle<f32>, other: &Triangle<f32>, rounding: f64) -> bool {
    let [a, b, c] = other.v.map(Vec3::f64);
    let n = (b - a).cross(c - a).normalize();
    let in_plane = n.dot(ray.o.f64() - a).abs() <= rounding;
    n.dot(ray.d.f64()) < 0.0 && in_plane && edge_distance(ray, own) <= rounding
}

/// A ray that leaves a convex mesh to the outside never meets it again, but where it touches it at its start.
#[test]
fn a_convex_mesh_has_no_acne() {
    for (faces, place) in [(round(), 0.0), (round(), 10.0), (cube(), 0.0)] {
        for scale in [1e-5, 1.0, 1e5] {
            let triangles = mesh(&faces, |p| (p + DVec3::splat(place)) * scale);
            let rounding = 4.0 * HALF_ULP * (place + 2.0) * scale;
            let caught = departures(&triangles, 40_000, 5).filter(|&ray| {
                let hit = nearest(&triangles, ray);
                let of = |prim: u32| &triangles[prim as usize];
                ray.start == START_OUTSIDE
                    && hit.shape != NONE
                    && !touches(ray, of(ray.prim), of(hit.prim), rounding)
            });
            assert_eq!(caught.count(), 0, "at {place}, scale {scale}");
        }
    }
}

/// A ray that leaves a closed mesh to the inside meets it, unless it passes by an edge of its own triangle more
/// closely than coordinates are rounded: beyond the edge, in the corner between two triangles, outside begins.
#[test]
fn no_ray_to_the_inside_of_a_mesh_gets_lost() {
    for (faces, place) in [(bumpy(), 0.0), (bumpy(), 10.0), (cube(), 0.0)] {
        for scale in [1e-5, 1.0, 1e5] {
            let triangles = mesh(&faces, |p| (p + DVec3::splat(place)) * scale);
            let rounding = 4.0 * HALF_ULP * (place + 2.0) * scale;
            let lost = departures(&triangles, 40_000, 6).filter(|&ray| {
                ray.start == START_INSIDE
                    && nearest(&triangles, ray).shape == NONE
                    && edge_distance(ray, &triangles[ray.prim as usize]) > rounding
            });
            assert_eq!(lost.count(), 0, "at {place}, scale {scale}");
        }
    }
}

/// Without the rule for its own mesh, each ray must be caught whose origin was rounded to behind its own triangle.
#[test]
fn acne_is_noticed() {
    let triangles = mesh(&round(), |p| p + DVec3::splat(10.0));
    // Exact arithmetic has the triangle ahead, by more than rounding and within its edges.
    let behind = |ray: &Ray<f32>| {
        let v = triangles[ray.prim as usize].v.map(Vec3::f64);
        let (t, u, w, cos) = moller_trumbore(ray.o.f64(), ray.d.f64(), v);
        let away = v
            .map(|p| p.distance(ray.o.f64()))
            .into_iter()
            .fold(0.0, f64::max);
        let [slack, blur] = rounding(v, away, cos);
        t > slack && u.min(w).min(1.0 - u - w) > blur
    };
    let mut caught = 0;
    for ray in departures(&triangles, 40_000, 5) {
        let stranger = Ray { shape: NONE, ..ray };
        if ray.start == START_OUTSIDE && behind(&ray) {
            assert_ne!(nearest(&triangles, stranger).shape, NONE, "{ray:?}");
            caught += 1;
        }
    }
    assert!(caught > 1000, "only {caught} origins lie behind");
}

/// A wall in a corner stops a ray that starts right next to it.
#[test]
fn a_wall_in_a_corner_is_met_however_near() {
    let triangles = mesh(&cube(), |p| p);
    let floor = triangles
        .iter()
        .position(|t| t.v.iter().all(|v| v.z == -1.0));
    for k in 1..=22 {
        // Inside the cube, on its floor, 2⁻ᵏ from the wall x = 1.
        let x = 1.0 - 2f32.powi(-k);
        let d = Vec3::<f32>::new(DVec3::new(1.0, 0.0, 1e-3).normalize());
        let (p, up) = (vec3(x, 0.25, -1.0), vec3(0.0, 0.0, -1.0));
        let ray = Ray {
            o: p,
            d,
            shape: 0,
            prim: floor.map_or(NONE, |i| i as u32),
            start: START_INSIDE,
            t_self: triangle_self_distance(p, up, d),
            ..Ray::new(vec3(0.0, 0.0, 0.0), d)
        };
        let hit = nearest(&triangles, ray);
        assert!(
            (hit.t - 2f32.powi(-k)).abs() <= 1e-5 * hit.t,
            "{k}: {hit:?}"
        );
    }
}
