//! Coincident faces: points on faces, and which of two faces is the uncovered one.

use glam::DVec3;
use vkpt::kernel::Slot;
use vkpt::layout::{GpuStruct, OnDevice};
use vkpt::prepared::{NONE, device};
use vkpt::reference::math::{Vec3, vec3};
use vkpt::reference::primitives::Primitives;
use vkpt::reference::shape::Cuboid;
use vkpt::reference::shape::r#box::box_enters;
use vkpt::reference::shape::cover::{Cover, is_covered_at, touching};
use vkpt::reference::shape::cylinder::cap_enters;
use vkpt::reference::shape::face::{
    FacePoint, box_face_point, cylinder_face_point, sphere_face_point, triangle_face_point,
};
use vkpt::shape::{self, Coincidence, Coincidences, ShapeKind};

use super::super::harness::{In, Out, Rng, Row, Twin};
use super::solids::{CYLINDER, cylinder, read_cylinder};
use super::{OUT_HIT, READ_HIT, READ_RAY, out_hit, prelude, read_hit, read_ray};

const OUT_POINT: &str = "out_b(at.within); out_vec2(at.uv);";

fn out_point(at: FacePoint<f32>, o: &mut Out) {
    o.b(at.within);
    o.vec2(at.uv);
}

pub fn twins() -> Vec<Twin> {
    [points(), entries(), table()]
        .into_iter()
        .flatten()
        .collect()
}

fn points() -> Vec<Twin> {
    let read_box = |i: &mut In| Cuboid {
        lo: i.vec3(),
        hi: i.vec3(),
        shape: 0,
    };
    vec![
        Twin::new("sphere_face_point", "shape/face/sphere")
            .glsl(&format!(
                "FacePoint at = sphere_face_point(); {OUT_POINT}"
            ))
            .rust(|_, o| out_point(sphere_face_point(), o))
            .edge(Row::new()),
        Twin::new("box_face_point", "shape/face/box")
            .prelude(device::Cuboid::glsl())
            .glsl(&format!(
                "vec3 lo = in_vec3(); Cuboid cuboid = Cuboid(lo, 0u, in_vec3(), 0u); uint face = in_u();
                 FacePoint at = box_face_point(cuboid, face, in_vec3()); {OUT_POINT}"
            ))
            .rust(move |i, o| {
                let cuboid = read_box(i);
                let face = i.u();
                out_point(box_face_point(&cuboid, face, i.vec3()), o);
            })
            // corners count
            .edge(Row::new().vec3(Vec3::zero()).vec3(Vec3::one()).u(3).vec3(vec3(1.0, 1.0, 0.0)))
            .seeded(2000, |r| {
                let row = Row::new().vec3(r.vec3(-1.0, 0.0)).vec3(r.vec3(0.0, 1.0));
                row.u(r.below(6)).vec3(r.vec3(-1.0, 1.0))
            }),
        Twin::new("cylinder_face_point", "shape/face/cylinder")
            .prelude(prelude() + &device::Cylinder::glsl())
            .glsl(&format!(
                "{CYLINDER} uint part = in_u();
                 FacePoint at = cylinder_face_point(cylinder, part, in_vec3()); {OUT_POINT}"
            ))
            .rust(|i, o| {
                let cylinder = read_cylinder(i);
                let part = i.u();
                out_point(cylinder_face_point(&cylinder, part, i.vec3()), o);
            })
            .seeded(3000, |r| cylinder(r, 1.0).0.u(r.below(3)).vec3(r.vec3(-1.0, 1.0))),
        Twin::new("triangle_face_point", "shape/face/triangle")
            .glsl(&format!(
                "vec3 v0 = in_vec3(); vec3 v1 = in_vec3(); vec3 v2 = in_vec3();
                 FacePoint at = triangle_face_point(v0, v1, v2, in_vec3()); {OUT_POINT}"
            ))
            .rust(|i, o| {
                let [v0, v1, v2] = [i.vec3(), i.vec3(), i.vec3()];
                out_point(triangle_face_point(v0, v1, v2, i.vec3()), o);
            })
            .seeded(4000, |r| {
                let v: [Vec3<f32>; 3] = [0; 3].map(|_| r.vec3(-1.0, 1.0));
                let (a, b) = (r.range(-0.2, 1.0), r.range(-0.2, 1.0));
                // in its plane; on an edge; of a triangle without area
                let p = match r.below(8) {
                    0 => v[1],
                    1 => (v[0] + v[2]) * 0.5,
                    _ => v[0] + (v[1] - v[0]) * a + (v[2] - v[0]) * b,
                };
                let last = if r.below(16) == 0 { v[1] } else { v[2] };
                Row::new().vec3(v[0]).vec3(v[1]).vec3(last).vec3(p)
            }),
    ]
}

