//! Triangles: the test, the surface, the rules of a ray that starts on a mesh.

use vkpt::kernel::Slot;
use vkpt::prepared::NONE;
use vkpt::reference::math::{Vec3, vec3};
use vkpt::reference::shape::cover::NoCover;
use vkpt::reference::shape::normal::interpolated_normal;
use vkpt::reference::shape::triangle::area::{
    abs3, triangle_area, triangle_point, triangle_sample,
};
use vkpt::reference::shape::triangle::hit::axis_last;
use vkpt::reference::shape::triangle::origin::is_origin;
use vkpt::reference::shape::{
    Target, Triangle, TriangleHit, nearer_triangle, ray_shear, triangle_hit,
    triangle_self_distance, triangle_surface,
};

use super::super::harness::{In, Rng, Row, Twin};
use super::{
    OUT_HIT, OUT_SURFACE, READ_HIT, READ_RAY, aimed, narrow, no_cover, out_hit, out_surface,
    prelude, read_hit, read_ray, scale,
};

/// Two triangles as in a scene's buffers.
const TRIANGLES: &str = "
vec3 corners[6];
vec3 corner_normals[6];
uint corner_shapes[2];
vec3 triangle_vertex(uint i, uint k) { return corners[3u * i + k]; }
vec3 triangle_normal(uint i, uint k) { return corner_normals[3u * i + k]; }
struct Triangle { vec3 v0; vec3 v1; vec3 v2; uint shape; };
Triangle triangle_at(uint i) {
    return Triangle(corners[3u * i], corners[3u * i + 1u], corners[3u * i + 2u], corner_shapes[i]);
}
";
const READ_TRIANGLES: &str = "uint n = 0u;
    while (n < 6u) { corners[n] = in_vec3(); n += 1u; }
    corner_shapes[0] = in_u(); corner_shapes[1] = in_u();";

pub fn triangles_slot() -> Slot {
    Slot::Text(TRIANGLES.into())
}

pub fn read_triangles(i: &mut In) -> [Triangle<f32>; 2] {
    let [v, w] = [0; 2].map(|_| [i.vec3(), i.vec3(), i.vec3()]);
    [
        Triangle { v, shape: i.u() },
        Triangle { v: w, shape: i.u() },
    ]
}

pub fn twins() -> Vec<Twin> {
    [points(), tests(), origins(), surfaces()]
        .into_iter()
        .flatten()
        .collect()
}

/// Three corners within `size` of the origin; one in eight without area.
fn corners(r: &mut Rng, size: f32) -> [Vec3<f32>; 3] {
    let v = [0; 3].map(|_| r.vec3(-size, size));
    match r.below(16) {
        0 => [v[0], v[0], v[2]],
        1 => [v[0], v[1], (v[0] + v[1]) * 0.5],
        _ => v,
    }
}

fn three(row: Row, v: [Vec3<f32>; 3]) -> Row {
    row.vec3(v[0]).vec3(v[1]).vec3(v[2])
}

fn weights(r: &mut Rng) -> [f32; 2] {
    let s = r.unit();
    [s * r.unit(), 1.0 - s]
}

