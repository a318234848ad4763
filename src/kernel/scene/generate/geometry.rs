//! The nearest hit, and the surface that was hit.

use super::uses;
use crate::features::Features;
use crate::kernel::scene::dispatch::Dispatch;
use crate::prepared::ShapeKind;

fn shape_file(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Sphere => "sphere",
        ShapeKind::Box => "box",
        ShapeKind::Cylinder => "cylinder",
        ShapeKind::Mesh => "triangle",
    }
}

/// A loop over each kind of which there are few, then the hierarchy: the least (t, shape, prim) in any order.
pub fn nearest(features: &Features) -> String {
    let looped: Vec<_> = features.shapes.difference(&features.in_bvh).collect();
    let mut text = uses(
        "shape/ray",
        "shape/linear",
        looped.iter().map(|&&k| shape_file(k)),
    );
    let mut body = String::new();
    for kind in looped {
        body += match kind {
            ShapeKind::Sphere => "    best = nearest_spheres(ray, skip, best);\n",
            ShapeKind::Box => "    best = nearest_boxes(ray, skip, best);\n",
            ShapeKind::Cylinder => "    best = nearest_cylinders(ray, skip, best);\n",
            ShapeKind::Mesh => "    best = nearest_triangles(ray, skip, best);\n",
        };
    }
    if !features.in_bvh.is_empty() {
        text += "// uses: shape/bvh/nearest\n";
        body += "    best = nearest_bvh(ray, skip, best);\n";
    }
    text += "Hit nearest(Ray ray, float t_max, Target skip) {\n    Hit best = no_hit(t_max);\n";
    text + &body + "    return best;\n}\n"
}

pub fn surface(features: &Features) -> String {
    let dispatch = Dispatch {
        result: "Surface",
        name: "hit_surface",
        arguments: &[("Ray", "ray"), ("Hit", "hit")],
        selector: "shapes[hit.shape].kind",
    };
    let member = |&kind: &ShapeKind| {
        let first = "shapes[hit.shape].first";
        let call = match kind {
            ShapeKind::Sphere => format!("sphere_surface(ray, hit, spheres[{first}])"),
            ShapeKind::Box => format!("box_surface(ray, hit, boxes[{first}])"),
            ShapeKind::Cylinder => format!("cylinder_surface(ray, hit, cylinders[{first}])"),
            ShapeKind::Mesh => "triangle_surface(hit)".into(),
        };
        (kind as u32, call)
    };
    let members: Vec<_> = features.shapes.iter().map(member).collect();
    let none = "Surface(ray.o, ray.d, ray.d)";
    let files = features.shapes.iter().map(|&k| shape_file(k));
    uses("shape/ray", "shape", files) + &dispatch.text(&members, none)
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
