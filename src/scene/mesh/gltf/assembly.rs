//! Assembles the triangles of all nodes.

use std::ops::Range;
use std::path::PathBuf;

use glam::{DAffine3, DMat3, DVec3};

use super::super::left_out::LeftOut;
use super::super::positions::finite;
use super::super::{MeshError, MeshFile};
use super::accessors::Accessors;
use super::binding::Binding;
use super::document::{Document, called};
use super::nodes::Nodes;
use super::primitive::{self, Triangles};
use super::skin::Skin;

/// The mesh under construction.
#[derive(Default)]
pub(super) struct Assembly {
    positions: Vec<DVec3>,
    /// One per position: zero where a primitive has none.
    normals: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Some primitive has normals.
    smooth: bool,
    morphed: bool,
    /// Some node requests instances of its mesh, by EXT_mesh_gpu_instancing.
    instanced: bool,
    left_out: LeftOut,
    /// Nodes whose scale flattened their meshes.
    flat: Vec<String>,
    parts: Vec<Part>,
}

/// The contribution of one primitive of a node.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Part {
    pub(in crate::scene) node: usize,
    pub(in crate::scene) mesh: usize,
    /// Index within the mesh.
    pub(in crate::scene) primitive: usize,
    /// Its vertices within the assembled mesh.
    pub(in crate::scene) vertices: Range<usize>,
    pub(in crate::scene) triangles: Range<usize>,
    pub(in crate::scene) has_normals: bool,
}

impl Assembly {
    /// Adds the mesh of a node, if it has one. Errors are messages.
    pub(super) fn add(
        &mut self,
        number: usize,
        document: &Document,
        accessors: &Accessors,
        nodes: &mut Nodes,
    ) -> Result<(), String> {
        let node = nodes.get(number)?;
        let Some(index) = node.mesh else {
            return Ok(());
        };
        self.instanced |= node.extensions.contains_key("EXT_mesh_gpu_instancing");
        let mesh = document.meshes.get(index);
        let mesh = mesh.ok_or_else(|| format!("mesh {index} does not exist"))?;
        // A skinned mesh is placed by its joints and not by its node (glTF 2.0, section 3.7.3.3).
        let skin = node
            .skin
            .map(|skin| Skin::read(skin, document, accessors, nodes));
        let skin = skin.transpose()?;
        let to_scene = match skin {
            Some(_) => DAffine3::IDENTITY,
            None => nodes.placed(number)?,
        };
        if of_normals(to_scene.matrix3) == DMat3::ZERO {
            let flat = nodes.flat(number).unwrap_or(number);
            self.flat.push(nodes.label(flat));
            return Ok(());
        }
        for (i, primitive) in mesh.primitives.iter().enumerate() {
            let within = |what| {
                let mesh = called("mesh", index, mesh.name.as_deref());
                format!("{mesh}, primitive {i}: {what}")
            };
            let read = primitive::read(primitive, accessors, &mut self.left_out);
            let Some(read) = read.map_err(within)? else {
                continue;
            };
            let has_normals = read.normals.is_some();
            let [vertex, triangle] = [self.positions.len(), self.triangles.len()];
            match &skin {
                None => self.place(read, |_| to_scene),
                Some(skin) => Binding::read(primitive, read.positions.len(), skin, accessors)
                    .and_then(|binding| self.place(read, |vertex| binding.to_scene(vertex))),
            }
            .map_err(within)?;
            self.morphed |= primitive.targets.is_some();
            self.parts.push(Part {
                node: number,
                mesh: index,
                primitive: i,
                vertices: vertex..self.positions.len(),
                triangles: triangle..self.triangles.len(),
                has_normals,
            });
        }
        Ok(())
    }

    /// Adds triangles, each vertex transformed.
    fn place(
        &mut self,
        read: Triangles,
        to_scene: impl Fn(usize) -> DAffine3,
    ) -> Result<(), String> {
        let first = self.positions.len() as u32;
        let positions = read.positions.iter().enumerate();
        let moved = positions.map(|(i, p)| to_scene(i).transform_point3(*p));
        let moved = finite(moved.collect(), &read.triangles);
        self.positions.extend(
            moved.map_err(|vertex| {
                format!("its vertex {vertex} is not finite in single precision")
            })?,
        );
        if let Some(normals) = read.normals {
            let turn = |i| of_normals(to_scene(i).matrix3);
            let turned = normals.iter().enumerate().map(|(i, n)| turn(i) * *n);
            self.normals.extend(turned.map(DVec3::normalize_or_zero));
            self.smooth = true;
        }
        self.normals.resize(self.positions.len(), DVec3::ZERO);
        // A mirrored triangle is seen from behind. For a skinned triangle the first corner decides.
        let mirrored = |i: u32| to_scene(i as usize).matrix3.determinant() < 0.0;
        let outward = |[a, b, c]: [u32; 3]| if mirrored(a) { [a, c, b] } else { [a, b, c] };
        let placed = read.triangles.into_iter().map(outward);
        self.triangles.extend(placed.map(|t| t.map(|i| i + first)));
        Ok(())
    }

    /// The contributions of primitives, in the order of nodes.
    pub(super) fn take_parts(&mut self) -> Vec<Part> {
        std::mem::take(&mut self.parts)
    }

    /// The finished mesh, if it has triangles; its warnings begin with `warnings`.
    pub(super) fn finish(
        self,
        files: Vec<PathBuf>,
        mut warnings: Vec<String>,
    ) -> Result<MeshFile, MeshError> {
        let left_out = self.flat_warning().into_iter();
        let left_out: Vec<_> = left_out.chain(self.left_out.warnings()).collect();
        if self.triangles.is_empty() {
            return Err(match left_out.first() {
                Some(why) => MeshError::Malformed(format!("it has no triangles: {why}")),
                None => MeshError::Empty("triangles"),
            });
        }
        warnings.extend(left_out);
        if self.instanced {
            warnings.push(
                "only the first instance (EXT_mesh_gpu_instancing) is read, at its node".to_owned(),
            );
        }
        if self.morphed {
            warnings.push("morph targets are skipped".to_owned());
        }
        Ok(MeshFile {
            files,
            positions: self.positions,
            normals: self.smooth.then_some(self.normals),
            triangles: self.triangles,
            warnings,
        })
    }

    /// A warning about nodes whose scale flattened their meshes.
    fn flat_warning(&self) -> Option<String> {
        let (first, more) = self.flat.split_first()?;
        let more = match more.len() {
            0 => "is skipped".to_owned(),
            more => format!("and {more} more like it are skipped"),
        };
        Some(format!("the scale of {first} is zero: its mesh {more}"))
    }
}

/// The transform of normals for the transform `m` of points: its inverse transpose up to a positive factor, which is
/// sign(det m) times the matrix of its cofactors and needs no division.
fn of_normals(m: DMat3) -> DMat3 {
    let [a, b, c] = [m.x_axis, m.y_axis, m.z_axis];
    let cofactors = DMat3::from_cols(b.cross(c), c.cross(a), a.cross(b));
    match m.determinant() < 0.0 {
        true => -cofactors,
        false => cofactors,
    }
}
