//! The samples against their density, over the sphere of directions.

use std::f64::consts::PI;

use glam::DVec3;
use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::reference::math::{Real, Vec3};

use super::ALPHA;
use super::emitter::{Emitter, tetrahedron};
use super::window::Window;
use crate::common::stats::{chi_square, sidak};
use crate::shape::random::Random;

const N: usize = 100_000;

/// An emitter, where it is seen from, the directions it may fill, and how many samples yield one.
struct Case {
    name: &'static str,
    emitter: Emitter<f64>,
    p: DVec3,
    window: Window,
    valid: f64,
}

fn case(name: &'static str, emitter: Emitter<f64>, p: DVec3, window: Window) -> Case {
    Case {
        name,
        emitter,
        p,
        window,
        valid: 1.0,
    }
}

/// The cone from p about a ball of `radius` around `middle`, a little wider.
fn around(p: DVec3, middle: DVec3, radius: f64) -> Window {
    let s = (1.01 * radius / (middle - p).length()).min(1.0);
    Window::cone(middle - p, (1.0 - s * s).sqrt())
}

fn everywhere() -> Window {
    Window::cone(DVec3::new(0.3, 0.2, 1.0), -1.0)
}

fn spheres_and_boxes() -> Vec<Case> {
    let v = DVec3::new;
    let c = v(0.3, -0.2, 0.5);
    let sphere = || Emitter::sphere(c, 1.0);
    let (lo, hi) = (v(-0.5, -1.0, 0.0), v(0.5, 0.4, 0.3));
    let cuboid = || Emitter::cuboid(lo, hi);
    let seen = |p| around(p, (lo + hi) / 2.0, (hi - lo).length() / 2.0);
    let (near, far) = (c + v(0.0, 1.1, 0.2), c + v(90.0, -30.0, 20.0));
    let touching = c + v(0.0, 1.0 + 1e-5, 0.0);
    let (one, two, three) = (v(0.1, 0.0, 2.0), v(0.1, -2.0, 1.5), v(2.0, -2.0, 1.5));
    let (close, away) = (v(0.1, -0.2, 0.6), v(-70.0, 40.0, 90.0));
    vec![
        case("sphere, near", sphere(), near, around(near, c, 1.0)),
        case(
            "sphere, all but touching",
            sphere(),
            touching,
            around(touching, c, 1.0),
        ),
        case("sphere, far", sphere(), far, around(far, c, 1.0)),
        case(
            "sphere, inside",
            sphere(),
            c + v(0.3, 0.1, -0.6),
            everywhere(),
        ),
        case("box, one face", cuboid(), one, seen(one)),
        case("box, two faces", cuboid(), two, seen(two)),
        case("box, three faces", cuboid(), three, seen(three)),
        case("box, near", cuboid(), close, everywhere()),
        case("box, far", cuboid(), away, seen(away)),
        case("box, inside", cuboid(), v(0.2, 0.1, 0.1), everywhere()),
        case(
            "background",
            Emitter::Background,
            v(0.0, 0.0, 0.0),
            everywhere(),
        ),
    ]
}

