//! The triangles of all nodes, put together.

use std::path::PathBuf;

use glam::{DAffine3, DMat3, DVec3};
use gltf::json::{Node, Root};

use super::super::{MeshError, MeshFile};
use super::accessors::Accessors;
use super::primitive::{self, Triangles};

/// The mesh under way.
#[derive(Default)]
pub(super) struct Assembly {
    positions: Vec<DVec3>,
    /// As many as positions: zero where a primitive has none.
    normals: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Some primitive has normals.
    smooth: bool,
    skinned: bool,
    morphed: bool,
}

impl Assembly {
    /// Adds the mesh of a node, if it has one; an error says what is wrong.
    pub(super) fn add(
        &mut self,
        node: &Node,
        to_scene: DAffine3,
        root: &Root,
        accessors: &Accessors,
    ) -> Result<(), String> {
        let Some(index) = node.mesh else {
            return Ok(());
        };
        let number = index.value();
        let mesh = root.get(index);
        let mesh = mesh.ok_or_else(|| format!("there is no mesh {number}"))?;
        // A skinned mesh is placed by its joints and not by its node (glTF 2.0, section 3.7.3.3): as it was bound, it
        // stands in the scene's space.
        let to_scene = match node.skin {
            Some(_) => DAffine3::IDENTITY,
            None => to_scene,
        };
        self.skinned |= node.skin.is_some();
        for (i, primitive) in mesh.primitives.iter().enumerate() {
            let within = |what| format!("mesh {number}, primitive {i}: {what}");
            if let Some(read) = primitive::read(primitive, accessors).map_err(within)? {
                self.place(read, to_scene).map_err(within)?;
                self.morphed |= primitive.targets.is_some();
            }
        }
        Ok(())
    }

    /// Adds triangles, transformed.
    fn place(&mut self, mut read: Triangles, to_scene: DAffine3) -> Result<(), String> {
        let first = self.positions.len() as u32;
        let finite = |v: &DVec3| v.as_vec3().is_finite();
        for p in &mut read.positions {
            *p = to_scene.transform_point3(*p);
        }
        if let Some(bad) = read.positions.iter().position(|p| !finite(p)) {
            return Err(format!(
                "its vertex {bad} is not finite in single precision"
            ));
        }
        self.positions.extend(read.positions);
        if let Some(normals) = read.normals {
            if let Some(bad) = normals.iter().position(|n| !finite(n)) {
                return Err(format!("its normal {bad} is not finite"));
            }
            let turn = of_normals(to_scene.matrix3);
            let turned = normals.iter().map(|n| (turn * *n).normalize_or_zero());
            self.normals.extend(turned);
            self.smooth = true;
        }
        self.normals.resize(self.positions.len(), DVec3::ZERO);
        // A mirrored triangle is seen from behind.
        let mirrored = to_scene.matrix3.determinant() < 0.0;
        let outward = |[a, b, c]: [u32; 3]| if mirrored { [a, c, b] } else { [a, b, c] };
        let placed = read.triangles.into_iter().map(|t| t.map(|i| i + first));
        self.triangles.extend(placed.map(outward));
        Ok(())
    }

    /// The mesh, if it is one.
    pub(super) fn finish(self, files: Vec<PathBuf>) -> Result<MeshFile, MeshError> {
        if self.triangles.is_empty() {
            return Err(MeshError::Empty("triangles"));
        }
        let mut warnings = Vec::new();
        if self.skinned {
            warnings.push("a skinned mesh is shown as it was bound".to_owned());
        }
        if self.morphed {
            warnings.push("morph targets are left out".to_owned());
        }
        Ok(MeshFile {
            files,
            positions: self.positions,
            normals: self.smooth.then_some(self.normals),
            triangles: self.triangles,
            warnings,
        })
    }
}

/// What normals are transformed by where points are by `m`: its inverse transpose but for a positive factor, which is
/// sign(det m) times the matrix of its cofactors and needs no division.
fn of_normals(m: DMat3) -> DMat3 {
    let [a, b, c] = [m.x_axis, m.y_axis, m.z_axis];
    let cofactors = DMat3::from_cols(b.cross(c), c.cross(a), a.cross(b));
    match m.determinant() < 0.0 {
        true => -cofactors,
        false => cofactors,
    }
}
