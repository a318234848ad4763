//! Shapes at their places in the scene, and the emission of lights.

use glam::{DMat4, DQuat, DVec3};

use super::document::Node;
use super::surface::{bsdf_id, medium_id};
use super::{Reason, Remark};
use crate::export::seen::{absorbs, seen};
use crate::export::{Subject, mesh};
use vkpt::prepared::{Material, MaterialKind};
use vkpt::scene::{Edges, Geometry, Mesh, Shape, edges};

/// All visible shapes; adds refusals to `refusals`.
pub fn nodes(subject: &Subject, refusals: &mut Vec<Remark<Reason>>) -> Vec<Node> {
    let mut nodes = Vec::new();
    for (shape, material) in seen(subject) {
        if let Geometry::Mesh(mesh) = &shape.geometry
            && let Some(reason) = against(mesh, material)
        {
            refusals.push(Remark::new(shape.line, reason));
            continue;
        }
        let pieces = pieces(shape, subject.stem);
        nodes.extend(pieces.into_iter().map(|piece| made_of(piece, material)));
    }
    nodes
}

fn against(mesh: &Mesh, material: &Material) -> Option<Reason> {
    let closed = || matches!(edges(mesh), Edges { open: 0, torn: 0 });
    if mesh.normals.is_some() && material.kind != MaterialKind::Black {
        Some(Reason::ShadingNormals)
    } else if material.radiance != DVec3::ZERO && !closed() {
        Some(Reason::OpenLight)
    } else {
        None
    }
}

fn made_of(piece: Node, material: &Material) -> Node {
    let mut piece = piece.reference(&bsdf_id(material));
    if material.radiance != DVec3::ZERO {
        let light = Node::plugin("emitter", "area");
        piece = piece.with(light.rgb("radiance", material.radiance));
    }
    match absorbs(material) {
        true => piece.named_reference("interior", &medium_id(material)),
        false => piece,
    }
}

/// One shape of Mitsuba's, or several that together bound the solid.
fn pieces(shape: &Shape, stem: &str) -> Vec<Node> {
    match &shape.geometry {
        Geometry::Sphere { centre, radius } => {
            let sphere = Node::plugin("shape", "sphere");
            vec![sphere.point("center", *centre).float("radius", *radius)]
        }
        // Mitsuba's cube is from −1 to 1 on each axis.
        Geometry::Box { corner, diagonal } => {
            let (half, centre) = (diagonal.abs() / 2.0, corner + diagonal / 2.0);
            let matrix = DMat4::from_translation(centre) * DMat4::from_scale(half);
            vec![Node::plugin("shape", "cube").placed(matrix)]
        }
        Geometry::Cylinder { base, axis, radius } => vec![
            Node::plugin("shape", "cylinder")
                .point("p0", *base)
                .point("p1", base + axis)
                .float("radius", *radius),
            cap(base + axis, *axis, *radius),
            cap(*base, -*axis, *radius),
        ],
        Geometry::Mesh(_) => vec![
            Node::plugin("shape", "ply")
                .string("filename", &mesh::file_name(stem, shape.line))
                .boolean("face_normals", true),
        ],
    }
}

/// A disc with its outside in the direction of `normal`.
fn cap(centre: DVec3, normal: DVec3, radius: f64) -> Node {
    let turn = DQuat::from_rotation_arc(DVec3::Z, normal.normalize());
    let scale = DVec3::new(radius, radius, 1.0);
    let matrix = DMat4::from_scale_rotation_translation(scale, turn, centre);
    Node::plugin("shape", "disk").placed(matrix)
}