fn points() -> Vec<Twin> {
    let read = "vec3 v0 = in_vec3(); vec3 v1 = in_vec3(); vec3 v2 = in_vec3();";
    vec![
        Twin::new("abs3", "shape/triangle/area")
            .glsl("out_vec3(abs3(in_vec3()));")
            .rust(|i, o| o.vec3(abs3(i.vec3())))
            .edge([-0.0, f32::NEG_INFINITY, -1e-45])
            .seeded(50, |r| Row::new().vec3(r.direction())),
        Twin::new("triangle_point", "shape/triangle/area")
            .glsl(&format!(
                "{read} out_vec3(triangle_point(v0, v1, v2, in_vec2()));"
            ))
            .rust(|i, o| {
                let (a, b, c) = (i.vec3(), i.vec3(), i.vec3());
                o.vec3(triangle_point(a, b, c, i.vec2()));
            })
            .seeded(1000, |r| {
                let size = scale(r);
                let v = corners(r, size);
                three(Row::new(), v).vec2(weights(r))
            }),
        Twin::new("triangle_sample", "shape/triangle/area")
            .glsl(&format!(
                "{read} out_vec3(triangle_sample(v0, v1, v2, in_vec2()));"
            ))
            .rust(|i, o| {
                let (a, b, c) = (i.vec3(), i.vec3(), i.vec3());
                o.vec3(triangle_sample(a, b, c, i.vec2()));
            })
            .seeded(1000, |r| {
                let size = scale(r);
                let v = corners(r, size);
                three(Row::new(), v).vec2([r.unit(), r.unit()])
            }),
        Twin::new("triangle_area", "shape/triangle/area")
            .glsl(&format!(
                "{read} TriangleArea a = triangle_area(v0, v1, v2); out_vec3(a.ng); out_f(a.area);"
            ))
            .rust(|i, o| {
                let a = triangle_area(i.vec3(), i.vec3(), i.vec3());
                o.vec3(a.ng);
                o.f(a.area);
            })
            .edge(three(Row::new(), [Vec3::one(); 3]))
            .seeded(2000, |r| {
                let size = r.log_range(1e-18, 1e18);
                three(Row::new(), corners(r, size))
            }),
    ]
}

/// A triangle and a ray at it: by a corner, by a point of an edge, by the middle, or past it.
fn triangle_and_ray(r: &mut Rng) -> ([Vec3<f32>; 3], Vec3<f32>, Vec3<f32>) {
    let size = scale(r);
    let v = corners(r, size);
    let s = r.unit();
    let target = match r.below(4) {
        0 => v[0],
        1 => v[0] + (v[1] - v[0]) * s,
        _ => (v[0] + v[1] + v[2]) * narrow(1.0 / 3.0),
    };
    let near = [0.0, 0.3, 1.5][r.below(3) as usize] * size;
    let (o, d) = aimed(r, target, size);
    let off = target.f64() + r.direction().f64() * f64::from(near) - o.f64();
    match r.below(4) {
        0 => (v, o, d),
        _ => (v, o, Vec3::new(off.normalize_or(glam::DVec3::Z))),
    }
}

