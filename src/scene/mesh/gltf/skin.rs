//! Skins at rest (glTF 2.0, section 3.7.3, *Skins*): joints have their nodes' transforms; animations are not read.

use glam::{DAffine3, DMat3, DMat4, DVec3};

use super::accessors::Accessors;
use super::document::{Document, called};
use super::nodes::Nodes;

/// A skin that a mesh is bound to.
pub(super) struct Skin {
    /// Its name in messages.
    pub(super) label: String,
    /// For each joint Jⱼ = (its transform to the scene's space) · (its inverse bind matrix).
    joints: Vec<DAffine3>,
}

impl Skin {
    /// Errors are messages.
    pub(super) fn read(
        number: usize,
        document: &Document,
        accessors: &Accessors,
        nodes: &mut Nodes,
    ) -> Result<Self, String> {
        let skin = document.skins.get(number);
        let skin = skin.ok_or_else(|| format!("skin {number} does not exist"))?;
        let label = called("skin", number, skin.name.as_deref());
        let within = |what| format!("{label}: {what}");
        let inverse = match skin.inverse_bind_matrices {
            Some(matrices) => accessors.vectors(matrices).map_err(within)?,
            None => vec![DMat4::IDENTITY.to_cols_array(); skin.joints.len()],
        };
        if inverse.len() < skin.joints.len() {
            let (given, joints) = (inverse.len(), skin.joints.len());
            return Err(within(format!(
                "it has {given} inverse bind matrices for {joints} joints"
            )));
        }
        let joint = |(number, (node, inverse)): (usize, (&usize, &[f64; 16]))| {
            // The last row is 0 0 0 1 (glTF 2.0, section 3.7.3.1); viewers ignore it.
            let inverse = DAffine3::from_mat4(DMat4::from_cols_array(inverse));
            match inverse.is_finite() {
                true => Ok(nodes.placed(*node)? * inverse),
                false => Err(format!("its inverse bind matrix {number} is not finite")),
            }
        };
        let joints = skin.joints.iter().zip(&inverse).enumerate().map(joint);
        let joints = joints.collect::<Result<_, _>>().map_err(within)?;
        Ok(Self { label, joints })
    }

    /// The number of joints.
    pub(super) fn len(&self) -> usize {
        self.joints.len()
    }

    /// Σ wⱼ·Jⱼ over joints and their weights.
    pub(super) fn blend(&self, weights: impl Iterator<Item = (u32, f64)>) -> DAffine3 {
        let zero = DAffine3 {
            matrix3: DMat3::ZERO,
            translation: DVec3::ZERO,
        };
        weights.fold(zero, |sum, (joint, weight)| {
            let joint = &self.joints[joint as usize];
            DAffine3 {
                matrix3: sum.matrix3 + joint.matrix3 * weight,
                translation: sum.translation + joint.translation * weight,
            }
        })
    }
}
