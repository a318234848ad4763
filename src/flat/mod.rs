//! Prepared scene → the GPU's buffers. What a buffer holds does not depend on the kernel that reads it; the
//! caller, who knows the features, asks only for those that are needed.

pub mod bvh;

use glam::DVec3;

use crate::layout;
use crate::prepared::Prepared;

fn f32x3(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}

fn f32x2(v: [f64; 2]) -> [f32; 2] {
    v.map(|x| x as f32)
}

pub fn camera(prepared: &Prepared, seed: u32) -> layout::Camera {
    let c = &prepared.camera;
    layout::Camera {
        eye: f32x3(c.eye),
        width: prepared.width,
        right: f32x3(c.right),
        height: prepared.height,
        up: f32x3(c.up),
        seed,
        forward: f32x3(c.forward),
        pad0: 0,
    }
}

pub fn materials(prepared: &Prepared) -> Vec<layout::Material> {
    let material = |m: &crate::prepared::Material| layout::Material {
        kd: f32x3(m.kd),
        kd_mean: m.kd_mean as f32,
        f0: f32x3(m.f0),
        alpha: m.alpha as f32,
        sigma: f32x3(m.sigma),
        width: m.width as f32,
        radiance: f32x3(m.radiance),
        p_d: m.p_d as f32,
        eta: f32x2(m.eta),
        one_minus_eta2: f32x2(m.one_minus_eta2),
        d: f32x2(m.d),
        p_r: m.p_r as f32,
        kind: m.kind as u32,
        distribution: m.distribution as u32,
        fresnel: m.fresnel as u32,
        pad0: 0,
        pad1: 0,
    };
    prepared.materials.iter().map(material).collect()
}

pub fn shapes(prepared: &Prepared) -> Vec<layout::Shape> {
    let shape = |s: &crate::prepared::Shape| layout::Shape {
        kind: s.kind as u32,
        first: s.first,
        count: s.count,
        material: s.material,
        light: s.light,
        pad0: 0,
        pad1: 0,
        pad2: 0,
    };
    prepared.shapes.iter().map(shape).collect()
}

pub fn spheres(prepared: &Prepared) -> Vec<layout::Sphere> {
    let sphere = |s: &crate::prepared::Sphere| layout::Sphere {
        centre: f32x3(s.centre),
        radius: s.radius as f32,
        shape: s.shape,
        pad0: 0,
        pad1: 0,
        pad2: 0,
    };
    prepared.spheres.iter().map(sphere).collect()
}

pub fn boxes(prepared: &Prepared) -> Vec<layout::Cuboid> {
    let cuboid = |b: &crate::prepared::Cuboid| layout::Cuboid {
        lo: f32x3(b.lo),
        shape: b.shape,
        hi: f32x3(b.hi),
        pad0: 0,
    };
    prepared.boxes.iter().map(cuboid).collect()
}

pub fn cylinders(prepared: &Prepared) -> Vec<layout::Cylinder> {
    let cylinder = |c: &crate::prepared::Cylinder| layout::Cylinder {
        base: f32x3(c.base),
        height: c.height as f32,
        u: f32x3(c.u),
        radius: c.radius as f32,
        v: f32x3(c.v),
        shape: c.shape,
        w: f32x3(c.w),
        pad0: 0.0,
    };
    prepared.cylinders.iter().map(cylinder).collect()
}

/// Nine floats a triangle: its corners.
pub fn triangles(prepared: &Prepared) -> Vec<[[f32; 3]; 3]> {
    prepared.triangles.iter().map(|t| t.v.map(f32x3)).collect()
}

/// The shape of each triangle.
pub fn triangle_shapes(prepared: &Prepared) -> Vec<u32> {
    prepared.triangles.iter().map(|t| t.shape).collect()
}

/// Nine floats a triangle: the shading normals of its corners; zero where its mesh gives none.
pub fn normals(prepared: &Prepared) -> Vec<[[f32; 3]; 3]> {
    prepared.normals.iter().map(|n| n.map(f32x3)).collect()
}

pub fn lights(prepared: &Prepared) -> Vec<layout::Light> {
    let light = |l: &crate::prepared::Light| layout::Light {
        radiance: f32x3(l.radiance),
        kind: l.kind as u32,
        shape: l.shape,
        first: l.first,
        count: l.count,
        cdf: l.cdf,
    };
    prepared.lights.iter().map(light).collect()
}
