//! The prelude of a scene's kernel: constants, structs, buffers.

use super::integrator::Own;
use super::{Parameters, Recording, SPLATS};
use crate::features::{Features, LightPick};
use crate::layout::{self, BufferUse, GpuStruct, constants};
use crate::prepared::{LightKind, device};
use crate::settings::{Integrator, Roulette};

/// The element type of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    Float,
    Uint,
    Uvec4,
    /// A struct of the layout, by name.
    Struct(&'static str),
}

impl Element {
    /// Size of a plain element.
    pub fn bytes(self) -> usize {
        match self {
            Self::Float | Self::Uint => 4,
            Self::Uvec4 | Self::Struct(_) => 16,
        }
    }

    /// The name of the type in GLSL.
    pub fn glsl(self) -> &'static str {
        match self {
            Self::Float => "float",
            Self::Uint => "uint",
            Self::Uvec4 => "uvec4",
            Self::Struct(name) => name,
        }
    }
}

/// A read-only array that a kernel finds at binding i of set 0, where i is its place in the list of bindings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    pub name: &'static str,
    pub element: Element,
    /// Meaningful elements. The buffer has at least one: zeros that no kernel reads.
    pub count: usize,
    pub buffer_use: BufferUse,
}

/// The declaration of one array, or of the one camera, which the kernel copies into a variable.
pub fn declare_binding(binding: &Binding, index: usize) -> String {
    let Binding {
        name,
        element,
        count,
        buffer_use,
    } = binding;
    let ty = element.glsl();
    let one = *name == "camera";
    match buffer_use {
        BufferUse::Uniform => {
            let variable = if one {
                format!("{name}_uniform")
            } else {
                format!("{name}[{}]", count.max(&1))
            };
            format!(
                "layout(std140, set = 0, binding = {index}) uniform {name}_block {{ {ty} {variable}; }};\n"
            )
        }
        BufferUse::Storage => format!(
            "layout(std430, set = 0, binding = {index}) readonly buffer {name}_block {{ {ty} {name}[]; }};\n"
        ),
    }
}

pub fn prelude(features: &Features, parameters: &Parameters, own: &Own) -> String {
    let mut text = numbers(parameters);
    text += &structs(features);
    for (i, binding) in parameters.bindings.iter().enumerate() {
        text += &declare_binding(binding, i);
    }
    let Own { state, slice, .. } = own;
    for (i, array) in state.iter().enumerate() {
        text += &array.glsl;
        text += &state_buffer(array.ty, array.name, parameters.bindings.len() + i);
    }
    let (ty, glsl) = slice;
    text += glsl;
    text += &format!("layout(push_constant) uniform SliceBlock {{ {ty} job_uniform; }};\n");
    text + &format!("Camera camera;\n{ty} job;\n")
}

fn state_buffer(ty: &str, name: &str, index: usize) -> String {
    format!(
        "layout(std430, set = 0, binding = {index}) buffer {name}_block {{ {ty} {name}[]; }};\n"
    )
}

fn numbers(parameters: &Parameters) -> String {
    let mut text = String::new();
    let mut uint = |name: &str, value: u32| text += &constants::uint(name, value);
    for binding in parameters.bindings {
        uint(&binding.name.to_uppercase(), binding.count as u32);
    }
    if let Some(n) = parameters.settings.model.max_depth {
        uint("MAX_DEPTH", n);
    }
    if let Some(light) = parameters.background_light {
        uint("BACKGROUND_LIGHT", light);
    }
    match parameters.recording {
        Recording::Nothing => {}
        Recording::Events(n) => uint("RECORDS", n),
        Recording::Outcomes(n) => uint("OUTCOMES", n),
    }
    if parameters.settings.estimator.integrator != Integrator::Path {
        uint("SPLATS", SPLATS);
    }
    if let Some((stack, _)) = parameters.bvh {
        uint("STACK", stack.max(1));
    }
    if let Some((_, reach)) = parameters.bvh {
        text += &format!("const float REACH = {reach:?};\n");
    }
    if parameters.settings.estimator.integrator == Integrator::Bidirectional {
        let scaling = parameters.settings.model.radiance_scaling;
        text += &format!("const bool RADIANCE_SCALING = {scaling};\n");
    }
    if let Roulette::Constant(p) = parameters.settings.estimator.roulette {
        text += &format!("const float ROULETTE = {:?};\n", p as f32);
    }
    text
}

/// Only the records that the kernel reads.
fn structs(features: &Features) -> String {
    let mut text = device::Camera::glsl()
        + &device::Material::glsl()
        + &device::Shape::glsl()
        + &layout::Ray::glsl()
        + &layout::ShadowRay::glsl()
        + &layout::Subpath::glsl();
    let primitives = (features.shapes.iter()).filter_map(|kind| kind.description().declaration);
    text.extend(primitives.map(|declaration| declaration()));
    if !features.covered.is_empty() {
        text += &device::Coincidence::glsl();
    }
    if !features.lights.is_empty() {
        text += &device::Light::glsl();
    }
    if features.lights.contains(&LightKind::Surroundings) {
        text += &device::Surroundings::glsl();
        text += &device::SurroundingsRow::glsl();
    }
    if features.aims {
        text += &device::Aim::glsl();
    }
    if features.lens {
        text += &device::Lens::glsl();
    }
    if features.picks.contains(&LightPick::Tree) {
        text += &device::LightNode::glsl();
    }
    text
}
