//! For any material, angle and random numbers, a sample is a unit vector on the right side with a finite weight and a positive,
//! finite density, or it is no sample (model.md, "Sound samples").

use glam::DVec3;
use vkpt::prepared::{self, MaterialKind};
use vkpt::reference::bsdf::{
    BsdfSample, Interaction, LOBE_DELTA, LOBE_NONE, LOBE_TRANSMISSION, bsdf_eval, bsdf_sample,
};
use vkpt::reference::math::{Real, Vec3};
use vkpt::settings::{Distribution, Settings};

use super::support::random::random;
use super::support::surface::{
    DISTRIBUTIONS, ESTIMATORS, dielectric, direction, estimator, opaque, parameter, seen,
};

const WIDTHS: [f64; 8] = [1e-6, 1e-5, 1e-4, 1.1e-4, 1e-3, 0.05, 0.3, 1.0];
const IORS: [f64; 8] = [1.0, 1.0 + 2e-6, 1.01, 1.5, 2.5, 10.0, 1.0 / 1.5, 0.1];
const COSINES: [f64; 9] = [1e-7, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 0.745_356, 0.99, 1.0];
/// 0, the largest below 1, and between.
const UNIFORMS: [f64; 4] = [0.0, 1.0 - 1.0 / 16_777_216.0, 0.3, 0.75];

/// The error in `s`, if any.
fn complaint<F: Real>(s: &BsdfSample<F>, length_tolerance: f64) -> Option<String> {
    let (wi, weight, pdf) = (s.wi.f64(), s.weight.f64(), s.pdf.f64());
    if s.lobe == LOBE_NONE {
        let empty = weight == DVec3::ZERO && pdf == 0.0;
        return (!empty).then(|| "an invalid sample carries light".to_owned());
    }
    let transmitted = s.lobe & !LOBE_DELTA == LOBE_TRANSMISSION;
    if (wi.length() - 1.0).abs() > length_tolerance || !wi.is_finite() {
        Some(format!("|wi| − 1 = {:e}", wi.length() - 1.0))
    } else if (wi.z < 0.0) != transmitted || wi.z == 0.0 {
        Some(format!("wi.z = {:e} is on the wrong side", wi.z))
    } else if !weight.is_finite() || weight.min_element() < 0.0 {
        Some(format!("weight {weight}"))
    } else if !(pdf > 0.0 && pdf.is_finite()) {
        Some(format!("density {pdf}"))
    } else {
        None
    }
}

/// Materials of every kind; those of a width that is perfectly smooth by its limit also as rough ones.
fn materials(distribution: Distribution, width: f64) -> Vec<prepared::Material> {
    let alpha = parameter(distribution, width);
    let (kd, ks) = (DVec3::new(0.2, 0.5, 0.7), DVec3::new(1.0, 0.3, 0.0));
    let mut all = vec![
        opaque(distribution, alpha, kd, ks),
        opaque(distribution, alpha, DVec3::ZERO, ks),
        opaque(distribution, alpha, kd, DVec3::ZERO),
    ];
    for ior in IORS {
        let mut m = dielectric(distribution, alpha, ior);
        all.push(m);
        m.kd = kd;
        m.kd_mean = (kd.x + kd.y + kd.z) / 3.0;
        m.p_d = 0.4;
        m.fresnel = vkpt::settings::Fresnel::Schlick;
        m.f0 = ks;
        all.push(m);
    }
    for i in 0..all.len() {
        let mut m = all[i];
        m.kind = match m.kind {
            MaterialKind::Mirror => MaterialKind::Glossy,
            MaterialKind::SmoothDielectric if width * (1.0 - m.eta[0]).abs() < 1e-5 => {
                MaterialKind::WeakDielectric
            }
            MaterialKind::SmoothDielectric => MaterialKind::RoughDielectric,
            _ => continue,
        };
        all.push(m);
    }
    all
}

/// Every complaint about samples drawn at `at`, and the number of valid ones.
fn draw_all<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    tolerance: f64,
    found: &mut Vec<String>,
) -> usize {
    let mut valid = 0;
    let u = UNIFORMS.map(F::new);
    for (i, j) in (0..256).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let digit = |k: u32| u[(i >> (2 * k)) & 3];
        let s = bsdf_sample(
            settings,
            at,
            random(digit(0), digit(1), [digit(2), digit(3)], [u[j], u[3 - j]]),
        );
        if let Some(what) = complaint(&s, tolerance) {
            found.push(format!("{what}: {s:?} at {at:?}, numbers {i} {j}"));
        }
        valid += usize::from(s.lobe != LOBE_NONE);
        let e = bsdf_eval(settings, at, s.wi);
        if !(e.value.f64().is_finite() && e.pdf.f64().is_finite() && e.pdf.f64() >= 0.0) {
            found.push(format!("evaluated {e:?} at {at:?} for {:?}", s.wi));
        }
    }
    valid
}

