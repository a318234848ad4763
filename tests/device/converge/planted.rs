//! An estimator that is wrong, in the kernel itself: one cosine too many in the connection to lights.

use vkpt::film::Film;
use vkpt::kernel::{OwnFile, file};
use vkpt::metrics::convergence::{LEVEL, Reference};
use vkpt::metrics::flip::Viewing;
use vkpt::render::{DispatchLimits, Engine, Job, KernelChoice, Replicates};
use vkpt::settings::Settings;
use vkpt_lab::converge::halves;
use vkpt_lab::converge::report::{Convergence, Subject, VariantRecord, table};

use super::{LIT, RUNNING, measured, plan};
use crate::common::device;
use crate::common::render::{job, prepared};

const CONNECTION: &str = "integrator/path/pick/candidate";

/// The connection with |cos θ| of the light's direction once more, which the BSDF's value already contains.
fn one_cosine_too_many() -> String {
    let honest = "        c.contribution = path.throughput * f.value * light_radiance(light, l.prim) * (weight / p);";
    let biased = "        c.contribution = path.throughput * f.value * light_radiance(light, l.prim) * (weight / p) * abs(wi.z);";
    let text = file(CONNECTION).expect("a shader");
    assert_eq!(text.matches(honest).count(), 1, "the line to be planted in");
    text.replace(honest, biased)
}

/// All that `vkpt converge` reports of a job, except its name.
fn reported(job: &Job, engine: &Engine, reference: &Reference) -> (VariantRecord, String) {
    let measured = measured(job, reference, engine, &plan());
    let subject = Subject {
        name: "",
        settings: &job.settings,
        reference,
        reference_name: "two halves",
    };
    let variant = VariantRecord::new(&subject, &measured.curves[0], None);
    let [device, driver] = engine.name();
    let experiment = Convergence {
        version: "",
        scene: "lit.txt".to_owned(),
        size: job.size(),
        crop: None,
        seed: plan().seeds[0],
        replicates: plan().seeds.len(),
        seconds: plan().seconds,
        spent_s: measured.spent_s,
        device,
        driver,
        level: LEVEL,
        models_differ: false,
        own_references: true,
        interrupted: false,
        variants: vec![variant.clone()],
    };
    (variant, table(&experiment))
}

#[test]
fn one_cosine_too_many_flattens_the_curve_which_is_reported() {
    let Some(device) = device() else { return };
    let limits = DispatchLimits::of(device).expect("a probe");
    let engine = Engine::Vulkan(device.clone(), limits);
    let settings = Settings::default();
    let scene = prepared(LIT, &settings);
    let text = one_cosine_too_many();
    let files = [OwnFile {
        name: CONNECTION,
        text: &text,
    }];
    let honest = job(&scene, settings, 1, 0);
    let biased = Job {
        kernel: KernelChoice::Own(&files),
        ..honest
    };
    let made = halves(&honest, &engine, (1e6, 8192), &RUNNING, &mut |_| {});
    let [a, b] = made.expect("samples").expect("not interrupted").films;
    let reference = Reference::halves(a, b, &Viewing::default()).expect("two halves");

    let ((right, right_text), (wrong, wrong_text)) = (
        reported(&honest, &engine, &reference),
        reported(&biased, &engine, &reference),
    );
    assert!(!right.is_off(), "{:?}", right.floor);
    assert!(wrong.is_off(), "{:?}", wrong.floor);
    let verdict = "does NOT converge to the reference";
    assert!(!right_text.contains(verdict), "{right_text}");
    assert!(wrong_text.contains(verdict), "{wrong_text}");
    let last_slope = |variant: &VariantRecord| {
        let step = variant.steps.last().expect("steps");
        step.slope.expect("two steps")
    };
    assert!(last_slope(&right).high < -0.7, "{right_text}");
    assert!(last_slope(&wrong).low > -0.1, "{wrong_text}");

    let truth = true_bias(&honest, &biased, &engine);
    let floor = wrong.floor.expect("six replicates");
    // Both estimates have their own errors, the floor's by 6 replicates, the truth's by 8 pairs: Student's t of
    // 5 degrees of freedom or more, and 6.87 of them two-sided at 1e-3.
    let tolerance = 6.87 * floor.standard_error.hypot(truth.standard_error);
    assert!(
        tolerance < 0.1 * truth.rel_mse,
        "a test that sees a tenth: {truth:?} {floor:?}"
    );
    assert!(
        (floor.rel_mse - truth.rel_mse).abs() < tolerance,
        "{truth:?} {floor:?}"
    );
}

/// The relMSE that the bias makes, without any of `metrics::convergence`.
#[derive(Debug)]
struct Truth {
    rel_mse: f64,
    standard_error: f64,
}

/// Seeds that neither the replicates nor the reference have.
const SEEDS: std::ops::Range<u32> = 100..116;
const SAMPLES: u32 = 512;

/// From 16 renderings of both: of two of them, w and w' biased, h and h' honest, the mean of (w − h)(w' − h') over the
/// honest mean squared is the effect of the bias, because no noise is in both factors. Eight such values are independent.
fn true_bias(honest: &Job, biased: &Job, engine: &Engine) -> Truth {
    let [honest, biased] = [honest, biased].map(|job| rendered(job, engine));
    let count = honest[0].len();
    let mean = |i: usize| honest.iter().map(|film| film[i]).sum::<f64>() / honest.len() as f64;
    let weights: Vec<f64> = (0..count)
        .map(|i| 1.0 / (mean(i) * mean(i) + 0.01))
        .collect();
    let off = |k: usize, i: usize| biased[k][i] - honest[k][i];
    let value = |k: usize| {
        let product = |i: usize| off(2 * k, i) * off(2 * k + 1, i) * weights[i];
        (0..count).map(product).sum::<f64>() / count as f64
    };
    let values: Vec<f64> = (0..honest.len() / 2).map(value).collect();
    let n = values.len() as f64;
    let rel_mse = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - rel_mse) * (v - rel_mse)).sum();
    Truth {
        rel_mse,
        standard_error: (squares / (n - 1.0) / n).sqrt(),
    }
}

/// The values of a picture for each of [`SEEDS`].
fn rendered(job: &Job, engine: &Engine) -> Vec<Vec<f64>> {
    let seeds: Vec<u32> = SEEDS.collect();
    let mut replicates = Replicates::new(job, engine, &seeds).expect("ready");
    let picture = |i: usize| {
        replicates.advance(i, SAMPLES, &RUNNING).expect("samples");
        let Film { rgb, .. } = replicates.picture(i);
        rgb.as_flattened().iter().map(|&x| f64::from(x)).collect()
    };
    (0..seeds.len()).map(picture).collect()
}
