//! A scene's buffers on a device: small arrays as uniforms, which is what makes kernels fast to compile and to
//! run on CPU drivers; the rest as storage.

use bytemuck::NoUninit;

use super::absent;
use crate::features::Features;
use crate::flat;
use crate::gpu::{Buffer, BufferUse, Device};
use crate::kernel::scene::{Binding, Element, Parameters, Recording};
use crate::layout::GpuStruct;
use crate::prepared::{LightKind, Prepared, ShapeKind};
use crate::render::{Job, RenderError};

/// The buffers of one scene, in the order of their bindings.
pub struct SceneBuffers {
    buffers: Vec<Buffer>,
    bindings: Vec<Binding>,
    /// Entries of the hierarchy's traversal stack that can be needed at once, and its reach.
    bvh: Option<(u32, f32)>,
    background_light: Option<u32>,
}

impl SceneBuffers {
    /// Uploads what a kernel of these features reads, and nothing else.
    pub fn new(
        device: &Device,
        prepared: &Prepared,
        features: &Features,
        seed: u32,
    ) -> Result<Self, RenderError> {
        let mut all = Upload {
            device,
            buffers: Vec::new(),
            bindings: Vec::new(),
        };
        let has = |kind| features.shapes.contains(&kind);
        all.records("camera", &[flat::camera(prepared, seed)])?;
        all.records("materials", &flat::materials(prepared))?;
        all.records("shapes", &flat::shapes(prepared))?;
        if has(ShapeKind::Sphere) {
            all.records("spheres", &flat::spheres(prepared))?;
        }
        if has(ShapeKind::Box) {
            all.records("boxes", &flat::boxes(prepared))?;
        }
        if has(ShapeKind::Cylinder) {
            all.records("cylinders", &flat::cylinders(prepared))?;
        }
        if has(ShapeKind::Mesh) {
            all.words("triangle_words", Element::Float, &flat::triangles(prepared))?;
            all.words(
                "triangle_shapes",
                Element::Uint,
                &flat::triangle_shapes(prepared),
            )?;
            if features.shading_normals {
                all.words("normal_words", Element::Float, &absent::normals(prepared))?;
            }
        }
        if !features.lights.is_empty() {
            all.records("lights", &absent::lights(prepared, features))?;
        }
        if features.many_lights {
            let cdf = absent::light_cdf(prepared, features);
            all.words("light_cdf", Element::Uint, &cdf)?;
        }
        if features.lights.contains(&LightKind::Mesh) {
            all.words("triangle_cdf", Element::Uint, &prepared.triangle_cdf)?;
        }
        let mut hierarchy = None;
        if !features.in_bvh.is_empty() {
            let kinds: Vec<ShapeKind> = features.in_bvh.iter().copied().collect();
            let bvh = flat::bvh::build(prepared, &kinds);
            all.words("bvh_words", Element::Uvec4, &bvh.nodes)?;
            all.words("bvh_references", Element::Uint, &bvh.references)?;
            hierarchy = Some((bvh.stack, bvh.reach));
        }
        Ok(Self {
            buffers: all.buffers,
            bindings: all.bindings,
            bvh: hierarchy,
            background_light: absent::background_light(prepared, features),
        })
    }

    /// What the text of the kernel needs to know of the buffers and of the job.
    pub fn parameters<'a>(&'a self, job: &'a Job, recording: Recording) -> Parameters<'a> {
        Parameters {
            settings: &job.settings,
            bindings: &self.bindings,
            bvh: self.bvh,
            background_light: self.background_light,
            recording,
        }
    }

    pub fn uses(&self) -> Vec<BufferUse> {
        self.bindings.iter().map(|b| b.buffer_use).collect()
    }

    pub fn buffers(&self) -> Vec<&Buffer> {
        self.buffers.iter().collect()
    }
}

struct Upload<'a> {
    device: &'a Device,
    buffers: Vec<Buffer>,
    bindings: Vec<Binding>,
}

impl Upload<'_> {
    /// An array of structs: a uniform where it fits.
    fn records<T: GpuStruct>(&mut self, name: &'static str, data: &[T]) -> Result<(), RenderError> {
        let none = [T::default()];
        // An array has one element at least, in GLSL and so in its buffer.
        let stored = if data.is_empty() { &none } else { data };
        let buffer_use = if size_of_val(stored) as u64 <= self.device.limits().uniform_buffer {
            BufferUse::Uniform
        } else {
            BufferUse::Storage
        };
        let element = Element::Struct(T::NAME);
        let bytes = bytemuck::cast_slice(stored);
        self.add(name, element, buffer_use, data.len(), bytes)
    }

    /// An array of plain words, always in storage: std140 would spread each over 16 bytes.
    fn words<T: NoUninit>(
        &mut self,
        name: &'static str,
        element: Element,
        data: &[T],
    ) -> Result<(), RenderError> {
        let bytes = bytemuck::cast_slice(data);
        let count = bytes.len() / element.bytes();
        self.add(name, element, BufferUse::Storage, count, bytes)
    }

    fn add(
        &mut self,
        name: &'static str,
        element: Element,
        buffer_use: BufferUse,
        count: usize,
        bytes: &[u8],
    ) -> Result<(), RenderError> {
        let buffer = self.device.buffer(name, buffer_use, bytes.len() as u64)?;
        buffer.write(bytes)?;
        self.buffers.push(buffer);
        self.bindings.push(Binding {
            name,
            element,
            count,
            buffer_use,
        });
        Ok(())
    }
}
