//! The nearest hit, and the surface that was hit.

use super::uses;
use super::written_out::WrittenOut;
use crate::features::Features;
use crate::kernel::scene::Parameters;
use crate::kernel::scene::dispatch::Dispatch;
use crate::shape::{ShapeKind, filled};

/// Tests the primitives of each kind that has few, one after the other, then the hierarchy: the least (t, shape, prim)
/// in any order. With `any`, the search may end at the first hit. `read_primitives()` must be called once, before.
pub fn nearest(features: &Features, parameters: &Parameters) -> String {
    let mut head = String::from("// uses: shape/ray, <cover>\n");
    let mut copies = String::new();
    let (mut read, mut test) = (String::new(), String::new());
    for kind in features.written_out() {
        let written = WrittenOut::new(kind, |array| parameters.count(array));
        head += &format!("// uses: {}\n", written.file());
        if parameters.read_first {
            copies += &written.copies();
            read += &written.read();
        }
        test += &written.test(parameters.read_first);
    }
    if !features.in_bvh.is_empty() {
        head += "// uses: shape/bvh/nearest\n";
        test += "    best = nearest_bvh(ray, skip, best, any);\n";
    }
    format!(
        "{head}{copies}void read_primitives() {{\n{read}}}\n\
         Hit nearest(Ray ray, Target skip, bool any) {{\n    Hit best = no_hit(ray.t_max);\n{test}    return touching(ray, best);\n}}\n"
    )
}

pub fn surface(features: &Features) -> String {
    let dispatch = Dispatch {
        result: "Surface",
        name: "hit_surface",
        arguments: &[("Ray", "ray"), ("Hit", "hit")],
        selector: "shapes[hit.shape].kind",
    };
    let member = |&kind: &ShapeKind| {
        let shape = kind.description();
        let x = filled(shape.element, &[("{i}", "shapes[hit.shape].first")]);
        (kind as u32, filled(shape.surface, &[("{x}", &x)]))
    };
    let members: Vec<_> = features.shapes.iter().map(member).collect();
    let none = "Surface(ray.o, ray.d, ray.d)";
    let files = (features.shapes.iter()).map(|kind| kind.description().surface_file);
    uses("shape/ray", files) + &dispatch.text(&members, none)
}

/// Whether a hit with a shape does not count, a function a kind: `is_covered`, or never.
pub fn covered(features: &Features) -> String {
    let function = |kind: &ShapeKind| {
        let value = match features.covered.contains(kind) {
            true => "is_covered(asked, ray, shape, prim, t, enters)",
            false => "false",
        };
        let name = kind.description().name;
        format!(
            "bool {name}_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) {{\n    return {value};\n}}\n"
        )
    };
    let functions: String = features.shapes.iter().map(function).collect();
    format!("// uses: <cover>\n{functions}")
}

/// Whether a point in the plane of a face lies on it.
pub fn face_point(features: &Features) -> String {
    let dispatch = Dispatch {
        result: "FacePoint",
        name: "face_point",
        arguments: &[("Coincidence", "face"), ("vec3", "p")],
        selector: "face.kind",
    };
    let member = |&kind: &ShapeKind| {
        let shape = kind.description();
        let x = filled(shape.element, &[("{i}", "face.index")]);
        (kind as u32, filled(shape.face_point, &[("{x}", &x)]))
    };
    let members: Vec<_> = features.shapes.iter().map(member).collect();
    let none = "FacePoint(false, vec2(0.0))";
    let files = (features.shapes.iter()).map(|kind| kind.description().face_file);
    let triangles = match features.shapes.contains(&ShapeKind::Mesh) {
        true => ", <triangles>",
        false => "",
    };
    let fixed = format!("shape/face/point{triangles}");
    uses(&fixed, files) + &dispatch.text(&members, none)
}

/// Access to the buffers of triangles.
pub fn triangles(features: &Features) -> String {
    let normals = if features.shading_normals {
        ", shape/triangle/corner_normals"
    } else {
        ""
    };
    format!("// uses: shape/triangle/corners{normals}\n")
}
