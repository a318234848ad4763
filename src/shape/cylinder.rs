//! Capped cylinders.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::{Body, Bounds, Description, Primitive, Space};
use crate::layout::GpuStruct;

crate::layout::record! {
    /// The solid { base + x u + y v + z w : x² + y² ≤ radius², 0 ≤ z ≤ height }, (u, v, w) orthonormal.
    pub struct Cylinder<F> {
        /// Centre of the base disc.
        base: vec3,
        height: float,
        u: vec3,
        radius: float,
        v: vec3,
        /// Index of its shape.
        shape: uint,
        /// Axis.
        w: vec3,
        (pad0: float),
    }
}

pub const DESCRIPTION: Description = Description {
    name: "cylinder",
    primitives: ["cylinder", "cylinders"],
    array: "cylinders",
    ty: "Cylinder",
    declaration: Some(device::Cylinder::glsl),
    element: "cylinders[{i}]",
    once: None,
    nearer_file: "shape/linear/cylinder",
    nearer: "nearer_cylinder(ray, skip, {best}, {x})",
    surface_file: "shape/cylinder",
    surface: "cylinder_surface(ray, hit, {x})",
    face_file: "shape/face/cylinder",
    face_point: "cylinder_face_point({x}, face.prim, p)",
    light_file: "light/cylinder",
    light_sample: "cylinder_light_sample(p, {x}, u24, u)",
    light_pdf: "cylinder_light_pdf(p, {x}, distance, cosine)",
    emission_file: "light/emission/cylinder",
    emission: "cylinder_emission({x}, u24, u)",
    emission_pdf: "cylinder_emission_pdf(p, {x})",
};

impl Cylinder {
    /// The cylinder whose axis starts at the centre of the base and is as long as the height.
    pub fn new(base: DVec3, axis: DVec3, radius: f64, shape: u32) -> Self {
        let w = axis.normalize();
        let (u, v) = w.any_orthonormal_pair();
        Self {
            base,
            u,
            v,
            w,
            height: axis.length(),
            radius,
            shape,
        }
    }

    /// Cylindrical coordinates of `p`: distance from the axis, height above the base.
    fn about_axis(&self, p: DVec3) -> (f64, f64) {
        let d = p - self.base;
        let z = d.dot(self.w);
        ((d - self.w * z).length(), z)
    }
}

impl Body for Cylinder {
    /// The boxes around the two end discs: a disc of normal w extends r·√(1 − w_k²) along axis k.
    fn bounds(&self) -> Bounds {
        let one_minus_w2 = (DVec3::ONE - self.w * self.w).max(DVec3::ZERO);
        let reach = one_minus_w2.map(f64::sqrt) * self.radius;
        let (base, top) = (self.base, self.base + self.w * self.height);
        Bounds::around([base - reach, base + reach, top - reach, top + reach])
    }

    fn contains(&self, p: DVec3) -> bool {
        let (rho, z) = self.about_axis(p);
        z > 0.0 && z < self.height && rho < self.radius
    }

    fn areas(&self) -> Vec<f64> {
        vec![2.0 * PI * self.radius * (self.radius + self.height)]
    }

    fn thickness(&self) -> f64 {
        self.height.min(2.0 * self.radius)
    }

    fn distance(&self, p: DVec3) -> Option<f64> {
        let (rho, z) = self.about_axis(p);
        let half = 0.5 * self.height;
        let beyond = DVec2::new(rho - self.radius, (z - half).abs() - half);
        Some((beyond.max(DVec2::ZERO).length() + beyond.max_element().min(0.0)).abs())
    }
}

impl Primitive for Cylinder {
    /// The boxes around the two end discs: a disc of radius r spanned by the unit vectors u and v extends r √(uᵢ² +
    /// vᵢ²) along axis i.
    fn extent(&self) -> Bounds {
        let axis = Bounds::around([self.base, self.base + self.w * self.height]);
        let disc = (self.u * self.u + self.v * self.v).map(f64::sqrt) * self.radius;
        Bounds {
            lo: axis.lo - disc,
            hi: axis.hi + disc,
        }
    }

    fn extent_in_f32(&self) -> Bounds {
        scalar::Cylinder::rounded(self, |x| x as f32)
            .widened(f64::from)
            .extent()
    }

    fn move_to(&mut self, space: &Space) {
        self.base = space.point(self.base);
        (self.height, self.radius) = (space.length(self.height), space.length(self.radius));
    }

    fn enlarge(&mut self, least: f64) {
        (self.radius, self.height) = (self.radius.max(least), self.height.max(least));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tilted cylinder: points on its rims, sampled on a fine grid, fill both boxes to within the grid.
    #[test]
    fn boxes_are_tight() {
        let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0 * 2.5;
        let cylinder = Cylinder::new(DVec3::new(0.3, -0.2, 5.0), axis, 0.75, 0);
        let rim = |k: u32| {
            let (s, c) = (f64::from(k) * 1e-5 * std::f64::consts::TAU).sin_cos();
            cylinder.base + (cylinder.u * c + cylinder.v * s) * cylinder.radius
        };
        let seen = Bounds::around((0..100_000).flat_map(|k| [rim(k), rim(k) + axis]));
        for (bounds, bound) in [
            (cylinder.bounds(), 1e-8),
            (cylinder.extent(), 1e-8),
            (cylinder.extent_in_f32(), 1e-6),
        ] {
            assert!(bounds.lo.abs_diff_eq(seen.lo, bound), "{bounds:?} {seen:?}");
            assert!(bounds.hi.abs_diff_eq(seen.hi, bound), "{bounds:?} {seen:?}");
        }
    }
}
