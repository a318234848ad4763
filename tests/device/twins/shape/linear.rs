//! Primitives tried one after the other.

use vkpt::layout::GpuStruct;
use vkpt::prepared::{NONE, device};
use vkpt::reference::math::{Vec3, vec3};
use vkpt::reference::shape::linear::nearer_solid;
use vkpt::reference::shape::{
    Cuboid, FAR, Hit, Ray, Sphere, Target, nearest_boxes, nearest_cylinders, nearest_spheres,
    nearest_triangles, no_hit,
};

use super::super::harness::{In, Rng, Row, Twin};
use super::solids::{CYLINDER, cylinder, read_cylinder};
use super::triangles::{read_triangles, triangles_slot};
use super::{
    OUT_HIT, READ_HIT, READ_RAY, aimed, no_cover, out_hit, prelude, read_hit, read_ray, some_shape,
};

const READ_SEARCH: &str = "Target skip = Target(in_u(), in_u()); float t_max = in_f();";

struct Search {
    ray: Ray<f32>,
    skip: Target,
    best: Hit<f32>,
}

fn read_search(i: &mut In) -> Search {
    Search {
        ray: read_ray(i),
        skip: Target {
            shape: i.u(),
            prim: i.u(),
        },
        best: no_hit(i.f()),
    }
}

/// A ray at shapes within 1 of the origin, that may start on one of them, be on its way to another, and be limited.
fn search(r: &mut Rng, row: Row) -> Row {
    let (o, d) = aimed(r, Vec3::zero(), 1.5);
    let on = [some_shape(r), r.below(3), r.below(3)];
    let row = row
        .ray(o, d, on, 1e-6)
        .u(some_shape(r))
        .u([0, 1, NONE][r.below(3) as usize]);
    row.f([FAR as f32, r.log_range(0.1, 10.0)][r.below(2) as usize])
}

/// The nearest of three, two or one primitive: `calls` in order, each an argument list behind `ray, …, skip, best`.
fn scene(
    name: &'static str,
    file: &'static str,
    declare: String,
    fill: &str,
    calls: &[&str],
) -> Twin {
    let calls: String = (calls.iter())
        .map(|call| format!("found = {name}({call}); "))
        .collect();
    Twin::new(name, file)
        .prelude(prelude() + &declare)
        .slot("covered", no_cover())
        .glsl(&format!(
            "{fill} {READ_RAY} {READ_SEARCH} Hit found = no_hit(t_max); {calls} {OUT_HIT}"
        ))
}

pub fn twins() -> Vec<Twin> {
    vec![solid(), spheres(), boxes(), cylinders(), triangles()]
}

fn solid() -> Twin {
    Twin::new("nearer_solid", "shape/linear/solid")
        .prelude(prelude())
        .glsl(&format!(
            "float t = in_f(); uint shape = in_u(); uint prim = in_u(); Target skip = Target(in_u(), in_u());
             {READ_HIT} Hit found = nearer_solid(t, shape, prim, skip, hit); {OUT_HIT}"
        ))
        .rust(|i, o| {
            let (t, shape, prim) = (i.f(), i.u(), i.u());
            let skip = Target { shape: i.u(), prim: i.u() };
            out_hit(nearer_solid(t, shape, prim, skip, read_hit(i)), o);
        })
        .seeded(1000, |r| {
            let mut t = || [-1.0, 0.0, -0.0, 1.0, r.unit()][r.below(5) as usize];
            let (t, best) = (t(), t());
            let row = Row::new().f(t).u(r.below(3)).u(r.below(3)).u(some_shape(r)).u(some_shape(r));
            row.hit(best, some_shape(r), r.below(3), [0.25, 0.5])
        })
}

