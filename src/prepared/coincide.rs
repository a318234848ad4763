//! Finds the coincident faces of a scene and their order.

use rayon::prelude::*;

use super::meeting::meeting_pairs;
use super::patch::{Orientation, Patch};
use super::placed::Placed;
use super::{Material, Prepared, Shape};
use crate::shape::{Bounds, Coincidence, Coincidences, Extent, ShapeKind};

/// A face, with the properties of its shape.
struct Face {
    shape: u32,
    prim: u32,
    kind: ShapeKind,
    index: u32,
    transmissive: bool,
    shines: bool,
    patch: Patch,
}

impl Face {
    fn entry(&self, touches: bool) -> Coincidence {
        Coincidence {
            shape: self.shape,
            prim: self.prim,
            kind: self.kind,
            index: self.index,
            touches: u32::from(touches),
        }
    }

    /// The order of shapes: opaque ones first, then file order.
    fn order(&self) -> (u32, u32) {
        (self.shape, self.prim)
    }

    fn is_mesh(&self) -> bool {
        self.kind == ShapeKind::Mesh
    }
}

/// The table of a placed scene; empty if no faces coincide.
pub fn coincidences(placed: &Placed, materials: &[Material]) -> Coincidences {
    let faces: Vec<Face> = (placed.shapes.iter().enumerate())
        .flat_map(|(i, shape)| faces(placed, materials, i as u32, shape))
        .collect();
    let list = entries_of_all(&faces);
    if list.is_empty() {
        return Coincidences::default();
    }
    let faces: Vec<_> = placed.shapes.iter().map(Shape::faces).collect();
    Coincidences::new(&faces, list)
}

fn faces(placed: &Placed, materials: &[Material], number: u32, shape: &Shape) -> Vec<Face> {
    let first = shape.first as usize;
    let p = &placed.primitives;
    let patches: Vec<Option<Patch>> = match shape.kind {
        ShapeKind::Sphere => vec![Some(Patch::sphere(&p.spheres[first]))],
        ShapeKind::Box => Patch::cuboid(&p.boxes[first]).map(Some).into(),
        ShapeKind::Cylinder => Patch::cylinder(&p.cylinders[first]).map(Some).into(),
        ShapeKind::Mesh => {
            let triangles = &p.triangles[first..first + shape.count as usize];
            triangles.par_iter().map(Patch::triangle).collect()
        }
    };
    let material = &materials[shape.material as usize];
    let face = |(prim, patch): (u32, Option<Patch>)| {
        Some(Face {
            shape: number,
            prim,
            kind: shape.kind,
            index: match shape.kind {
                ShapeKind::Mesh => prim,
                _ => shape.first,
            },
            transmissive: Prepared::is_transmissive(material),
            shines: material.radiance.max_element() > 0.0,
            patch: patch.filter(Patch::is_finite)?,
        })
    };
    let numbered = shape.faces().into_par_iter().zip(patches);
    numbered.filter_map(face).collect()
}

/// The entries for all pairs of faces, except pairs of one solid, in no particular order.
fn entries_of_all(faces: &[Face]) -> Vec<(u32, u32, Coincidence)> {
    let extent = |face: &Face| {
        let (Bounds { lo, hi }, near) = (face.patch.bounds(), face.patch.near());
        Extent::around(Bounds {
            lo: lo - near,
            hi: hi + near,
        })
    };
    let extents: Vec<Extent> = faces.par_iter().map(extent).collect();
    meeting_pairs(&extents, |i, j, found| {
        let (face, other) = (&faces[i], &faces[j]);
        if other.shape != face.shape || face.is_mesh() {
            found.extend(entries(face, other));
        }
    })
}

/// The list entries of a pair, if it coincides: (shape, prim) of the list, and the entry.
fn entries(a: &Face, b: &Face) -> Vec<(u32, u32, Coincidence)> {
    let Some(orientation) = a.patch.coincides(&b.patch) else {
        return Vec::new();
    };
    let [first, second] = if a.order() < b.order() {
        [a, b]
    } else {
        [b, a]
    };
    let opposite = orientation == Orientation::Opposite;
    let boxes = first.kind == ShapeKind::Box && second.kind == ShapeKind::Box;
    let in_list_of = |of: &Face, entry| (of.shape, of.prim, entry);
    match (first.transmissive, second.transmissive) {
        // Light passes from one solid into the other.
        (true, true) if opposite => vec![
            in_list_of(first, second.entry(true)),
            in_list_of(second, first.entry(true)),
        ],
        // The distances to coplanar faces of boxes are the same number, so the order of shapes already decides; but the
        // distance to a point on a light is computed from other numbers.
        (false, false) if boxes && !first.shines && !second.shines => Vec::new(),
        // No ray runs between two opaque solids in contact. A mesh may not be closed.
        (false, false) if opposite && !first.is_mesh() && !second.is_mesh() => Vec::new(),
        _ => vec![in_list_of(second, first.entry(false))],
    }
}