fn tests() -> Vec<Twin> {
    let read = "vec3 v0 = in_vec3(); vec3 v1 = in_vec3(); vec3 v2 = in_vec3();";
    let flat = [Vec3::zero(), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
    let down = |x: f32, y: f32| {
        three(Row::new(), flat)
            .vec3(vec3(x, y, 2.0))
            .vec3(vec3(0.0, -0.0, -1.0))
    };
    vec![
        Twin::new("axis_last", "shape/triangle/hit")
            .glsl("vec3 v = in_vec3(); out_vec3(axis_last(v, in_u()));")
            .rust(|i, o| {
                let v = i.vec3();
                o.vec3(axis_last(v, i.u()));
            })
            .seeded(50, |r| Row::new().vec3(r.direction()).u(r.below(3))),
        Twin::new("ray_shear", "shape/triangle/hit")
            .glsl("RayShear s = ray_shear(in_vec3()); out_u(s.axis); out_f(s.sx); out_f(s.sy); out_f(s.sz);")
            .rust(|i, o| {
                let s = ray_shear(i.vec3());
                o.u(s.axis);
                o.f(s.sx);
                o.f(s.sy);
                o.f(s.sz);
            })
            .edges([[1.0, 0.0, -0.0], [0.0, -1.0, 0.0], [-0.0, 0.0, 1.0]].map(Row::from))
            .edges([[0.6, -0.6, 0.529], [0.5, 0.61, 0.61], [-0.61, 0.5, -0.61]].map(Row::from))
            .seeded(1000, |r| Row::new().vec3(r.direction())),
        Twin::new("triangle_hit", "shape/triangle/hit")
            .glsl(&format!(
                "{read} vec3 o = in_vec3(); TriangleHit h = triangle_hit(o, ray_shear(in_vec3()), v0, v1, v2);
                 out_f(h.t); out_f(h.u); out_f(h.v); out_b(h.back);"
            ))
            .rust(|i, o| {
                let (a, b, c, from) = (i.vec3(), i.vec3(), i.vec3(), i.vec3());
                let h = triangle_hit(from, ray_shear(i.vec3()), a, b, c);
                o.f(h.t);
                o.f(h.u);
                o.f(h.v);
                o.b(h.back);
            })
            // corners, edges, the diagonal, the inside, just outside
            .edges([down(0.0, 0.0), down(1.0, 0.0), down(0.0, 1.0), down(0.5, 0.0)])
            .edges([down(0.5, 0.5), down(0.25, 0.25), down(-1e-30, 0.0), down(0.5, 0.500_000_1)])
            .seeded(8000, |r| {
                let (v, o, d) = triangle_and_ray(r);
                three(Row::new(), v).vec3(o).vec3(d)
            }),
    ]
}

/// A ray that starts on the first of two triangles that share an edge, near it or on it.
fn departure(r: &mut Rng) -> Row {
    let size = scale(r);
    let shift = r.vec3(-size, size) * [0.0, 1.0, 30.0][r.below(3) as usize];
    let [a, b, c] = [0; 3].map(|_| r.vec3(-size, size) + shift);
    // In the same plane, or not.
    let d = match r.below(2) {
        0 => b + (c - a),
        _ => r.vec3(-size, size) + shift,
    };
    let own = triangle_area(a, b, c);
    let near = [1.0, 1e-5, 1e-7, 0.0][r.below(4) as usize] * r.unit();
    let p = triangle_point(a, b, c, [(1.0 - near) * 0.5, (1.0 - near) * 0.5]);
    let go = r.direction();
    let shape = r.below(3);
    let on = [shape, [0, 0, 1, NONE][r.below(4) as usize], r.below(3)];
    let row = three(three(Row::new(), [a, b, c]), [b, d, c]);
    let row = row.u(0).u(r.below(2));
    row.ray(p, go, on, triangle_self_distance(p, own.ng, go))
}

fn origins() -> Vec<Twin> {
    let scene = |name: &'static str, file: &'static str| {
        Twin::new(name, file)
            .prelude(prelude())
            .slot("triangles", triangles_slot())
            .slot("shading_normal", Slot::File("shape/normal/flat".into()))
            .slot("covered", no_cover())
            .file("shape/triangle/nearer")
    };
    let t = 4.0;
    vec![
        Twin::new("triangle_self_distance", "shape/triangle/origin")
            .prelude(prelude())
            .glsl("vec3 p = in_vec3(); vec3 ng = in_vec3(); out_f(triangle_self_distance(p, ng, in_vec3()));")
            .rust(|i, o| {
                let (p, ng) = (i.vec3(), i.vec3());
                o.f(triangle_self_distance(p, ng, i.vec3()));
            })
            .edge([0.0, -0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0])
            .edge([1.0, -2.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0])
            .seeded(1000, |r| {
                let size = scale(r);
                Row::new().vec3(r.vec3(-size, size)).vec3(r.direction()).vec3(r.direction())
            }),
        scene("is_origin", "shape/triangle/origin")
            .glsl(&format!(
                "{READ_TRIANGLES} {READ_RAY}
                 TriangleHit hit = triangle_hit(ray.o, ray_shear(ray.d), corners[3], corners[4], corners[5]);
                 out_b(is_origin(ray, corners[3], corners[4], corners[5], corner_shapes[1], 1u, hit));
                 hit.t = in_f(); hit.back = !hit.back;
                 out_b(is_origin(ray, corners[3], corners[4], corners[5], corner_shapes[1], 1u, hit));"
            ))
            .rust(|i, o| {
                let [_, other] = read_triangles(i);
                let ray = read_ray(i);
                let [a, b, c] = other.v;
                let hit = triangle_hit(ray.o, ray_shear(ray.d), a, b, c);
                o.b(is_origin(ray, &other, 1, hit));
                let turned = TriangleHit { t: i.f(), back: !hit.back, ..hit };
                o.b(is_origin(ray, &other, 1, turned));
            })
            .seeded(8000, |r| departure(r).f(r.log_range(1e-9, 1e3))),
        scene("nearer_triangle", "shape/triangle/nearer")
            .glsl(&format!(
                "{READ_TRIANGLES} {READ_RAY} {READ_HIT} Target skip = Target(in_u(), in_u());
                 Hit found = nearer_triangle(ray, ray_shear(ray.d), skip, hit, triangle_at(1u), 1u); {OUT_HIT}"
            ))
            .rust(|i, o| {
                let [_, other] = read_triangles(i);
                let (ray, best) = (read_ray(i), read_hit(i));
                let skip = Target { shape: i.u(), prim: i.u() };
                out_hit(nearer_triangle(ray, ray_shear(ray.d), skip, best, &other, 1, &NoCover), o);
            })
            .seeded(8000, move |r| {
                let row = departure(r).hit(t * scale(r), r.below(3), r.below(3), [0.25, 0.5]);
                row.u([0, NONE][r.below(2) as usize]).u([1, NONE, NONE][r.below(3) as usize])
            }),
    ]
}

fn surfaces() -> Vec<Twin> {
    let two = |r: &mut Rng| {
        let size = scale(r);
        let (v, w) = (corners(r, size), corners(r, size));
        three(three(Row::new(), v), w).u(0).u(0)
    };
    vec![
        Twin::new("triangle_surface", "shape/triangle")
            .also(&["shading_normal"])
            .prelude(prelude())
            .slot("triangles", triangles_slot())
            .slot("shading_normal", Slot::File("shape/normal/smooth".into()))
            .glsl(&format!(
                "{READ_TRIANGLES} n = 0u; while (n < 6u) {{ corner_normals[n] = in_vec3(); n += 1u; }}
                 {READ_HIT} Surface at = triangle_surface(hit); {OUT_SURFACE}"
            ))
            .rust(|i, o| {
                let triangles = read_triangles(i);
                let normals = [0; 2].map(|_| [i.vec3(), i.vec3(), i.vec3()]);
                let hit = read_hit(i);
                let k = hit.prim as usize;
                out_surface(triangle_surface(hit, &triangles[k], Some(&normals[k])), o);
            })
            .seeded(2000, move |r| {
                let row = two(r);
                let n = |r: &mut Rng| [0; 3].map(|_| r.direction());
                let row = match r.below(4) {
                    0 => three(three(row, [Vec3::zero(); 3]), [Vec3::zero(); 3]),
                    _ => {
                        let (a, b) = (n(r), n(r));
                        three(three(row, a), b)
                    }
                };
                row.hit(1.0, 0, r.below(2), weights(r))
            }),
        Twin::new("interpolated_normal", "shape/normal/smooth")
            .prelude(prelude())
            .slot("triangles", triangles_slot())
            .glsl(
                "vec3 a = in_vec3(); vec3 b = in_vec3(); vec3 c = in_vec3(); vec2 uv = in_vec2();
                 out_vec3(interpolated_normal(a, b, c, uv, in_vec3()));",
            )
            .rust(|i, o| {
                let (a, b, c, uv) = (i.vec3(), i.vec3(), i.vec3(), i.vec2());
                o.vec3(interpolated_normal(a, b, c, uv, i.vec3()));
            })
            .edge(three(Row::new(), [Vec3::zero(); 3]).vec2([0.5, 0.25]).vec3(vec3(0.0, 0.0, 1.0)))
            .seeded(1000, |r| {
                let n = [0; 3].map(|_| r.direction());
                three(Row::new(), n).vec2(weights(r)).vec3(r.direction())
            }),
        // without normals the surface's own
        Twin::new("shading_normal", "shape/normal/flat")
            .glsl("uint prim = in_u(); vec2 uv = in_vec2(); out_vec3(shading_normal(prim, uv, in_vec3()));")
            .rust(|i, o| {
                let _ = (i.u(), i.vec2());
                o.vec3(i.vec3());
            })
            .seeded(20, |r| Row::new().u(r.below(9)).vec2(weights(r)).vec3(r.direction())),
    ]
}
