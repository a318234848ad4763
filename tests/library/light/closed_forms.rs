//! Solid angles and irradiances: E[1/pdf] and E[cos/pdf] have closed forms.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use vkpt::reference::light::LightSample;
use vkpt::reference::math::Vec3;

use super::ALPHA;
use super::emitter::{Emitter, tetrahedron};
use crate::common::stats::{p_of_mean, sidak};
use crate::shape::random::Random;

const N: usize = 100_000;

/// An emitter seen from p, under n: its solid angle and the irradiance of its unit radiance, where known.
struct Case {
    name: &'static str,
    emitter: Emitter<f64>,
    p: DVec3,
    n: DVec3,
    solid_angle: f64,
    irradiance: f64,
}

/// Van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983.
fn solid_angle_of(corners: [DVec3; 3], p: DVec3) -> f64 {
    let [a, b, c] = corners.map(|v| v - p);
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let below = la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la;
    2.0 * a.dot(b.cross(c)).abs().atan2(below)
}

/// Lambert's formula for a polygon of unit radiance above the horizon: ½ Σ Θᵢ Γᵢ·n.
fn irradiance_of(corners: [DVec3; 3], p: DVec3, n: DVec3) -> f64 {
    let v = corners.map(|v| (v - p).normalize());
    let edge = |a: DVec3, b: DVec3| a.dot(b).acos() * a.cross(b).normalize().dot(n);
    0.5 * (edge(v[0], v[1]) + edge(v[1], v[2]) + edge(v[2], v[0])).abs()
}

fn polygon(
    name: &'static str,
    emitter: Emitter<f64>,
    seen: &[[DVec3; 3]],
    p: DVec3,
    n: DVec3,
) -> Case {
    Case {
        name,
        emitter,
        p,
        n,
        solid_angle: seen.iter().map(|t| solid_angle_of(*t, p)).sum(),
        irradiance: seen.iter().map(|t| irradiance_of(*t, p, n)).sum(),
    }
}

/// The rectangle with corner a and sides u, v.
fn rectangle(a: DVec3, u: DVec3, v: DVec3) -> [[DVec3; 3]; 2] {
    [[a, a + u, a + u + v], [a, a + u + v, a + v]]
}

fn sphere(name: &'static str, radius: f64, away: f64) -> Case {
    let (n, towards) = (DVec3::Z, DVec3::new(0.6, 0.0, 0.8));
    let s = radius / away;
    Case {
        name,
        emitter: Emitter::sphere(towards * away, radius),
        p: DVec3::ZERO,
        n,
        // 2π(1 − cos θ), written without cancellation.
        solid_angle: TAU * s * s / (1.0 + (1.0 - s * s).sqrt()),
        irradiance: PI * s * s * 0.8,
    }
}

/// All around: 4π, and π from the half above.
fn around(name: &'static str, emitter: Emitter<f64>, p: DVec3) -> Case {
    Case {
        name,
        emitter,
        p,
        n: DVec3::Z,
        solid_angle: 2.0 * TAU,
        irradiance: PI,
    }
}

/// ∫ over the side of a cylinder about z that shows its front to p, of dω and of cos dω.
fn side_of_cylinder(radius: f64, height: f64, p: DVec3, n: DVec3) -> (f64, f64) {
    const NODES: u32 = 1000;
    let arc = (radius / p.truncate().length()).acos();
    let towards = p.y.atan2(p.x);
    let (mut solid_angle, mut irradiance) = (0.0, 0.0);
    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(NODES);
    for i in 0..NODES {
        let phi = towards + arc * (2.0 * middle(i) - 1.0);
        let out = DVec3::new(phi.cos(), phi.sin(), 0.0);
        for j in 0..NODES {
            let to = out * radius + DVec3::Z * (height * middle(j)) - p;
            let d = to.normalize();
            let w = -d.dot(out) / to.length_squared() * radius * 2.0 * arc * height;
            solid_angle += w / f64::from(NODES * NODES);
            irradiance += w * d.dot(n).max(0.0) / f64::from(NODES * NODES);
        }
    }
    (solid_angle, irradiance)
}