fn all_are_sound<F: Real>(tolerance: f64) {
    let mut found = Vec::new();
    let mut valid = 0;
    for distribution in DISTRIBUTIONS {
        let materials = WIDTHS.iter().flat_map(|&w| materials(distribution, w));
        for (i, m) in materials.enumerate() {
            for (k, &cosine) in COSINES.iter().enumerate() {
                // each angle meets each estimator, with other materials
                let (lobe, normals) = ESTIMATORS[(i + k) % 4];
                let wo = direction(cosine, 0.3 + k as f64);
                let wo = Vec3::<F>::new(wo.f64());
                let at = seen(&m, k % 2 == 0, wo);
                valid += draw_all(&estimator(lobe, normals), &at, tolerance, &mut found);
                let at = seen(&m, k % 2 == 1, wo);
                valid += draw_all(&estimator(lobe, normals), &at, tolerance, &mut found);
            }
        }
    }
    let shown = &found[..found.len().min(10)];
    assert!(
        found.is_empty(),
        "{} of them:\n{}",
        found.len(),
        shown.join("\n")
    );
    assert!(valid > 1_000_000, "only {valid} samples were valid");
}

#[test]
fn samples_are_sound_in_f32() {
    all_are_sound::<f32>(1e-6);
}

#[test]
fn samples_are_sound_in_f64() {
    all_are_sound::<f64>(1e-14);
}

/// A ray that grazes a ball has wo.z = 0, one that meets a shading normal turned away wo.z < 0: micro-facets then give
/// nothing, neither a NaN nor less than nothing.
#[test]
fn from_the_horizon_and_below_it_samples_are_sound() {
    let mut found = Vec::new();
    for distribution in DISTRIBUTIONS {
        for m in WIDTHS.iter().flat_map(|&w| materials(distribution, w)) {
            for (k, z) in [0.0, -0.0, -1e-7, -0.3].into_iter().enumerate() {
                let (lobe, normals) = ESTIMATORS[k];
                let wo = Vec3::<f32>::new(DVec3::new((1.0 - z * z).sqrt(), 0.0, z));
                for outside in [true, false] {
                    let at = seen(&m, outside, wo);
                    let settings = estimator(lobe, normals);
                    draw_all(&settings, &at, 1e-6, &mut found);
                    for wi in [[0.6, 0.0, 0.8], [-0.8, 0.0, 0.6], [-0.6, 0.0, -0.8]] {
                        let e = bsdf_eval(&settings, &at, Vec3::new(DVec3::from(wi)));
                        if !(e.value.f64().min_element() >= 0.0 && e.value.f64().is_finite()) {
                            found.push(format!("evaluated {e:?} at {at:?} for {wi:?}"));
                        }
                    }
                }
            }
        }
    }
    let shown = &found[..found.len().min(10)];
    assert!(
        found.is_empty(),
        "{} of them:\n{}",
        found.len(),
        shown.join("\n")
    );
}

#[test]
fn unsound_samples_are_seen() {
    let m = dielectric(Distribution::Ggx, 0.3, 1.5);
    let at = seen(&m, true, direction(0.5, 0.0));
    let good = bsdf_sample(
        &Settings::default(),
        &at,
        random(0.9, 0.9, [0.2, 0.3], [0.0, 0.0]),
    );
    assert_eq!(good.lobe, LOBE_TRANSMISSION);
    assert_eq!(complaint(&good, 1e-14), None);
    let planted: [fn(&mut BsdfSample<f64>); 6] = [
        |s| s.wi *= Vec3::splat(1.0 + 1e-12),
        |s| s.wi.z = -s.wi.z,
        |s| s.weight.y = f64::NAN,
        |s| s.weight.y = -1e-9,
        |s| s.pdf = 0.0,
        |s| s.lobe = LOBE_NONE,
    ];
    for plant in planted {
        let mut bad = good;
        plant(&mut bad);
        assert!(complaint(&bad, 1e-14).is_some(), "{bad:?}");
    }
}
