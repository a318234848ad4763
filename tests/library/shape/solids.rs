//! Distances to solids in f32 against textbook formulas in f64, for the very same f32 numbers.

use glam::DVec3;
use vkpt::reference::math::{Real, Vec3, dot3, frame::frame_about};
use vkpt::reference::shape::{Cylinder, START_ELSEWHERE, box_hit, cylinder_hit, sphere_hit};

use super::random::Random;

/// Half an ulp of 1 in f32.
const HALF_ULP: f64 = 1.0 / 16_777_216.0;
const SCALES: [f64; 5] = [1e-5, 1e-2, 1.0, 1e3, 1e5];
/// Distances of the origin from the solid, in its sizes.
const DISTANCES: [f64; 4] = [0.01, 1.0, 30.0, 1000.0];

/// A hit by a formula in f64: distance and |n·d|.
type Exact = Option<(f64, f64)>;

/// The roots of a t² − 2 b t + c that is the textbook's way.
fn quadratic(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let disc = b * b - a * c;
    (disc >= 0.0).then(|| ((b - disc.sqrt()) / a, (b + disc.sqrt()) / a))
}

fn exact_sphere(o: DVec3, d: DVec3, centre: DVec3, r: f64) -> Exact {
    let oc = o - centre;
    let (t0, t1) = quadratic(d.length_squared(), -oc.dot(d), oc.length_squared() - r * r)?;
    let t = if t0 > 0.0 { t0 } else { t1 };
    (t > 0.0).then(|| (t, ((oc + d * t) / r).dot(d).abs()))
}

/// The least t > 0 at which the ray crosses one of six planes within the face.
fn exact_box(o: DVec3, d: DVec3, lo: DVec3, hi: DVec3) -> Exact {
    let mut best: Exact = None;
    for axis in 0..3 {
        for plane in [lo[axis], hi[axis]] {
            let t = (plane - o[axis]) / d[axis];
            let p = o + d * t;
            let within = (0..3).all(|k| k == axis || (lo[k] <= p[k] && p[k] <= hi[k]));
            if within && t > 0.0 && best.is_none_or(|b| t < b.0) {
                best = Some((t, d[axis].abs()));
            }
        }
    }
    best
}

fn exact_cylinder(o: DVec3, d: DVec3, c: &Cylinder<f64>) -> Exact {
    let local = |v: DVec3| DVec3::new(v.dot(c.u.f64()), v.dot(c.v.f64()), v.dot(c.w.f64()));
    let (o, d) = (local(o - c.base.f64()), local(d));
    let (r, h) = (c.radius, c.height);
    let mut hits = Vec::new();
    let a = d.x * d.x + d.y * d.y;
    let b = -(o.x * d.x + o.y * d.y);
    if let Some((t0, t1)) = quadratic(a, b, o.x * o.x + o.y * o.y - r * r) {
        for t in [t0, t1] {
            let p = o + d * t;
            if (0.0..=h).contains(&p.z) {
                hits.push((t, ((p.x * d.x + p.y * d.y) / r).abs()));
            }
        }
    }
    for t in [-o.z / d.z, (h - o.z) / d.z] {
        let p = o + d * t;
        if p.x * p.x + p.y * p.y <= r * r {
            hits.push((t, d.z.abs()));
        }
    }
    hits.into_iter()
        .filter(|h| h.0 > 0.0)
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Whether a distance in f32 is the exact one as far as rounding allows.
///
/// A solid of `size`, `away` from the origin: with at most sixteen roundings in a row of numbers of that
/// size its surface appears at most `slack` = 16 (away + size) half-ulps from its place, the distance
/// along the ray at most slack/cos. Where the solid, `slack` larger and smaller, would be both hit and
/// missed (or its edge lies between two parts), either answer is right.
fn agrees(t: f64, slack: f64, exact: impl Fn(f64) -> Exact) -> bool {
    let (small, here, large) = (exact(-slack), exact(0.0), exact(slack));
    match (small, here, large) {
        (Some(s), Some((t0, cos)), Some(l)) => {
            let spread = (s.0 - l.0).abs();
            (t - t0).abs() <= slack / cos + 2.0 * spread
        }
        (None, None, None) => t < 0.0,
        _ => true,
    }
}

struct Case {
    o: Vec3<f32>,
    d: Vec3<f32>,
    slack: f64,
}

/// Rays towards a solid of `size` about `centre`: through a point well inside, by its silhouette, or past it.
fn rays(seed: u64, n: usize, size: f64, centre: DVec3) -> impl Iterator<Item = Case> {
    let mut random = Random(seed);
    (0..n).map(move |i| {
        let away = DISTANCES[i % 4] * size + size;
        let towards: Vec3<f64> = random.direction();
        let o: Vec3<f32> = Vec3::new(centre + towards.f64() * away);
        let aim = random.direction::<f64>().f64() * (size * random.between(0.0, 1.2));
        Case {
            o,
            d: Vec3::new((centre + aim - o.f64()).normalize()),
            slack: 16.0 * HALF_ULP * (away + size + centre.length()),
        }
    })
}

fn check(name: &str, right: usize, n: usize) {
    assert_eq!(right, n, "{name}: {} of {n} distances are wrong", n - right);
}

const N: usize = 40_000;

#[test]
fn sphere_distances_are_exact_up_to_rounding() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let centre: Vec3<f32> = Random(i as u64).point(scale);
        let r = scale as f32;
        let right = rays(10 + i as u64, N, scale, centre.f64()).filter(|c| {
            let t = sphere_hit(c.o, c.d, centre, r, START_ELSEWHERE);
            agrees(t.f64(), c.slack, |e| {
                exact_sphere(c.o.f64(), c.d.f64(), centre.f64(), r.f64() + e)
            })
        });
        check("sphere", right.count(), N);
    }
}

