//! The kernel's way from a reference to the primitive's test: text for the slot `<leaf>`.

use std::fmt::Write as _;

use super::reference::{INDEX_BITS, INDEX_MASK};
use crate::prepared::ShapeKind;

/// GLSL that tries the primitive of a reference, for a hierarchy that holds these kinds: `begin_leaves(ray)`, to be
/// called before the first one, and `nearer_leaf(reference, ray, skip, best)`.
pub fn leaf_text(kinds: impl IntoIterator<Item = ShapeKind>) -> String {
    let kinds: Vec<ShapeKind> = kinds.into_iter().collect();
    let mut uses = vec!["shape/ray"];
    uses.extend(kinds.iter().map(|&kind| file(kind)));
    let mut text = format!("// uses: {}\n", uses.join(", "));
    text += if kinds.contains(&ShapeKind::Mesh) {
        "RayShear leaf_shear;\nvoid begin_leaves(Ray ray) { leaf_shear = ray_shear(ray.d); }\n"
    } else {
        "void begin_leaves(Ray ray) {}\n"
    };
    text += "Hit nearer_leaf(uint reference, Ray ray, Target skip, Hit best) {\n";
    let _ = writeln!(text, "    uint i = reference & {INDEX_MASK}u;");
    text += "    Hit nearest = best;\n";
    for &kind in &kinds {
        let condition = match kinds.len() {
            1 => String::new(),
            _ => format!("if (reference >> {INDEX_BITS}u == {}u) ", kind as u32),
        };
        let _ = writeln!(text, "    {condition}{{ nearest = {}; }}", test(kind));
    }
    text + "    return nearest;\n}\n"
}

/// The file with the test of a kind.
fn file(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Sphere => "shape/linear/sphere",
        ShapeKind::Box => "shape/linear/box",
        ShapeKind::Cylinder => "shape/linear/cylinder",
        ShapeKind::Mesh => "shape/triangle/nearer",
    }
}

/// The call of it.
fn test(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Sphere => "nearer_sphere(ray, skip, nearest, spheres[i])",
        ShapeKind::Box => "nearer_box(ray, skip, nearest, boxes[i])",
        ShapeKind::Cylinder => "nearer_cylinder(ray, skip, nearest, cylinders[i])",
        ShapeKind::Mesh => "nearer_triangle(ray, leaf_shear, skip, nearest, triangle_at(i), i)",
    }
}
