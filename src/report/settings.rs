//! Settings as words.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::names::Named;
use crate::settings::{DistributionRule, Integrator, Roulette, Settings};

/// Every setting (model.md, "Settings"), with the name and value of its flag.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SettingsRecord {
    /// `scene`: each material as in the scene, `schlick` by default.
    pub fresnel: String,
    /// `scene`: each material as in the scene, `auto` by default.
    pub distribution: String,
    pub absorption: String,
    pub radiance_scaling: bool,
    /// `None`: no cap.
    pub max_depth: Option<u32>,
    pub integrator: String,
    pub lobe: String,
    pub normals: String,
    pub roulette: String,
    pub connect: String,
    pub lights: String,
    pub sampler: String,
}

impl From<&Settings> for SettingsRecord {
    fn from(settings: &Settings) -> Self {
        let Settings { model, estimator } = settings;
        Self {
            fresnel: model.fresnel.map_or("scene", Named::name).into(),
            distribution: match model.distribution {
                DistributionRule::Scene => "scene",
                DistributionRule::Auto => "auto",
                DistributionRule::Always(distribution) => distribution.name(),
            }
            .into(),
            absorption: model.absorption.name().into(),
            radiance_scaling: model.radiance_scaling,
            max_depth: model.max_depth,
            integrator: estimator.integrator.name().into(),
            lobe: estimator.lobe.name().into(),
            normals: estimator.normals.name().into(),
            roulette: match estimator.roulette {
                Roulette::Throughput => "throughput".to_owned(),
                Roulette::Constant(p) => p.to_string(),
                Roulette::Off => "off".to_owned(),
            },
            connect: estimator.connect.name().into(),
            lights: estimator.lights.name().into(),
            sampler: estimator.sampler.name().into(),
        }
    }
}

/// `fresnel=scene distribution=scene absorption=segment …`
impl fmt::Display for SettingsRecord {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let scaling = if self.radiance_scaling { "on" } else { "off" };
        let depth = self
            .max_depth
            .map_or("none".to_owned(), |depth| depth.to_string());
        let Self {
            fresnel,
            distribution,
            absorption,
            integrator,
            lobe,
            normals,
            roulette,
            connect,
            lights,
            sampler,
            ..
        } = self;
        write!(
            f,
            "fresnel={fresnel} distribution={distribution} absorption={absorption} "
        )?;
        write!(f, "radiance-scaling={scaling} max-depth={depth} ")?;
        // Pictures made before there was a second integrator keep their notes.
        if *integrator != Integrator::Path.name() {
            write!(f, "integrator={integrator} ")?;
        }
        write!(
            f,
            "lobe={lobe} normals={normals} roulette={roulette} connect={connect} lights={lights} sampler={sampler}"
        )
    }
}
