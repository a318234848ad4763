//! The GLSL types allowed in a shared struct, including structs, and their alignment.

#![allow(non_camel_case_types, reason = "a declaration reads as its GLSL does")]

pub use super::kernel::{Ray, ShadowRay, Subpath};

pub type float = f32;
pub type uint = u32;
pub type int = i32;
pub type vec2 = [f32; 2];
pub type vec3 = [f32; 3];
pub type vec4 = [f32; 4];
pub type uvec2 = [u32; 2];
pub type uvec4 = [u32; 4];

/// A type with the same size in Rust and in GLSL.
pub trait GlslType: bytemuck::Pod {
    /// Bytes, in std140 and in std430 alike (OpenGL 4.6, section 7.6.2.2, rules 1 to 3, and 9 for structs).
    const ALIGN: usize;
}

macro_rules! align {
    ($($ty:ty: $align:literal),*) => { $(impl GlslType for $ty { const ALIGN: usize = $align; })* };
}
align!(float: 4, uint: 4, int: 4, vec2: 8, uvec2: 8, vec3: 16, vec4: 16, uvec4: 16);
