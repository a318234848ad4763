//! Shapes at their places in the scene, and the emission of lights.

use glam::{DMat4, DQuat, DVec3};

use super::statement::Statement;
use super::surface::{medium_name, name};
use super::{Reason, Remark};
use crate::export::seen::{absorbs, seen};
use crate::export::{Subject, mesh};
use vkpt::prepared::{Material, MaterialKind};
use vkpt::scene::{Geometry, Shape};

/// All visible shapes; adds refusals to `refusals`.
pub fn statements(subject: &Subject, refusals: &mut Vec<Remark<Reason>>) -> Vec<Statement> {
    let mut statements = Vec::new();
    for (shape, material) in seen(subject) {
        if let Geometry::Mesh(mesh) = &shape.geometry
            && mesh.normals.is_some()
            && material.kind != MaterialKind::Black
        {
            refusals.push(Remark::new(shape.line, Reason::ShadingNormals));
        }
        statements.push(Statement::new("AttributeBegin"));
        statements.extend(made_of(material));
        statements.extend(pieces(shape, subject.stem));
        statements.push(Statement::new("AttributeEnd"));
    }
    statements
}

/// The material, medium and emission of the shapes that follow.
fn made_of(material: &Material) -> Vec<Statement> {
    let inside = match absorbs(material) {
        true => medium_name(material),
        false => String::new(),
    };
    let mut statements = vec![
        Statement::new("NamedMaterial").word(&name(material)),
        // The exterior is reset, because the medium set earlier applies only to the camera.
        Statement::new("MediumInterface").word(&inside).word(""),
    ];
    let shines = material.radiance != DVec3::ZERO;
    statements.extend(shines.then(|| {
        Statement::new("AreaLightSource")
            .word("diffuse")
            .rgb("L", material.radiance)
            .boolean("twosided", true)
    }));
    statements
}

/// One shape of pbrt's, or several that together bound the solid, each with its transform.
fn pieces(shape: &Shape, stem: &str) -> Vec<Statement> {
    let plugin = |kind| Statement::new("Shape").word(kind);
    match &shape.geometry {
        Geometry::Sphere { centre, radius } => vec![
            at(DMat4::from_translation(*centre)),
            plugin("sphere").float("radius", *radius),
        ],
        Geometry::Box { corner, diagonal } => {
            let other = corner + diagonal;
            let corners = mesh::corners(corner.min(other), corner.max(other));
            vec![
                plugin("trianglemesh")
                    .points("P", &corners)
                    .integers("indices", mesh::BOX.as_flattened()),
            ]
        }
        Geometry::Cylinder { base, axis, radius } => {
            let turn = DQuat::from_rotation_arc(DVec3::Z, axis.normalize());
            let height = axis.length();
            vec![
                at(DMat4::from_rotation_translation(turn, *base)),
                plugin("cylinder")
                    .float("radius", *radius)
                    .float("zmin", 0.0)
                    .float("zmax", height),
                plugin("disk")
                    .float("radius", *radius)
                    .float("height", height),
                // The outside of the base is below it.
                Statement::new("ReverseOrientation"),
                plugin("disk").float("radius", *radius),
            ]
        }
        Geometry::Mesh(_) => {
            vec![plugin("plymesh").string("filename", &mesh::file_name(stem, shape.line))]
        }
    }
}

/// Sets the transform of the statements that follow.
fn at(matrix: DMat4) -> Statement {
    Statement::new("ConcatTransform").matrix(matrix)
}
