//! The shapes of a scene, and their lines.

use std::collections::HashMap;
use std::path::Path;

use glam::{DQuat, DVec3};

use super::document::Document;
use super::lamps::{self, Lamp};
use super::listing::{Listing, number, numbers};
use super::materials::{self, Materials};
use crate::scene::mesh::gltf::{Part, Whole, called};
use crate::scene::{Geometry, MaterialKind, Mesh, Shape};

/// A shape for each primitive.
pub(super) fn meshes(
    whole: &Whole,
    path: &Path,
    materials: &Materials,
    listing: &mut Listing,
) -> Vec<Shape> {
    let labels = whole.nodes.iter().map(|node| (node.number, &*node.label));
    let labels: HashMap<usize, &str> = labels.collect();
    let label = |number| labels.get(&number).copied().unwrap_or_default();
    let mut shapes = Vec::new();
    for (part, material) in whole.parts.iter().zip(materials.of_parts()) {
        let of = called("mesh", part.mesh, None);
        let line = format!(
            "mesh {}, {of}, primitive {}",
            label(part.node),
            part.primitive
        );
        let line = listing.add(&line, materials.label(material));
        shapes.push(Shape {
            line,
            material,
            geometry: Geometry::Mesh(mesh(whole, part, path)),
        });
    }
    shapes
}

/// The triangles of a primitive, with only its own vertices.
fn mesh(whole: &Whole, part: &Part, path: &Path) -> Mesh {
    let first = part.vertices.start as u32;
    let own = |triangle: &[u32; 3]| triangle.map(|i| i - first);
    let all = &whole.mesh;
    let normals = all.normals.as_ref().filter(|_| part.has_normals);
    Mesh {
        path: path.to_owned(),
        files: all.files.clone(),
        positions: all.positions[part.vertices.clone()].to_vec(),
        normals: normals.map(|normals| normals[part.vertices.clone()].to_vec()),
        triangles: all.triangles[part.triangles.clone()]
            .iter()
            .map(own)
            .collect(),
        translate: DVec3::ZERO,
        scale: 1.0,
        rotate: DQuat::IDENTITY,
    }
}

/// A ball and a material for each lamp.
pub(super) fn add_lamps(
    document: &Document,
    lamps: Vec<Lamp>,
    materials: &mut Materials,
    listing: &mut Listing,
    shapes: &mut Vec<Shape>,
) {
    for lamp in lamps {
        let kind = MaterialKind::Light(lamp.radiance);
        let label = lamps::label(document, lamp.light);
        let line = listing.add(&materials::listed(&kind), &label);
        let material = materials.add(line, kind, label);
        let sphere = format!("sphere {}  {}", numbers(lamp.centre), number(lamp.radius));
        let line = listing.add(&sphere, &lamp.node);
        shapes.push(Shape {
            line,
            material,
            geometry: Geometry::Sphere {
                centre: lamp.centre,
                radius: lamp.radius,
            },
        });
    }
}
