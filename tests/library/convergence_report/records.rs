//! Experiments that never were.

use vkpt::film::Film;
use vkpt::metrics::Trimmed;
use vkpt::metrics::convergence::{Curve, Figures, LEVEL, Reference, Step};
use vkpt::settings::Settings;
use vkpt_lab::converge::report::{Convergence, Subject, VariantRecord};

/// 4×3 pixels, each of its own brightness times `scale`.
pub fn film(scale: f32) -> Film {
    let pixel = |i: usize| [scale * (0.1 + 0.05 * i as f32), 0.5 * scale, 0.2 * scale];
    Film {
        width: 4,
        height: 3,
        rgb: (0..12).map(pixel).collect(),
    }
}

/// A reference whose own relMSE is about 1e-6: its halves differ by so little.
pub fn reference() -> Reference {
    let viewing = vkpt::metrics::flip::Viewing::default();
    Reference::halves(film(1.0), film(1.002), &viewing).expect("two halves")
}

/// Two replicates a step, whose relMSE and seconds are a tenth below and above the given values.
pub fn curve(steps: &[(f64, f64)]) -> Curve {
    let step = |(i, &(seconds, rel_mse)): (usize, &(f64, f64))| {
        let figures = |factor: f64| {
            let error = Trimmed {
                all: factor * rel_mse,
                without_worst: 0.5 * rel_mse,
            };
            Figures {
                mse: error,
                rmse: error,
                rel_mse: error,
                smape: error,
                flip: error,
            }
        };
        Step {
            spp: 1 << i,
            wall_s: vec![0.9 * seconds, 1.1 * seconds],
            gpu_s: None,
            figures: vec![figures(0.9), figures(1.1)],
            picture: film(1.0 + 0.5 / (i + 1) as f32),
        }
    };
    Curve {
        set_up_s: 0.25,
        steps: steps.iter().enumerate().map(step).collect(),
        pictures: vec![film(1.1), film(0.9)],
    }
}

/// A variant for each name and curve, the first of which the others are compared with.
pub fn experiment(scene: &str, variants: &[(&str, &Curve)]) -> Convergence {
    let (settings, reference) = (Settings::default(), reference());
    let record = |(i, (name, curve)): (usize, &(&str, &Curve))| {
        let subject = Subject {
            name,
            settings: &settings,
            reference: &reference,
            reference_name: "two halves",
        };
        let first = (i > 0).then(|| variants[0].1);
        VariantRecord::new(&subject, curve, first)
    };
    Convergence {
        version: "0.0.0",
        scene: scene.to_owned(),
        size: [4, 3],
        crop: None,
        seed: 0,
        replicates: 2,
        seconds: 60.0,
        spent_s: 31.0,
        device: "a device".to_owned(),
        driver: "a driver".to_owned(),
        level: LEVEL,
        models_differ: false,
        own_references: true,
        interrupted: false,
        variants: variants.iter().enumerate().map(record).collect(),
    }
}
