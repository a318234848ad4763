//! Parts that settings and flags decide. The kernel's list of files shows whether such a part is present.

use super::Subject;
use crate::explain::report::Part;
use vkpt::film::Aov;
use vkpt::report::SettingsRecord;
use vkpt::settings::{Connect, Integrator, LobeChoice, Normals, Roulette, Sampler};

/// Why a kernel of light paths does not search for light.
const FROM_LIGHT: &str = "paths start at the lights";

/// A part of the kernel that a flag decides on.
struct Setting {
    group: &'static str,
    name: String,
    /// Its file of `shaders/`; empty if it is switched off.
    file: &'static str,
    /// The flag or default that selects it.
    by: String,
    /// Why it may be absent.
    absent: &'static str,
}

pub fn parts(subject: &Subject) -> Vec<Part> {
    let all = estimator(subject).into_iter().chain(model(subject));
    let part = |s: Setting| {
        let present = subject.contains(s.file);
        Part {
            group: s.group,
            name: s.name,
            present,
            lines: Vec::new(),
            why: if present { s.by } else { s.absent.to_owned() },
            quote: String::new(),
        }
    };
    all.chain(beside(subject)).map(part).collect()
}

/// The flag that gave a setting the value `now`, unless it is the preset's.
pub fn by(subject: &Subject, flag: &str, value: impl Fn(&SettingsRecord) -> String) -> String {
    let now = value(&SettingsRecord::from(&subject.job.settings));
    let preset = value(&SettingsRecord::from(&subject.preset.settings));
    match now == preset {
        true => subject.preset.name.to_owned(),
        false => format!("--{flag} {now}"),
    }
}

fn estimator(subject: &Subject) -> [Setting; 9] {
    let settings = &subject.job.settings.estimator;
    let names = SettingsRecord::from(&subject.job.settings);
    let connect = by(subject, "connect", |s| s.connect.to_owned());
    let integrator = match subject.auto {
        Some(why) => format!("auto: {why}"),
        None => by(subject, "integrator", |s| s.integrator.to_owned()),
    };
    [
        Setting {
            group: "integrator",
            name: "path".to_owned(),
            file: "integrator/path/path_trace.comp",
            by: integrator.clone(),
            absent: match settings.integrator {
                Integrator::Bidirectional => "paths from both ends find more light",
                _ => "--integrator light: each vertex of a light path is connected to the eye",
            },
        },
        Setting {
            group: "integrator",
            name: "light".to_owned(),
            file: "integrator/light/shade",
            by: integrator.clone(),
            absent: match settings.integrator {
                Integrator::Bidirectional => "paths from both ends find more light",
                _ => "paths start at the eye",
            },
        },
        Setting {
            group: "integrator",
            name: "bidirectional".to_owned(),
            file: "integrator/bidirectional/eye_trace.comp",
            by: integrator,
            absent: "paths start at one end only",
        },
        Setting {
            group: "micronormals",
            name: names.normals.to_owned(),
            file: match settings.normals {
                Normals::Visible => "bsdf/normals/visible",
                Normals::Distribution => "bsdf/normals/distribution",
            },
            by: by(subject, "normals", |s| s.normals.to_owned()),
            absent: "nothing is rough: no micro-normals are sampled",
        },
        Setting {
            group: "lobe choice",
            name: names.lobe.to_owned(),
            file: match settings.lobe {
                LobeChoice::Fresnel => "bsdf/choice/fresnel",
                LobeChoice::Norms => "bsdf/choice/norms",
            },
            by: by(subject, "lobe", |s| s.lobe.to_owned()),
            absent: "no surface has two lobes",
        },
        Setting {
            group: "light sampling",
            name: "by connections".to_owned(),
            file: "integrator/path/direct/shadow",
            by: connect.clone(),
            absent: match (settings.integrator, settings.connect) {
                (Integrator::Light, _) => FROM_LIGHT,
                (_, Connect::Bsdf) => "--connect bsdf: paths find light only by hitting it",
                _ => "the scene has no light",
            },
        },
        Setting {
            group: "light sampling",
            name: match settings.integrator {
                Integrator::Bidirectional => "weights: of all ways".to_owned(),
                _ => format!("weights: {}", names.connect),
            },
            file: match (settings.integrator, settings.connect) {
                (Integrator::Bidirectional, _) => "integrator/bidirectional/partial",
                (_, Connect::Mis) => "integrator/path/connect/mis",
                (_, Connect::Light) => "integrator/path/connect/light",
                (_, Connect::Bsdf) => "integrator/path/connect/bsdf",
            },
            by: connect,
            absent: match settings.integrator {
                Integrator::Light => FROM_LIGHT,
                Integrator::Path | Integrator::Bidirectional => "the scene has no light",
            },
        },
        Setting {
            group: "roulette",
            name: names.roulette,
            file: match settings.roulette {
                Roulette::Throughput => "path/roulette/throughput",
                Roulette::Constant(_) => "path/roulette/constant",
                Roulette::Off => "path/roulette/off",
            },
            by: by(subject, "roulette", |s| s.roulette.clone()),
            absent: "",
        },
        Setting {
            group: "sampler",
            name: names.sampler.to_owned(),
            file: match settings.sampler {
                Sampler::Random => "sampler/random",
                Sampler::Sobol => "sampler/sobol",
                Sampler::SobolQuarters => "sampler/sobol_quarters",
            },
            by: by(subject, "sampler", |s| s.sampler.to_owned()),
            absent: "",
        },
    ]
}

