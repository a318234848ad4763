//! The cost of f32: the forms in use against the same function in f64 on the same inputs.

use glam::DVec3;
use vkpt::reference::bsdf::distribution::{distribution_d, distribution_sample};
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::normals::normals_sample;
use vkpt::reference::math::{Vec3, vec3};
use vkpt::settings::{Distribution, Settings};

use super::support::random::Random;
use super::support::surface::{DISTRIBUTIONS, dielectric, direction, opaque, parameter, seen};

const WIDTHS: [f64; 5] = [1e-4, 1e-3, 1e-2, 0.1, 1.0];

/// The q-quantile of |a/b − 1|.
fn quantile(mut errors: Vec<f64>, q: f64) -> f64 {
    errors.sort_by(f64::total_cmp);
    errors[((errors.len() - 1) as f64 * q) as usize]
}

fn relative(a: f64, b: f64) -> f64 {
    if a == b { 0.0 } else { (a / b - 1.0).abs() }
}

/// A number that f32 represents exactly, in [0, 1).
fn uniform(r: &mut Random) -> f64 {
    (r.bits() >> 40) as f64 / 16_777_216.0
}

/// D and the sampled tan θ keep their digits at every width (model.md, "Precision of the distributions").
#[test]
fn distributions_keep_their_digits() {
    let mut r = Random::new(1);
    for d in DISTRIBUTIONS {
        for width in WIDTHS {
            // an exponent that f32 represents exactly
            let alpha = f64::from(parameter(d, width) as f32);
            let m = opaque(d, alpha, DVec3::ZERO, DVec3::ONE);
            let up = vec3(0.0, 0.0, 1.0);
            let (single, double) = (
                seen::<f32>(&m, true, Vec3::new(up.f64())),
                seen(&m, true, up),
            );
            // the widths too: sampling scales with them
            let mut double = double.material;
            double.alpha = f64::from(single.material.alpha);
            let (mut tan, mut density) = (Vec::new(), Vec::new());
            for _ in 0..4_000 {
                let u = [uniform(&mut r), uniform(&mut r)];
                let n = distribution_sample(&single.material, u.map(|x| x as f32));
                let exact = distribution_sample(&double, u);
                let slope = |v: DVec3| v.x.hypot(v.y) / v.z;
                tan.push(relative(slope(n.f64()), slope(exact.f64())));
                let same = vec3(f64::from(n.x), f64::from(n.y), f64::from(n.z));
                density.push(relative(
                    f64::from(distribution_d(&single.material, n)),
                    distribution_d(&double, same),
                ));
            }
            // a few units of 6e-8; −ln(D/D(N)) units for an exponential
            let (t, p) = (quantile(tan, 0.5), quantile(density, 0.5));
            assert!(t < 2e-7 && p < 5e-7, "{d:?} {width}: tan θ {t:e}, D {p:e}");
        }
    }
}

/// Visible normals lose few digits at any angle (model.md, "Visible micro-normals"): GGX's form cancels nowhere; close to where
/// `wo` sees no facets, the visible ones are at the root of the rest of the others, and of its digits.
#[test]
fn visible_normals_keep_their_digits() {
    let bounds = [
        (Distribution::Ggx, 2e-7, 2e-6),
        (Distribution::Beckmann, 4e-7, 2e-5),
        (Distribution::Phong, 4e-7, 2e-5),
    ];
    for (distribution, median, nearly_all) in bounds {
        let errors = visible_normal_errors(distribution);
        let (p50, p99) = (quantile(errors.clone(), 0.5), quantile(errors, 0.99));
        assert!(
            p50 < median && p99 < nearly_all,
            "{distribution:?}: {p50:e} {p99:e}"
        );
    }
}

/// The error of a normal's slope in f32 against f64's, relative to it.
fn visible_normal_errors(distribution: Distribution) -> Vec<f64> {
    let mut r = Random::new(2);
    let mut errors = Vec::new();
    for _ in 0..20_000 {
        let width = f64::from((1e-4f64).powf(r.unit()) as f32);
        let alpha = f64::from(parameter(distribution, width) as f32);
        let m = opaque(distribution, alpha, DVec3::ZERO, DVec3::ONE);
        let wo = Vec3::<f32>::new(direction(r.unit().powi(2) + 1e-6, 6.0 * r.unit()).f64());
        let exact = vec3(f64::from(wo.x), f64::from(wo.y), f64::from(wo.z));
        let u = [uniform(&mut r), uniform(&mut r)];
        let settings = Settings::default();
        let n = normals_sample(&settings, &seen(&m, true, wo), u.map(|x| x as f32));
        let truth = normals_sample(&settings, &seen(&m, true, exact), u).f64();
        let off = (n.f64() / f64::from(n.z) - truth / truth.z).length();
        errors.push(off / (truth / truth.z).truncate().length());
    }
    errors
}

/// Exact Fresnel at n = 1 + 1e-6, where the usual form is 9 % off (model.md, "Exact reflectance").
#[test]
fn fresnel_near_ior_one_keeps_its_digits() {
    let m = dielectric(Distribution::Ggx, 0.3, 1.0 + 1e-6);
    let mut worst = 0.0f64;
    let mut usual = 0.0f64;
    for i in 1..=1000 {
        let c = i as f32 / 1000.0;
        let up = vec3(0.0f32, 0.0, 1.0);
        let single = f64::from(fresnel(&seen(&m, true, up), c).x);
        let exact = fresnel(&seen(&m, true, vec3(0.0, 0.0, 1.0)), f64::from(c)).x;
        worst = worst.max(relative(single, exact));
        // the hand-out's: g = √(n² − 1 + c²), (g − c)²/(g + c)² …, in f32
        let n = (1.0 + 1e-6) as f32;
        let g = (n * n - 1.0 + c * c).sqrt();
        let b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
        let f = 0.5 * ((g - c) / (g + c)).powi(2) * (1.0 + b * b);
        usual = usual.max(relative(f64::from(f), exact));
    }
    assert!(worst < 2e-6, "{worst:e}");
    assert!(usual > 0.05, "{usual}");
}