fn entries() -> Vec<Twin> {
    vec![
        Twin::new("box_enters", "shape/box")
            .prelude(prelude() + &device::Cuboid::glsl())
            .glsl("uint face = in_u(); out_b(box_enters(face, in_vec3()));")
            .rust(|i, o| {
                let face = i.u();
                o.b(box_enters(face, i.vec3()));
            })
            .edge(Row::new().u(2).vec3(vec3(1.0, 0.0, 0.0)))
            .seeded(500, |r| Row::new().u(r.below(6)).vec3(r.direction())),
        Twin::new("cap_enters", "shape/cylinder")
            .prelude(prelude() + &device::Cylinder::glsl())
            .glsl(&format!(
                "{CYLINDER} uint part = in_u(); out_b(cap_enters(cylinder, part, in_vec3()));"
            ))
            .rust(|i, o| {
                let cylinder = read_cylinder(i);
                let part = i.u();
                o.b(cap_enters(&cylinder, part, i.vec3()));
            })
            .seeded(1000, |r| {
                cylinder(r, 1.0).0.u(r.below(3)).vec3(r.direction())
            }),
    ]
}

/// A table of a table: an opaque box, with two of glass on it that touch.
fn boxes() -> shape::Primitives {
    let places = [
        [[0.0, 0.0, -1.0], [2.0, 2.0, 0.0]],
        [[0.2, 0.2, 0.0], [1.0, 1.0, 1.0]],
        [[1.0, 0.4, 0.0], [1.8, 1.4, 1.0]],
    ];
    let boxes = (0..).zip(places).map(|(shape, [lo, hi])| {
        shape::Cuboid::between(DVec3::from_array(lo), DVec3::from_array(hi), shape)
    });
    let entry = |shape: u32, prim: u32, touches: u32| Coincidence {
        shape,
        prim,
        kind: ShapeKind::Box,
        index: shape,
        touches,
    };
    let list = vec![
        (1, 4, entry(0, 5, 0)),
        (2, 4, entry(0, 5, 0)),
        (1, 1, entry(2, 0, 1)),
        (2, 0, entry(1, 1, 1)),
    ];
    shape::Primitives {
        boxes: boxes.collect(),
        coincident: Coincidences::new(&[0..6, 0..6, 0..6], list),
        ..Default::default()
    }
}

/// The same in a kernel: the declarations, and the statements that fill them.
fn buffers(p: &shape::Primitives) -> (String, String) {
    let table = &p.coincident;
    let (faces, list) = (&table.faces, &table.list);
    let declared = format!(
        "{}{}Cuboid boxes[3];\nuint coincident_faces[{}];\nCoincidence coincidences[{}];\n",
        device::Cuboid::glsl(),
        device::Coincidence::glsl(),
        faces.len(),
        list.len()
    );
    let mut filled = String::new();
    for (i, b) in p.boxes.iter().enumerate() {
        let v = |v: DVec3| format!("vec3({:?}, {:?}, {:?})", v.x as f32, v.y as f32, v.z as f32);
        filled += &format!(
            "boxes[{i}] = Cuboid({}, {}u, {}, 0u);\n",
            v(b.lo),
            b.shape,
            v(b.hi)
        );
    }
    for (i, at) in faces.iter().enumerate() {
        filled += &format!("coincident_faces[{i}] = {at}u;\n");
    }
    for (i, c) in list.iter().map(OnDevice::record).enumerate() {
        filled += &format!(
            "coincidences[{i}] = Coincidence({}u, {}u, {}u, {}u, {}u, 0u, 0u, 0u);\n",
            c.shape, c.prim, c.kind, c.index, c.touches
        );
    }
    (declared, filled)
}

