//! Shapes in rendering space, opaque ones first.

use std::borrow::Cow;

use glam::DVec3;

use super::{
    Bounds, Cuboid, Cylinder, Material, NONE, Prepared, Shape, ShapeKind, Space, Sphere, Triangle,
};

use crate::scene::{Edges, Geometry, Mesh, Scene, edges, flip, signed_volume};

/// p' = T·S·R·p
fn place(mesh: &Mesh, p: DVec3) -> DVec3 {
    mesh.translate + mesh.scale * (mesh.rotate * p)
}

/// The scene's shapes, each kind in its own array.
#[derive(Debug, Default)]
pub struct Placed {
    pub shapes: Vec<Shape>,
    pub spheres: Vec<Sphere>,
    pub boxes: Vec<Cuboid>,
    pub cylinders: Vec<Cylinder>,
    pub triangles: Vec<Triangle>,
    pub normals: Vec<[DVec3; 3]>,
}

impl Placed {
    /// Shapes in the order in which they win at equal distance: opaque ones, then transmissive ones,
    /// each in file order (model.md, "Order of hits").
    pub fn new(scene: &Scene, materials: &[Material], warnings: &mut Vec<String>) -> Self {
        let mut order: Vec<_> = scene.shapes.iter().collect();
        order.sort_by_key(|s| Prepared::is_transmissive(&materials[s.material]));
        let mut placed = Self::default();
        for shape in order {
            let transmissive = Prepared::is_transmissive(&materials[shape.material]);
            let mut entry = Shape {
                kind: ShapeKind::Mesh,
                first: 0,
                count: 1,
                material: shape.material as u32,
                light: NONE,
                line: shape.line,
            };
            placed.add(&mut entry, &shape.geometry, transmissive, warnings);
            placed.shapes.push(entry);
        }
        placed
    }

    fn add(
        &mut self,
        entry: &mut Shape,
        geometry: &Geometry,
        transmissive: bool,
        warnings: &mut Vec<String>,
    ) {
        let shape = self.shapes.len() as u32;
        match geometry {
            Geometry::Sphere { centre, radius } => {
                (entry.kind, entry.first) = (ShapeKind::Sphere, self.spheres.len() as u32);
                let (centre, radius) = (*centre, *radius);
                self.spheres.push(Sphere {
                    centre,
                    radius,
                    shape,
                });
            }
            Geometry::Box { corner, diagonal } => {
                (entry.kind, entry.first) = (ShapeKind::Box, self.boxes.len() as u32);
                let (a, b) = (*corner, *corner + *diagonal);
                self.boxes.push(Cuboid {
                    lo: a.min(b),
                    hi: a.max(b),
                    shape,
                });
            }
            Geometry::Cylinder { base, axis, radius } => {
                (entry.kind, entry.first) = (ShapeKind::Cylinder, self.cylinders.len() as u32);
                self.cylinders.push(cylinder(*base, *axis, *radius, shape));
            }
            Geometry::Mesh(mesh) => {
                (entry.first, entry.count) =
                    (self.triangles.len() as u32, mesh.triangles.len() as u32);
                let mesh = match transmissive {
                    true => checked(mesh, entry.line, warnings),
                    false => Cow::Borrowed(mesh),
                };
                self.add_mesh(&mesh, shape);
            }
        }
    }

    fn add_mesh(&mut self, mesh: &Mesh, shape: u32) {
        for t in &mesh.triangles {
            let v = t.map(|k| place(mesh, mesh.positions[k as usize]));
            self.triangles.push(Triangle { v, shape });
            if let Some(normals) = &mesh.normals {
                let n = t.map(|k| (mesh.rotate * normals[k as usize]).normalize_or_zero());
                self.normals
                    .resize(self.triangles.len() - 1, [DVec3::ZERO; 3]);
                self.normals.push(n);
            }
        }
        if !self.normals.is_empty() {
            self.normals.resize(self.triangles.len(), [DVec3::ZERO; 3]);
        }
    }
}

impl Placed {
    /// The shapes that light travels through.
    pub fn transmissive<'a>(
        &'a self,
        materials: &'a [Material],
    ) -> impl Iterator<Item = &'a Shape> {
        let is_transmissive =
            |s: &&Shape| Prepared::is_transmissive(&materials[s.material as usize]);
        self.shapes.iter().filter(is_transmissive)
    }

    /// The bounds of one shape.
    pub fn bounds(&self, shape: &Shape) -> Bounds {
        let first = shape.first as usize;
        match shape.kind {
            ShapeKind::Sphere => {
                let s = &self.spheres[first];
                Bounds::around([s.centre - s.radius, s.centre + s.radius])
            }
            ShapeKind::Box => Bounds::around([self.boxes[first].lo, self.boxes[first].hi]),
            ShapeKind::Cylinder => {
                let c = &self.cylinders[first];
                // A disc of normal w reaches r·√(1 − w_k²) along axis k.
                let reach = (DVec3::ONE - c.w * c.w).max(DVec3::ZERO).map(f64::sqrt) * c.radius;
                let top = c.base + c.w * c.height;
                Bounds::around([c.base - reach, c.base + reach, top - reach, top + reach])
            }
            ShapeKind::Mesh => {
                let triangles = &self.triangles[first..first + shape.count as usize];
                Bounds::around(triangles.iter().flat_map(|t| t.v))
            }
        }
    }

    /// The bounds of all shapes, of `p` where there are none.
    pub fn all_bounds(&self, p: DVec3) -> Bounds {
        let all = self
            .shapes
            .iter()
            .map(|s| self.bounds(s))
            .reduce(Bounds::union);
        all.unwrap_or(Bounds::point(p))
    }

    /// Moves every shape from the scene to rendering space.
    pub fn move_to(&mut self, space: &Space) {
        for s in &mut self.spheres {
            (s.centre, s.radius) = (space.point(s.centre), space.length(s.radius));
        }
        for c in &mut self.cylinders {
            (c.base, c.height, c.radius) = (
                space.point(c.base),
                space.length(c.height),
                space.length(c.radius),
            );
        }
        for b in &mut self.boxes {
            (b.lo, b.hi) = (space.point(b.lo), space.point(b.hi));
        }
        for t in &mut self.triangles {
            t.v = t.v.map(|v| space.point(v));
        }
    }
}

fn cylinder(base: DVec3, axis: DVec3, radius: f64, shape: u32) -> Cylinder {
    let w = axis.normalize();
    let (u, v) = w.any_orthonormal_pair();
    Cylinder {
        base,
        u,
        v,
        w,
        height: axis.length(),
        radius,
        shape,
    }
}

/// A transmissive mesh must bound a solid: warns where it does not, and turns it where it is wound inside out.
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
        "line {line}: the transmissive mesh {name} is wound inside out (its volume is negative): turned"
    ));
    let mut turned = mesh.clone();
    flip(&mut turned);
    Cow::Owned(turned)
}
