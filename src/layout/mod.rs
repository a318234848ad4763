//! One declaration → a `#[repr(C)]` struct, its GLSL text, and their common offsets.
//!
//! [`gpu_struct!`](crate::gpu_struct) declares structs that only kernels use ([`kernel`]), [`record!`](crate::record)
//! the records of a scene that they read, with the CPU's forms of them. [`types`] has the GLSL types of their fields,
//! [`constants`] the numbers that both sides need.

mod buffer_use;
pub mod constants;
pub mod kernel;
mod macros;
mod record;
pub mod types;

pub use crate::record;
pub use buffer_use::BufferUse;
pub use kernel::{
    EyeState, FilmMoments, FilmPixel, FilmQuarters, LightLane, LightSlice, LightState, LightVertex,
    PathOutcome, PathState, Radiance, Ray, Record, Reservoir, ShadowRay, Slice, Splat, Subpath,
};
pub use record::{OnDevice, Records, Vec3};

/// A struct with the same bytes in Rust, in a uniform buffer (std140) and in a storage buffer (std430), alone and in an array.
///
/// Implemented by [`gpu_struct!`](crate::gpu_struct), which rejects structs with different layouts at compile time.
pub trait GpuStruct: bytemuck::Pod + Default + PartialEq + std::fmt::Debug {
    /// The name in Rust and in GLSL.
    const NAME: &'static str;
    /// Its description, line by line.
    const DOC: &'static [&'static str];
    /// In declaration order.
    const FIELDS: &'static [Field];

    /// The declaration in GLSL; doc comments and units become `//` comments.
    fn glsl() -> String {
        let mut text = comment(Self::DOC, "");
        text += &format!("struct {} {{\n", Self::NAME);
        for field in Self::FIELDS {
            text += &comment(field.doc, "    ");
            text += &format!("    {} {};\n", field.ty, field.name);
        }
        text + "};\n"
    }
}

/// A field of a [`GpuStruct`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    pub name: &'static str,
    /// The GLSL type.
    pub ty: &'static str,
    /// Bytes from the start of the struct.
    pub offset: usize,
    pub doc: &'static [&'static str],
}

fn comment(lines: &[&str], indent: &str) -> String {
    lines.iter().map(|l| format!("{indent}//{l}\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    crate::record! {
        /// A ball: { p : |p − centre| ≤ radius }.
        pub struct Sphere {
            /// Rendering space.
            centre: vec3,
            radius: float,
            /// Index of its shape.
            shape: uint,
            (pad0: uint),
            (pad1: uint),
            (pad2: uint),
        }
    }

    #[test]
    fn glsl_text_carries_names_types_and_units() {
        let expected = "\
// A ball: { p : |p − centre| ≤ radius }.
struct Sphere {
    // Rendering space.
    vec3 centre;
    float radius;
    // Index of its shape.
    uint shape;
    uint pad0;
    uint pad1;
    uint pad2;
};
";
        assert_eq!(device::Sphere::glsl(), expected);
    }

    #[test]
    fn fields_lie_where_repr_c_puts_them() {
        let sphere = Sphere {
            centre: glam::DVec3::new(1.0, 2.0, 3.0),
            radius: 4.0,
            shape: 5,
        }
        .record();
        let words: &[u32] = bytemuck::cast_slice(std::slice::from_ref(&sphere));
        let word = |name| {
            let field = device::Sphere::FIELDS.iter().find(|f| f.name == name);
            field.map(|f| words[f.offset / 4])
        };
        assert_eq!(word("centre"), Some(1.0f32.to_bits()));
        assert_eq!(word("radius"), Some(4.0f32.to_bits()));
        assert_eq!(word("shape"), Some(5));
    }
}
