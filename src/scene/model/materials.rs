//! The materials of the primitives of a scene.

use std::collections::HashMap;

use super::document::Document;
use super::left_out::LeftOut;
use super::listing::{number, numbers};
use super::surface;
use crate::scene::mesh::gltf::{Part, called};
use crate::scene::{Brdf, Geometry, Material, MaterialKind, Shape, WordLines, edges};

/// The materials in use, in the order in which primitives need them.
#[derive(Default)]
pub(super) struct Materials {
    all: Vec<Material>,
    /// Their names in messages.
    labels: Vec<String>,
    /// Their indices in the document; `None` is the material of primitives without one.
    numbers: Vec<Option<usize>>,
    /// The position of each document index in `numbers`.
    known: HashMap<Option<usize>, usize>,
    /// The material of each primitive: an index into `all`.
    of_parts: Vec<usize>,
    /// Error messages.
    pub(super) errors: Vec<String>,
}

impl Materials {
    /// Reads the materials of `parts`.
    pub(super) fn read(document: &Document, parts: &[Part], left_out: &mut LeftOut) -> Self {
        let mut materials = Self::default();
        for part in parts {
            let mesh = document.meshes.get(part.mesh);
            let primitive = mesh.and_then(|mesh| mesh.primitives.get(part.primitive));
            let number = primitive.and_then(|primitive| primitive.material);
            let known = materials.known.get(&number).copied();
            let index = known.unwrap_or_else(|| materials.read_one(document, number, left_out));
            materials.of_parts.push(index);
        }
        materials
    }

    fn read_one(
        &mut self,
        document: &Document,
        number: Option<usize>,
        left_out: &mut LeftOut,
    ) -> usize {
        let default = Default::default();
        let material = match number {
            Some(number) => document.materials.get(number),
            None => Some(&default),
        };
        let name = material.and_then(|material| material.name.as_deref());
        let label = match number {
            Some(number) => called("material", number, name),
            None => "glTF's default material".to_owned(),
        };
        let kind = match material {
            Some(material) => surface::kind(material, &label, left_out),
            None => Err("it does not exist".to_owned()),
        };
        let kind = kind.unwrap_or_else(|what| {
            self.errors.push(format!("{label}: {what}"));
            MaterialKind::Light(glam::DVec3::ZERO)
        });
        self.known.insert(number, self.numbers.len());
        self.numbers.push(number);
        self.add(0, kind, label)
    }

    /// Adds a material; returns its index.
    pub(super) fn add(&mut self, line: usize, kind: MaterialKind, label: String) -> usize {
        self.labels.push(label);
        self.all.push(Material {
            line,
            words: WordLines::default(),
            kind,
        });
        self.all.len() - 1
    }

    /// Whether one of them emits light.
    pub(super) fn shine(&self) -> bool {
        self.all.iter().any(shines)
    }

    /// Each material with its label.
    pub(super) fn all_mut(&mut self) -> impl Iterator<Item = (&mut Material, &str)> {
        self.all
            .iter_mut()
            .zip(self.labels.iter().map(|label| &**label))
    }

    /// The index of each primitive's material.
    pub(super) fn of_parts(&self) -> impl Iterator<Item = usize> {
        self.of_parts.iter().copied()
    }

    pub(super) fn label(&self, index: usize) -> &str {
        &self.labels[index]
    }

    pub(super) fn into_all(self) -> Vec<Material> {
        self.all
    }

    /// Notes lights that glTF defines as one-sided, where this makes a difference: on surfaces that are not closed.
    pub(super) fn note_both_sides(
        &self,
        document: &Document,
        shapes: &[Shape],
        left_out: &mut LeftOut,
    ) {
        for shape in shapes {
            let number = self.numbers.get(shape.material).copied().flatten();
            let material = number.and_then(|number| document.materials.get(number));
            let one_sided = material.is_none_or(|material| !material.double_sided);
            let Geometry::Mesh(mesh) = &shape.geometry else {
                continue;
            };
            if one_sided && shines(&self.all[shape.material]) && edges(mesh).open > 0 {
                let what =
                    "it is not closed, and emits light to both sides, as all lights in vkpt do";
                left_out.note(what, self.label(shape.material));
            }
        }
    }
}

fn shines(material: &Material) -> bool {
    matches!(material.kind, MaterialKind::Light(_))
}

/// The equivalent line of a scene file.
pub(super) fn listed(kind: &MaterialKind) -> String {
    match kind {
        MaterialKind::Light(radiance) => format!("light {}", numbers(*radiance)),
        MaterialKind::Brdf(brdf) => {
            let Brdf { kd, ks, alpha, .. } = brdf;
            let opaque = format!(
                "brdf {}  {}  {}",
                numbers(*kd),
                numbers(*ks),
                number(*alpha)
            );
            match brdf.kt == glam::DVec3::ZERO {
                true => opaque,
                // Transmittance per unit length.
                false => {
                    let kt = brdf.kt.powf(1.0 / brdf.kt_length);
                    format!("{opaque}  {} {}", numbers(kt), number(brdf.ior))
                }
            }
        }
    }
}
