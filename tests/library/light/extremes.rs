//! Small and far, on the surface, without area, at the ends of the random numbers: every digit that f32 has, no NaN.

use glam::DVec3;
use vkpt::reference::light::sphere::cone_height;
use vkpt::reference::light::{cdf_choice, cdf_probability, mesh_light_pdf};
use vkpt::reference::math::{Real, Vec3};

use super::emitter::{Emitter, tetrahedron};
use crate::shape::random::Random;

const HALF_ULP: f64 = 1.0 / 16_777_216.0;
/// 1 − 2⁻²⁴
const LAST: f32 = 0.999_999_94;

/// 1 − cos θ_max = s²/(1 + √(1 − s²)) in f64: at most eight roundings of f32 away, for any r/d.
#[test]
fn the_height_of_a_cone_keeps_its_digits() {
    let mut random = Random(1);
    let mut worst = 0.0f64;
    for i in 0..100_000 {
        let r = 10f64.powf(random.between(-5.0, 5.0)) as f32;
        // From almost touching to r/d = 1e-10.
        let apart = 10f64.powf(random.between(-6.0, 10.0)) as f32;
        let d = if i % 2 == 0 {
            r + r * apart
        } else {
            r * apart.max(1.1)
        };
        if d > r {
            let s = r.f64() / d.f64();
            // 1 − s² as it is known near 1: (d − r)(d + r)/d².
            let cos = ((d.f64() - r.f64()) * (d.f64() + r.f64())).sqrt() / d.f64();
            let exact = s * s / (1.0 + cos);
            worst = worst.max((cone_height(r, d).f64() / exact - 1.0).abs());
        }
    }
    assert!(worst <= 8.0 * HALF_ULP, "{}", worst / HALF_ULP);
}

/// Mitsuba's form of it in f32 must fail the same bound.
#[test]
fn cancellation_is_noticed() {
    let s = 1.0f32 / 1500.0;
    let naive = 1.0 - (1.0 - s * s).sqrt();
    let exact = s.f64().powi(2) / (1.0 + (1.0 - s.f64().powi(2)).sqrt());
    assert!((naive.f64() / exact - 1.0).abs() > 0.05);
}

/// Directions to a small or near sphere, in f32 against f64 for the same numbers.
#[test]
fn samples_of_far_and_near_spheres_keep_their_digits() {
    let mut random = Random(2);
    for i in 0..100_000 {
        let scale = 10f64.powf(random.between(-5.0, 5.0));
        let apart = [1.5, 15.0, 15_000.0, 1e8][i % 4];
        let centre: Vec3<f32> = Vec3::new(random.direction::<f64>().f64() * (scale * apart));
        let (r, seed) = (scale as f32, random.bits());
        let narrow = Emitter::<f32>::sphere(centre.f64(), r.f64());
        let wide = Emitter::<f64>::sphere(centre.f64(), r.f64());
        let a = narrow.sample(Vec3::zero(), &mut Random(seed));
        let b = wide.sample(Vec3::zero(), &mut Random(seed));
        assert!(
            (a.pdf.f64() / b.pdf - 1.0).abs() <= 16.0 * HALF_ULP,
            "{apart}: {a:?} {b:?}"
        );
        // A unit vector in f32, turned by a frame of unit vectors.
        assert!((a.wi.f64() - b.wi.f64()).length() <= 16.0 * HALF_ULP);
        assert!((a.wi.f64().length() - 1.0).abs() <= 1e-6);
        // By the rim the distance is as steep as a square root.
        let slack = HALF_ULP.sqrt() * r.f64() + 16.0 * HALF_ULP * b.distance;
        assert!(
            (a.distance.f64() - b.distance).abs() <= slack,
            "{a:?} {b:?}"
        );
    }
}

