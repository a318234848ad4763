//! The flags of the settings, which every command that renders takes.

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
    /// A preset. handout: all settings as the course's hand-out has them. Words in the scene beat
    /// it, flags beat both
    #[arg(long, value_name = "PRESET", help_heading = MODEL)]
    #[arg(value_parser = choice::<Preset>(), hide_possible_values = true)]
    pub model: Option<Preset>,

    /// Reflectance of an interface: schlick or exact [default: the scene's, else schlick]
    #[arg(long, value_name = "FORM", help_heading = MODEL)]
    #[arg(value_parser = choice::<Fresnel>(), hide_possible_values = true)]
    pub fresnel: Option<Fresnel>,

    /// Micro-normals: phong, beckmann, ggx, or auto: phong for an exponent and ggx for a width
    /// [default: the scene's, else auto]
    #[arg(long, value_name = "NAME", help_heading = MODEL)]
    #[arg(value_parser = values::distribution(), hide_possible_values = true)]
    pub distribution: Option<DistributionRule>,

    /// Absorb along every segment in a medium, or only in the transmission term as the hand-out
    /// prints it: segment or term [default: segment]
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

    /// Which paths find the light: those from the eye; those from the lights, each vertex joined to
    /// the eye, which see neither mirrors nor through smooth glass; or both, joined to each other: path,
    /// light, bidirectional, or auto: what suits the scene [default: auto]
    #[arg(long, value_name = "PATHS", help_heading = ESTIMATOR)]
    #[arg(value_parser = values::integrator(), hide_possible_values = true)]
    pub integrator: Option<IntegratorRule>,

    /// How a lobe is chosen: by its share of fresnel, or by the norms of Kd, Ks and Kt [default:
    /// fresnel]
    #[arg(long, value_name = "RULE", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<LobeChoice>(), hide_possible_values = true)]
    pub lobe: Option<LobeChoice>,

    /// Which micro-normals are drawn: the visible ones, or those of the whole distribution [default:
    /// visible]
    #[arg(long, value_name = "DENSITY", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Normals>(), hide_possible_values = true)]
    pub normals: Option<Normals>,

    /// Let paths survive by their throughput, with a constant probability such as 0.8, or always:
    /// throughput, P or off [default: throughput]
    #[arg(long, value_name = "RULE", help_heading = ESTIMATOR, value_parser = numbers::roulette)]
    pub roulette: Option<Roulette>,

    /// Find light by connecting to it, by paths that hit it, or by both, weighted: light, bsdf or
    /// mis [default: mis]
    #[arg(long, value_name = "HOW", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Connect>(), hide_possible_values = true)]
    pub connect: Option<Connect>,

    /// How the light that a connection leads to is picked: by what it brings to the vertex, or by its
    /// power: contribution or power [default: contribution]
    #[arg(long, value_name = "RULE", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Lights>(), hide_possible_values = true)]
    pub lights: Option<Lights>,

    /// Numbers that the samples of a pixel draw: independent ones, or scrambled Sobol points, spread
    /// evenly: random or sobol [default: sobol]
    #[arg(long, value_name = "KIND", help_heading = ESTIMATOR)]
    #[arg(value_parser = choice::<Sampler>(), hide_possible_values = true)]
    pub sampler: Option<Sampler>,
}

impl SettingArguments {
    /// The values that hold where no flag says otherwise, and where they come from.
    pub fn preset(&self) -> (&'static str, Settings) {
        match self.model {
            Some(Preset::Handout) => ("--model handout", Settings::handout()),
            None => ("the default", Settings::default()),
        }
    }

    /// Whether the scene is to choose its integrator.
    pub fn auto(&self) -> bool {
        matches!(self.integrator, None | Some(IntegratorRule::Auto))
    }

    /// The preset's values, or the defaults, with what the flags say put over them.
    pub fn settings(&self) -> Settings {
        let (_, preset) = self.preset();
        self.over(preset)
    }

    /// The same with what the flags of `others` say put over these; their preset, if they have one, under both.
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
