//! The kinds with one lobe, or with lobes that have no density: those with one fit it (model.md, "Samples against density"),
//! and every lobe is drawn as often as it should be (model.md, "Choice of lobe"), in probabilities computed here from
//! cosines and constants alone.

use glam::DVec3;
use vkpt::prepared::{Material, MaterialKind};
use vkpt::reference::bsdf::{
    Interaction, LOBE_DELTA, LOBE_DIFFUSE, LOBE_NONE, LOBE_REFLECTION, LOBE_TRANSMISSION,
    bsdf_eval, bsdf_sample,
};
use vkpt::reference::math::Vec3;
use vkpt::settings::{Distribution, Fresnel, LobeChoice, Normals, Settings};

use super::support::chi_square::{Verdict, compare, expectation, histogram};
use super::support::random::{Random, random};
use super::support::statistics::{binomial_p, sidak};
use super::support::surface::{ESTIMATORS, dielectric, direction, estimator, opaque, seen};

/// Of a whole family.
const LEVEL: f64 = 0.01;
const SAMPLES: u64 = 200_000;
const KD: DVec3 = DVec3::new(0.2, 0.5, 0.8);
const KS: DVec3 = DVec3::new(0.1, 0.3, 0.5);

struct Case {
    name: &'static str,
    m: Material,
    outside: bool,
}

/// One of every kind that scatters, each ior from both sides, with Kd and without.
fn cases() -> Vec<Case> {
    let ggx = Distribution::Ggx;
    let mut all = Vec::new();
    let mut add = |name, kind, m: Material, outside| {
        assert_eq!(m.kind, kind, "{name}");
        all.push(Case { name, m, outside });
    };
    let kinds = [
        ("diffuse alone", MaterialKind::Diffuse, 0.3, KD, DVec3::ZERO),
        ("rough alone", MaterialKind::Glossy, 0.3, DVec3::ZERO, KS),
        ("rough, Kd", MaterialKind::Glossy, 0.3, KD, KS),
        ("mirror alone", MaterialKind::Mirror, 0.0, DVec3::ZERO, KS),
        ("mirror, Kd", MaterialKind::Mirror, 0.0, KD, KS),
    ];
    for (name, kind, width, kd, ks) in kinds {
        add(name, kind, with_norms(opaque(ggx, width, kd, ks), kd), true);
    }
    for outside in [true, false] {
        for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
            for kd in [DVec3::ZERO, KD] {
                let through = |width: f64, ior: f64| {
                    let mut m = with_norms(dielectric(ggx, width, ior), kd);
                    (m.fresnel, m.f0) = (fresnel, KS);
                    m
                };
                add(
                    "glass",
                    MaterialKind::SmoothDielectric,
                    through(0.0, 1.5),
                    outside,
                );
                // α·|n − 1| = 9e-6
                let weak = through(0.3, 1.0 + 3e-5);
                add("weak", MaterialKind::WeakDielectric, weak, outside);
            }
        }
    }
    all
}

/// Probabilities by norms that draw every lobe often enough to be seen.
fn with_norms(mut m: Material, kd: DVec3) -> Material {
    (m.kd, m.kd_mean) = (kd, kd.element_sum() / 3.0);
    (m.p_d, m.p_r) = match (kd == DVec3::ZERO, m.f0 == DVec3::ZERO) {
        (false, true) => (1.0, 0.0),
        (false, false) => (0.3, 0.4),
        (true, _) => (0.0, 0.4),
    };
    if m.kind < MaterialKind::RoughDielectric {
        m.p_r = 1.0;
    }
    m
}

fn draw(settings: &Settings, at: &Interaction<f64>, r: &mut Random) -> (u32, Vec3<f64>) {
    let s = bsdf_sample(settings, at, random(r.unit(), r.unit(), r.pair(), r.pair()));
    (s.lobe, s.wi)
}

/// Samples that have a density against it; delta lobes count as lost.
fn verdict(settings: &Settings, at: &Interaction<f64>, seed: u64, planted: f64) -> Verdict {
    let mut r = Random::new(seed);
    let found = histogram(SAMPLES, || {
        let (lobe, wi) = draw(settings, at, &mut r);
        (lobe != LOBE_NONE && lobe & LOBE_DELTA == 0).then_some(wi)
    });
    compare(
        &found,
        &expectation(2, |wi| planted * bsdf_eval(settings, at, wi).pdf),
    )
}

fn is_smooth(case: &Case) -> bool {
    matches!(
        case.m.kind,
        MaterialKind::Mirror | MaterialKind::SmoothDielectric
    )
}

