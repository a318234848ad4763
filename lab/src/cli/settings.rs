//! The flags of the settings, common to all commands that render.

use super::numbers;
use super::values::{self, IntegratorRule, Preset, choice};
use vkpt::settings::{
    Absorption, Connect, DistributionRule, Fresnel, Integrator, Lights, LobeChoice, Normals,
    Roulette, Sampler, Settings,
};

const MODEL: &str = "Model (what the picture converges to)";
const ESTIMATOR: &str = "Estimator (how fast it converges)";

/// One flag per setting of the surface model.
#[derive(clap::Args, Debug)]
pub struct SettingArguments {
    /// Preset. handout: all settings as in the course hand-out. Words in the scene override it, flags
    /// override both
    #[arg(long, value_name = "PRESET", help_heading = MODEL)]
    #[arg(value_parser = choice::<Preset>(), hide_possible_values = true)]
    pub model: Option<Preset>,

    /// Reflectance of an interface: schlick or exact [default: the scene's, else schlick]
    #[arg(long, value_name = "FORM", help_heading = MODEL)]
    #[arg(value_parser = choice::<Fresnel>(), hide_possible_values = true)]
    pub fresnel: Option<Fresnel>,

    /// Microfacet distribution: phong, beckmann, ggx, or auto (phong for an exponent, ggx for a width)
    /// [default: the scene's, else auto]
    #[arg(long, value_name = "NAME", help_heading = MODEL)]
    #[arg(value_parser = values::distribution(), hide_possible_values = true)]
    pub distribution: Option<DistributionRule>,

    /// Absorb along every segment in a medium, or only in the transmission term as in the hand-out:
    /// segment or term [default: segment]
    #[arg(long, value_name = "WHERE", help_heading = MODEL)]
    #[arg(value_parser = choice::<Absorption>(), hide_possible_values = true)]
    pub absorption: Option<Absorption>,

    /// Scale radiance by the squared ratio of indices at each refraction: on or off [default: on]
    #[arg(long, value_name = "SWITCH", help_heading = MODEL)]
    #[arg(value_parser = values::switch(), hide_possible_values = true)]
    pub radiance_scaling: Option<bool>,

    /// Longest path in bounces: 0 shows emitters, 1 adds direct light [default: no cap]
    #[arg(long, value_name = "N", help_heading = MODEL, value_parser = numbers::whole(0))]
    pub max_depth: Option<u32>,

    /// Integrator: path (paths from the eye), light (paths from the lights, each vertex connected to
    /// the eye; sees neither mirrors nor through smooth glass), bidirectional (both, connected), or
    /// auto (path or bidirectional, whichever suits the scene) [default: auto]
    #[arg(long, value_name = "PATHS", help_heading = ESTIMATOR)]
    #[arg(value_parser = values::integrator(), hide_possible_values = true)]
    pub integrator: Option<IntegratorRule>,

    /// Choose a lobe by its share of the Fresnel reflectance, or by the norms of Kd, Ks and Kt:
    /// fresnel or norms [default: fresnel]
    #[arg(long, value_name = "RULE", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<LobeChoice>(), hide_possible_values = true)]
    pub lobe: Option<LobeChoice>,

    /// Sample only the visible micro-normals, or the whole distribution: visible or distribution
    /// [default: visible]
    #[arg(long, value_name = "DENSITY", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Normals>(), hide_possible_values = true)]
    pub normals: Option<Normals>,

    /// Russian roulette: survival by throughput, with a constant probability P such as 0.8, or always:
    /// throughput, P or off [default: throughput]
    #[arg(long, value_name = "RULE", help_heading = ESTIMATOR, value_parser = numbers::roulette)]
    pub roulette: Option<Roulette>,

    /// Find light by connections, by paths that hit it, or by both, weighted: light, bsdf or mis
    /// [default: mis]
    #[arg(long, value_name = "HOW", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Connect>(), hide_possible_values = true)]
    pub connect: Option<Connect>,

    /// Pick the light of a connection by its contribution at the vertex, or by its power: contribution
    /// or power [default: contribution]
    #[arg(long, value_name = "RULE", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Lights>(), hide_possible_values = true)]
    pub lights: Option<Lights>,

    /// Random numbers of a pixel's samples: independent, or scrambled Sobol points, or these in four
    /// independent groups: random, sobol or sobol-quarters [default: sobol; with --denoise
    /// sobol-quarters]
    #[arg(long, value_name = "KIND", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Sampler>(), hide_possible_values = true)]
    pub sampler: Option<Sampler>,
}

impl SettingArguments {
    /// The values that apply without flags, and their origin.
    pub fn preset(&self) -> (&'static str, Settings) {
        match self.model {
            Some(Preset::Handout) => ("--model handout", Settings::handout()),
            None => ("the default", Settings::default()),
        }
    }

    /// Whether the scene chooses its integrator.
    pub fn auto(&self) -> bool {
        matches!(self.integrator, None | Some(IntegratorRule::Auto))
    }

    /// The preset's values, or the defaults, overridden by the flags.
    pub fn settings(&self) -> Settings {
        let (_, preset) = self.preset();
        self.over(preset)
    }

    /// The same overridden by the flags of `others`; their preset, if any, comes below both.
    pub fn with(&self, others: &Self) -> Settings {
        let (_, preset) = match others.model {
            Some(_) => others.preset(),
            None => self.preset(),
        };
        others.over(self.over(preset))
    }

    fn over(&self, mut settings: Settings) -> Settings {
        let Settings { model, estimator } = &mut settings;
        model.fresnel = self.fresnel.or(model.fresnel);
        replace(&mut model.distribution, self.distribution);
        replace(&mut model.absorption, self.absorption);
        replace(&mut model.radiance_scaling, self.radiance_scaling);
        model.max_depth = self.max_depth.or(model.max_depth);
        match self.integrator {
            Some(IntegratorRule::Always(integrator)) => estimator.integrator = integrator,
            // Until the scene is known.
            Some(IntegratorRule::Auto) => estimator.integrator = Integrator::Path,
            None => {}
        }
        replace(&mut estimator.lobe, self.lobe);
        replace(&mut estimator.normals, self.normals);
        replace(&mut estimator.roulette, self.roulette);
        replace(&mut estimator.connect, self.connect);
        replace(&mut estimator.lights, self.lights);
        replace(&mut estimator.sampler, self.sampler);
        settings
    }
}

fn replace<T>(value: &mut T, flag: Option<T>) {
    if let Some(flag) = flag {
        *value = flag;
    }
}
