//! Where shading normals are far from a face's: wo sees the normal of a mirror or of glass, and delta directions leave the
//! face on the side they are meant for. Directions that were valid stay unchanged.

use glam::DVec3;
use vkpt::prepared::MaterialKind;
use vkpt::reference::bsdf::{LOBE_DELTA, LOBE_REFLECTION, LOBE_TRANSMISSION};
use vkpt::reference::math::Vec3;
use vkpt::reference::path::valid::{LIFT, SEEN, leaving_direction, seen_normal};

/// Triples of directions: the k-th by the fractional parts of multiples of k of irrational numbers.
fn directions(k: u32) -> [DVec3; 3] {
    let u = |p: f64| (p.sqrt() * f64::from(k)).fract();
    [[2.0, 3.0], [5.0, 7.0], [11.0, 13.0]].map(|[a, b]| {
        let (z, (sin, cos)) = (2.0 * u(a) - 1.0, (std::f64::consts::TAU * u(b)).sin_cos());
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * cos, r * sin, z)
    })
}

#[test]
fn wo_sees_the_normals_of_mirrors_and_glass() {
    let mut turned = 0;
    for k in 1..20_000 {
        let [n, g, wo] = directions(k);
        let seen = |kind| seen_normal(Vec3::<f64>::new(n), Vec3::new(g), Vec3::new(wo), kind).f64();
        assert_eq!(seen(MaterialKind::Diffuse), n);
        let m = seen(MaterialKind::SmoothDielectric);
        assert!((m.length() - 1.0).abs() < 1e-15, "{m}");
        if n.dot(wo) >= SEEN {
            assert_eq!(m, n);
        } else {
            turned += 1;
            // the length of n + (SEEN − c) wo is at most 1 + SEEN²/2, reached where c = 0
            assert!(
                m.dot(wo) >= SEEN / (1.0 + SEEN * SEEN / 2.0),
                "{n} {wo}: {m}"
            );
            assert!(
                m.dot(wo) <= 1.0 && m.cross(wo).dot(n).abs() < 1e-12,
                "turned in their plane"
            );
        }
    }
    assert!(turned > 9_000, "{turned}");
}

#[test]
fn delta_directions_leave_on_their_side() {
    let mut lifted = 0;
    for k in 1..20_000 {
        let [n, g, wi] = directions(k);
        for (side, lobe) in [(1.0, LOBE_REFLECTION), (-1.0, LOBE_TRANSMISSION)] {
            let leaving = |n: DVec3, lobe| {
                leaving_direction(Vec3::<f64>::new(n), Vec3::new(g), Vec3::new(wi), side, lobe)
                    .f64()
            };
            assert_eq!(leaving(n, lobe), wi, "a density stays");
            assert_eq!(leaving(g, lobe | LOBE_DELTA), wi, "a flat face");
            let w = leaving(n, lobe | LOBE_DELTA);
            if side * wi.dot(g) > 0.0 {
                assert_eq!(w, wi);
            } else {
                lifted += 1;
                assert!((w.length() - 1.0).abs() < 1e-15, "{w}");
                // the length of wi + (LIFT − wi·g) g is at most 1 + LIFT²/2
                assert!(
                    side * w.dot(g) >= LIFT / (1.0 + LIFT * LIFT / 2.0),
                    "{wi} {g}: {w}"
                );
            }
        }
    }
    assert!(lifted > 19_000, "{lifted}");
}
