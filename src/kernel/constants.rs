//! The texts that replace `// uses: constants/NAME` in files.

use std::fmt::Debug;

use crate::features::words;
use crate::layout::constants::{self, uint};
use crate::prepared::{MaterialKind, ShapeKind};

/// The declarations of `constants/NAME`, by NAME: those of [`layout::constants`](crate::layout::constants), and the
/// numbers of Rust enums.
pub fn text(name: &str) -> Option<String> {
    let name = name.strip_prefix("constants/")?;
    match name {
        "material_kind" => Some(
            MaterialKind::EVERY
                .map(|k| one("KIND", &k, k as u32))
                .concat(),
        ),
        "shape_kind" => Some(
            ShapeKind::EVERY
                .map(|k| one("SHAPE", &k, k as u32))
                .concat(),
        ),
        _ => constants::glsl(name),
    }
}

/// The number of a variant: `RoughDielectric` of prefix KIND is KIND_ROUGH_DIELECTRIC.
fn one(prefix: &str, variant: &impl Debug, value: u32) -> String {
    let name = words(variant).to_uppercase().replace(' ', "_");
    uint(&format!("{prefix}_{name}"), value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_have_the_numbers_of_their_variants() {
        let kinds = text("constants/material_kind").expect("a text");
        assert!(
            kinds.contains("const uint KIND_ROUGH_DIELECTRIC = 4u;\n"),
            "{kinds}"
        );
        assert_eq!(kinds.lines().count(), MaterialKind::EVERY.len());
        let shapes = text("constants/shape_kind").expect("a text");
        assert!(
            shapes.contains(&uint("SHAPE_MESH", ShapeKind::Mesh as u32)),
            "{shapes}"
        );
    }

    #[test]
    fn other_names_have_none() {
        assert_eq!(text("constants/nonesuch"), None);
        assert_eq!(text("cylinder"), None);
    }
}