#[test]
fn samples_of_lobes_fit_their_density() {
    let mut cases = cases();
    cases.retain(|c| c.m.kd != DVec3::ZERO || !is_smooth(c));
    let least = sidak(LEVEL, 2 * cases.len());
    for (i, case) in cases.iter().enumerate() {
        let (lobe, normals) = ESTIMATORS[i % 4];
        let settings = estimator(lobe, normals);
        let at = seen(
            &case.m,
            case.outside,
            direction([0.8, 0.3][i % 2], i as f64),
        );
        let v = verdict(&settings, &at, i as u64, 1.0);
        assert!(v.p() > least, "{} {i}, {settings:?}: {v:?}", case.name);
        let off = verdict(&settings, &at, i as u64, 1.1);
        // exact reflectance at n = 1 + 3e-5: two in ten billion
        let seldom = case.m.kind == MaterialKind::WeakDielectric
            && (case.m.fresnel, lobe) == (Fresnel::Exact, LobeChoice::Fresnel)
            && case.m.kd == DVec3::ZERO;
        assert!(off.p() < 1e-6 || seldom, "{} {i}: {off:?}", case.name);
    }
}

/// Fresnel's mean over RGB at the cosine c = wo·N, by the law of refraction and the amplitudes of both polarisations.
fn reflectance(m: &Material, outside: bool, c: f64) -> f64 {
    let eta = m.eta[usize::from(!outside)];
    let r = 1.0 - eta * eta * (1.0 - c * c);
    if r <= 0.0 {
        return 1.0;
    }
    let t = r.sqrt();
    if m.fresnel == Fresnel::Exact {
        let s = (eta * c - t) / (eta * c + t);
        let p = (c - eta * t) / (c + eta * t);
        return 0.5 * (s * s + p * p);
    }
    let f0 = m.f0.element_sum() / 3.0;
    f0 + (1.0 - f0) * (1.0 - if eta > 1.0 { t } else { c }).powi(5)
}

/// Probabilities of the diffuse lobe, and of reflection once it is not chosen, at a smooth surface (model.md,
/// "Choice of lobe").
fn probabilities(case: &Case, choice: LobeChoice, c: f64) -> [f64; 2] {
    let m = &case.m;
    let transmits = m.kind >= MaterialKind::RoughDielectric;
    let f = reflectance(m, case.outside, c);
    let p_d = match choice {
        LobeChoice::Norms => m.p_d,
        LobeChoice::Fresnel if transmits => m.kd_mean / (m.kd_mean + 1.0),
        LobeChoice::Fresnel if m.kd_mean == 0.0 => 0.0,
        LobeChoice::Fresnel => 1.0 - (f / (f + m.kd_mean)).clamp(0.1, 0.9),
    };
    let p_r = match choice {
        LobeChoice::Norms if f < 1.0 => m.p_r,
        LobeChoice::Fresnel if transmits => f,
        _ => 1.0,
    };
    [p_d, p_r]
}

/// Probabilities of diffuse, reflected and transmitted samples.
fn shares(case: &Case, choice: LobeChoice, c: f64) -> [f64; 3] {
    let [p_d, p_r] = probabilities(case, choice, c);
    [p_d, (1.0 - p_d) * p_r, (1.0 - p_d) * (1.0 - p_r)]
}

/// The index of the largest of them.
fn likeliest(case: &Case, choice: LobeChoice, c: f64) -> usize {
    let shares = shares(case, choice, c);
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| shares[j].total_cmp(&shares[i]));
    order[0]
}

/// p-values of the numbers of diffuse, reflected and transmitted samples, if each probability were `factor` times
/// its value.
fn frequencies(case: &Case, choice: LobeChoice, c: f64, seed: u64, factor: f64) -> [f64; 3] {
    let settings = estimator(choice, Normals::Visible);
    let at = seen(&case.m, case.outside, direction(c, 0.4));
    let mut r = Random::new(seed);
    let mut counts = [0u64; 3];
    for _ in 0..SAMPLES {
        match draw(&settings, &at, &mut r).0 & !LOBE_DELTA {
            LOBE_DIFFUSE => counts[0] += 1,
            LOBE_REFLECTION => counts[1] += 1,
            LOBE_TRANSMISSION => counts[2] += 1,
            other => panic!("lobe {other} at a smooth surface"),
        }
    }
    let expected = shares(case, choice, c);
    std::array::from_fn(|i| binomial_p(counts[i], SAMPLES, factor * expected[i], 1e-12))
}

#[test]
fn lobes_are_drawn_as_often_as_they_should_be() {
    let mut cases = cases();
    cases.retain(is_smooth);
    // 0.7 is beyond the critical angle of glass, from inside
    let cosines = [1.0, 0.85, 0.7, 0.2];
    let least = sidak(LEVEL, 3 * 2 * cosines.len() * cases.len());
    let mut seed = 0;
    for case in &cases {
        for (choice, c) in [LobeChoice::Fresnel, LobeChoice::Norms]
            .into_iter()
            .flat_map(|choice| cosines.map(|c| (choice, c)))
        {
            seed += 1;
            let p = frequencies(case, choice, c, seed, 1.0);
            let name = format!("{}, {choice:?}, {}, {c}", case.name, case.outside);
            assert!(p.iter().all(|p| *p > least), "{name}: {p:?}");
            // The likeliest of three lobes has a probability of ⅓ or more, of which 3 % are nine standard errors.
            let off = frequencies(case, choice, c, seed, 0.97);
            let likeliest = likeliest(case, choice, c);
            assert!(off[likeliest] < least, "{name}: {off:?} passes × 0.97");
        }
    }
}
