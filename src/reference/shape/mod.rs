//! Rays and the shapes that they hit; twin of `shaders/shape/`.
//!
//! A ray that leaves a shape never meets that shape because of its own rounding error, and no offset ever skips another
//! shape: the side to which it leaves determines the root of a convex shape ([`ray`]), and a triangle of a mesh is
//! distinguished from the one on which the ray starts by planes and orientation ([`triangle::nearer`]). No constant
//! here has a unit of length.

pub mod r#box;
pub mod cover;
pub mod cylinder;
pub mod face;
pub mod linear;
pub mod normal;
pub mod ray;
pub mod slab;
pub mod sphere;
pub mod triangle;

pub use r#box::{BoxHit, Cuboid, box_face, box_hit, box_snap, box_surface};
pub use cylinder::{
    CYLINDER_BASE, CYLINDER_SIDE, CYLINDER_TOP, Cylinder, CylinderHit, cylinder_frame,
    cylinder_hit, cylinder_surface,
};
pub use linear::{nearest_boxes, nearest_cylinders, nearest_spheres, nearest_triangles};
pub use ray::{
    FAR, Hit, Ray, START_ELSEWHERE, START_INSIDE, START_OUTSIDE, Surface, Target, closer, no_hit,
    start_on,
};
pub use sphere::{Sphere, sphere_hit, sphere_surface};
pub use triangle::{
    RayShear, Triangle, TriangleHit, nearer_triangle, ray_shear, triangle_hit,
    triangle_self_distance, triangle_surface,
};