fn model(subject: &Subject) -> [Setting; 2] {
    let depth = subject.job.settings.model.max_depth;
    let scales = subject.job.settings.model.radiance_scaling;
    let scaling = |s: &SettingsRecord| if s.radiance_scaling { "on" } else { "off" }.to_owned();
    [
        Setting {
            group: "scaling",
            name: "radiance, eta²".to_owned(),
            file: match (scales, subject.job.settings.estimator.integrator) {
                (false, _) => "",
                (true, Integrator::Path) => "bsdf/scaling/radiance",
                // Light paths carry the adjoint.
                (true, Integrator::Light) => "bsdf/scaling/flux",
                (true, Integrator::Bidirectional) => "bsdf/scaling/both",
            },
            by: by(subject, "radiance-scaling", scaling),
            absent: match (
                subject.plan.features.transmits(),
                subject.preset.settings.model.radiance_scaling,
            ) {
                (false, _) => "nothing refracts light",
                (true, true) => "--radiance-scaling off",
                (true, false) => subject.preset.name,
            },
        },
        Setting {
            group: "longest path",
            name: depth.map_or("capped".to_owned(), |n| format!("{n} bounces")),
            file: "path/depth/capped",
            by: depth.map_or(String::new(), |n| format!("--max-depth {n}")),
            absent: "no --max-depth given: only roulette ends paths",
        },
    ]
}

/// Data in addition to the picture.
fn beside(subject: &Subject) -> [Setting; 4] {
    [
        Setting {
            group: "film data",
            name: "spread of samples".to_owned(),
            file: "film/moments/welford",
            by: "--aov stderr with independent samples".to_owned(),
            absent: match subject.job.aovs.contains(&Aov::Stderr) {
                true => {
                    "--aov stderr uses the two groups of samples: Sobol points are not independent"
                }
                false => "no --aov stderr given: a pixel's sum suffices",
            },
        },
        Setting {
            group: "film data",
            name: "quarters of the samples".to_owned(),
            file: "film/moments/quarters",
            by: "--denoise".to_owned(),
            absent: "no --denoise given",
        },
        Setting {
            group: "film data",
            name: "path events".to_owned(),
            file: "integrator/path/record/on",
            by: "--trace".to_owned(),
            absent: "only --trace records them",
        },
        Setting {
            group: "film data",
            name: "layers".to_owned(),
            file: "render/layers",
            by: String::new(),
            absent: match subject.job.aovs.iter().any(|aov| aov.is_layer())
                || !subject.job.classes.is_empty()
            {
                true => "the reference makes them after the picture",
                false => "no --aov requests any",
            },
        },
    ]
}
