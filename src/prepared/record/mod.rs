//! The records of a scene, each declared once: see [`record!`](crate::layout::record).

pub mod aim;
pub mod camera;
pub mod lens;
pub mod light;
pub mod light_node;
pub mod material;
pub mod shape;
pub mod surroundings;
pub mod surroundings_row;
