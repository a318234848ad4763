//! Twins of `shaders/light/`.

use vkpt::kernel::Slot;
use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::light::r#box::{face_areas, faces_seen, upper_face};
use vkpt::reference::light::cylinder::cylinder_area;
use vkpt::reference::light::sample::{
    LightSample, area_density, area_sample, choice_below, solid_angle_pdf, unit_sphere,
};
use vkpt::reference::light::sphere::{cone_height, cone_pdf, cone_sample, sphere_density};
use vkpt::reference::light::{
    background_light_pdf, background_light_sample, background_outside, box_light_pdf,
    box_light_sample, cdf_choice, cdf_probability, cylinder_light_pdf, cylinder_light_sample,
    mesh_light_pdf, mesh_light_sample, sphere_light_pdf, sphere_light_sample,
};
use vkpt::reference::math::{Vec3, vec3};
use vkpt::reference::shape::Triangle;

use super::harness::{In, Out, Rng, Row, Twin};
use super::shape::{CYLINDER, cylinder, prelude, read_cylinder};

pub fn twins() -> Vec<Twin> {
    [
        shared(),
        uniform(),
        choices(),
        spheres(),
        cones(),
        boxes(),
        cylinders(),
        meshes(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

pub const OUT_SAMPLE: &str =
    "out_vec3(s.wi); out_f(s.distance); out_f(s.pdf); out_f(s.cosine); out_u(s.prim);";
/// 1 − 2⁻²⁴, the largest that the sampler draws.
const LAST: f32 = 0.999_999_94;

pub fn out_sample(s: LightSample<f32>, o: &mut Out) {
    o.vec3(s.wi);
    o.f(s.distance);
    o.f(s.pdf);
    o.f(s.cosine);
    o.u(s.prim);
}

pub fn light(name: &'static str, file: &'static str) -> Twin {
    Twin::new(name, file).prelude(prelude())
}

/// Two numbers of the sampler, one in eight of them at an end.
pub fn uniforms(r: &mut Rng) -> [f32; 2] {
    [0; 2].map(|_| [0.0, LAST, r.unit(), r.unit()][(r.below(16) as usize).min(3)])
}

pub fn u24(r: &mut Rng) -> u32 {
    [0, (1 << 24) - 1, r.below(1 << 24)][(r.below(16) as usize).min(2)]
}

fn shared() -> Vec<Twin> {
    vec![
        light("area_density", "light/sample")
            .glsl("out_f(area_density(in_f()));")
            .rust(|i, o| o.f(area_density(i.f())))
            .edges([0.0, -0.0, 1.0, 3.0, 1e-30, 1e30, f32::NAN].map(|x| Row::from([x]))),
        light("solid_angle_pdf", "light/sample")
            .glsl("float p = in_f(); float t = in_f(); out_f(solid_angle_pdf(p, t, in_f()));")
            .rust(|i, o| {
                let (p, t) = (i.f(), i.f());
                o.f(solid_angle_pdf(p, t, i.f()));
            })
            .edge([1.0, 1.0, 0.0])
            .edge([0.0, 1.0, 1.0])
            .edge([1.0, 2.0, f32::NAN])
            .seeded(500, |r| {
                Row::from([r.log_range(1e-9, 1e9), r.log_range(1e-5, 1e5), r.unit()])
            }),
        light("area_sample", "light/sample")
            .glsl(&format!(
                "vec3 to = in_vec3(); vec3 n = in_vec3(); float p = in_f();
                 LightSample s = area_sample(to, n, p, in_u()); {OUT_SAMPLE}"
            ))
            .rust(|i, o| {
                let (to, n, p) = (i.vec3(), i.vec3(), i.f());
                out_sample(area_sample(to, n, p, i.u()), o);
            })
            // in the point itself, and edge-on
            .edge(Row::from([0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0]).u(0))
            .edge(Row::from([1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0]).u(0))
            .seeded(1000, |r| {
                let size = r.log_range(1e-5, 1e5);
                let row = Row::new().vec3(r.vec3(-size, size)).vec3(r.direction());
                row.f(r.unit()).u(r.below(9))
            }),
        light("choice_below", "light/sample")
            .glsl("uint u24 = in_u(); out_f(choice_below(u24, in_f()));")
            .rust(|i, o| {
                let u24 = i.u();
                o.f(choice_below(u24, i.f()));
            })
            .seeded(1000, |r| Row::new().u(u24(r)).f(r.log_range(1e-10, 1e10))),
    ]
}

fn uniform() -> Vec<Twin> {
    let ends = [[0.0, 0.0], [LAST, LAST], [0.5, 0.25]].map(Row::from);
    vec![
        light("unit_sphere", "light/sample")
            .glsl("out_vec3(unit_sphere(in_vec2()));")
            .rust(|i, o| o.vec3(unit_sphere(i.vec2())))
            .edges(ends.clone())
            .seeded(1000, |r| Row::new().vec2(uniforms(r))),
        light("background_outside", "light/background")
            .glsl("Outside s = background_outside(in_vec3()); out_vec3(s.radiance); out_f(s.pdf);")
            .rust(|i, o| {
                let seen = background_outside(i.vec3());
                o.vec3(seen.radiance);
                o.f(seen.pdf);
            })
            .seeded(20, |r| Row::new().vec3(r.vec3(0.0, 10.0))),
        light("background_light_sample", "light/background")
            .also(&["background_light_pdf"])
            .glsl(&format!(
                "LightSample s = background_light_sample(in_vec2()); {OUT_SAMPLE} out_f(background_light_pdf());"
            ))
            .rust(|i, o| {
                out_sample(background_light_sample(i.vec2()), o);
                o.f(background_light_pdf());
            })
            .edges(ends)
            .seeded(1000, |r| Row::new().vec2(uniforms(r))),
    ]
}

/// Cumulative counts of up to seven choices, some of no width, from 0 to 2²⁴.
fn counts(r: &mut Rng) -> [u32; 8] {
    let mut cdf = [0; 8].map(|_| r.below((1 << 24) + 1));
    let (from, to) = (r.below(8) as usize, r.below(8) as usize);
    cdf[to] = cdf[from];
    cdf.sort_unstable();
    cdf[0] = 0;
    cdf[7] = 1 << 24;
    cdf
}

fn eight(row: Row, words: [u32; 8]) -> Row {
    words.into_iter().fold(row, Row::u)
}

fn read_eight(i: &mut In) -> [u32; 8] {
    [0; 8].map(|_| i.u())
}

/// A choice at, just before and well after an entry of the table.
fn near_entry(r: &mut Rng, cdf: [u32; 8]) -> u32 {
    let entry = cdf[r.below(8) as usize];
    let choice = [entry, entry.wrapping_sub(1), r.below(1 << 24)][r.below(3) as usize];
    choice.min((1 << 24) - 1)
}

const FILL_COUNTS: &str = "uint n = 0u; while (n < 8u) { COUNTS[n] = in_u(); n += 1u; }";

fn choices() -> Vec<Twin> {
    let table = |name: &'static str| {
        light(name, "light/choice/many").prelude("const uint LIGHTS = 7u;\nuint light_cdf[8];\n")
    };
    let fill = FILL_COUNTS.replace("COUNTS", "light_cdf");
    vec![
        table("light_choice")
            .glsl(&format!("{fill} out_u(light_choice(in_u()));"))
            .rust(|i, o| {
                let cdf = read_eight(i);
                o.u(cdf_choice(&cdf, i.u()));
            })
            .seeded(2000, |r| {
                let cdf = counts(r);
                eight(Row::new(), cdf).u(near_entry(r, cdf))
            }),
        table("light_pmf")
            .glsl(&format!("{fill} out_f(light_pmf(in_u()));"))
            .rust(|i, o| {
                let cdf = read_eight(i);
                o.f(cdf_probability(&cdf, i.u()));
            })
            .seeded(500, |r| {
                let cdf = counts(r);
                eight(Row::new(), cdf).u(r.below(7))
            }),
        // the only light of a scene
        light("light_choice", "light/choice/one")
            .also(&["light_pmf"])
            .glsl("uint light = light_choice(in_u()); out_u(light); out_f(light_pmf(light));")
            .rust(|i, o| {
                let cdf = [0, 1 << 24];
                let light = cdf_choice(&cdf, i.u());
                o.u(light);
                o.f(cdf_probability(&cdf, light));
            })
            .seeded(20, |r| Row::new().u(u24(r))),
    ]
}

/// A sphere and a point inside, on, near and far away from it.
fn sphere_and_point(r: &mut Rng) -> Row {
    let radius = r.log_range(1e-5, 1e5);
    let centre = r.vec3(-radius, radius);
    let away = [0.0, r.unit(), 1.0, 1.000_001, 1.1, 15_000.0][r.below(6) as usize];
    let p = centre + r.direction() * (radius * away);
    Row::new().vec3(p).vec3(centre).f(radius)
}

fn spheres() -> Vec<Twin> {
    let read = "vec3 p = in_vec3(); vec3 centre = in_vec3(); float radius = in_f();";
    vec![
        light("sphere_light_sample", "light/sphere")
            .glsl(&format!(
                "{read} LightSample s = sphere_light_sample(p, centre, radius, in_vec2()); {OUT_SAMPLE}"
            ))
            .rust(|i, o| {
                let (p, centre, radius) = (i.vec3(), i.vec3(), i.f());
                out_sample(sphere_light_sample(p, centre, radius, i.vec2()), o);
            })
            .seeded(4000, |r| sphere_and_point(r).vec2(uniforms(r))),
        light("sphere_light_pdf", "light/sphere")
            .glsl(&format!(
                "{read} float t = in_f(); out_f(sphere_light_pdf(p, centre, radius, t, in_f()));"
            ))
            .rust(|i, o| {
                let (p, centre, radius, t) = (i.vec3(), i.vec3(), i.f(), i.f());
                o.f(sphere_light_pdf(p, centre, radius, t, i.f()));
            })
            .seeded(2000, |r| sphere_and_point(r).f(r.log_range(1e-5, 1e5)).f(r.unit())),
        light("sphere_density", "light/sphere")
            .glsl("out_f(sphere_density(in_f()));")
            .rust(|i, o| o.f(sphere_density(i.f())))
            .edge([0.0])
            .seeded(100, |r| Row::from([r.log_range(1e-5, 1e5)])),
    ]
}

fn cones() -> Vec<Twin> {
    let apart = |r: &mut Rng| {
        let radius = r.log_range(1e-5, 1e5);
        [radius, radius * (1.0 + r.log_range(1e-6, 1e9))]
    };
    vec![
        light("cone_height", "light/sphere")
            .glsl("float r = in_f(); out_f(cone_height(r, in_f()));")
            .rust(|i, o| {
                let r = i.f();
                o.f(cone_height(r, i.f()));
            })
            .edge([1.0, 1.000_000_1])
            .edge([1e-5, 1e12])
            .seeded(1000, move |r| apart(r).into()),
        light("cone_pdf", "light/sphere")
            .glsl("out_f(cone_pdf(in_f()));")
            .rust(|i, o| o.f(cone_pdf(i.f())))
            .edges([0.0, 1e-40, 1e-36, 1.0].map(|x| Row::from([x]))),
        light("cone_sample", "light/sphere")
            .also(&["cone_direction"])
            .glsl(&format!(
                "vec3 axis = in_vec3(); float d = in_f(); float r = in_f();
                 LightSample s = cone_sample(axis, d, r, in_vec2()); {OUT_SAMPLE}"
            ))
            .rust(|i, o| {
                let (axis, d, r) = (i.vec3(), i.f(), i.f());
                out_sample(cone_sample(axis, d, r, i.vec2()), o);
            })
            .seeded(2000, move |r| {
                let [radius, d] = apart(r);
                Row::new()
                    .vec3(r.direction() * d)
                    .f(d)
                    .f(radius)
                    .vec2(uniforms(r))
            }),
    ]
}

/// A box and a point that is below, within, on the plane of, or above it along each axis.
fn box_and_point(r: &mut Rng) -> Row {
    let size = r.log_range(1e-5, 1e5);
    let lo = r.vec3(-size, size);
    let hi = lo + r.vec3(0.01 * size, size);
    let mut place = |lo: f32, hi: f32| {
        let inside = r.range(lo, hi);
        [lo - size, lo, inside, inside, hi, hi + size * r.unit()][r.below(6) as usize]
    };
    let p = vec3(place(lo.x, hi.x), place(lo.y, hi.y), place(lo.z, hi.z));
    Row::new().vec3(p).vec3(lo).vec3(hi)
}

fn boxes() -> Vec<Twin> {
    let read = "vec3 p = in_vec3(); vec3 lo = in_vec3(); vec3 hi = in_vec3();";
    vec![
        light("faces_seen", "light/box")
            .glsl(&format!("{read} out_vec3(faces_seen(p, lo, hi));"))
            .rust(|i, o| o.vec3(faces_seen(i.vec3(), i.vec3(), i.vec3())))
            .seeded(1000, box_and_point),
        light("face_areas", "light/box")
            .glsl("out_vec3(face_areas(in_vec3()));")
            .rust(|i, o| o.vec3(face_areas(i.vec3())))
            .seeded(100, |r| Row::new().vec3(r.vec3(0.0, 9.0))),
        light("upper_face", "light/box")
            .glsl(
                "float p = in_f(); float lo = in_f(); float faces = in_f(); float area = in_f();
                 out_b(upper_face(p, lo, faces, area, in_f()));",
            )
            .rust(|i, o| {
                let (p, lo, faces, area) = (i.f(), i.f(), i.f(), i.f());
                o.b(upper_face(p, lo, faces, area, i.f()));
            })
            .seeded(200, |r| {
                let faces = r.below(3) as f32;
                Row::from([r.unit(), r.unit(), faces, 0.5, r.unit()])
            }),
        light("box_light_sample", "light/box")
            .glsl(&format!(
                "{read} uint u24 = in_u(); LightSample s = box_light_sample(p, lo, hi, u24, in_vec2()); {OUT_SAMPLE}"
            ))
            .rust(|i, o| {
                let (p, lo, hi, u24) = (i.vec3(), i.vec3(), i.vec3(), i.u());
                out_sample(box_light_sample(p, lo, hi, u24, i.vec2()), o);
            })
            // without extent
            .edge(Row::new().vec3(Vec3::one()).vec3(Vec3::zero()).vec3(Vec3::zero()).u(0).vec2([0.5; 2]))
            .seeded(4000, |r| box_and_point(r).u(u24(r)).vec2(uniforms(r))),
        light("box_light_pdf", "light/box")
            .glsl(&format!("{read} float t = in_f(); out_f(box_light_pdf(p, lo, hi, t, in_f()));"))
            .rust(|i, o| {
                let (p, lo, hi, t) = (i.vec3(), i.vec3(), i.vec3(), i.f());
                o.f(box_light_pdf(p, lo, hi, t, i.f()));
            })
            .seeded(2000, |r| box_and_point(r).f(r.log_range(1e-5, 1e5)).f(r.unit())),
    ]
}

/// A point about a cylinder of `size`, inside, on a cap's plane, on the axis or elsewhere; then the cylinder.
fn point_and_cylinder(r: &mut Rng) -> Row {
    let size = r.log_range(1e-5, 1e5);
    let (row, middle) = cylinder(r, size);
    let away = [0.0, 0.1, 1.0, 5.0][r.below(4) as usize] * size;
    let p = middle + r.direction() * away;
    let mut all = Row::new().vec3(p);
    all.0.extend(row.0);
    all
}

fn cylinders() -> Vec<Twin> {
    let on = |name: &'static str| light(name, "light/cylinder").prelude(device::Cylinder::glsl());
    vec![
        on("cylinder_area")
            .glsl(
                "vec3 p = in_vec3(); float r = in_f(); CylinderArea a = cylinder_area(p, r, in_f());
                 out_f(a.side); out_f(a.base); out_f(a.top); out_b(a.inside);",
            )
            .rust(|i, o| {
                let (p, r) = (i.vec3(), i.f());
                let a = cylinder_area(p, r, i.f());
                o.f(a.side);
                o.f(a.base);
                o.f(a.top);
                o.b(a.inside);
            })
            .edge([1.0, 0.0, 0.0, 1.0, 2.0])
            .edge([0.0, 0.0, 2.0, 1.0, 2.0])
            .seeded(1000, |r| Row::new().vec3(r.vec3(-3.0, 3.0)).f(r.unit()).f(r.unit())),
        on("cylinder_light_sample")
            .glsl(&format!(
                "vec3 p = in_vec3(); {CYLINDER} uint u24 = in_u();
                 LightSample s = cylinder_light_sample(p, cylinder, u24, in_vec2()); {OUT_SAMPLE}"
            ))
            .rust(|i, o| {
                let (p, cylinder, u24) = (i.vec3(), read_cylinder(i), i.u());
                out_sample(cylinder_light_sample(p, &cylinder, u24, i.vec2()), o);
            })
            .seeded(4000, |r| point_and_cylinder(r).u(u24(r)).vec2(uniforms(r))),
        on("cylinder_light_pdf")
            .glsl(&format!(
                "vec3 p = in_vec3(); {CYLINDER} float t = in_f(); out_f(cylinder_light_pdf(p, cylinder, t, in_f()));"
            ))
            .rust(|i, o| {
                let (p, cylinder, t) = (i.vec3(), read_cylinder(i), i.f());
                o.f(cylinder_light_pdf(p, &cylinder, t, i.f()));
            })
            .seeded(2000, |r| point_and_cylinder(r).f(r.log_range(1e-5, 1e5)).f(r.unit())),
    ]
}

/// Seven triangles that come after two others, and a table that comes after one entry.
const MESH: &str = "
vec3 corners[21];
vec3 triangle_vertex(uint i, uint k) { return corners[3u * (i - 2u) + k]; }
";
pub const FILL_MESH: &str = "uint n = 0u;
    while (n < 8u) { triangle_cdf[n + 1u] = in_u(); n += 1u; }
    n = 0u;
    while (n < 21u) { corners[n] = in_vec3(); n += 1u; }
    vec3 p = in_vec3();";

pub struct Mesh {
    pub cdf: [u32; 8],
    /// Two of another mesh first.
    pub triangles: Vec<Triangle<f32>>,
    p: Vec3<f32>,
}

pub fn read_mesh(i: &mut In) -> Mesh {
    let cdf = read_eight(i);
    let zero = Triangle {
        v: [Vec3::zero(); 3],
        shape: 0,
    };
    let own = (0..7).map(|_| Triangle {
        v: [i.vec3(), i.vec3(), i.vec3()],
        shape: 1,
    });
    let triangles = [zero; 2].into_iter().chain(own).collect();
    Mesh {
        cdf,
        triangles,
        p: i.vec3(),
    }
}

pub fn mesh_row(r: &mut Rng) -> (Row, [u32; 8]) {
    let size = r.log_range(1e-5, 1e5);
    let cdf = counts(r);
    let row = (0..7).fold(eight(Row::new(), cdf), |row, _| {
        let v = [0; 3].map(|_| r.vec3(-size, size));
        // One in eight without area.
        let last = if r.below(8) == 0 { v[0] } else { v[2] };
        row.vec3(v[0]).vec3(v[1]).vec3(last)
    });
    (row.vec3(r.vec3(-2.0 * size, 2.0 * size)), cdf)
}

/// A function of a mesh: [`MESH`] declares its input.
pub fn mesh(name: &'static str, file: &'static str) -> Twin {
    light(name, file)
        .prelude("uint triangle_cdf[9];\n")
        .slot("triangles", Slot::Text(MESH.into()))
}

fn meshes() -> Vec<Twin> {
    let on = |name: &'static str| mesh(name, "light/mesh");
    vec![
        on("triangle_choice")
            .glsl(&format!("{FILL_MESH} out_u(triangle_choice(1u, 7u, in_u()));"))
            .rust(|i, o| {
                let m = read_mesh(i);
                o.u(cdf_choice(&m.cdf, i.u()));
            })
            .seeded(500, |r| {
                let (row, cdf) = mesh_row(r);
                row.u(near_entry(r, cdf))
            }),
        on("triangle_pmf")
            .glsl(&format!("{FILL_MESH} out_f(triangle_pmf(1u, in_u()));"))
            .rust(|i, o| {
                let m = read_mesh(i);
                o.f(cdf_probability(&m.cdf, i.u()));
            })
            .seeded(200, |r| mesh_row(r).0.u(r.below(7))),
        on("mesh_light_sample")
            .glsl(&format!(
                "{FILL_MESH} uint u24 = in_u();
                 LightSample s = mesh_light_sample(p, 2u, 7u, 1u, u24, in_vec2()); {OUT_SAMPLE}"
            ))
            .rust(|i, o| {
                let m = read_mesh(i);
                let u24 = i.u();
                out_sample(mesh_light_sample(m.p, &m.triangles, 2, &m.cdf, u24, i.vec2()), o);
            })
            .seeded(4000, |r| {
                let (row, cdf) = mesh_row(r);
                row.u(near_entry(r, cdf)).vec2(uniforms(r))
            }),
        on("mesh_light_pdf")
            .glsl(&format!(
                "{FILL_MESH} uint prim = in_u(); float t = in_f(); out_f(mesh_light_pdf(2u, 1u, prim, t, in_f()));"
            ))
            .rust(|i, o| {
                let m = read_mesh(i);
                let (prim, t) = (i.u(), i.f());
                o.f(mesh_light_pdf(&m.triangles, 2, &m.cdf, prim, t, i.f()));
            })
            .seeded(1000, |r| {
                let row = mesh_row(r).0;
                row.u(2 + r.below(7)).f(r.log_range(1e-5, 1e5)).f(r.unit())
            }),
    ]
}
