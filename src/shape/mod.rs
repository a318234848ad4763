//! Shapes, one file per kind: record, geometry and size in f64.
//!
//! A solid is one primitive, a mesh many. [`Primitives`] has all of a scene's; the traits [`Body`] and [`Primitive`]
//! are implemented by each kind.

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

        /// The kind of a light: a shape of this kind, or everything outside, with constant radiance or from a picture.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u32)]
        pub enum LightKind { $($kind,)* Background, Surroundings }

        impl LightKind {
            pub const EVERY: [Self; 2 + ShapeKind::EVERY.len()] =
                [$(Self::$kind,)* Self::Background, Self::Surroundings];

            /// The kind of the emitting shape.
            pub fn shape(self) -> Option<ShapeKind> {
                match self {
                    $(Self::$kind => Some(ShapeKind::$kind),)*
                    Self::Background | Self::Surroundings => None,
                }
            }

            /// Whether it is the background or surroundings.
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

// The order gives the numbers of the kinds in kernels and in the hierarchy.
kinds!(Sphere: sphere, Box: cuboid, Cylinder: cylinder, Mesh: mesh);