fn emitters(scale: f64) -> Vec<Emitter<f32>> {
    let v = |x, y, z| DVec3::new(x, y, z) * scale;
    let mesh: Vec<_> = tetrahedron().iter().map(|t| t.map(|p| p * scale)).collect();
    vec![
        Emitter::sphere(v(0.25, 0.5, 0.5), scale),
        Emitter::cuboid(v(0.0, 0.0, 0.0), v(1.0, 2.0, 0.5)),
        Emitter::cuboid(v(0.0, 0.0, 0.0), v(1.0, 2.0, 1e-6)),
        Emitter::cylinder(v(0.0, 0.0, 0.0), v(0.0, 0.0, 2.0), scale),
        Emitter::cylinder(v(0.0, 0.0, 0.0), v(1.0, 2.0, -0.5), 0.01 * scale),
        Emitter::mesh(&mesh),
    ]
}

/// Points inside, outside, far away, on faces, edges, axes and corners.
fn places(scale: f64, random: &mut Random) -> Vec<Vec3<f32>> {
    let mut all = vec![Vec3::zero()];
    for x in [0.0, 0.5, 1.0, 2.0] {
        for y in [0.0, 1.0, 2.0] {
            all.extend([0.0, 0.5, 1.0, 2.0].map(|z| Vec3::new(DVec3::new(x, y, z) * scale)));
        }
    }
    all.extend((0..50).map(|_| random.point(3.0 * scale)));
    all.extend((0..10).map(|_| random.point(1e5 * scale)));
    all
}

#[test]
fn no_sample_is_broken() {
    let mut random = Random(3);
    for scale in [1e-5, 1e-2, 1.0, 1e3, 1e5] {
        for emitter in emitters(scale) {
            for p in places(scale, &mut random) {
                for i in 0..64 {
                    let x = random.unit() as f32;
                    let u = [[0.0, LAST, 0.5, x][i % 4], [x, 0.0, LAST][i % 3]];
                    let u24 = [0, (1 << 24) - 1, 1 << 23, 12_345_678][i / 16];
                    let s = emitter.sample_at(p, u24, u);
                    assert!(s.pdf >= 0.0 && s.pdf.is_finite(), "{emitter:?} {p:?} {s:?}");
                    if s.pdf > 0.0 {
                        assert!((s.wi.f64().length() - 1.0).abs() <= 1e-6, "{p:?} {s:?}");
                        assert!(s.distance > 0.0 && s.distance.is_finite());
                    }
                }
            }
        }
    }
}

#[test]
fn a_triangle_without_area_is_never_drawn_and_has_no_density() {
    let v = DVec3::new;
    let flat = [v(0.0, 0.0, 0.0), v(1.0, 1.0, 1.0), v(2.0, 2.0, 2.0)];
    let good = [v(0.0, 0.0, 1.0), v(1.0, 0.0, 1.0), v(0.0, 1.0, 1.0)];
    let Emitter::Mesh(triangles, cdf) = Emitter::<f64>::mesh(&[flat, good, flat]) else {
        unreachable!("a mesh is a mesh");
    };
    assert_eq!(cdf, [0, 0, 1 << 24, 1 << 24]);
    for u24 in [0, 1, (1 << 24) - 1] {
        assert_eq!(cdf_choice(&cdf, u24), 1);
    }
    assert_eq!(mesh_light_pdf(&triangles, 0, &cdf, 0, 1.0, 1.0), 0.0);
    assert!(mesh_light_pdf(&triangles, 0, &cdf, 1, 1.0, 1.0) > 0.0);
}

/// Every count leads to its own entry, and the probabilities add up exactly.
#[test]
fn choices_are_exact() {
    let cdf = [0, 0, 3, 3, 10, 1 << 20, 1 << 24, 1 << 24];
    let own = |u24: u32| (cdf.iter().rposition(|&c| c <= u24)).map(|i| i as u32);
    for u24 in (0..20).chain([(1 << 20) - 1, 1 << 20, (1 << 24) - 1]) {
        assert_eq!(Some(cdf_choice(&cdf, u24)), own(u24));
    }
    let sum: f32 = (0..7).map(|i| cdf_probability::<f32>(&cdf, i)).sum();
    assert_eq!(sum, 1.0);
}
