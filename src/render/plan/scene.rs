//! Decides which arrays of a scene go to a kernel, for uploading and for reporting.
//!
//! Small arrays are uniforms, which makes kernels fast to compile and to run on CPU drivers; the
//! rest is in storage buffers.

use bytemuck::NoUninit;

use super::PlanLimits;
use super::absent;
use super::array::{ArrayPlan, SceneArray};
use crate::features::{Features, LightPick};
use crate::flat::bvh::Bvh;
use crate::flat::{self, bvh};
use crate::kernel::scene::{Binding, Element, Parameters, Recording};
use crate::layout::{BufferUse, Records};
use crate::prepared::{LightKind, Prepared, ShapeKind, Surroundings};
use crate::render::Job;
use crate::settings::Integrator;

/// The array with the camera and the seed.
pub const CAMERA: &str = "camera";

/// Names of the parts of surroundings' arrays: of the counts of texels, and of their values.
const ENDS: [&str; 8] = [
    "surroundings_ends_0",
    "surroundings_ends_1",
    "surroundings_ends_2",
    "surroundings_ends_3",
    "surroundings_ends_4",
    "surroundings_ends_5",
    "surroundings_ends_6",
    "surroundings_ends_7",
];
const VALUES: [&str; 24] = [
    "surroundings_values_0",
    "surroundings_values_1",
    "surroundings_values_2",
    "surroundings_values_3",
    "surroundings_values_4",
    "surroundings_values_5",
    "surroundings_values_6",
    "surroundings_values_7",
    "surroundings_values_8",
    "surroundings_values_9",
    "surroundings_values_10",
    "surroundings_values_11",
    "surroundings_values_12",
    "surroundings_values_13",
    "surroundings_values_14",
    "surroundings_values_15",
    "surroundings_values_16",
    "surroundings_values_17",
    "surroundings_values_18",
    "surroundings_values_19",
    "surroundings_values_20",
    "surroundings_values_21",
    "surroundings_values_22",
    "surroundings_values_23",
];

/// The arrays of one scene, in the order of their bindings, and its hierarchy.
pub struct ScenePlan<'a> {
    job: &'a Job<'a>,
    arrays: Vec<SceneArray<'a>>,
    bindings: Vec<Binding>,
    bvh: Option<&'a Bvh>,
    background_light: Option<u32>,
    outside: Option<LightKind>,
    read_first: bool,
}

/// The hierarchy that a kernel of these features searches, if any.
pub fn hierarchy(prepared: &Prepared, features: &Features) -> Option<Bvh> {
    let kinds: Vec<ShapeKind> = features.in_bvh.iter().copied().collect();
    (!kinds.is_empty()).then(|| bvh::build(prepared, &kinds))
}

impl<'a> ScenePlan<'a> {
    /// The arrays that a kernel of these features reads. `bvh` is their [`hierarchy`].
    pub fn new(
        job: &'a Job<'a>,
        features: &Features,
        bvh: Option<&'a Bvh>,
        limits: PlanLimits,
    ) -> Self {
        let mut all = Arrays {
            all: Vec::new(),
            limits,
        };
        all.scene(job.prepared, job.seed);
        if features.lens {
            all.records("lens", vec![absent::lens(job.prepared)]);
        }
        all.primitives(job.prepared, features);
        all.lights(job.prepared, features);
        if !features.covered.is_empty() {
            let faces = absent::coincident_faces(job.prepared);
            let count = faces.len();
            all.words("coincident_faces", Element::Uint, count, move || {
                faces.clone()
            });
            all.records("coincidences", &job.prepared.primitives.coincident.list);
        }
        if let Some(bvh) = bvh {
            all.lent("bvh_words", Element::Uvec4, &bvh.nodes);
            all.lent("bvh_references", Element::Uint, &bvh.references);
        }
        let arrays = all.all;
        Self {
            job,
            bindings: arrays.iter().map(|a| a.plan.binding).collect(),
            arrays,
            bvh,
            background_light: absent::background_light(job.prepared, features),
            outside: absent::outside(job.prepared, features),
            read_first: limits.read_first,
        }
    }

    pub fn arrays(&self) -> &[SceneArray<'a>] {
        &self.arrays
    }

    pub fn plans(&self) -> impl Iterator<Item = ArrayPlan> {
        self.arrays.iter().map(|a| a.plan)
    }

    pub fn uses(&self) -> Vec<BufferUse> {
        self.bindings.iter().map(|b| b.buffer_use).collect()
    }

