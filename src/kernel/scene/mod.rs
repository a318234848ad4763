//! Features → the composed kernel of a scene: the file in each slot, generated text, declarations.

mod declare;
mod dispatch;
mod generate;
mod integrator;

use std::collections::BTreeSet;

use super::{Composed, Composer, KernelError, OwnFile, Slot};
use crate::features::{Features, Keeps, LightPick, RouletteKind};
use crate::prepared::{LightKind, ShapeKind};
use crate::settings::{Absorption, Connect, Integrator, LobeChoice, Normals, Sampler, Settings};
pub use declare::{Binding, Element, declare_binding};
use integrator::Own;

/// The parameters of a kernel's text apart from its features.
#[derive(Clone, Copy, Debug)]
pub struct Parameters<'a> {
    pub settings: &'a Settings,
    pub bindings: &'a [Binding],
    /// Entries of the hierarchy's traversal stack, and the largest coordinate in it.
    pub bvh: Option<(u32, f32)>,
    /// Index of the background among the lights, if it emits.
    pub background_light: Option<u32>,
    /// Its kind. Kernels do not read it at run time: if a branch depends only on a uniform at a fixed place, Mesa
    /// 22.3's compiler may write beyond its own arrays.
    pub outside: Option<LightKind>,
    pub recording: Recording,
    /// Read the unrolled primitives before any branch, which CPU drivers need; no bit depends on it.
    pub read_first: bool,
    /// Files that replace those of `shaders/`, or are added to them.
    pub own_files: &'a [OwnFile<'a>],
}

impl Parameters<'_> {
    /// Elements of an array; none if it is not bound.
    fn count(&self, name: &str) -> usize {
        let binding = self.bindings.iter().find(|b| b.name == name);
        binding.map_or(0, |b| b.count)
    }
}

/// An end at which paths begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Eye,
    Light,
}

impl Side {
    /// The ends from which an integrator follows paths, a kernel each, in the order of their dispatches.
    pub fn of(integrator: Integrator) -> &'static [Self] {
        match integrator {
            Integrator::Path => &[Self::Eye],
            Integrator::Light => &[Self::Light],
            Integrator::Bidirectional => &[Self::Light, Self::Eye],
        }
    }
}

/// The records that a kernel makes of its paths in addition to the film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recording {
    Nothing,
    /// This many events of a path, into the buffer `records`.
    Events(u32),
    /// The outcomes of the paths of this many samples a pixel, into the buffer `outcomes`.
    Outcomes(u32),
}

/// Slots of a thread for the splats of one dispatch of light tracing.
pub const SPLATS: u32 = 16;

/// The kernels for a scene of these features, one for each of [`Side::of`] the integrator: the files they need, the
/// generated dispatch, nothing else.
///
/// # Errors
/// If a file or slot is missing, which would be a bug in this program; if a custom file is not used.
pub fn compose(features: &Features, parameters: &Parameters) -> Result<Vec<Composed>, KernelError> {
    let kernel = |&side: &Side| {
        let own = Own::of(features, parameters.recording, side);
        composer(features, parameters, side, &own).compose(&[own.root])
    };
    let sides = Side::of(features.integrator).iter();
    let kernels: Vec<Composed> = sides.map(kernel).collect::<Result<_, _>>()?;
    let used = |name: &str| kernels.iter().any(|k| k.files().any(|file| file == name));
    match parameters.own_files.iter().find(|own| !used(own.name)) {
        Some(OwnFile { name, .. }) => Err(KernelError::Unused {
            name: (*name).to_owned(),
        }),
        None => Ok(kernels),
    }
}

fn composer(features: &Features, parameters: &Parameters, side: Side, own: &Own) -> Composer {
    let file = |path: &str| Slot::File(path.into());
    let mut composer = Composer::new().prelude(declare::prelude(features, parameters, own));
    for (name, path) in files(features, parameters, side) {
        composer = composer.slot(name, file(path));
    }
    for (name, text) in generate::texts(features, parameters) {
        composer = composer.slot(name, Slot::Text(text));
    }
    for own in parameters.own_files {
        composer = composer.add(own.name, own.text);
    }
    composer
}

