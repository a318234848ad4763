//! The macro behind every record of a scene: its field list is written once for all readers.

use glam::DVec3;

use super::GpuStruct;

/// A record of a scene that the kernels read.
pub trait OnDevice {
    /// Its form on the device.
    type Record: GpuStruct;

    /// Rounds each number once, from f64 to f32.
    fn record(&self) -> Self::Record;
}

/// Structs that the device reads unchanged.
impl<T: GpuStruct> OnDevice for T {
    type Record = T;

    fn record(&self) -> T {
        *self
    }
}

/// An array of records of any type.
pub trait Records {
    /// The name of their struct in GLSL.
    fn name(&self) -> &'static str;

    /// Bytes of one record on the device.
    fn size(&self) -> usize;

    fn count(&self) -> usize;

    /// All records in their device form.
    fn bytes(&self) -> Vec<u8>;
}

impl<T: OnDevice> Records for Vec<T> {
    fn name(&self) -> &'static str {
        T::Record::NAME
    }

    fn size(&self) -> usize {
        size_of::<T::Record>()
    }

    fn count(&self) -> usize {
        self.len()
    }

    fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.count() * self.size());
        for record in self {
            bytes.extend_from_slice(bytemuck::bytes_of(&record.record()));
        }
        bytes
    }
}

impl<R: Records + ?Sized> Records for &R {
    fn name(&self) -> &'static str {
        R::name(self)
    }

    fn size(&self) -> usize {
        R::size(self)
    }

    fn count(&self) -> usize {
        R::count(self)
    }

    fn bytes(&self) -> Vec<u8> {
        R::bytes(self)
    }
}

/// Three components of the scalar `F`: GLSL's `vec3` in the `scalar` form of a record. `reference::math` computes with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<F> {
    pub x: F,
    pub y: F,
    pub z: F,
}

impl<F> Vec3<F> {
    /// Each component rounded by `round`.
    pub fn rounded(v: DVec3, round: impl Fn(f64) -> F) -> Self {
        Self {
            x: round(v.x),
            y: round(v.y),
            z: round(v.z),
        }
    }

    /// The same components in f64, by `widen`.
    pub fn widened(self, widen: impl Fn(F) -> f64) -> DVec3 {
        DVec3::new(widen(self.x), widen(self.y), widen(self.z))
    }
}

