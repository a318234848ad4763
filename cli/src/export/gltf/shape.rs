//! Shapes: each is a mesh of one primitive at its own node, which has its position and scale in f64.

use glam::DVec3;
use serde_json::{Value, json};

use super::buffer::Buffer;
use super::materials::Materials;
use super::{Reason, Remark};
use crate::export::seen::seen;
use crate::export::{Subject, mesh};
use vkpt::prepared::Material;
use vkpt::scene::{Geometry, Mesh, Shape};

/// A mesh and its node.
pub struct Placed {
    pub mesh: Value,
    pub node: Value,
}

/// The meshes of all visible shapes; adds refusals to `refusals`.
pub fn meshes(
    subject: &Subject,
    materials: &Materials,
    buffer: &mut Buffer,
    refusals: &mut Vec<Remark<Reason>>,
) -> Vec<Placed> {
    let mut all = Vec::new();
    let mut cube = None;
    for (shape, material) in seen(subject) {
        let made = match &shape.geometry {
            Geometry::Box { corner, diagonal } => {
                let cube = cube.get_or_insert_with(|| unit_cube(buffer));
                Ok((cube.clone(), of_box(*corner, *diagonal)))
            }
            Geometry::Mesh(mesh) => of_mesh(mesh, material, buffer),
            Geometry::Sphere { .. } => Err(Reason::Sphere),
            Geometry::Cylinder { .. } => Err(Reason::Cylinder),
        };
        match made {
            Ok((primitive, node)) => {
                let material = materials.place(shape.material);
                all.push(placed(shape, primitive, node, material, all.len()));
            }
            Err(reason) => refusals.push(Remark::new(shape.line, reason)),
        }
    }
    all
}

fn placed(
    shape: &Shape,
    mut primitive: Value,
    mut node: Value,
    material: Option<usize>,
    number: usize,
) -> Placed {
    primitive["material"] = json!(material);
    node["name"] = json!(format!("line {}", shape.line));
    node["mesh"] = json!(number);
    Placed {
        mesh: json!({ "primitives": [primitive] }),
        node,
    }
}

/// The cube from 0 to 1, the primitive that all boxes share.
fn unit_cube(buffer: &mut Buffer) -> Value {
    let corners = mesh::corners(DVec3::ZERO, DVec3::ONE);
    json!({
        "attributes": { "POSITION": buffer.points(&corners) },
        "indices": buffer.triangles(&mesh::BOX),
    })
}

fn of_box(corner: DVec3, diagonal: DVec3) -> Value {
    let lo = corner.min(corner + diagonal);
    json!({ "translation": lo.to_array(), "scale": diagonal.abs().to_array() })
}

fn of_mesh(
    mesh: &Mesh,
    material: &Material,
    buffer: &mut Buffer,
) -> Result<(Value, Value), Reason> {
    let mesh = mesh::outwards(mesh, material);
    let mut attributes = json!({ "POSITION": buffer.points(&mesh.positions) });
    if let Some(normals) = &mesh.normals {
        if normals.contains(&DVec3::ZERO) {
            return Err(Reason::NoNormal);
        }
        attributes["NORMAL"] = json!(buffer.points(normals));
    }
    let primitive = json!({
        "attributes": attributes,
        "indices": buffer.triangles(&mesh.triangles),
    });
    let node = json!({
        "translation": mesh.translate.to_array(),
        "rotation": mesh.rotate.to_array(),
        "scale": DVec3::splat(mesh.scale).to_array(),
    });
    Ok((primitive, node))
}
