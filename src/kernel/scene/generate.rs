//! Generated dispatch: which of several functions a shape, a material or a light calls.

use super::dispatch::Dispatch;
use crate::features::Features;
use crate::flat::bvh::leaf_text;
use crate::prepared::{LightKind, MaterialKind, ShapeKind};
use crate::settings::{Distribution, Fresnel};

/// Slots filled with generated text.
pub fn texts(features: &Features) -> Vec<(&'static str, String)> {
    let mut texts = vec![
        ("surface", surface(features)),
        ("bsdf", bsdf(features)),
        ("distribution", distribution(features)),
        ("fresnel", fresnel(features)),
        ("light", light(features)),
        ("triangles", triangles(features)),
        ("nearest", nearest(features)),
    ];
    if !features.in_bvh.is_empty() {
        texts.push(("leaf", leaf_text(features.in_bvh.iter().copied())));
    }
    texts
}

/// A `// uses:` line for files of one folder.
fn uses(fixed: &str, folder: &str, files: impl Iterator<Item = &'static str>) -> String {
    let all: Vec<String> = std::iter::once(fixed.to_owned())
        .chain(files.map(|f| format!("{folder}/{f}")))
        .collect();
    format!("// uses: {}\n", all.join(", "))
}

fn shape_file(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Sphere => "sphere",
        ShapeKind::Box => "box",
        ShapeKind::Cylinder => "cylinder",
        ShapeKind::Mesh => "triangle",
    }
}

/// A loop over each kind of which there are few, then the hierarchy: the least (t, shape, prim) in any order.
fn nearest(features: &Features) -> String {
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

fn surface(features: &Features) -> String {
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
            ShapeKind::Mesh => "triangle_surface(ray, hit)".into(),
        };
        (kind as u32, call)
    };
    let members: Vec<_> = features.shapes.iter().map(member).collect();
    let none = "Surface(ray.o, ray.d, ray.d)";
    let files = features.shapes.iter().map(|&k| shape_file(k));
    uses("shape/ray", "shape", files) + &dispatch.text(&members, none)
}

/// File of `bsdf/kind/` and stem of its functions; `None` for what never scatters.
fn kind_file(kind: MaterialKind) -> Option<&'static str> {
    Some(match kind {
        MaterialKind::Black | MaterialKind::Nothing => return None,
        MaterialKind::Diffuse => "diffuse",
        MaterialKind::Opaque => "opaque",
        MaterialKind::Mirror => "mirror",
        MaterialKind::Dielectric => "dielectric",
        MaterialKind::Glass => "glass",
        MaterialKind::Weak => "weak",
    })
}

fn bsdf(features: &Features) -> String {
    let kinds: Vec<_> = features
        .materials
        .iter()
        .filter_map(|&k| Some((k as u32, kind_file(k)?)))
        .collect();
    let members = |suffix: &str| -> Vec<(u32, String)> {
        kinds
            .iter()
            .map(|(k, stem)| (*k, format!("{stem}_{suffix}")))
            .collect()
    };
    let sample = Dispatch {
        result: "BsdfSample",
        name: "bsdf_sample",
        arguments: &[
            ("Interaction", "at"),
            ("float", "u_lobe"),
            ("float", "u_reflect"),
            ("vec2", "u_m"),
            ("vec2", "u_d"),
        ],
        selector: "at.material.kind",
    };
    let eval = Dispatch {
        result: "BsdfValue",
        name: "bsdf_eval",
        arguments: &[("Interaction", "at"), ("vec3", "wi")],
        selector: "at.material.kind",
    };
    uses("bsdf/sample", "bsdf/kind", kinds.iter().map(|k| k.1))
        + &sample.text(
            &members("sample(at, u_lobe, u_reflect, u_m, u_d)"),
            "no_sample()",
        )
        + &eval.text(&members("eval(at, wi)"), "no_value()")
}

fn distribution(features: &Features) -> String {
    let stem = |d: Distribution| match d {
        Distribution::Phong => "phong",
        Distribution::Beckmann => "beckmann",
        Distribution::Ggx => "ggx",
    };
    let members = |call: &dyn Fn(Distribution) -> String| -> Vec<(u32, String)> {
        features
            .distributions
            .iter()
            .map(|&d| (d as u32, call(d)))
            .collect()
    };
    let function = |result, name, arguments| Dispatch {
        result,
        name,
        arguments,
        selector: "material.distribution",
    };
    let files = features.distributions.iter().map(|&d| stem(d));
    uses("math/vec", "bsdf/distribution", files)
        + &function(
            "float",
            "distribution_d",
            &[("Material", "material"), ("vec3", "m")],
        )
        .text(
            &members(&|d| format!("{}_d(m, material.alpha)", stem(d))),
            "0.0",
        )
        + &function(
            "float",
            "distribution_g1",
            &[("Material", "material"), ("vec3", "v")],
        )
        .text(
            &members(&|d| format!("{}_g1(v, material.width)", stem(d))),
            "1.0",
        )
        + &function(
            "vec3",
            "distribution_sample",
            &[("Material", "material"), ("vec2", "u")],
        )
        .text(
            &members(&|d| format!("{}_sample(material.alpha, u)", stem(d))),
            "vec3(0.0, 0.0, 1.0)",
        )
}

