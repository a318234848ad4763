//! Settings that depart from the default in one word each.

use vkpt::settings::{
    Absorption, Connect, Distribution, DistributionRule, Estimator, Fresnel, Integrator, Lights,
    LobeChoice, Model, Normals, Roulette, Sampler, Settings,
};

/// The defaults with another integrator.
pub fn by(integrator: Integrator) -> Settings {
    let mut settings = Settings::default();
    settings.estimator.integrator = integrator;
    settings
}

/// Each estimator setting alone, and all that the hand-out has, with the default model.
pub fn estimators() -> Vec<(&'static str, Settings)> {
    let with = |change: fn(&mut Estimator)| {
        let mut s = Settings::default();
        change(&mut s.estimator);
        s
    };
    vec![
        ("lobe norms", with(|e| e.lobe = LobeChoice::Norms)),
        (
            "normals distribution",
            with(|e| e.normals = Normals::Distribution),
        ),
        (
            "roulette 0.8",
            with(|e| e.roulette = Roulette::Constant(0.8)),
        ),
        ("roulette off", with(|e| e.roulette = Roulette::Off)),
        ("connect light", with(|e| e.connect = Connect::Light)),
        ("connect bsdf", with(|e| e.connect = Connect::Bsdf)),
        ("lights power", with(|e| e.lights = Lights::Power)),
        ("sampler random", with(|e| e.sampler = Sampler::Random)),
        (
            "sampler sobol-quarters",
            with(|e| e.sampler = Sampler::SobolQuarters),
        ),
        (
            "the hand-out's",
            with(|e| *e = Settings::handout().estimator),
        ),
    ]
}

/// The defaults, with independent random numbers: for tests that take samples for independent.
pub fn independent() -> Settings {
    let mut settings = Settings::default();
    settings.estimator.sampler = Sampler::Random;
    settings
}

/// Each model setting alone.
pub fn models() -> Vec<(&'static str, Settings)> {
    let with = |change: fn(&mut Model)| {
        let mut s = Settings::default();
        change(&mut s.model);
        s
    };
    vec![
        (
            "fresnel schlick",
            with(|m| m.fresnel = Some(Fresnel::Schlick)),
        ),
        ("fresnel exact", with(|m| m.fresnel = Some(Fresnel::Exact))),
        (
            "distribution ggx",
            with(|m| m.distribution = DistributionRule::Always(Distribution::Ggx)),
        ),
        (
            "distribution beckmann",
            with(|m| m.distribution = DistributionRule::Always(Distribution::Beckmann)),
        ),
        (
            "distribution phong",
            with(|m| m.distribution = DistributionRule::Always(Distribution::Phong)),
        ),
        ("absorption term", with(|m| m.absorption = Absorption::Term)),
        ("no radiance scaling", with(|m| m.radiance_scaling = false)),
        ("max-depth 3", with(|m| m.max_depth = Some(3))),
        ("the hand-out's", Settings::handout()),
    ]
}
