//! The features of the kernel that a scene with its settings needs: decided only here.
//!
//! Small sets that can be printed, compared and hashed. They determine which files are in the kernel; never a buffer's
//! layout, never the order in which random numbers are drawn. So a kernel with more features than its scene needs, up
//! to [`Features::full`], makes the same picture.

mod auto;
mod member;
mod names;

use std::collections::BTreeSet;

use glam::DVec3;

use crate::film::Aov;
pub use crate::film::Keeps;
use crate::layout::constants::lights::FEW_LIGHTS;
use crate::prepared::{LightKind, Material, MaterialKind, Prepared, Shape, ShapeKind};
use crate::settings::{
    Absorption, Connect, Distribution, Estimator, Fresnel, Integrator, Lights, LobeChoice, Normals,
    Roulette, Sampler, Settings,
};
pub use auto::{Chosen, chosen};
pub use member::Member;
pub use names::words;

/// The kind of roulette, without its parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RouletteKind {
    Throughput,
    Constant,
    Off,
}

/// How one of several lights is picked; with one light there is no choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LightPick {
    /// By its power: for light paths, and if the settings say so.
    Power,
    /// A few lights: each is a candidate at every vertex.
    Every,
    /// Many lights: in the tree.
    Tree,
}

impl LightPick {
    /// All ways that some number of lights needs under these settings.
    pub fn all(settings: &Settings) -> &'static [Self] {
        let Estimator {
            integrator, lights, ..
        } = settings.estimator;
        match (integrator, lights) {
            (Integrator::Light, _) | (_, Lights::Power) => &[Self::Power],
            (Integrator::Path, Lights::Contribution) => &[Self::Every, Self::Tree],
            (Integrator::Bidirectional, Lights::Contribution) => {
                &[Self::Power, Self::Every, Self::Tree]
            }
        }
    }

    /// Whether it is used for this number of lights, if the settings allow it.
    pub fn picks_among(self, lights: usize) -> bool {
        let few = lights <= FEW_LIGHTS as usize;
        lights > 1
            && match self {
                Self::Power => true,
                Self::Every => few,
                Self::Tree => !few,
            }
    }

    /// The ways for this number of lights.
    fn of(lights: usize, settings: &Settings) -> BTreeSet<Self> {
        let all = Self::all(settings).iter().copied();
        all.filter(|pick| pick.picks_among(lights)).collect()
    }
}

/// The features that one scene with its settings needs.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Features {
    pub shapes: BTreeSet<ShapeKind>,
    /// Shapes found through a bounding volume hierarchy; the others are tested one by one.
    pub in_bvh: BTreeSet<ShapeKind>,
    /// Kinds of the materials in use.
    pub materials: BTreeSet<MaterialKind>,
    /// Some material has both a diffuse and a specular lobe.
    pub diffuse_beside: bool,
    /// Of rough materials.
    pub distributions: BTreeSet<Distribution>,
    /// Of materials that reflect specularly.
    pub fresnel: BTreeSet<Fresnel>,
    pub lights: BTreeSet<LightKind>,
    /// Ways to pick one of several lights.
    pub picks: BTreeSet<LightPick>,
    pub integrator: Integrator,
    pub normals: Normals,
    pub lobe: LobeChoice,
    pub connect: Connect,
    pub sampler: Sampler,
    pub roulette: RouletteKind,
    pub radiance_scaling: bool,
    /// `None` if nothing absorbs.
    pub absorption: Option<Absorption>,
    pub max_depth: bool,
    /// Some mesh has its own normals.
    pub shading_normals: bool,
    /// Light paths are aimed at shapes that concentrate light.
    pub aims: bool,
    /// The eye has a lens.
    pub lens: bool,
    /// Kinds with a face that may be covered by another shape's.
    pub covered: BTreeSet<ShapeKind>,
    /// Outputs in addition to the picture.
    pub aovs: BTreeSet<Aov>,
}

/// Up to this number of primitives it is faster to test them one by one, each written out, than to search a hierarchy.
pub const WRITTEN_OUT: usize = 24;

impl Features {
    /// The features that this scene needs.
    pub fn of(prepared: &Prepared, settings: &Settings, aovs: &[Aov]) -> Self {
        let used: Vec<&Material> = prepared
            .shapes
            .iter()
            .map(|s| &prepared.materials[s.material as usize])
            .collect();
        let shapes: BTreeSet<ShapeKind> = prepared.shapes.iter().map(|s| s.kind).collect();
        Self {
            in_bvh: in_bvh(prepared, &shapes),
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
            picks: LightPick::of(prepared.lights.len(), settings),
            absorption: used
                .iter()
                .any(|m| Prepared::is_transmissive(m) && m.sigma != DVec3::ZERO)
                .then_some(settings.model.absorption),
            shading_normals: !prepared.primitives.normals.is_empty(),
            aims: Self::aims(settings) && !prepared.aims.is_empty(),
            lens: prepared.lens.is_some(),
            covered: covered(prepared),
            ..Self::bare(settings, aovs)
        }
    }

