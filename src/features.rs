//! What a scene with its settings needs of the kernel: decided here and nowhere else.
//!
//! Small sets that print, compare and hash. They choose which files are in the kernel; never a buffer's
//! layout, never the order in which random numbers are drawn.

use std::collections::BTreeSet;
use std::fmt::Debug;

use glam::DVec3;

use crate::film::Aov;
use crate::prepared::{LightKind, Material, MaterialKind, Prepared, ShapeKind};
use crate::settings::{
    Absorption, Connect, Distribution, Fresnel, LobeChoice, Normals, Roulette, Settings,
};

/// Which of the three roulettes, apart from its parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RouletteKind {
    Throughput,
    Constant,
    Off,
}

/// The parts of the renderer that one scene with its settings needs.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Features {
    pub shapes: BTreeSet<ShapeKind>,
    /// Those of them that are found through a bounding volume hierarchy, not by a loop over all.
    pub in_bvh: BTreeSet<ShapeKind>,
    /// Kinds of the materials that shapes have.
    pub materials: BTreeSet<MaterialKind>,
    /// A material has a diffuse lobe beside a specular one.
    pub diffuse_beside: bool,
    /// Of rough materials.
    pub distributions: BTreeSet<Distribution>,
    /// Of materials that reflect specularly.
    pub fresnel: BTreeSet<Fresnel>,
    pub lights: BTreeSet<LightKind>,
    /// More than one light to choose from.
    pub many_lights: bool,
    pub normals: Normals,
    pub lobe: LobeChoice,
    pub connect: Connect,
    pub roulette: RouletteKind,
    pub radiance_scaling: bool,
    /// `None` where nothing absorbs.
    pub absorption: Option<Absorption>,
    pub max_depth: bool,
    /// A mesh brings normals of its own.
    pub shading_normals: bool,
    /// What is made beside the picture.
    pub aovs: BTreeSet<Aov>,
}

/// Up to so many primitives of a kind a loop over them is faster than a hierarchy.
const LINEAR_PRIMITIVES: usize = 32;

impl Features {
    pub fn of(prepared: &Prepared, settings: &Settings, aovs: &[Aov]) -> Self {
        let used: Vec<&Material> = prepared
            .shapes
            .iter()
            .map(|s| &prepared.materials[s.material as usize])
            .collect();
        let shapes: BTreeSet<ShapeKind> = prepared.shapes.iter().map(|s| s.kind).collect();
        let in_bvh = |kind: &ShapeKind| prepared.primitives(*kind) > LINEAR_PRIMITIVES;
        let (model, estimator) = (&settings.model, &settings.estimator);
        Self {
            in_bvh: shapes.iter().copied().filter(in_bvh).collect(),
            shapes,
            materials: used.iter().map(|m| m.kind).collect(),
            diffuse_beside: used.iter().any(|m| is_specular(m.kind) && m.kd_mean > 0.0),
            distributions: used
                .iter()
                .filter(|m| is_rough(m.kind))
                .map(|m| m.distribution)
                .collect(),
            fresnel: used
                .iter()
                .filter(|m| is_specular(m.kind))
                .map(|m| m.fresnel)
                .collect(),
            lights: prepared.lights.iter().map(|l| l.kind).collect(),
            many_lights: prepared.lights.len() > 1,
            normals: estimator.normals,
            lobe: estimator.lobe,
            connect: estimator.connect,
            roulette: match estimator.roulette {
                Roulette::Throughput => RouletteKind::Throughput,
                Roulette::Constant(_) => RouletteKind::Constant,
                Roulette::Off => RouletteKind::Off,
            },
            radiance_scaling: model.radiance_scaling,
            absorption: used
                .iter()
                .any(|m| Prepared::is_transmissive(m) && m.sigma != DVec3::ZERO)
                .then_some(model.absorption),
            max_depth: model.max_depth.is_some(),
            shading_normals: !prepared.normals.is_empty(),
            aovs: aovs.iter().copied().collect(),
        }
    }

    /// A surface of this scene is not there: |ior − 1| < 1e-7.
    pub fn goes_straight(&self) -> bool {
        self.materials.contains(&MaterialKind::Nothing)
    }

    /// The kernel keeps each pixel's moments.
    pub fn keeps_moments(&self) -> bool {
        self.aovs.contains(&Aov::Stderr)
    }

    /// One phrase a feature, for people and for the JSON report.
    pub fn names(&self) -> Vec<String> {
        let set = |name: &str, members: String| format!("{name}: {members}");
        let mut names = vec![
            set("shapes", list(&self.shapes)),
            set("in a hierarchy", list(&self.in_bvh)),
            set("materials", list(&self.materials)),
            set("distributions", list(&self.distributions)),
            set("fresnel", list(&self.fresnel)),
            set("lights", list(&self.lights)),
            set("normals", lower(&self.normals)),
            set("lobe", lower(&self.lobe)),
            set("connect", lower(&self.connect)),
            set("roulette", lower(&self.roulette)),
        ];
        if let Some(absorption) = self.absorption {
            names.push(set("absorption", lower(&absorption)));
        }
        if !self.aovs.is_empty() {
            names.push(set("beside the picture", list(&self.aovs)));
        }
        names
    }
}

fn is_rough(kind: MaterialKind) -> bool {
    use MaterialKind::{Dielectric, Opaque, Weak};
    matches!(kind, Opaque | Dielectric | Weak)
}

fn is_specular(kind: MaterialKind) -> bool {
    is_rough(kind) || matches!(kind, MaterialKind::Mirror | MaterialKind::Glass)
}

fn lower(member: &impl Debug) -> String {
    format!("{member:?}").to_lowercase()
}

fn list<T: Debug>(set: &BTreeSet<T>) -> String {
    if set.is_empty() {
        return "none".into();
    }
    set.iter().map(lower).collect::<Vec<_>>().join(", ")
}