#[test]
fn box_distances_are_exact_up_to_rounding() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        let centre: Vec3<f32> = random.point(scale);
        let half = random.point::<f32>(0.4 * scale) + Vec3::splat(0.6 * scale as f32);
        let (lo, hi) = (centre - half, centre + half);
        let right = rays(20 + i as u64, N, scale, centre.f64()).filter(|c| {
            let t = box_hit(c.o, c.d, lo, hi, START_ELSEWHERE).t;
            agrees(t.f64(), c.slack, |e| {
                let e = DVec3::splat(e);
                exact_box(c.o.f64(), c.d.f64(), lo.f64() - e, hi.f64() + e)
            })
        });
        check("box", right.count(), N);
    }
}

#[test]
fn cylinder_distances_are_exact_up_to_rounding() {
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Random(i as u64);
        let cylinder = some_cylinder(&mut random, scale);
        let wide = cylinder_in_f64(&cylinder);
        let middle = (wide.base + wide.w * (0.5 * wide.height)).f64();
        let right = rays(30 + i as u64, N, scale, middle).filter(|c| {
            let t = cylinder_hit(c.o, c.d, &cylinder, START_ELSEWHERE, 0).t;
            agrees(t.f64(), c.slack, |e| {
                let grown = Cylinder {
                    base: wide.base - wide.w * e,
                    height: wide.height + 2.0 * e,
                    radius: wide.radius + e,
                    ..wide
                };
                exact_cylinder(c.o.f64(), c.d.f64(), &grown)
            })
        });
        check("cylinder", right.count(), N);
    }
}

pub fn some_cylinder(random: &mut Random, scale: f64) -> Cylinder<f32> {
    let frame = frame_about(random.direction::<f64>());
    Cylinder {
        base: random.point(scale),
        u: Vec3::new(frame.t.f64()),
        v: Vec3::new(frame.b.f64()),
        w: Vec3::new(frame.n.f64()),
        height: (scale * random.between(0.2, 1.2)) as f32,
        radius: (scale * random.between(0.2, 1.0)) as f32,
        shape: 0,
    }
}

fn cylinder_in_f64(c: &Cylinder<f32>) -> Cylinder<f64> {
    let wide = |v: Vec3<f32>| Vec3::new(v.f64());
    Cylinder {
        base: wide(c.base),
        u: wide(c.u),
        v: wide(c.v),
        w: wide(c.w),
        height: c.height.f64(),
        radius: c.radius.f64(),
        shape: 0,
    }
}

/// The textbook's discriminant loses a far sphere in f32; the comparison above must notice.
#[test]
fn a_textbook_discriminant_in_f32_is_caught() {
    let (centre, r) = (Vec3::<f32>::zero(), 1.0f32);
    let wrong = rays(40, N, 1.0, DVec3::ZERO).filter(|c| {
        let b = -dot3(c.o, c.d);
        let disc = b * b - (dot3(c.o, c.o) - r * r);
        let t = if disc < 0.0 { -1.0 } else { b - disc.sqrt() };
        !agrees(t.f64(), c.slack, |e| {
            exact_sphere(c.o.f64(), c.d.f64(), centre.f64(), r.f64() + e)
        })
    });
    assert!(wrong.count() > N / 100);
}

/// So must a distance that is wrong by a thousandth.
#[test]
fn a_planted_error_is_caught() {
    let (centre, r) = (Vec3::<f32>::zero(), 1.0f32);
    let wrong = rays(41, N, 1.0, DVec3::ZERO).filter(|c| {
        let t = sphere_hit(c.o, c.d, centre, r, START_ELSEWHERE) * 1.001;
        !agrees(t.f64(), c.slack, |e| {
            exact_sphere(c.o.f64(), c.d.f64(), centre.f64(), r.f64() + e)
        })
    });
    assert!(wrong.count() > N / 4);
}

#[test]
fn f64_reproduces_a_hit_that_it_was_made_from() {
    let mut random = Random(50);
    for _ in 0..N {
        let centre: Vec3<f64> = random.point(1.0);
        let n = random.direction::<f64>();
        let d = random.direction::<f64>();
        let cos = -dot3(n, d);
        if cos > 0.01 {
            let t0 = random.between(0.1, 10.0);
            let o = centre + n * 0.5 - d * t0;
            let t = sphere_hit(o, d, centre, 0.5, START_ELSEWHERE);
            assert!((t - t0).abs() <= 1e-14 * (t0 + 2.0) / cos, "{t} {t0}");
        }
    }
}
