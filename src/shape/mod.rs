//! What a shape is, a file a kind: its record, and its place and size in f64.
//!
//! A solid is one primitive, a mesh many. [`Primitives`] has all of a scene, [`Body`] and [`Primitive`] are the questions
//! that a kind answers.

mod body;
mod bounds;
pub mod coincident;
pub mod cuboid;
pub mod cylinder;
mod description;
mod extent;
pub mod mesh;
mod primitives;
mod space;
pub mod sphere;

pub use body::{Body, Primitive};
pub use bounds::Bounds;
pub use coincident::{Coincidence, Coincidences};
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use description::{Description, filled};
pub use extent::Extent;
pub use mesh::Triangle;
pub use primitives::Primitives;
pub use space::Space;
pub use sphere::Sphere;

/// The records as the kernels read them.
pub mod device {
    pub use super::coincident::device::Coincidence;
    pub use super::cuboid::device::Cuboid;
    pub use super::cylinder::device::Cylinder;
    pub use super::sphere::device::Sphere;
}

macro_rules! kinds {
    ($($kind:ident: $room:ident),*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u32)]
        pub enum ShapeKind { $($kind),* }

        impl ShapeKind {
            pub const EVERY: [Self; [$(Self::$kind),*].len()] = [$(Self::$kind),*];

            pub fn description(self) -> &'static Description {
                match self {
                    $(Self::$kind => &$room::DESCRIPTION,)*
                }
            }
        }

        /// What a light is: a shape of this kind, or everything outside, of constant radiance or as a picture has it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u32)]
        pub enum LightKind { $($kind,)* Background, Surroundings }

        impl LightKind {
            pub const EVERY: [Self; 2 + ShapeKind::EVERY.len()] =
                [$(Self::$kind,)* Self::Background, Self::Surroundings];

            /// The kind of the shape that shines.
            pub fn shape(self) -> Option<ShapeKind> {
                match self {
                    $(Self::$kind => Some(ShapeKind::$kind),)*
                    Self::Background | Self::Surroundings => None,
                }
            }

            /// Whether it is everything outside.
            pub fn is_outside(self) -> bool {
                self.shape().is_none()
            }
        }

        impl From<ShapeKind> for LightKind {
            fn from(kind: ShapeKind) -> Self {
                match kind {
                    $(ShapeKind::$kind => Self::$kind,)*
                }
            }
        }
    };
}

// Their order is that of the numbers by which the kernels and the hierarchy know them.
kinds!(Sphere: sphere, Box: cuboid, Cylinder: cylinder, Mesh: mesh);
