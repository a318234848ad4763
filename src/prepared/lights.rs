//! The table of emitters, and the integer tables for choosing among them.

use std::f64::consts::PI;

use glam::DVec3;

use super::cdf::{CdfError, quantised_cdf};
use super::placed::Placed;
use super::{Light, LightKind, Material, NONE, Shape, ShapeKind};

/// Everything outside, as a light.
#[derive(Clone, Copy, Debug)]
pub struct Outside {
    pub kind: LightKind,
    /// The radiance of its record: the factor on a picture.
    pub radiance: DVec3,
    /// Mean over all directions.
    pub mean: DVec3,
}

/// Emitters and the probabilities of choosing them.
#[derive(Debug, Default)]
pub struct Lights {
    pub lights: Vec<Light>,
    pub light_cdf: Vec<u32>,
    pub triangle_cdf: Vec<u32>,
}

impl Lights {
    /// One light per shape of positive radiance, in the order of shapes, then everything outside if it emits.
    ///
    /// A light is chosen in proportion to its power π·A·L̄. Everything outside counts as the sphere around the scene,
    /// through whose area the same power passes.
    pub fn new(
        placed: &Placed,
        materials: &[Material],
        outside: Outside,
    ) -> Result<Self, CdfError> {
        let mut all = Self::default();
        let mut power = Vec::new();
        for (i, shape) in placed.shapes.iter().enumerate() {
            let radiance = materials[shape.material as usize].radiance;
            let areas = placed.body(shape).areas();
            let area: f64 = areas.iter().sum();
            if radiance.max_element() > 0.0 && area > 0.0 {
                all.add(shape, i as u32, radiance, &areas)?;
                power.push(area * radiance.element_sum());
            }
        }
        if outside.mean.max_element() > 0.0 {
            all.lights.push(Light {
                kind: outside.kind,
                shape: NONE,
                first: 0,
                count: 0,
                cdf: 0,
                radiance: outside.radiance,
            });
            let radius = placed.all_bounds(DVec3::ZERO).radius();
            power.push(4.0 * PI * radius * radius * outside.mean.element_sum());
        }
        // A scene without extent is lit by its background alone.
        if power == [0.0] {
            power = vec![1.0];
        }
        if !power.is_empty() {
            all.light_cdf = quantised_cdf(&power)?;
        }
        Ok(all)
    }

    /// Adds one emitting shape; `areas` are those of its primitives.
    fn add(
        &mut self,
        shape: &Shape,
        index: u32,
        radiance: DVec3,
        areas: &[f64],
    ) -> Result<(), CdfError> {
        let cdf = self.triangle_cdf.len() as u32;
        if shape.kind == ShapeKind::Mesh {
            self.triangle_cdf.extend(quantised_cdf(areas)?);
        }
        self.lights.push(Light {
            kind: shape.kind.into(),
            shape: index,
            first: shape.first,
            count: shape.count,
            cdf,
            radiance,
        });
        Ok(())
    }
}
