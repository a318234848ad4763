//! The materials of visible shapes, each once.

use std::collections::{BTreeSet, HashMap};

use serde_json::Value;

use super::material::material;
use super::{Reason, Remark};
use crate::export::Subject;
use crate::export::seen::seen;

/// The materials so far, and the extensions that they need.
pub struct Materials {
    all: Vec<Value>,
    /// The index in the file of each material of the scene in use.
    places: HashMap<usize, usize>,
    extensions: BTreeSet<String>,
}

impl Materials {
    /// Converts the materials in use; adds refusals to `refusals`.
    pub fn of(subject: &Subject, refusals: &mut Vec<Remark<Reason>>) -> Self {
        let mut materials = Self {
            all: Vec::new(),
            places: HashMap::new(),
            extensions: BTreeSet::new(),
        };
        for (shape, prepared) in seen(subject) {
            if materials.places.contains_key(&shape.material) {
                continue;
            }
            let place = materials.all.len();
            materials.places.insert(shape.material, place);
            let own = &subject.scene.materials[shape.material];
            match material(own, prepared) {
                Ok(value) => materials.add(value),
                Err(reason) => refusals.push(Remark::new(prepared.line, reason)),
            }
        }
        materials
    }

    fn add(&mut self, material: Value) {
        let extensions = material["extensions"].as_object();
        let names = extensions.into_iter().flat_map(|all| all.keys().cloned());
        self.extensions.extend(names);
        self.all.push(material);
    }

    /// The index in the file of a material of the scene.
    pub fn place(&self, material: usize) -> Option<usize> {
        self.places.get(&material).copied()
    }

    /// All materials, and the extensions that they use.
    pub fn into_json(self) -> (Vec<Value>, BTreeSet<String>) {
        (self.all, self.extensions)
    }
}