/// A face of one of the boxes, a point on it, and a ray from there or to there.
fn face(r: &mut Rng) -> Row {
    let p = boxes();
    let faces = [[0, 5], [1, 4], [2, 4], [1, 1], [2, 0], [1, 5]];
    let [shape, prim] = faces[r.below(6) as usize];
    let b = &p.boxes[shape as usize];
    let axis = (prim / 2) as usize;
    let mut at =
        b.lo + (b.hi - b.lo) * DVec3::new(r.unit().into(), r.unit().into(), r.unit().into());
    at[axis] = if prim % 2 == 1 {
        b.hi[axis]
    } else {
        b.lo[axis]
    };
    let [x, y, z] = at.as_vec3().to_array();
    let (at, d) = (vec3(x, y, z), r.direction());
    let t = [0.0, 0.5, 2.0][r.below(3) as usize];
    let [on, of] = faces[r.below(6) as usize];
    let start = r.below(3);
    let row = Row::new().ray(at - d * t, d, [on, of, start], 1e-6);
    row.u(shape).u(prim).f(t).u([NONE, 1][r.below(2) as usize])
}

fn table() -> Vec<Twin> {
    let (declared, filled) = buffers(&boxes());
    let scene = |name| {
        Twin::new(name, "shape/cover/table")
            .prelude(prelude() + &declared)
            .slot(
                "face_point",
                Slot::Text(
                    "// uses: shape/face/box\nFacePoint face_point(Coincidence face, vec3 p) \
                     { return box_face_point(boxes[face.index], face.prim, p); }\n"
                        .into(),
                ),
            )
    };
    let read = format!(
        "{filled} {READ_RAY} uint shape = in_u(); uint prim = in_u(); float t = in_f(); ray.medium = in_u();"
    );
    let primitives = || Primitives::<f32>::new(&boxes());
    let given = |i: &mut In| {
        let mut ray = read_ray(i);
        let (shape, prim, t) = (i.u(), i.u(), i.f());
        ray.medium = i.u();
        (ray, shape, prim, t)
    };
    vec![
        scene("is_covered")
            .also(&["coincidences_of"])
            .glsl(&format!(
                "{read} out_b(is_covered(true, ray, shape, prim, t, false)); out_b(is_covered(true, ray, shape, prim, t, true));
                 out_b(is_covered(false, ray, shape, prim, t, true));"
            ))
            .rust(move |i, o| {
                let (p, (ray, shape, prim, t)) = (primitives(), given(i));
                for enters in [false, true] {
                    o.b(p.is_covered(ray, shape, prim, t, enters));
                }
                o.b(false);
            })
            .seeded(4000, face),
        scene("is_covered_at")
            .glsl(&format!(
                "{read} out_b(is_covered_at(shape, prim, ray.o)); out_b(is_covered_at(NONE, NONE, ray.o));"
            ))
            .rust(move |i, o| {
                let (p, (ray, shape, prim, _)) = (primitives(), given(i));
                o.b(is_covered_at(&p, shape, prim, ray.o));
                o.b(is_covered_at(&p, NONE, NONE, ray.o));
            })
            .seeded(2000, face),
        scene("touching")
            .glsl(&format!(
                "{read} {READ_HIT} Hit found = touching(ray, hit); {OUT_HIT}"
            ))
            .rust(move |i, o| {
                let (p, (ray, ..)) = (primitives(), given(i));
                out_hit(touching(&p, ray, read_hit(i)), o);
            })
            .seeded(4000, |r| face(r).hit(0.7, 0, 3, [0.0, 0.0])),
    ]
}
