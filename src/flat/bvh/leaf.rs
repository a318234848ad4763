//! The kernel's way from a reference to the primitive's test: text for the slot `<leaf>`.

use std::fmt::Write as _;

use super::reference::{INDEX_BITS, INDEX_MASK};
use crate::prepared::ShapeKind;

/// GLSL that tries the primitive of a reference, for a hierarchy that holds these kinds: `begin_leaves(ray)`, to be
/// called before the first one, and `nearer_leaf(reference, ray, skip, best)`.
pub fn leaf_text(kinds: impl IntoIterator<Item = ShapeKind>) -> String {
    let kinds: Vec<ShapeKind> = kinds.into_iter().collect();
    let mut uses = vec!["shape/ray"];
    uses.extend(kinds.iter().flat_map(|&kind| files(kind)));
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
        let _ = writeln!(text, "    {condition}{{\n{}    }}", test(kind));
    }
    text + "    return nearest;\n}\n"
}

/// What the test of a kind is made of.
fn files(kind: ShapeKind) -> [&'static str; 2] {
    match kind {
        ShapeKind::Sphere => ["shape/sphere", "shape/linear/nearer"],
        ShapeKind::Box => ["shape/box", "shape/linear/nearer"],
        ShapeKind::Cylinder => ["shape/cylinder", "shape/linear/nearer"],
        ShapeKind::Mesh => ["shape/triangle/hit", "shape/triangle/nearer"],
    }
}

/// The body of the loop in `shaders/shape/linear/`.
fn test(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Sphere => {
            "        uint shape = spheres[i].shape;
        float t = sphere_hit(ray.o, ray.d, spheres[i].centre, spheres[i].radius, start_on(ray, shape));
        nearest = nearer_solid(t, shape, 0u, skip, nearest);\n"
        }
        ShapeKind::Box => {
            "        uint shape = boxes[i].shape;
        BoxHit hit = box_hit(ray.o, ray.d, boxes[i].lo, boxes[i].hi, start_on(ray, shape));
        nearest = nearer_solid(hit.t, shape, hit.face, skip, nearest);\n"
        }
        ShapeKind::Cylinder => {
            "        uint shape = cylinders[i].shape;
        CylinderHit hit = cylinder_hit(ray.o, ray.d, cylinders[i], start_on(ray, shape), ray.prim);
        nearest = nearer_solid(hit.t, shape, hit.part, skip, nearest);\n"
        }
        ShapeKind::Mesh => {
            "        nearest = nearer_triangle(ray, leaf_shear, skip, nearest, i);\n"
        }
    }
}
