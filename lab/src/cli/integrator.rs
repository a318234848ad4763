//! What an integrator cannot do, said before it renders.

use glam::DVec3;

use super::exit::Failure;
use vkpt::features::{Chosen, chosen};
use vkpt::prepared::{MaterialKind, Prepared};
use vkpt::report::names::Named;
use vkpt::settings::{Absorption, Connect, Integrator, Settings};

/// Refuses settings that the integrator has no meaning for.
pub fn check(settings: &Settings) -> Result<(), Failure> {
    let integrator = settings.estimator.integrator;
    let name = integrator.name();
    if integrator != Integrator::Path && settings.model.absorption == Absorption::Term {
        return Err(Failure::Usage(format!(
            "--integrator {name} cannot render --absorption term, which --model handout sets: light that absorption takes at \
             surfaces alone has no path backwards. Add --absorption segment, or leave --integrator {name} out"
        )));
    }
    let weighs = settings.estimator.connect == Connect::Mis;
    if integrator == Integrator::Bidirectional && !weighs {
        return Err(Failure::Usage(format!(
            "--integrator {name} weighs all ways to find light against each other: leave --connect out"
        )));
    }
    Ok(())
}

/// Settings with the integrator that a scene has chosen, and why.
pub struct Settled {
    pub settings: Settings,
    pub why: &'static str,
}

/// These settings with the integrator that the scene chooses.
pub fn settled(prepared: &Prepared, mut settings: Settings) -> Settled {
    let Chosen { integrator, why } = chosen(prepared, &settings);
    settings.estimator.integrator = integrator;
    Settled { settings, why }
}

/// Refuses what `flag` shows of the paths of a pixel's samples with light paths alone, which belong to no pixel.
pub fn needs_eye_paths(settings: &Settings, flag: &str) -> Result<(), Failure> {
    match settings.estimator.integrator {
        Integrator::Path | Integrator::Bidirectional => Ok(()),
        Integrator::Light => Err(no_eye_paths(flag)),
    }
}

/// `what` follows paths from the eye.
pub fn no_eye_paths(what: &str) -> Failure {
    Failure::Usage(format!(
        "{what} follows paths from the eye, which --integrator light has none of: use --integrator path or bidirectional"
    ))
}

/// What the integrator does not see of a scene.
pub fn unseen(prepared: &Prepared, settings: &Settings) -> Option<String> {
    use MaterialKind::{Mirror, SmoothDielectric, WeakDielectric};
    let has = |kind| {
        let mut shapes = prepared.shapes.iter();
        shapes.any(|s| prepared.materials[s.material as usize].kind == kind)
    };
    let missing: Vec<&str> = [
        (has(Mirror), "what mirrors show"),
        (
            has(SmoothDielectric) || has(WeakDielectric),
            "what smooth glass shows",
        ),
        (prepared.background != DVec3::ZERO, "the background"),
    ]
    .into_iter()
    .filter_map(|(there, what)| there.then_some(what))
    .collect();
    let light = settings.estimator.integrator == Integrator::Light;
    (light && !missing.is_empty()).then(|| {
        format!(
            "--integrator light does not see {}: the picture lacks it",
            missing.join(", nor ")
        )
    })
}
