//! The primitives of a scene.

use std::ops::Range;

use glam::DVec3;

use super::mesh::Mesh;
use super::{Body, Coincidences, Cuboid, Cylinder, Primitive, ShapeKind, Sphere, Triangle};
use crate::layout::Records;

/// The primitives of a scene, one array per kind.
#[derive(Clone, Debug, Default)]
pub struct Primitives {
    pub spheres: Vec<Sphere>,
    pub boxes: Vec<Cuboid>,
    pub cylinders: Vec<Cylinder>,
    /// All triangles of all meshes, in the order of their shapes.
    pub triangles: Vec<Triangle>,
    /// Shading normals of each triangle's corners; empty if no mesh has any, zero for triangles without.
    pub normals: Vec<[DVec3; 3]>,
    /// Empty if no two faces coincide.
    pub coincident: Coincidences,
}

impl Primitives {
    /// The number of primitives of a kind.
    pub fn count(&self, kind: ShapeKind) -> usize {
        match kind {
            ShapeKind::Sphere => self.spheres.len(),
            ShapeKind::Box => self.boxes.len(),
            ShapeKind::Cylinder => self.cylinders.len(),
            ShapeKind::Mesh => self.triangles.len(),
        }
    }

    /// Total bytes of all arrays.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.spheres[..])
            + size_of_val(&self.boxes[..])
            + size_of_val(&self.cylinders[..])
            + size_of_val(&self.triangles[..])
            + size_of_val(&self.normals[..])
            + size_of_val(&self.coincident.faces[..])
            + size_of_val(&self.coincident.list[..])
    }

    /// The array of a kind, if it consists of records; on the device, triangles are split across several arrays.
    pub fn records(&self, kind: ShapeKind) -> Option<&dyn Records> {
        match kind {
            ShapeKind::Sphere => Some(&self.spheres),
            ShapeKind::Box => Some(&self.boxes),
            ShapeKind::Cylinder => Some(&self.cylinders),
            ShapeKind::Mesh => None,
        }
    }

    /// Primitive `index` of a kind.
    pub fn get(&self, kind: ShapeKind, index: usize) -> &dyn Primitive {
        match kind {
            ShapeKind::Sphere => &self.spheres[index],
            ShapeKind::Box => &self.boxes[index],
            ShapeKind::Cylinder => &self.cylinders[index],
            ShapeKind::Mesh => &self.triangles[index],
        }
    }

    /// The shape made of this range of primitives: one primitive, or the triangles of a mesh.
    pub fn body(&self, kind: ShapeKind, range: Range<usize>) -> Box<dyn Body + '_> {
        match kind {
            ShapeKind::Sphere => Box::new(self.spheres[range.start]),
            ShapeKind::Box => Box::new(self.boxes[range.start]),
            ShapeKind::Cylinder => Box::new(self.cylinders[range.start]),
            ShapeKind::Mesh => Box::new(Mesh(&self.triangles[range])),
        }
    }

    /// Every primitive.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut dyn Primitive> {
        let spheres = self.spheres.iter_mut().map(|p| p as &mut dyn Primitive);
        spheres
            .chain(self.boxes.iter_mut().map(|p| p as _))
            .chain(self.cylinders.iter_mut().map(|p| p as _))
            .chain(self.triangles.iter_mut().map(|p| p as _))
    }
}
