//! Twins of `shaders/shape/`.

mod cover;
mod linear;
mod ray;
mod solids;
mod triangles;

use vkpt::kernel::Slot;
use vkpt::layout::{self, GpuStruct};
use vkpt::prepared::NONE;
use vkpt::reference::math::{Real, Vec3};
use vkpt::reference::shape::{Hit, Ray, Surface};

use super::harness::{In, Out, Rng, Row, Twin};

pub use solids::{CYLINDER, cylinder, read_cylinder};

pub fn twins() -> Vec<Twin> {
    [
        ray::twins(),
        solids::twins(),
        triangles::twins(),
        linear::twins(),
        cover::twins(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Declarations of every kernel.
pub fn prelude() -> String {
    layout::Ray::glsl()
}

/// For shapes of which no two faces coincide.
fn no_cover() -> Slot {
    let never = |kind: &str| {
        format!(
            "bool {kind}_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) {{ return false; }}\n"
        )
    };
    Slot::Text(
        "// uses: shape/ray\n".to_owned()
            + &["box", "sphere", "cylinder", "mesh"].map(never).concat(),
    )
}

/// Reads a ray, writes a hit, writes a surface.
const READ_RAY: &str =
    "Ray ray = Ray(in_vec3(), FAR, in_vec3(), in_u(), in_u(), in_u(), in_f(), NONE);";
const READ_HIT: &str = "Hit hit = Hit(in_f(), in_u(), in_u(), in_vec2());";
const OUT_HIT: &str = "out_f(found.t); out_u(found.shape); out_u(found.prim); out_vec2(found.uv);";
const OUT_SURFACE: &str = "out_vec3(at.p); out_vec3(at.ng); out_vec3(at.ns);";

fn read_ray(i: &mut In) -> Ray<f32> {
    let o = i.vec3();
    let ray = Ray::new(o, i.vec3());
    Ray {
        shape: i.u(),
        prim: i.u(),
        start: i.u(),
        t_self: i.f(),
        ..ray
    }
}

fn read_hit(i: &mut In) -> Hit<f32> {
    Hit {
        t: i.f(),
        shape: i.u(),
        prim: i.u(),
        uv: i.vec2(),
    }
}

fn out_hit(hit: Hit<f32>, o: &mut Out) {
    o.f(hit.t);
    o.u(hit.shape);
    o.u(hit.prim);
    o.vec2(hit.uv);
}

fn out_surface(at: Surface<f32>, o: &mut Out) {
    o.vec3(at.p);
    o.vec3(at.ng);
    o.vec3(at.ns);
}

impl Row {
    fn ray(self, o: Vec3<f32>, d: Vec3<f32>, on: [u32; 3], t_self: f32) -> Self {
        self.vec3(o).vec3(d).u(on[0]).u(on[1]).u(on[2]).f(t_self)
    }
    fn hit(self, t: f32, shape: u32, prim: u32, uv: [f32; 2]) -> Self {
        self.f(t).u(shape).u(prim).vec2(uv)
    }
}

/// A size from 1e-5 to 1e5.
fn scale(r: &mut Rng) -> f32 {
    r.log_range(1e-5, 1e5)
}

/// A ray from up to ten sizes away that goes near `target`; one in eight along an axis, one from the target itself.
fn aimed(r: &mut Rng, target: Vec3<f32>, size: f32) -> (Vec3<f32>, Vec3<f32>) {
    let away = r.direction() * (size * r.log_range(0.01, 10.0));
    let o = if r.below(8) == 0 {
        target
    } else {
        target + away
    };
    let aim = target.f64() + r.vec3(-size, size).f64() - o.f64();
    let d = match r.below(8) {
        0 => [glam::DVec3::X, -glam::DVec3::Y, glam::DVec3::Z][r.below(3) as usize],
        _ => aim.normalize_or(glam::DVec3::X),
    };
    (o, Vec3::new(d))
}

/// A shape number: one of a few, or none.
fn some_shape(r: &mut Rng) -> u32 {
    [0, 1, 2, NONE][r.below(4) as usize]
}

/// The nearest `f32`, which keeps rows the same words for both sides.
fn narrow(x: f64) -> f32 {
    f32::new(x)
}