fn cylinders_and_meshes() -> Vec<Case> {
    let v = DVec3::new;
    let axis = v(0.0, 0.0, 2.0);
    let cylinder = || Emitter::cylinder(DVec3::ZERO, axis, 0.5);
    let (above, inside) = (v(0.3, 0.2, 3.0), v(0.1, 0.2, 0.7));
    let beside = |name, p: DVec3| {
        let rho = p.truncate().length();
        // Between the planes through the axis's direction that touch: sin φ = r/ρ. The arc with cos > r/ρ shows its front, out
        // of the half turn that is drawn from.
        let half = (0.5 / rho).asin();
        let z = |h: f64, x: f64| (h - p.z) / (h - p.z).hypot(x);
        let reach = [rho - 0.5, rho + 0.5];
        let low = z(0.0, reach[0]).min(z(0.0, reach[1]));
        let high = z(2.0, reach[0]).max(z(2.0, reach[1]));
        let (side, cap) = (PI * 0.5 * 2.0, PI * 0.25);
        let caps = if p.z > 2.0 { cap } else { 0.0 };
        let arc = 2.0 * (0.5 / rho).acos() / PI;
        Case {
            valid: (side * arc + caps) / (side + caps),
            ..case(
                name,
                cylinder(),
                p,
                Window::beside(axis, v(-p.x, -p.y, 0.0), half, [low, high]),
            )
        }
    };
    let mesh = tetrahedron();
    let m = v(0.4, 0.25, 0.4);
    let (p, far) = (v(2.0, -1.0, 0.5), v(-60.0, 80.0, -30.0));
    vec![
        case(
            "cylinder, above",
            cylinder(),
            above,
            around(above, v(0.0, 0.0, 2.0), 0.5),
        ),
        case(
            "cylinder, inside",
            cylinder(),
            inside,
            Window::cone(axis, -1.0),
        ),
        beside("cylinder, beside", v(1.2, -0.5, 0.8)),
        beside("cylinder, beside and above", v(1.2, -0.5, 2.6)),
        beside("cylinder, near its side", v(0.5, -0.25, 1.2)),
        beside("cylinder, far", v(40.0, -25.0, 1.3)),
        beside("cylinder, far above", v(5.0, 3.0, 80.0)),
        case("mesh, outside", Emitter::mesh(&mesh), p, around(p, m, 1.2)),
        case("mesh, far", Emitter::mesh(&mesh), far, around(far, m, 1.2)),
        case(
            "mesh, inside",
            Emitter::mesh(&mesh),
            v(0.4, 0.25, 0.3),
            everywhere(),
        ),
    ]
}

fn cases() -> Vec<Case> {
    let mut all = spheres_and_boxes();
    all.extend(cylinders_and_meshes());
    all
}

struct Drawn {
    counts: Vec<usize>,
    valid: usize,
    outside: usize,
}

fn draw(case: &Case, seed: u64) -> Drawn {
    let mut random = Random(seed);
    let mut drawn = Drawn {
        counts: vec![0; 400],
        valid: 0,
        outside: 0,
    };
    for _ in 0..N {
        let s = case.emitter.sample(Vec3::new(case.p), &mut random);
        if s.pdf > 0.0 {
            drawn.valid += 1;
            match case.window.bin(s.wi) {
                Some(bin) => drawn.counts[bin] += 1,
                None => drawn.outside += 1,
            }
        }
    }
    drawn
}

#[test]
fn samples_follow_their_density() {
    let cases = cases();
    let level = sidak(ALPHA, cases.len());
    for (i, case) in cases.iter().enumerate() {
        let p = Vec3::new(case.p);
        let expected = case.window.integrate(|d| case.emitter.pdf(p, d) * N as f64);
        let drawn = draw(case, 100 + i as u64);
        assert_eq!(drawn.outside, 0, "{}", case.name);
        let p_value = chi_square(&drawn.counts, &expected);
        assert!(p_value > level, "{}: p = {p_value}", case.name);
    }
}

/// ∫ pdf dω + P(no sample) = 1. The midpoint rule with 10⁶ nodes is wrong in the cells on outlines alone: by at most
/// half of 4000 of them.
#[test]
fn densities_integrate_to_one() {
    for case in cases() {
        let p = Vec3::new(case.p);
        let whole: f64 = case
            .window
            .integrate(|d| case.emitter.pdf(p, d))
            .iter()
            .sum();
        let off = whole - case.valid;
        assert!(
            off.abs() < 2e-3,
            "{}: {whole} for {}",
            case.name,
            case.valid
        );
    }
}

/// Next to a cylinder some samples show their back: the arc gives their share.
#[test]
fn samples_are_lost_as_often_as_the_arc_says() {
    let cases = cases();
    let level = sidak(ALPHA, cases.len());
    for (i, case) in cases.iter().enumerate() {
        let valid = draw(case, 200 + i as u64).valid as u64;
        if case.valid == 1.0 {
            assert_eq!(valid, N as u64, "{}", case.name);
        } else {
            let binomial = Binomial::new(case.valid, N as u64).expect("a probability");
            let below = binomial.cdf(valid);
            assert!(
                below > level / 2.0 && below < 1.0 - level / 2.0,
                "{}",
                case.name
            );
        }
    }
}