fn fresnel(features: &Features) -> String {
    let stem = |f: Fresnel| match f {
        Fresnel::Schlick => "schlick",
        Fresnel::Exact => "exact",
    };
    let dispatch = Dispatch {
        result: "vec3",
        name: "fresnel",
        arguments: &[("Interaction", "at"), ("float", "c")],
        selector: "at.material.fresnel",
    };
    let members: Vec<_> = features
        .fresnel
        .iter()
        .map(|&f| (f as u32, format!("fresnel_{}(at, c)", stem(f))))
        .collect();
    uses(
        "bsdf/interaction",
        "bsdf/fresnel",
        features.fresnel.iter().map(|&f| stem(f)),
    ) + &dispatch.text(&members, "vec3(0.0)")
}

fn light_file(kind: LightKind) -> &'static str {
    match kind {
        LightKind::Sphere => "sphere",
        LightKind::Box => "box",
        LightKind::Cylinder => "cylinder",
        LightKind::Mesh => "mesh",
        LightKind::Background => "background",
    }
}

/// Explicit sampling: `light_sample`, and `light_pdf` for what a path hits.
fn light(features: &Features) -> String {
    let first = "lights[light].first";
    let (sphere, cuboid) = (format!("spheres[{first}]"), format!("boxes[{first}]"));
    let cylinder = format!("cylinders[{first}]");
    let cosine = "abs(dot3(d, v.ng))";
    let sample = |kind: LightKind| match kind {
        LightKind::Sphere => {
            format!("sphere_light_sample(p, {sphere}.centre, {sphere}.radius, u)")
        }
        LightKind::Box => format!("box_light_sample(p, {cuboid}.lo, {cuboid}.hi, u24, u)"),
        LightKind::Cylinder => format!("cylinder_light_sample(p, {cylinder}, u24, u)"),
        LightKind::Mesh => {
            format!("mesh_light_sample(p, {first}, lights[light].count, lights[light].cdf, u24, u)")
        }
        LightKind::Background => "background_light_sample(u)".into(),
    };
    let pdf = |kind: LightKind| match kind {
        LightKind::Sphere => {
            format!("sphere_light_pdf(p, {sphere}.centre, {sphere}.radius, distance, {cosine})")
        }
        LightKind::Box => {
            format!("box_light_pdf(p, {cuboid}.lo, {cuboid}.hi, distance, {cosine})")
        }
        LightKind::Cylinder => format!("cylinder_light_pdf(p, {cylinder}, distance, {cosine})"),
        LightKind::Mesh => {
            format!("mesh_light_pdf({first}, lights[light].cdf, v.prim, distance, {cosine})")
        }
        LightKind::Background => "background_light_pdf()".into(),
    };
    let members = |call: &dyn Fn(LightKind) -> String| -> Vec<(u32, String)> {
        features
            .lights
            .iter()
            .map(|&k| (k as u32, call(k)))
            .collect()
    };
    let function = |result, name, arguments| Dispatch {
        result,
        name,
        arguments,
        selector: "lights[light].kind",
    };
    let sample_arguments = [
        ("uint", "light"),
        ("vec3", "p"),
        ("uint", "u24"),
        ("vec2", "u"),
    ];
    let pdf_arguments = [
        ("uint", "light"),
        ("vec3", "p"),
        ("Vertex", "v"),
        ("vec3", "d"),
        ("float", "distance"),
    ];
    let none = "LightSample(vec3(0.0), -1.0, 0.0, NONE)";
    let files = features.lights.iter().map(|&k| light_file(k));
    uses("math/vec, light/sample, path/vertex", "light", files)
        + &function("LightSample", "light_sample", &sample_arguments).text(&members(&sample), none)
        + &function("float", "light_pdf", &pdf_arguments).text(&members(&pdf), "0.0")
}

/// Access to the buffers of triangles.
fn triangles(features: &Features) -> String {
    let normals = if features.shading_normals {
        ", shape/triangle/corner_normals"
    } else {
        ""
    };
    format!("// uses: shape/triangle/corners{normals}\n")
}
