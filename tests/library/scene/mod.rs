//! The scene reader, from outside.

mod bad;
mod checks;
mod classroom;
mod dialects;
mod foreign;
mod fuzz;
mod gltf;
mod gltf_accessors;
mod gltf_bad;
mod gltf_files;
mod gltf_nodes;
mod gltf_skin;
mod good;
mod grammar;
mod model;
mod model_bad;
mod model_pictures;
mod model_views;
mod obj;
mod obj_spellings;
mod oddities;
mod own;
mod ply;
mod ply_writer;
mod polygons;
mod rendering;
mod surroundings;
mod trimesh;

use std::path::Path;

use vkpt::scene::{Errors, Read, parse};

/// A scene of the two lines that each must have, and `lines` after them; read as `dir/test.scn`.
fn read_lines(lines: &str) -> Result<Read, Errors> {
    parse(
        &format!("screen 4 3\ncamera 0 0 5 0.5\n{lines}"),
        Path::new("dir/test.scn"),
        false,
    )
}