/// The density that a sample carries is the one that a path which hits the same point would compute.
#[test]
fn a_hit_has_the_density_of_the_sample() {
    for (i, case) in cases().iter().enumerate() {
        let (p, mut random) = (Vec3::new(case.p), Random(300 + i as u64));
        for _ in 0..N / 10 {
            let s = case.emitter.sample(p, &mut random);
            let sights = case.emitter.sights(p, s.wi);
            let away = |t: f64| {
                if s.distance < 0.0 {
                    0.0
                } else {
                    (t - s.distance).abs()
                }
            };
            let same = sights
                .iter()
                .min_by(|a, b| away(a.distance).total_cmp(&away(b.distance)));
            match same {
                Some(hit) if s.pdf > 0.0 => {
                    // Rounding in f64, seen under the cosine.
                    let slack = 1e-12 / hit.cosine.powi(2);
                    assert!(
                        away(hit.distance) <= slack * s.distance.abs(),
                        "{}",
                        case.name
                    );
                    let ratio = hit.pdf / s.pdf;
                    assert!((ratio - 1.0).abs() <= slack, "{}: {ratio}", case.name);
                }
                // Within rounding of an outline.
                None if s.pdf > 0.0 => assert!(s.pdf > 1e5 || case.name.starts_with("sphere")),
                _ => {}
            }
        }
    }
}

/// Two cosines instead of one, and the density of another point: the test of the density must notice.
#[test]
fn planted_errors_are_caught() {
    let level = sidak(ALPHA, cases().len());
    let mut caught = [0, 0, 0];
    let mut boxes = 0;
    for (i, case) in cases()
        .iter()
        .enumerate()
        .filter(|(_, c)| c.name.starts_with("box"))
    {
        boxes += 1;
        let p = Vec3::new(case.p);
        let drawn = draw(case, 100 + i as u64);
        let two_cosines = case.window.integrate(|d| {
            case.emitter
                .sights(p, d)
                .iter()
                .map(|s| s.pdf * s.cosine * N as f64)
                .sum()
        });
        let beside = p + Vec3::splat(0.05);
        let moved = case
            .window
            .integrate(|d| case.emitter.pdf(beside, d) * N as f64);
        let more = case.window.integrate(|d| case.emitter.pdf(p, d) * 1.01);
        caught[0] += usize::from(chi_square(&drawn.counts, &two_cosines) <= level);
        caught[1] += usize::from(chi_square(&drawn.counts, &moved) <= level);
        caught[2] += usize::from((more.iter().sum::<f64>() - case.valid).abs() >= 2e-3);
    }
    assert_eq!(caught, [boxes; 3]);
}

/// The samples of f32 are those of f64 for the same random numbers, except for rounding: 1e-7, seen under cosines down to 1e-4.
/// A light seen more edge-on has a density beyond 1e3, and a choice at its limit may fall either way.
#[test]
fn samples_in_f32_are_those_in_f64() {
    let v = DVec3::new;
    let (lo, hi) = (v(-0.5, -1.0, 0.0), v(0.5, 0.4, 0.3));
    let pairs: Vec<(Emitter<f32>, Emitter<f64>)> = vec![
        (
            Emitter::sphere(v(0.25, -0.5, 0.5), 1.0),
            Emitter::sphere(v(0.25, -0.5, 0.5), 1.0),
        ),
        (Emitter::cuboid(lo, hi), Emitter::cuboid(lo, hi)),
        (
            Emitter::cylinder(lo, v(0.0, 0.0, 2.0), 0.5),
            Emitter::cylinder(lo, v(0.0, 0.0, 2.0), 0.5),
        ),
        (Emitter::mesh(&tetrahedron()), Emitter::mesh(&tetrahedron())),
    ];
    let mut random = Random(400);
    for (narrow, wide) in pairs {
        let mut diverged = 0;
        for _ in 0..N / 10 {
            let p = random.point::<f32>(3.0);
            let seed = random.bits();
            let a = narrow.sample(p, &mut Random(seed));
            let b = wide.sample(Vec3::new(p.f64()), &mut Random(seed));
            let off = (a.wi.f64() - b.wi.f64()).length();
            if off > 1e-4 || (a.pdf > 0.0) != (b.pdf > 0.0) {
                diverged += 1;
            } else if b.pdf > 0.0 {
                let pdf = (a.pdf.f64() / b.pdf - 1.0).abs();
                assert!(pdf < 1e-3 || b.pdf > 1e3, "{a:?} {b:?}");
            }
        }
        assert!(diverged < N / 1000, "{diverged}");
    }
}
