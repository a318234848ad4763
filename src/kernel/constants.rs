//! The texts that stand where a file says `// uses: constants/NAME`.

use crate::layout::constants::{self, uint};
use crate::prepared::{MaterialKind, ShapeKind};
use crate::sample::GROUPS;

/// The declarations of `constants/NAME`, by NAME: those of [`layout::constants`](crate::layout::constants), and the
/// numbers of what has a type of its own in Rust.
pub fn text(name: &str) -> Option<String> {
    let name = name.strip_prefix("constants/")?;
    match name {
        "material_kind" => {
            let kinds = MaterialKind::EVERY.map(|k| (format!("{k:?}"), k as u32));
            Some(enumerated("KIND", kinds))
        }
        "shape_kind" => {
            let kinds = ShapeKind::EVERY.map(|k| (format!("{k:?}"), k as u32));
            Some(enumerated("SHAPE", kinds))
        }
        "groups" => Some(uint("GROUPS", GROUPS)),
        _ => constants::glsl(name),
    }
}

/// PREFIX_FIRST_VARIANT and so on.
fn enumerated(prefix: &str, variants: impl IntoIterator<Item = (String, u32)>) -> String {
    let line = |(variant, value): (String, u32)| {
        let mut name = prefix.to_owned();
        for c in variant.chars() {
            if c.is_uppercase() {
                name.push('_');
            }
            name.extend(c.to_uppercase());
        }
        uint(&name, value)
    };
    variants.into_iter().map(line).collect()
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
