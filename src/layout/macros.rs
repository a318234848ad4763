//! The macro behind every struct that host and kernel share.

/// Declares a struct once, for Rust and for GLSL.
///
/// ```
/// vkpt::gpu_struct! {
///     /// A directional light.
///     pub struct Sun {
///         /// Unit length, towards the sun.
///         direction: vec3,
///         /// W·m⁻².
///         irradiance: float,
///     }
/// }
/// # use vkpt::layout::GpuStruct;
/// assert_eq!(Sun::FIELDS[1].offset, 12);
/// ```
///
/// Field types are those of [`layout::types`](crate::layout::types). Structs that std140 or std430 would lay out
/// differently from `repr(C)` do not compile; here `b` would be at offset 4 in Rust and at 16 in GLSL:
///
/// ```compile_fail
/// vkpt::gpu_struct! {
///     pub struct Torn { a: float, b: vec3 }
/// }
/// ```
///
/// and this one would have an array stride of 4 in Rust and in std430, but of 16 in std140:
///
/// ```compile_fail
/// vkpt::gpu_struct! {
///     pub struct Thin { a: float }
/// }
/// ```
#[macro_export]
macro_rules! gpu_struct {
    ($(
        $(#[doc = $doc:literal])*
        pub struct $name:ident {
            $( $(#[doc = $field_doc:literal])* $field:ident : $ty:ident ),* $(,)?
        }
    )*) => { $(
        $(#[doc = $doc])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq, ::bytemuck::Pod, ::bytemuck::Zeroable)]
        pub struct $name {
            $( $(#[doc = $field_doc])* pub $field: $crate::layout::types::$ty, )*
        }

        const _: () = {
            use $crate::layout::types::GlslType;
            use ::core::mem::{offset_of, size_of};
            $( assert!(
                offset_of!($name, $field) % <$crate::layout::types::$ty as GlslType>::ALIGN == 0,
                concat!(stringify!($name), ".", stringify!($field), " is not aligned as GLSL aligns it: reorder or pad"),
            ); )*
            assert!(
                size_of::<$name>() % 16 == 0,
                concat!(stringify!($name), " must be padded to a multiple of 16 bytes"),
            );
        };

        impl $crate::layout::types::GlslType for $name {
            // Its size is a multiple of 16, so its offsets are the same in std140, which requires that, and in std430.
            const ALIGN: usize = 16;
        }

        impl $crate::layout::GpuStruct for $name {
            const NAME: &'static str = stringify!($name);
            const DOC: &'static [&'static str] = &[$($doc),*];
            const FIELDS: &'static [$crate::layout::Field] = &[$(
                $crate::layout::Field {
                    name: stringify!($field),
                    ty: stringify!($ty),
                    offset: ::core::mem::offset_of!($name, $field),
                    doc: &[$($field_doc),*],
                },
            )*];
        }
    )* };
}