    /// The features that any scene could need. Settings of model and estimator and the additional outputs stay as
    /// chosen, because they are alternatives of which a kernel has exactly one.
    pub fn full(settings: &Settings, aovs: &[Aov]) -> Self {
        Member::all(settings)
            .into_iter()
            .fold(Self::bare(settings, aovs), |features, member| {
                features.with(member)
            })
    }

    /// The features that the settings alone require: those of an empty scene.
    fn bare(settings: &Settings, aovs: &[Aov]) -> Self {
        let (model, estimator) = (&settings.model, &settings.estimator);
        Self {
            shapes: BTreeSet::new(),
            in_bvh: BTreeSet::new(),
            materials: BTreeSet::new(),
            diffuse_beside: false,
            distributions: BTreeSet::new(),
            fresnel: BTreeSet::new(),
            lights: BTreeSet::new(),
            picks: BTreeSet::new(),
            integrator: estimator.integrator,
            normals: estimator.normals,
            lobe: estimator.lobe,
            connect: estimator.connect,
            sampler: estimator.sampler,
            roulette: match estimator.roulette {
                Roulette::Throughput => RouletteKind::Throughput,
                Roulette::Constant(_) => RouletteKind::Constant,
                Roulette::Off => RouletteKind::Off,
            },
            radiance_scaling: model.radiance_scaling,
            absorption: None,
            max_depth: model.max_depth.is_some(),
            shading_normals: false,
            aims: false,
            lens: false,
            covered: BTreeSet::new(),
            // Layers are made separately (render/layers.rs).
            aovs: aovs.iter().copied().filter(|aov| !aov.is_layer()).collect(),
        }
    }

    /// Whether light paths are aimed if there are targets.
    fn aims(settings: &Settings) -> bool {
        settings.estimator.integrator == Integrator::Bidirectional
    }

    /// The kinds whose primitives are tested one by one.
    pub fn written_out(&self) -> impl Iterator<Item = ShapeKind> {
        self.shapes.difference(&self.in_bvh).copied()
    }

    /// Some surface transmits and refracts light.
    pub fn transmits(&self) -> bool {
        use MaterialKind::{RoughDielectric, SmoothDielectric, WeakDielectric};
        let kinds = [RoughDielectric, SmoothDielectric, WeakDielectric];
        kinds.iter().any(|kind| self.materials.contains(kind))
    }

    /// A surface of this scene is a null interface: |ior − 1| < 1e-7.
    pub fn has_null_interface(&self) -> bool {
        self.materials.contains(&MaterialKind::NullInterface)
    }

    /// The data kept of each pixel: quarters for the error estimate of a denoised picture; else moments, which give
    /// standard errors if samples are independent. For other samplers they come from the two groups of samples, which
    /// any film keeps.
    pub fn keeps(&self) -> Keeps {
        let independent = self.sampler == Sampler::Random;
        match self.aovs.contains(&Aov::Denoised) {
            true => Keeps::Quarters,
            false if independent && self.aovs.contains(&Aov::Stderr) => Keeps::Moments,
            false => Keeps::Nothing,
        }
    }
}

/// The kinds with an entry in the table of coincident faces.
fn covered(prepared: &Prepared) -> BTreeSet<ShapeKind> {
    let table = &prepared.primitives.coincident;
    let has = |i: u32, shape: &Shape| shape.faces().any(|prim| !table.of(i, prim).is_empty());
    let shapes = (0..).zip(&prepared.shapes);
    let covered = shapes.filter(|(i, shape)| !table.is_empty() && has(*i, shape));
    covered.map(|(_, shape)| shape.kind).collect()
}

/// All kinds but the rarest, which together have few primitives.
fn in_bvh(prepared: &Prepared, shapes: &BTreeSet<ShapeKind>) -> BTreeSet<ShapeKind> {
    let mut kinds: Vec<(usize, ShapeKind)> = shapes
        .iter()
        .map(|&kind| (prepared.primitives.count(kind), kind))
        .collect();
    kinds.sort_unstable();
    let mut total = 0;
    let few = |(count, _): &(usize, ShapeKind)| {
        total += count;
        total <= WRITTEN_OUT
    };
    kinds
        .into_iter()
        .skip_while(few)
        .map(|(_, kind)| kind)
        .collect()
}

/// Whether micro-normals are sampled on it.
pub fn is_rough(kind: MaterialKind) -> bool {
    use MaterialKind::{Glossy, RoughDielectric, WeakDielectric};
    matches!(kind, Glossy | RoughDielectric | WeakDielectric)
}

/// Whether it reflects by Fresnel's law, rough or smooth.
pub fn is_specular(kind: MaterialKind) -> bool {
    is_rough(kind) || matches!(kind, MaterialKind::Mirror | MaterialKind::SmoothDielectric)
}
