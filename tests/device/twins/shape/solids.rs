//! Spheres, boxes, cylinders.

use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::math::frame::frame_about;
use vkpt::reference::math::{Vec3, vec3};
use vkpt::reference::shape::cylinder::side_stretch;
use vkpt::reference::shape::{
    Cuboid, Cylinder, Sphere, box_face, box_hit, box_snap, box_surface, cylinder_frame,
    cylinder_hit, cylinder_surface, sphere_hit, sphere_surface,
};

use super::super::harness::{In, Rng, Row, Twin};
use super::{
    OUT_SURFACE, READ_HIT, READ_RAY, aimed, out_surface, prelude, read_hit, read_ray, scale,
};

/// Reads a cylinder.
pub const CYLINDER: &str = "vec3 base = in_vec3(); vec3 cu = in_vec3(); vec3 cv = in_vec3(); vec3 cw = in_vec3(); \
    float height = in_f(); Cylinder cylinder = Cylinder(base, height, cu, in_f(), cv, 0u, cw, 0.0);";

pub fn twins() -> Vec<Twin> {
    [
        spheres(),
        boxes(),
        box_parts(),
        cylinders(),
        cylinder_parts(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn spheres() -> Vec<Twin> {
    let prelude = format!("{}{}", prelude(), device::Sphere::glsl());
    let one = |o: Vec3<f32>, d: Vec3<f32>, start: u32| {
        Row::new()
            .vec3(o)
            .vec3(d)
            .vec3(Vec3::zero())
            .f(1.0)
            .u(start)
    };
    let (x, y) = (vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    vec![
        Twin::new("sphere_hit", "shape/sphere")
            .prelude(&*prelude)
            .glsl(
                "vec3 o = in_vec3(); vec3 d = in_vec3(); vec3 centre = in_vec3(); float radius = in_f();
                 out_f(sphere_hit(o, d, centre, radius, in_u()));",
            )
            .rust(|i, o| {
                let (from, d, centre, radius) = (i.vec3(), i.vec3(), i.vec3(), i.f());
                o.f(sphere_hit(from, d, centre, radius, i.u()));
            })
            // towards, away, tangent, from the middle, from the surface, far away
            .edges([one(x * -3.0, x, 0), one(x * 3.0, x, 0), one(y - x * 3.0, x, 0)])
            .edges([one(x * 0.0, x, 0), one(x, y, 0), one(x, -x, 0), one(x * 1e7, -x, 0)])
            .edges([one(x, x, 1), one(x, -x, 2), one(x, y, 2), one(x, x, 2)])
            .seeded(5000, |r| {
                let size = scale(r);
                let centre = r.vec3(-size, size);
                let (o, d) = aimed(r, centre, size);
                Row::new().vec3(o).vec3(d).vec3(centre).f(size * 0.7).u(r.below(3))
            }),
        Twin::new("sphere_surface", "shape/sphere")
            .prelude(prelude)
            .glsl(&format!(
                "{READ_RAY} {READ_HIT} Sphere sphere = Sphere(in_vec3(), in_f(), 0u, 0u, 0u, 0u);
                 Surface at = sphere_surface(ray, hit, sphere); {OUT_SURFACE}"
            ))
            .rust(|i, o| {
                let (ray, hit) = (read_ray(i), read_hit(i));
                let sphere = Sphere { centre: i.vec3(), radius: i.f(), shape: 0 };
                out_surface(sphere_surface(ray, hit, &sphere), o);
            })
            // too small to be distinguished from its centre
            .edge(on_surface(x * 100.0, -x, 100.0, 0).vec3(Vec3::zero()).f(1e-8))
            .seeded(2000, |r| {
                let size = scale(r);
                let centre = r.vec3(-size, size);
                let (o, d) = aimed(r, centre, size);
                on_surface(o, d, size * r.unit(), 0).vec3(centre).f(size)
            }),
    ]
}

/// A ray and where it has hit.
fn on_surface(o: Vec3<f32>, d: Vec3<f32>, t: f32, prim: u32) -> Row {
    Row::new()
        .ray(o, d, [0, 0, 0], 0.0)
        .hit(t, 0, prim, [0.0; 2])
}

/// A box and a ray by it; one in four starts on a face or an edge.
fn box_and_ray(r: &mut Rng) -> (Row, Vec3<f32>, Vec3<f32>) {
    let size = scale(r);
    let lo = r.vec3(-size, size);
    let hi = lo + r.vec3(0.1 * size, size);
    let (mut o, d) = aimed(r, (lo + hi) * 0.5, size);
    if r.below(4) == 0 {
        o = vec3(
            [lo.x, hi.x][r.below(2) as usize],
            o.y,
            [lo.z, hi.z][r.below(2) as usize],
        );
    }
    (Row::new().vec3(lo).vec3(hi), o, d)
}

fn boxes() -> Vec<Twin> {
    let prelude = format!("{}{}", prelude(), device::Cuboid::glsl());
    let unit = || Row::new().vec3(Vec3::zero()).vec3(Vec3::one());
    let edge = |o: [f32; 3], d: [f32; 3], start: u32| {
        unit()
            .vec3(vec3(o[0], o[1], o[2]))
            .vec3(vec3(d[0], d[1], d[2]))
            .u(start)
    };
    vec![
        Twin::new("box_hit", "shape/box")
            .prelude(&*prelude)
            .glsl(
                "vec3 lo = in_vec3(); vec3 hi = in_vec3(); vec3 o = in_vec3(); vec3 d = in_vec3();
                 BoxHit hit = box_hit(o, d, lo, hi, in_u()); out_f(hit.t); out_u(hit.face);",
            )
            .rust(|i, o| {
                let (lo, hi, from, d) = (i.vec3(), i.vec3(), i.vec3(), i.vec3());
                let hit = box_hit(from, d, lo, hi, i.u());
                o.f(hit.t);
                o.u(hit.face);
            })
            // in the plane of a face: next to it, on it, sliding; through two edges and two corners
            .edge(edge([-1.0, 0.5, 1.0], [0.8, 0.0, -0.6], 0))
            .edge(edge([0.25, 0.5, 1.0], [0.6, 0.0, -0.8], 0))
            .edge(edge([-1.0, 0.5, 1.0], [1.0, 0.0, -0.0], 0))
            .edge(edge(
                [-1.0, -1.0, 0.5],
                [0.707_106_77, 0.707_106_77, 0.0],
                0,
            ))
            .edge(edge(
                [-1.0, -1.0, -1.0],
                [0.577_350_26, 0.577_350_26, 0.577_350_26],
                0,
            ))
            .edge(edge([1.0, 1.0, 0.5], [0.0, 0.0, 1.0], 2))
            .edge(edge([1.0, 1.0, 1.0], [1.0, 0.0, 0.0], 2))
            .seeded(5000, |r| {
                let (row, o, d) = box_and_ray(r);
                row.vec3(o).vec3(d).u(r.below(3))
            }),
        Twin::new("box_surface", "shape/box")
            .prelude(prelude)
            .glsl(&format!(
                "vec3 lo = in_vec3(); vec3 hi = in_vec3(); {READ_RAY} {READ_HIT}
                 Surface at = box_surface(ray, hit, Cuboid(lo, 0u, hi, 0u)); {OUT_SURFACE}"
            ))
            .rust(|i, o| {
                let cuboid = Cuboid {
                    lo: i.vec3(),
                    hi: i.vec3(),
                    shape: 0,
                };
                let (ray, hit) = (read_ray(i), read_hit(i));
                out_surface(box_surface(ray, hit, &cuboid), o);
            })
            .seeded(2000, |r| {
                let (row, o, d) = box_and_ray(r);
                let row = row.ray(o, d, [0, 0, 0], 0.0);
                row.hit(r.log_range(1e-5, 1e5), 0, r.below(6), [0.0; 2])
            }),
    ]
}

fn box_parts() -> Vec<Twin> {
    let prelude = format!("{}{}", prelude(), device::Cuboid::glsl());
    vec![
        Twin::new("box_face", "shape/box")
            .prelude(&*prelude)
            .glsl("bool x = in_b(); bool y = in_b(); out_u(box_face(x, y, in_vec3()));")
            .rust(|i, o| {
                let (x, y) = (i.b(), i.b());
                o.u(box_face(x, y, i.vec3()));
            })
            .edge(Row::new().u(0).u(0).vec3(vec3(0.0, 0.0, -0.0)))
            .seeded(200, |r| {
                Row::new().u(r.below(2)).u(r.below(2)).vec3(r.direction())
            }),
        Twin::new("box_snap", "shape/box")
            .prelude(prelude)
            .glsl(
                "bool across = in_b(); bool upper = in_b(); float p = in_f(); float lo = in_f();
                 out_f(box_snap(across, upper, p, lo, in_f()));",
            )
            .rust(|i, o| {
                let (across, upper, p, lo) = (i.b(), i.b(), i.f(), i.f());
                o.f(box_snap(across, upper, p, lo, i.f()));
            })
            .seeded(200, |r| {
                let row = Row::new().u(r.below(2)).u(r.below(2));
                row.f(r.range(-2.0, 2.0)).f(-r.unit()).f(r.unit())
            }),
    ]
}

/// A cylinder of about `size`, in the order in which [`CYLINDER`] reads it.
pub fn cylinder(r: &mut Rng, size: f32) -> (Row, Vec3<f32>) {
    let axis = if r.below(4) == 0 {
        vec3(0.0, 0.0, 1.0)
    } else {
        r.direction()
    };
    let frame = frame_about(axis);
    let base = r.vec3(-size, size);
    let height = size * r.range(0.1, 1.5);
    let middle = base + axis * (height * 0.5);
    let row = Row::new()
        .vec3(base)
        .vec3(frame.t)
        .vec3(frame.b)
        .vec3(frame.n);
    (row.f(height).f(size * r.range(0.1, 0.8)), middle)
}

pub fn read_cylinder(i: &mut In) -> Cylinder<f32> {
    let (base, u, v, w) = (i.vec3(), i.vec3(), i.vec3(), i.vec3());
    Cylinder {
        base,
        u,
        v,
        w,
        height: i.f(),
        radius: i.f(),
        shape: 0,
    }
}

/// The cylinder of radius 1 and height 2 on the plane z = 0.
fn upright() -> Row {
    let axes = Row::new().vec3(Vec3::zero()).vec3(vec3(1.0, 0.0, 0.0));
    axes.vec3(vec3(0.0, 1.0, 0.0))
        .vec3(vec3(0.0, 0.0, 1.0))
        .f(2.0)
        .f(1.0)
}

fn cylinders() -> Vec<Twin> {
    let prelude = format!("{}{}", prelude(), device::Cylinder::glsl());
    let edge = |o: [f32; 3], d: [f32; 3], start: u32, part: u32| {
        let row = upright()
            .vec3(vec3(o[0], o[1], o[2]))
            .vec3(vec3(d[0], d[1], d[2]));
        row.u(start).u(part)
    };
    vec![
        Twin::new("cylinder_hit", "shape/cylinder")
            .prelude(&*prelude)
            .glsl(&format!(
                "{CYLINDER} vec3 o = in_vec3(); vec3 d = in_vec3(); uint start = in_u();
                 CylinderHit hit = cylinder_hit(o, d, cylinder, start, in_u()); out_f(hit.t); out_u(hit.part);"
            ))
            .rust(|i, o| {
                let cylinder = read_cylinder(i);
                let (from, d, start) = (i.vec3(), i.vec3(), i.u());
                let hit = cylinder_hit(from, d, &cylinder, start, i.u());
                o.f(hit.t);
                o.u(hit.part);
            })
            // along the axis within, on and outside the side; along a cap; tangent; from the rim
            .edge(edge([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], 0, 0))
            .edge(edge([1.0, 0.0, -1.0], [0.0, 0.0, 1.0], 0, 0))
            .edge(edge([2.0, 0.0, -1.0], [0.0, 0.0, 1.0], 0, 0))
            .edge(edge([-2.0, 0.0, 2.0], [1.0, 0.0, 0.0], 0, 0))
            .edge(edge([-2.0, 1.0, 1.0], [1.0, 0.0, 0.0], 0, 0))
            .edge(edge([1.0, 0.0, 2.0], [-0.6, 0.0, -0.8], 2, 2))
            .edge(edge([1.0, 0.0, 1.0], [-1.0, 0.0, 0.0], 2, 0))
            .edge(edge([1.0, 0.0, 1.0], [0.0, 0.0, 1.0], 2, 0))
            .seeded(5000, |r| {
                let size = scale(r);
                let (row, middle) = cylinder(r, size);
                let (o, d) = aimed(r, middle, size);
                row.vec3(o).vec3(d).u(r.below(3)).u(r.below(3))
            }),
        Twin::new("cylinder_surface", "shape/cylinder")
            .prelude(prelude)
            .glsl(&format!(
                "{CYLINDER} {READ_RAY} {READ_HIT} Surface at = cylinder_surface(ray, hit, cylinder); {OUT_SURFACE}"
            ))
            .rust(|i, o| {
                let cylinder = read_cylinder(i);
                let (ray, hit) = (read_ray(i), read_hit(i));
                out_surface(cylinder_surface(ray, hit, &cylinder), o);
            })
            // a point on the axis
            .edge(upright().ray(vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, -1.0), [0; 3], 0.0).hit(3.0, 0, 0, [0.0; 2]))
            .edge(upright().ray(vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, -1.0), [0; 3], 0.0).hit(3.0, 0, 2, [0.0; 2]))
            .seeded(2000, |r| {
                let size = scale(r);
                let (row, middle) = cylinder(r, size);
                let (o, d) = aimed(r, middle, size);
                row.ray(o, d, [0; 3], 0.0).hit(size * r.unit(), 0, r.below(3), [0.0; 2])
            }),
    ]
}

fn cylinder_parts() -> Vec<Twin> {
    let prelude = format!("{}{}", prelude(), device::Cylinder::glsl());
    vec![
        Twin::new("cylinder_frame", "shape/cylinder")
            .prelude(&*prelude)
            .glsl(&format!(
                "{CYLINDER} Frame f = cylinder_frame(cylinder); out_vec3(f.t); out_vec3(f.b); out_vec3(f.n);"
            ))
            .rust(|i, o| {
                let f = cylinder_frame(&read_cylinder(i));
                o.vec3(f.t);
                o.vec3(f.b);
                o.vec3(f.n);
            })
            .seeded(20, |r| cylinder(r, 1.0).0),
        Twin::new("side_stretch", "shape/cylinder")
            .prelude(prelude)
            .glsl(
                "vec3 o = in_vec3(); vec3 d = in_vec3(); float radius = in_f(); uint start = in_u();
                 Slab s = side_stretch(o, d, radius, start, in_u()); out_f(s.near); out_f(s.far);",
            )
            .rust(|i, o| {
                let (from, d, radius, start) = (i.vec3(), i.vec3(), i.f(), i.u());
                let s = side_stretch(from, d, radius, start, i.u());
                o.f(s.near);
                o.f(s.far);
            })
            // on the side, with a direction that comes ever nearer to the axis's
            .edges([0.0, 1e-30, 1e-16, 1e-14, 1e-8, 1e-3].map(|x| {
                Row::new().vec3(vec3(1.0, 0.0, 0.0)).vec3(vec3(-x, 0.0, 1.0)).f(1.0).u(2).u(0)
            }))
            .seeded(2000, |r| {
                let size = scale(r);
                let (o, d) = aimed(r, Vec3::zero(), size);
                Row::new().vec3(o).vec3(d).f(size * 0.5).u(r.below(3)).u(r.below(3))
            }),
    ]
}
