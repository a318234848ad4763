//! Twins of `shaders/light/emission/`.

use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::light::emission::{
    Emission, box_emission, box_emission_pdf, cylinder_emission, cylinder_emission_pdf,
    mesh_emission, mesh_emission_pdf, sphere_emission, sphere_emission_pdf,
};

use super::harness::{Out, Row, Twin};
use super::light::{FILL_MESH, light, mesh, mesh_row, read_mesh, u24, uniforms};
use super::shape::{CYLINDER, cylinder, read_cylinder};

const OUT_EMISSION: &str = "out_vec3(e.p); out_vec3(e.n); out_f(e.area_pdf); out_u(e.prim);";

fn out_emission(e: Emission<f32>, o: &mut Out) {
    o.vec3(e.p);
    o.vec3(e.n);
    o.f(e.area_pdf);
    o.u(e.prim);
}

pub fn twins() -> Vec<Twin> {
    vec![sphere(), cuboid(), capped(), triangles()]
}

fn sphere() -> Twin {
    light("sphere_emission", "light/emission/sphere")
        .glsl(&format!(
            "vec3 centre = in_vec3(); float radius = in_f();
             Emission e = sphere_emission(centre, radius, in_vec2()); {OUT_EMISSION}
             out_f(sphere_emission_pdf(in_vec3(), centre, radius));"
        ))
        .also(&["sphere_emission_pdf"])
        .rust(|i, o| {
            let (centre, radius) = (i.vec3(), i.f());
            out_emission(sphere_emission(centre, radius, i.vec2()), o);
            o.f(sphere_emission_pdf(i.vec3(), centre, radius));
        })
        .seeded(2000, |r| {
            let radius = r.log_range(1e-5, 1e5);
            let row = Row::new().vec3(r.vec3(-radius, radius)).f(radius);
            row.vec2(uniforms(r))
                .vec3(r.vec3(-2.0 * radius, 2.0 * radius))
        })
}

fn cuboid() -> Twin {
    light("box_emission", "light/emission/box")
        .glsl(&format!(
            "vec3 lo = in_vec3(); vec3 hi = in_vec3(); uint u24 = in_u();
             Emission e = box_emission(lo, hi, u24, in_vec2()); {OUT_EMISSION}
             out_f(box_emission_pdf(in_vec3(), lo, hi));"
        ))
        .also(&["box_emission_pdf", "is_outside"])
        .rust(|i, o| {
            let (lo, hi, u24) = (i.vec3(), i.vec3(), i.u());
            out_emission(box_emission(lo, hi, u24, i.vec2()), o);
            o.f(box_emission_pdf(i.vec3(), lo, hi));
        })
        .seeded(4000, |r| {
            let (a, b) = (r.vec3(-2.0, 2.0), r.vec3(-2.0, 2.0));
            let least = |a: f32, b: f32| if a < b { [a, b] } else { [b, a] };
            let [x, y, z] = [least(a.x, b.x), least(a.y, b.y), least(a.z, b.z)];
            let corner = |k: usize| vkpt::reference::math::vec3(x[k], y[k], z[k]);
            let row = Row::new().vec3(corner(0)).vec3(corner(1));
            row.u(u24(r)).vec2(uniforms(r)).vec3(r.vec3(-2.0, 2.0))
        })
}

fn capped() -> Twin {
    light("cylinder_emission", "light/emission/cylinder")
        .prelude(device::Cylinder::glsl())
        .glsl(&format!(
            "{CYLINDER} uint u24 = in_u();
             Emission e = cylinder_emission(cylinder, u24, in_vec2()); {OUT_EMISSION}
             out_f(cylinder_emission_pdf(in_vec3(), cylinder));"
        ))
        .also(&["cylinder_emission_pdf"])
        .rust(|i, o| {
            let (cylinder, u24) = (read_cylinder(i), i.u());
            out_emission(cylinder_emission(&cylinder, u24, i.vec2()), o);
            o.f(cylinder_emission_pdf(i.vec3(), &cylinder));
        })
        .seeded(4000, |r| {
            let size = r.log_range(1e-3, 1e3);
            let (row, _) = cylinder(r, size);
            let p = r.vec3(-2.0 * size, 2.0 * size);
            row.u(u24(r)).vec2(uniforms(r)).vec3(p)
        })
}

fn triangles() -> Twin {
    mesh("mesh_emission", "light/emission/mesh")
        .glsl(&format!(
            "{FILL_MESH} uint u24 = in_u();
             Emission e = mesh_emission(2u, 7u, 1u, u24, in_vec2()); {OUT_EMISSION}
             out_f(mesh_emission_pdf(2u, 1u, e.prim, in_vec3()));"
        ))
        .also(&["mesh_emission_pdf"])
        .rust(|i, o| {
            let (m, u24) = (read_mesh(i), i.u());
            let e = mesh_emission(&m.triangles, 2, &m.cdf, u24, i.vec2());
            out_emission(e, o);
            o.f(mesh_emission_pdf(&m.triangles, 2, &m.cdf, e.prim, i.vec3()));
        })
        .seeded(2000, |r| {
            let row = mesh_row(r).0.u(u24(r)).vec2(uniforms(r));
            row.vec3(r.direction())
        })
}