fn spheres() -> Twin {
    let declare = format!("{}Sphere spheres[3];\n", device::Sphere::glsl());
    let fill = "spheres[0] = Sphere(in_vec3(), in_f(), 0u, 0u, 0u, 0u);
        spheres[1] = Sphere(in_vec3(), in_f(), 2u, 0u, 0u, 0u);
        spheres[2] = Sphere(in_vec3(), in_f(), 1u, 0u, 0u, 0u);";
    let calls = [0, 1, 2].map(|i| format!("ray, skip, found, spheres[{i}]"));
    let calls = calls.each_ref().map(String::as_str);
    scene(
        "nearer_sphere",
        "shape/linear/sphere",
        declare,
        fill,
        &calls,
    )
    .rust(|i, o| {
        let all = [0, 2, 1].map(|shape| Sphere {
            centre: i.vec3(),
            radius: i.f(),
            shape,
        });
        let s = read_search(i);
        out_hit(nearest_spheres(&all, s.ray, s.skip, s.best), o);
    })
    .seeded(4000, |r| {
        let same = r.bool();
        let first = r.vec3(-1.0, 1.0);
        let row = (0..3).fold(Row::new(), |row, _| {
            let centre = if same { first } else { r.vec3(-1.0, 1.0) };
            row.vec3(centre)
                .f(if same { 0.5 } else { r.range(0.1, 1.0) })
        });
        search(r, row)
    })
}

fn boxes() -> Twin {
    let declare = format!("{}Cuboid boxes[2];\n", device::Cuboid::glsl());
    let fill = "vec3 lo = in_vec3(); boxes[0] = Cuboid(lo, 1u, in_vec3(), 0u);
        lo = in_vec3(); boxes[1] = Cuboid(lo, 0u, in_vec3(), 0u);";
    let calls = [0, 1].map(|i| format!("ray, skip, found, boxes[{i}]"));
    let calls = calls.each_ref().map(String::as_str);
    scene("nearer_box", "shape/linear/box", declare, fill, &calls)
        .rust(|i, o| {
            let all = [1, 0].map(|shape| Cuboid {
                lo: i.vec3(),
                hi: i.vec3(),
                shape,
            });
            let s = read_search(i);
            out_hit(nearest_boxes(&all, s.ray, s.skip, s.best), o);
        })
        // One is on the other, or next to it, or anywhere.
        .seeded(4000, |r| {
            let (lo, hi) = (r.vec3(-1.0, 0.0), r.vec3(0.0, 1.0));
            let row = Row::new().vec3(lo).vec3(hi);
            let row = match r.below(3) {
                0 => row.vec3(vec3(lo.x, lo.y, hi.z)).vec3(hi + Vec3::one()),
                1 => row.vec3(vec3(hi.x, lo.y, lo.z)).vec3(vec3(2.0, hi.y, hi.z)),
                _ => row.vec3(r.vec3(-1.0, 0.0)).vec3(r.vec3(0.0, 1.0)),
            };
            search(r, row)
        })
}

fn cylinders() -> Twin {
    let declare = device::Cylinder::glsl();
    let calls = ["ray, skip, found, cylinder"];
    scene(
        "nearer_cylinder",
        "shape/linear/cylinder",
        declare,
        CYLINDER,
        &calls,
    )
    .rust(|i, o| {
        let all = [read_cylinder(i)];
        let s = read_search(i);
        out_hit(nearest_cylinders(&all, s.ray, s.skip, s.best), o);
    })
    .seeded(4000, |r| {
        let row = cylinder(r, 1.0).0;
        search(r, row)
    })
}

fn triangles() -> Twin {
    let fill = "uint n = 0u;
        while (n < 6u) { corners[n] = in_vec3(); n += 1u; }
        corner_shapes[0] = in_u(); corner_shapes[1] = in_u();";
    let calls =
        [0, 1].map(|i| format!("ray, ray_shear(ray.d), skip, found, triangle_at({i}u), {i}u"));
    scene(
        "nearer_triangle",
        "shape/triangle/nearer",
        String::new(),
        fill,
        &calls.each_ref().map(String::as_str),
    )
    .slot("triangles", triangles_slot())
    .rust(|i, o| {
        let all = read_triangles(i);
        let s = read_search(i);
        out_hit(nearest_triangles(&all, s.ray, s.skip, s.best), o);
    })
    .seeded(4000, |r| {
        let row = (0..6).fold(Row::new(), |row, _| row.vec3(r.vec3(-1.0, 1.0)));
        let row = row.u(r.below(2)).u(1);
        search(r, row)
    })
}