/// Slots that are filled with one of several files.
fn files(
    features: &Features,
    parameters: &Parameters,
    side: Side,
) -> Vec<(&'static str, &'static str)> {
    let connects = !features.lights.is_empty() && features.connect != Connect::Bsdf;
    let both = features.integrator == Integrator::Bidirectional;
    vec![
        (
            "blocks",
            match side {
                Side::Eye => "path/blocks/eye",
                Side::Light => "path/blocks/light",
            },
        ),
        (
            "begin",
            match features.lens {
                true => "integrator/path/begin/lens",
                false => "integrator/path/begin/pinhole",
            },
        ),
        (
            "lens",
            match features.lens {
                true => "camera/lens/thin",
                false => "camera/lens/none",
            },
        ),
        (
            "correction",
            match (features.shading_normals, side) {
                (true, Side::Light) => "path/correction/shading_normal",
                (true, Side::Eye) if both => "path/correction/both",
                (_, Side::Eye) | (false, _) => "path/correction/none",
            },
        ),
        (
            "sampler",
            match features.sampler {
                Sampler::Random => "sampler/random",
                Sampler::Sobol => "sampler/sobol",
                Sampler::SobolQuarters => "sampler/sobol_quarters",
            },
        ),
        (
            "normals",
            match features.normals {
                Normals::Visible => "bsdf/normals/visible",
                Normals::Distribution => "bsdf/normals/distribution",
            },
        ),
        (
            "choice",
            match features.lobe {
                LobeChoice::Fresnel => "bsdf/choice/fresnel",
                LobeChoice::Norms => "bsdf/choice/norms",
            },
        ),
        (
            "diffuse",
            match features.diffuse_beside {
                true => "bsdf/diffuse/mixed",
                false => "bsdf/diffuse/absent",
            },
        ),
        (
            "scaling",
            // Light paths carry the adjoint: `Settings::adjoint`.
            match (side, features.radiance_scaling) {
                (Side::Eye, _) if both => "bsdf/scaling/both",
                (Side::Eye, true) | (Side::Light, false) => "bsdf/scaling/radiance",
                (Side::Eye, false) | (Side::Light, true) => "bsdf/scaling/flux",
            },
        ),
        (
            "crossing",
            match features.transmits() {
                true => "path/crossing/through",
                false => "path/crossing/none",
            },
        ),
        (
            "medium",
            match features.absorption {
                None => "path/medium/none",
                Some(Absorption::Segment) => "path/medium/segment",
                Some(Absorption::Term) => "path/medium/term",
            },
        ),
        (
            "null_interface",
            match features.has_null_interface() {
                true => "path/null_interface/through",
                false => "path/null_interface/none",
            },
        ),
        (
            "roulette",
            match features.roulette {
                RouletteKind::Throughput => "path/roulette/throughput",
                RouletteKind::Constant => "path/roulette/constant",
                RouletteKind::Off => "path/roulette/off",
            },
        ),
        (
            "depth",
            match features.max_depth {
                true => "path/depth/capped",
                false => "path/depth/unlimited",
            },
        ),
        (
            "connect",
            match features.connect {
                Connect::Mis => "integrator/path/connect/mis",
                Connect::Light => "integrator/path/connect/light",
                Connect::Bsdf => "integrator/path/connect/bsdf",
            },
        ),
        (
            "direct",
            match (both, connects) {
                (false, true) => "integrator/path/direct/sample",
                (false, false) => "integrator/path/direct/none",
                (true, true) => "integrator/bidirectional/direct/sample",
                (true, false) => "integrator/bidirectional/direct/none",
            },
        ),
        (
            "weigh",
            match both {
                false => "integrator/path/weigh",
                true => "integrator/bidirectional/to_light",
            },
        ),
        (
            "aim",
            match features.aims {
                true => "integrator/bidirectional/aim/balls",
                false => "integrator/bidirectional/aim/none",
            },
        ),
        (
            "light_shade",
            match both {
                false => "integrator/light/shade",
                true => "integrator/bidirectional/light_path",
            },
        ),
        (
            "first_partial",
            match features.lights.is_empty() {
                false => "integrator/bidirectional/first/light",
                true => "integrator/bidirectional/first/none",
            },
        ),
        (
            "pick",
            match connects {
                true => picked(features),
                false => "integrator/path/pick/none",
            },
        ),
        (
            "emission",
            match (both, shine(&features.lights)) {
                (false, true) => "integrator/path/emission/shapes",
                (false, false) => "integrator/path/emission/none",
                (true, true) => "integrator/bidirectional/emission/shapes",
                (true, false) => "integrator/bidirectional/emission/none",
            },
        ),
        (
            "background",
            match (both, features.lights.iter().any(|l| l.is_outside())) {
                (false, true) => "integrator/path/background/shining",
                (false, false) => "integrator/path/background/black",
                (true, true) => "integrator/bidirectional/background/shining",
                (true, false) => "integrator/bidirectional/background/black",
            },
        ),
        (
            "light_start",
            match features.lights.is_empty() {
                true => "integrator/light/start/none",
                false => "integrator/light/start/sample",
            },
        ),
        (
            "light_choice",
            match features.picks.contains(&LightPick::Power) {
                true => "light/choice/many",
                false => "light/choice/one",
            },
        ),
        (
            "self_distance",
            match features.shapes.contains(&ShapeKind::Mesh) {
                true => "path/self_distance/mesh",
                false => "path/self_distance/none",
            },
        ),
        (
            "cover",
            match features.covered.is_empty() {
                true => "shape/cover/none",
                false => "shape/cover/table",
            },
        ),
        (
            "shading_normal",
            match features.shading_normals {
                true => "shape/normal/smooth",
                false => "shape/normal/flat",
            },
        ),
        (
            "valid",
            match features.shading_normals {
                true => "path/valid/smooth",
                false => "path/valid/flat",
            },
        ),
        (
            "moments",
            match features.keeps() {
                Keeps::Moments => "film/moments/welford",
                Keeps::Quarters => "film/moments/quarters",
                Keeps::Nothing => "film/moments/none",
            },
        ),
        (
            "record",
            recorder(features.integrator, side, parameters.recording),
        ),
    ]
}

