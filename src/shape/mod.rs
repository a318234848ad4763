//! What a shape is, a file a kind.

pub mod cuboid;
pub mod cylinder;
pub mod sphere;

pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use sphere::Sphere;

/// The records as the kernels read them.
pub mod device {
    pub use super::cuboid::device::Cuboid;
    pub use super::cylinder::device::Cylinder;
    pub use super::sphere::device::Sphere;
}
