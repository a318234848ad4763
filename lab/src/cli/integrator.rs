//! Limits of an integrator, checked before it renders.

use glam::DVec3;

use super::exit::Failure;
use vkpt::features::{Chosen, chosen};
use vkpt::prepared::{MaterialKind, Prepared};
use vkpt::report::names::Named;
use vkpt::settings::{Absorption, Connect, Integrator, Settings};

/// Refuses settings that the integrator does not support.
pub fn check(settings: &Settings) -> Result<(), Failure> {
    let integrator = settings.estimator.integrator;
    let name = integrator.name();
    if integrator != Integrator::Path && settings.model.absorption == Absorption::Term {
        return Err(Failure::Usage(format!(
            "--integrator {name} does not support --absorption term (part of --model handout): absorption at surfaces \
             alone has no adjoint for light paths. Add --absorption segment, or omit --integrator {name}"
        )));
    }
    let weighs = settings.estimator.connect == Connect::Mis;
    if integrator == Integrator::Bidirectional && !weighs {
        return Err(Failure::Usage(format!(
            "--integrator {name} always weighs all ways to find light: omit --connect"
        )));
    }
    Ok(())
}

/// Settings with the integrator that suits a scene, and the reason.
pub struct Settled {
    pub settings: Settings,
    pub why: &'static str,
}

/// These settings with the integrator that suits the scene.
pub fn settled(prepared: &Prepared, mut settings: Settings) -> Settled {
    let Chosen { integrator, why } = chosen(prepared, &settings);
    settings.estimator.integrator = integrator;
    Settled { settings, why }
}

/// Refuses `flag`, which follows the paths of a pixel's samples, for light tracing, whose paths belong to no pixel.
pub fn needs_eye_paths(settings: &Settings, flag: &str) -> Result<(), Failure> {
    match settings.estimator.integrator {
        Integrator::Path | Integrator::Bidirectional => Ok(()),
        Integrator::Light => Err(no_eye_paths(flag)),
    }
}

/// `what` follows paths from the eye.
pub fn no_eye_paths(what: &str) -> Failure {
    Failure::Usage(format!(
        "{what} follows paths from the eye, and --integrator light has none: use --integrator path or bidirectional"
    ))
}

/// A warning about the parts of a scene that the integrator does not render.
pub fn unseen(prepared: &Prepared, settings: &Settings) -> Option<String> {
    use MaterialKind::{Mirror, SmoothDielectric, WeakDielectric};
    let has = |kind| {
        let mut shapes = prepared.shapes.iter();
        shapes.any(|s| prepared.materials[s.material as usize].kind == kind)
    };
    let missing: Vec<&str> = [
        (has(Mirror), "reflections in mirrors"),
        (
            has(SmoothDielectric) || has(WeakDielectric),
            "objects behind smooth glass",
        ),
        (prepared.background != DVec3::ZERO, "the background"),
    ]
    .into_iter()
    .filter_map(|(there, what)| there.then_some(what))
    .collect();
    let light = settings.estimator.integrator == Integrator::Light;
    (light && !missing.is_empty()).then(|| {
        format!(
            "--integrator light does not render {}: the picture lacks them",
            missing.join(" or ")
        )
    })
}