/// How a vertex picks the light to which it is connected.
fn picked(features: &Features) -> &'static str {
    let has = |pick| features.picks.contains(&pick);
    match (has(LightPick::Every), has(LightPick::Tree)) {
        (false, false) => "integrator/path/pick/power",
        (true, false) => "integrator/path/pick/few",
        (false, true) => "integrator/path/pick/many",
        (true, true) => "integrator/path/pick/any",
    }
}

/// The recorder of a kernel's paths; for a light tracer one that records nothing.
fn recorder(integrator: Integrator, side: Side, recording: Recording) -> &'static str {
    let both = integrator == Integrator::Bidirectional;
    match (both, side, recording) {
        (false, _, Recording::Nothing) => "integrator/path/record/off",
        (false, _, Recording::Events(_)) => "integrator/path/record/on",
        (false, _, Recording::Outcomes(_)) => "integrator/path/record/signature",
        (true, Side::Eye, Recording::Outcomes(_)) => {
            "integrator/bidirectional/record/eye_signature"
        }
        (true, Side::Eye, _) => "integrator/bidirectional/record/eye_off",
        (true, Side::Light, Recording::Outcomes(_)) => {
            "integrator/bidirectional/record/light_signature"
        }
        (true, Side::Light, _) => "integrator/bidirectional/record/light_off",
    }
}

/// Whether a shape is among the lights.
fn shine(lights: &BTreeSet<LightKind>) -> bool {
    lights.iter().any(|l| !l.is_outside())
}