fn cases() -> Vec<Case> {
    let v = DVec3::new;
    let (lo, hi) = (v(0.5, -1.0, 1.0), v(1.5, 0.4, 1.3));
    let e = hi - lo;
    let cuboid = || Emitter::cuboid(lo, hi);
    let (x, y, z) = (v(e.x, 0.0, 0.0), v(0.0, e.y, 0.0), v(0.0, 0.0, e.z));
    let mut seen = rectangle(lo, x, y).to_vec();
    let below = v(1.0, 0.0, -0.5);
    let one = polygon("box, one face", cuboid(), &seen, below, DVec3::Z);
    seen.extend(rectangle(lo, y, z));
    let two = polygon("box, two faces", cuboid(), &seen, DVec3::ZERO, DVec3::Z);
    // Two triangles that do not hide each other, seen from either side.
    let sheets = [
        [v(0.0, 0.0, 1.0), v(1.0, 0.0, 1.5), v(0.0, 1.0, 1.0)],
        [v(-0.1, -0.1, 2.0), v(-3.0, 0.0, 1.0), v(0.0, -2.0, 1.5)],
    ];
    let mesh = polygon(
        "mesh",
        Emitter::mesh(&sheets),
        &sheets,
        v(0.1, 0.1, 0.0),
        DVec3::Z,
    );
    // A cap seen from its axis: a disc. 2π(1 − cos), π sin².
    let h = v(0.0, 0.0, 1.0);
    let hypotenuse = 1.0f64.hypot(0.5);
    let disc = Case {
        name: "cap",
        emitter: Emitter::cylinder(h, h * 0.2, 0.5),
        p: DVec3::ZERO,
        n: DVec3::Z,
        solid_angle: TAU * (1.0 - 1.0 / hypotenuse),
        irradiance: PI * 0.25 / (hypotenuse * hypotenuse),
    };
    let p = v(1.0, 0.7, 0.4);
    let n = v(-0.8, -0.6, 0.0);
    let (solid_angle, irradiance) = side_of_cylinder(0.5, 2.0, p, n);
    let pillar = || Emitter::cylinder(DVec3::ZERO, v(0.0, 0.0, 2.0), 0.5);
    let side = Case {
        name: "side",
        emitter: pillar(),
        p,
        n,
        solid_angle,
        irradiance,
    };
    vec![
        one,
        two,
        mesh,
        disc,
        side,
        sphere("sphere, near", 1.0, 1.25),
        sphere("sphere, far", 1.0, 15_000.0),
        sphere("sphere, farther", 1e-5, 1e5),
        around(
            "inside a sphere",
            Emitter::sphere(v(0.1, 0.2, 0.3), 1.0),
            DVec3::ZERO,
        ),
        around("inside a box", Emitter::cuboid(-hi, hi), DVec3::ZERO),
        around("inside a cylinder", pillar(), v(0.2, 0.1, 0.6)),
        around("background", Emitter::Background, DVec3::ZERO),
    ]
}

/// p-values of the mean of 1/pdf and of cos/pdf over `n` samples, for a density that may have been tampered with.
fn p_values(case: &Case, n: usize, seed: u64, pdf: impl Fn(&LightSample<f64>) -> f64) -> [f64; 2] {
    let mut random = Random(seed);
    let (mut ones, mut cosines) = (Vec::new(), Vec::new());
    for _ in 0..n {
        let s = case.emitter.sample(Vec3::new(case.p), &mut random);
        let weight = if s.pdf > 0.0 { 1.0 / pdf(&s) } else { 0.0 };
        ones.push(weight);
        cosines.push(weight * s.wi.f64().dot(case.n).max(0.0));
    }
    let p = |samples: &[f64], exact: f64| p_of_mean(samples, exact, 1e-9 * exact);
    [p(&ones, case.solid_angle), p(&cosines, case.irradiance)]
}

#[test]
fn estimates_meet_solid_angles_and_irradiances() {
    let cases = cases();
    let level = sidak(ALPHA, 2 * cases.len());
    for (i, case) in cases.iter().enumerate() {
        for (what, p) in
            ["solid angle", "irradiance"]
                .iter()
                .zip(p_values(case, N, i as u64, |s| s.pdf))
        {
            assert!(p > level, "{what} of {}: p = {p}", case.name);
        }
    }
}

/// A tetrahedron's four faces, each seen through the others: 1/pdf sums to the solid angle of every one of them.
#[test]
fn every_triangle_of_a_mesh_counts_wherever_it_faces() {
    let mesh = tetrahedron();
    let p = DVec3::new(2.0, -1.0, 0.5);
    let case = polygon("tetrahedron", Emitter::mesh(&mesh), &mesh, p, DVec3::NEG_X);
    let [solid_angle, _] = p_values(&case, N, 50, |s| s.pdf);
    assert!(solid_angle > ALPHA);
}

#[test]
fn planted_errors_are_caught() {
    let cases = cases();
    let level = sidak(ALPHA, 2 * cases.len());
    for (i, case) in cases.iter().enumerate() {
        let more = p_values(case, 4 * N, i as u64, |s| s.pdf * 1.01);
        assert!(more[0] <= level, "×1.01 passes for {}: {more:?}", case.name);
        let n = case.n;
        let two_cosines = p_values(case, N, i as u64, |s| s.pdf / s.wi.f64().dot(n).abs());
        assert!(
            two_cosines[0] <= level,
            "two cosines pass for {}",
            case.name
        );
    }
}
