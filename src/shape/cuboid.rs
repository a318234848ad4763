//! Axis-aligned boxes.

use glam::DVec3;

use super::{Body, Bounds, Description, Primitive, Space};
use crate::layout::GpuStruct;

crate::layout::record! {
    /// An axis-aligned box: { p : lo ≤ p ≤ hi }.
    pub struct Cuboid<F> {
        lo: vec3,
        /// Index of its shape.
        shape: uint,
        hi: vec3,
        (pad0: uint),
    }
}

pub const DESCRIPTION: Description = Description {
    name: "box",
    primitives: ["box", "boxes"],
    array: "boxes",
    ty: "Cuboid",
    declaration: Some(device::Cuboid::glsl),
    element: "boxes[{i}]",
    once: None,
    nearer_file: "shape/linear/box",
    nearer: "nearer_box(ray, skip, {best}, {x})",
    surface_file: "shape/box",
    surface: "box_surface(ray, hit, {x})",
    face_file: "shape/face/box",
    face_point: "box_face_point({x}, face.prim, p)",
    light_file: "light/box",
    light_sample: "box_light_sample(p, {x}.lo, {x}.hi, u24, u)",
    light_pdf: "box_light_pdf(p, {x}.lo, {x}.hi, distance, cosine)",
    emission_file: "light/emission/box",
    emission: "box_emission({x}.lo, {x}.hi, u24, u)",
    emission_pdf: "box_emission_pdf(p, {x}.lo, {x}.hi)",
};

impl Cuboid {
    /// The box between any two opposite corners.
    pub fn between(a: DVec3, b: DVec3, shape: u32) -> Self {
        Self {
            lo: a.min(b),
            hi: a.max(b),
            shape,
        }
    }
}

impl Body for Cuboid {
    fn bounds(&self) -> Bounds {
        self.extent()
    }

    fn contains(&self, p: DVec3) -> bool {
        p.cmpgt(self.lo).all() && p.cmplt(self.hi).all()
    }

    fn areas(&self) -> Vec<f64> {
        let d = self.hi - self.lo;
        vec![2.0 * (d.x * d.y + d.y * d.z + d.z * d.x)]
    }

    fn thickness(&self) -> f64 {
        (self.hi - self.lo).min_element()
    }

    fn distance(&self, p: DVec3) -> Option<f64> {
        let beyond = (p - 0.5 * (self.lo + self.hi)).abs() - 0.5 * (self.hi - self.lo);
        Some((beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)).abs())
    }

    fn overlaps_ball(&self, centre: DVec3, radius: f64) -> bool {
        centre.distance(centre.clamp(self.lo, self.hi)) < radius
    }
}

impl Primitive for Cuboid {
    fn extent(&self) -> Bounds {
        Bounds::around([self.lo, self.hi])
    }

    fn extent_in_f32(&self) -> Bounds {
        scalar::Cuboid::rounded(self, |x| x as f32)
            .widened(f64::from)
            .extent()
    }

    fn move_to(&mut self, space: &Space) {
        (self.lo, self.hi) = (space.point(self.lo), space.point(self.hi));
    }
}