/// Declares a record of a scene once: `Sun` in f64, `scalar::Sun<F>` in the scalar of the CPU reference, `device::Sun` as
/// the kernels read it.
///
/// ```
/// mod sun {
///     vkpt::record! {
///         /// A directional light.
///         pub struct Sun<F> {
///             /// Unit length, towards the sun.
///             direction: vec3,
///             /// W·m⁻².
///             irradiance: float,
///         } and {
///             /// The scene file's line.
///             pub line: usize,
///         }
///     }
/// }
/// # use sun::{Sun, device, scalar};
/// # use vkpt::layout::{OnDevice, Vec3};
/// let sun = Sun { direction: glam::DVec3::Z, irradiance: 0.1, line: 7 };
/// let rounded = scalar::Sun::rounded(&sun, |x| x as f32);
/// assert_eq!(rounded, scalar::Sun { direction: Vec3 { x: 0.0, y: 0.0, z: 1.0 }, irradiance: 0.1 });
/// assert_eq!(sun.record(), device::Sun { direction: [0.0, 0.0, 1.0], irradiance: 0.1 });
/// ```
///
/// Types are those of GLSL, in the order of the device. `kind: uint as MaterialKind` is that enum, and its number on
/// the device. A field in parentheses exists only on the device, 0 until it is set; a field after `and` exists only in
/// f64. A record without numbers omits `<F>` and has no `scalar` form. Each module has one record.
#[macro_export]
macro_rules! record {
    ($(#[doc = $doc:literal])* pub struct $name:ident<F> { $($body:tt)* } $(and { $($more:tt)* })?) => {
        $crate::record!(@field { [$($doc)*] $name [scalar] [$($($more)*)?] } [] [] [] $($body)*);
    };
    ($(#[doc = $doc:literal])* pub struct $name:ident { $($body:tt)* } $(and { $($more:tt)* })?) => {
        $crate::record!(@field { [$($doc)*] $name [] [$($($more)*)?] } [] [] [] $($body)*);
    };

    // Distributes the fields over three lists: those of every form, with their types in f64 and in F; those of the
    // device; those that exist only on the device.
    (@field $head:tt [$($all:tt)*] [$($device:tt)*] $own:tt
     $(#[doc = $doc:literal])* $field:ident : uint as $kind:ident, $($rest:tt)*) => {
        $crate::record!(@field $head
            [$($all)* { [$($doc)*] $field [uint as $kind] [$kind] [$kind] }]
            [$($device)* $(#[doc = $doc])* $field : uint,] $own $($rest)*);
    };
    (@field $head:tt [$($all:tt)*] [$($device:tt)*] $own:tt
     $(#[doc = $doc:literal])* $field:ident : uint, $($rest:tt)*) => {
        $crate::record!(@field $head
            [$($all)* { [$($doc)*] $field [uint] [u32] [u32] }]
            [$($device)* $(#[doc = $doc])* $field : uint,] $own $($rest)*);
    };
    (@field $head:tt [$($all:tt)*] [$($device:tt)*] $own:tt
     $(#[doc = $doc:literal])* $field:ident : float, $($rest:tt)*) => {
        $crate::record!(@field $head
            [$($all)* { [$($doc)*] $field [float] [f64] [F] }]
            [$($device)* $(#[doc = $doc])* $field : float,] $own $($rest)*);
    };
    (@field $head:tt [$($all:tt)*] [$($device:tt)*] $own:tt
     $(#[doc = $doc:literal])* $field:ident : vec2, $($rest:tt)*) => {
        $crate::record!(@field $head
            [$($all)* { [$($doc)*] $field [vec2] [[f64; 2]] [[F; 2]] }]
            [$($device)* $(#[doc = $doc])* $field : vec2,] $own $($rest)*);
    };
    (@field $head:tt [$($all:tt)*] [$($device:tt)*] $own:tt
     $(#[doc = $doc:literal])* $field:ident : vec3, $($rest:tt)*) => {
        $crate::record!(@field $head
            [$($all)* { [$($doc)*] $field [vec3] [::glam::DVec3] [$crate::layout::Vec3<F>] }]
            [$($device)* $(#[doc = $doc])* $field : vec3,] $own $($rest)*);
    };
    (@field $head:tt $all:tt [$($device:tt)*] [$($own:tt)*]
     ($(#[doc = $doc:literal])* $field:ident : $glsl:ident), $($rest:tt)*) => {
        $crate::record!(@field $head $all
            [$($device)* $(#[doc = $doc])* $field : $glsl,] [$($own)* ($field $glsl)] $($rest)*);
    };
    (@field { $doc:tt $name:ident [$($scalar:ident)?] $more:tt } $all:tt $device:tt $own:tt) => {
        $crate::record!(@host $doc $name $more $all);
        $crate::record!(@device $doc $name $all $device $own);
        $( $crate::record!(@$scalar $doc $name $more $all); )?
    };

    (@host [$($doc:literal)*] $name:ident [$($more:tt)*]
     [$({ [$($field_doc:literal)*] $field:ident $glsl:tt [$host:ty] $scalar:tt })*]) => {
        $(#[doc = $doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            $( $(#[doc = $field_doc])* pub $field: $host, )*
            $($more)*
        }
    };
    (@device [$($doc:literal)*] $name:ident [$({ $field_doc:tt $field:ident $glsl:tt $host:tt $scalar:tt })*]
     [$($device:tt)*] [$(($own:ident $own_glsl:ident))*]) => {
        /// The record as the kernels read it.
        pub mod device {
            $crate::gpu_struct! {
                $(#[doc = $doc])*
                pub struct $name { $($device)* }
            }
        }

        impl $crate::layout::OnDevice for $name {
            type Record = device::$name;

            fn record(&self) -> device::$name {
                device::$name {
                    $( $field: $crate::record_field!(@device $glsl self.$field), )*
                    $( $own: 0 as $crate::layout::types::$own_glsl, )*
                }
            }
        }
    };
    (@scalar [$($doc:literal)*] $name:ident $more:tt
     [$({ [$($field_doc:literal)*] $field:ident $glsl:tt $host:tt [$scalar:ty] })*]) => {
        /// The record in the CPU reference's scalar type.
        pub mod scalar {
            #[allow(unused_imports, reason = "for the kinds, where a record has any")]
            use super::*;

            $(#[doc = $doc])*
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct $name<F> {
                $( $(#[doc = $field_doc])* pub $field: $scalar, )*
            }

            impl<F> $name<F> {
                /// Rounds each number once, by `round`.
                pub fn rounded(record: &super::$name, round: impl Fn(f64) -> F) -> Self {
                    Self { $( $field: $crate::record_field!(@scalar $glsl record.$field, round), )* }
                }
            }
        }
        $crate::record!(@widened $name $more [$({ $field $glsl })*]);
    };
    (@widened $name:ident [] [$({ $field:ident $glsl:tt })*]) => {
        impl<F> scalar::$name<F> {
            /// The same numbers in f64, by `widen`.
            pub fn widened(self, widen: impl Fn(F) -> f64) -> $name {
                $name { $( $field: $crate::record_field!(@widened $glsl self.$field, widen), )* }
            }
        }
    };
    (@widened $name:ident $more:tt $all:tt) => {};
}

/// The value of a field in another form of its record.
#[doc(hidden)]
#[macro_export]
macro_rules! record_field {
    (@device [uint as $kind:ident] $x:expr) => {
        $x as u32
    };
    (@device [uint] $x:expr) => {
        $x
    };
    (@device [float] $x:expr) => {
        $x as f32
    };
    (@device [vec2] $x:expr) => {
        $x.map(|x| x as f32)
    };
    (@device [vec3] $x:expr) => {
        $x.as_vec3().to_array()
    };
    (@widened [vec3] $x:expr, $widen:ident) => { $x.widened(&$widen) };
    (@widened $glsl:tt $x:expr, $widen:ident) => { $crate::record_field!(@scalar $glsl $x, $widen) };
    (@scalar [uint as $kind:ident] $x:expr, $round:ident) => {
        $x
    };
    (@scalar [uint] $x:expr, $round:ident) => {
        $x
    };
    (@scalar [float] $x:expr, $round:ident) => {
        $round($x)
    };
    (@scalar [vec2] $x:expr, $round:ident) => {
        $x.map(&$round)
    };
    (@scalar [vec3] $x:expr, $round:ident) => {
        $crate::layout::Vec3::rounded($x, &$round)
    };
}