    /// The parameters of the kernel's text.
    pub fn parameters(&self, recording: Recording) -> Parameters<'_> {
        Parameters {
            settings: &self.job.settings,
            bindings: &self.bindings,
            bvh: self.bvh.map(|bvh| (bvh.stack, bvh.reach)),
            background_light: self.background_light,
            outside: self.outside,
            recording,
            read_first: self.read_first,
            own_files: self.job.own_files(),
        }
    }
}

/// The arrays so far.
struct Arrays<'a> {
    all: Vec<SceneArray<'a>>,
    limits: PlanLimits,
}

impl<'a> Arrays<'a> {
    /// The arrays of every scene.
    fn scene(&mut self, prepared: &'a Prepared, seed: u32) {
        self.records(CAMERA, vec![flat::camera(prepared, seed)]);
        self.records("materials", &prepared.materials);
        self.records("shapes", &prepared.shapes);
    }

    fn primitives(&mut self, prepared: &'a Prepared, features: &Features) {
        for &kind in &features.shapes {
            match prepared.primitives.records(kind) {
                Some(records) => self.records(kind.description().array, records),
                None => self.triangles(prepared, features),
            }
        }
    }

    fn triangles(&mut self, prepared: &'a Prepared, features: &Features) {
        let (float, uint) = (Element::Float, Element::Uint);
        let count = prepared.primitives.triangles.len();
        self.words("triangle_words", float, count, || flat::triangles(prepared));
        self.words("triangle_shapes", uint, count, || {
            flat::triangle_shapes(prepared)
        });
        if features.shading_normals {
            self.words("normal_words", float, count, || absent::normals(prepared));
        }
    }

    fn lights(&mut self, prepared: &'a Prepared, features: &Features) {
        if !features.lights.is_empty() {
            self.records("lights", absent::lights(prepared, features));
        }
        if features.picks.contains(&LightPick::Power) {
            let cdf = absent::light_cdf(prepared, features);
            self.words("light_cdf", Element::Uint, cdf.len(), move || cdf.clone());
        }
        if features.picks.contains(&LightPick::Tree) {
            let (nodes, trails) = absent::light_tree(prepared, features);
            self.records("light_nodes", nodes);
            self.words("light_trails", Element::Uint, trails.len(), move || {
                trails.clone()
            });
        }
        if features.integrator != Integrator::Path && !features.lights.is_empty() {
            let media = absent::light_media(prepared, features);
            self.words("light_media", Element::Uint, media.len(), move || {
                media.clone()
            });
        }
        if features.aims {
            self.records("aims", &prepared.aims);
        }
        if features.lights.contains(&LightKind::Surroundings) {
            self.surroundings(prepared.surroundings.as_ref());
        }
        if features.lights.contains(&LightKind::Mesh) {
            self.lent("triangle_cdf", Element::Uint, &prepared.triangle_cdf);
        }
    }

    fn surroundings(&mut self, surroundings: Option<&'a Surroundings>) {
        let Some(s) = surroundings else {
            self.records("surroundings", vec![absent::BLACK_TEXEL]);
            self.records("surroundings_rows", vec![absent::BLACK_ROW]);
            self.lent(ENDS[0], Element::Uint, &[0_u32]);
            self.lent(VALUES[0], Element::Float, &[0.0_f32; 3]);
            return;
        };
        self.records("surroundings", vec![flat::surroundings(s)]);
        self.records("surroundings_rows", &s.rows);
        self.parts(&ENDS, Element::Uint, &s.ends);
        self.parts(&VALUES, Element::Float, s.picture.rgb.as_flattened());
    }

    /// An array in as few parts as the device's buffers allow, each of a power of two of words except the last.
    fn parts<T: NoUninit>(&mut self, names: &[&'static str], element: Element, words: &'a [T]) {
        let most = (self.limits.storage_buffer / 4).max(1).ilog2();
        for (name, part) in names.iter().zip(words.chunks(1 << most)) {
            self.lent(name, element, part);
        }
    }

    fn records(&mut self, name: &'static str, records: impl Records + 'a) {
        self.all.push(SceneArray::records(
            name,
            records,
            self.limits.uniform_buffer,
        ));
    }

    fn words<T: NoUninit>(
        &mut self,
        name: &'static str,
        element: Element,
        count: usize,
        make: impl Fn() -> Vec<T> + 'a,
    ) {
        self.all.push(SceneArray::words(name, element, count, make));
    }

    fn lent<T: NoUninit>(&mut self, name: &'static str, element: Element, records: &'a [T]) {
        self.all.push(SceneArray::lent(name, element, records));
    }
}
