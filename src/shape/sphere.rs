//! Spheres.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Body, Bounds, Description, Primitive, Space};
use crate::layout::GpuStruct;

crate::layout::record! {
    /// A ball: { p : |p − centre| ≤ radius }.
    pub struct Sphere<F> {
        centre: vec3,
        radius: float,
        /// Index of its shape.
        shape: uint,
        (pad0: uint),
        (pad1: uint),
        (pad2: uint),
    }
}

pub const DESCRIPTION: Description = Description {
    name: "sphere",
    primitives: ["sphere", "spheres"],
    array: "spheres",
    ty: "Sphere",
    declaration: Some(device::Sphere::glsl),
    element: "spheres[{i}]",
    once: None,
    nearer_file: "shape/linear/sphere",
    nearer: "nearer_sphere(ray, skip, {best}, {x})",
    surface_file: "shape/sphere",
    surface: "sphere_surface(ray, hit, {x})",
    face_file: "shape/face/sphere",
    face_point: "sphere_face_point()",
    light_file: "light/sphere",
    light_sample: "sphere_light_sample(p, {x}.centre, {x}.radius, u)",
    light_pdf: "sphere_light_pdf(p, {x}.centre, {x}.radius, distance, cosine)",
    emission_file: "light/emission/sphere",
    emission: "sphere_emission({x}.centre, {x}.radius, u)",
    emission_pdf: "sphere_emission_pdf(p, {x}.centre, {x}.radius)",
};

impl Body for Sphere {
    fn bounds(&self) -> Bounds {
        self.extent()
    }

    fn contains(&self, p: DVec3) -> bool {
        p.distance(self.centre) < self.radius
    }

    fn areas(&self) -> Vec<f64> {
        vec![4.0 * PI * self.radius.powi(2)]
    }

    fn thickness(&self) -> f64 {
        2.0 * self.radius
    }

    fn distance(&self, p: DVec3) -> Option<f64> {
        Some((p.distance(self.centre) - self.radius).abs())
    }

    fn overlaps_ball(&self, centre: DVec3, radius: f64) -> bool {
        centre.distance(self.centre) < radius + self.radius
    }

    fn ball(&self) -> Option<(DVec3, f64)> {
        Some((self.centre, self.radius))
    }
}

impl Primitive for Sphere {
    /// centre ± radius
    fn extent(&self) -> Bounds {
        Bounds::around([self.centre - self.radius, self.centre + self.radius])
    }

    fn extent_in_f32(&self) -> Bounds {
        scalar::Sphere::rounded(self, |x| x as f32)
            .widened(f64::from)
            .extent()
    }

    fn move_to(&mut self, space: &Space) {
        (self.centre, self.radius) = (space.point(self.centre), space.length(self.radius));
    }

    fn enlarge(&mut self, least: f64) {
        self.radius = self.radius.max(least);
    }
}
