//! Shapes in rendering space, opaque ones first.

use std::borrow::Cow;

use glam::DVec3;
use rayon::prelude::*;

use super::{Cuboid, Cylinder, Material, NONE, Prepared, Shape, Sphere, Triangle};
use crate::scene::{self, Edges, Geometry, Mesh, Scene, edges, flip, signed_volume};
use crate::shape::{Body, Bounds, Primitives, ShapeKind, Space};

/// The scene's shapes and their primitives.
#[derive(Debug, Default)]
pub struct Placed {
    pub shapes: Vec<Shape>,
    pub primitives: Primitives,
}

impl Placed {
    /// Shapes in the order in which they win at equal distance: opaque ones, then transmissive ones, each in file order
    /// (model.md, "Order of hits").
    pub fn new(scene: &Scene, materials: &[Material], warnings: &mut Vec<String>) -> Self {
        let mut order: Vec<_> = scene.shapes.iter().collect();
        order.sort_by_key(|s| Prepared::is_transmissive(&materials[s.material]));
        let mut placed = Self::default();
        for shape in order {
            let transmissive = Prepared::is_transmissive(&materials[shape.material]);
            let (kind, count) = placed.add(shape, transmissive, warnings);
            placed.shapes.push(Shape {
                kind,
                first: (placed.primitives.count(kind) - count) as u32,
                count: count as u32,
                material: shape.material as u32,
                light: NONE,
                line: shape.line,
            });
        }
        placed
    }

    /// Adds the primitives of the next shape; returns their kind and index range.
    fn add(
        &mut self,
        shape: &scene::Shape,
        transmissive: bool,
        warnings: &mut Vec<String>,
    ) -> (ShapeKind, usize) {
        let index = self.shapes.len() as u32;
        let all = &mut self.primitives;
        match &shape.geometry {
            Geometry::Sphere { centre, radius } => {
                all.spheres.push(Sphere {
                    centre: *centre,
                    radius: *radius,
                    shape: index,
                });
                (ShapeKind::Sphere, 1)
            }
            Geometry::Box { corner, diagonal } => {
                all.boxes
                    .push(Cuboid::between(*corner, *corner + *diagonal, index));
                (ShapeKind::Box, 1)
            }
            Geometry::Cylinder { base, axis, radius } => {
                all.cylinders
                    .push(Cylinder::new(*base, *axis, *radius, index));
                (ShapeKind::Cylinder, 1)
            }
            Geometry::Mesh(mesh) => {
                let mesh = match transmissive {
                    true => checked(mesh, shape.line, warnings),
                    false => Cow::Borrowed(mesh),
                };
                add_mesh(all, &mesh, index);
                (ShapeKind::Mesh, mesh.triangles.len())
            }
        }
    }

    /// The shapes that light travels through.
    pub fn transmissive<'a>(
        &'a self,
        materials: &'a [Material],
    ) -> impl Iterator<Item = &'a Shape> {
        let is_transmissive =
            |s: &&Shape| Prepared::is_transmissive(&materials[s.material as usize]);
        self.shapes.iter().filter(is_transmissive)
    }

    /// A shape as a whole.
    pub fn body(&self, shape: &Shape) -> Box<dyn Body + '_> {
        let first = shape.first as usize;
        self.primitives
            .body(shape.kind, first..first + shape.count as usize)
    }

    /// The bounds of all shapes, or of `p` if there are none.
    pub fn all_bounds(&self, p: DVec3) -> Bounds {
        let all = self
            .shapes
            .iter()
            .map(|s| self.body(s).bounds())
            .reduce(Bounds::union);
        all.unwrap_or(Bounds::point(p))
    }

    /// Moves every shape from the scene to rendering space.
    pub fn move_to(&mut self, space: &Space) {
        self.primitives.iter_mut().for_each(|p| p.move_to(space));
    }
}

/// Adds the transformed triangles of a mesh: p' = T·S·R·p.
fn add_mesh(all: &mut Primitives, mesh: &Mesh, shape: u32) {
    let before = all.triangles.len();
    let place = |p: DVec3| mesh.translate + mesh.scale * (mesh.rotate * p);
    let triangle = |t: &[u32; 3]| Triangle {
        v: t.map(|k| place(mesh.positions[k as usize])),
        shape,
    };
    let triangles = mesh.triangles.par_iter();
    all.triangles.par_extend(triangles.clone().map(triangle));
    if let Some(normals) = &mesh.normals {
        let turned = |k: u32| (mesh.rotate * normals[k as usize]).normalize_or_zero();
        all.normals.resize(before, [DVec3::ZERO; 3]);
        all.normals.par_extend(triangles.map(|t| t.map(turned)));
    }
    if !all.normals.is_empty() {
        all.normals.resize(all.triangles.len(), [DVec3::ZERO; 3]);
    }
}

/// A transmissive mesh must bound a solid: warns if it does not, and flips it if it is wound inside out.
fn checked<'m>(mesh: &'m Mesh, line: usize, warnings: &mut Vec<String>) -> Cow<'m, Mesh> {
    let name = mesh.path.display();
    let Edges { open, torn } = edges(mesh);
    if open + torn > 0 {
        warnings.push(format!(
            "line {line}: the transmissive mesh {name} is not closed: {open} open edges, {torn} between \
             triangles of opposite winding; light may enter it and never leave"
        ));
    }
    if signed_volume(mesh) >= 0.0 {
        return Cow::Borrowed(mesh);
    }
    warnings.push(format!(
        "line {line}: the transmissive mesh {name} is wound inside out (its volume is negative): its triangles are reversed"
    ));
    let mut turned = mesh.clone();
    flip(&mut turned);
    Cow::Owned(turned)
}
