//! The contributions of a sample's paths, class by class.

use glam::DVec3;

use super::shares::Shares;
use super::surface::Surface;
use crate::path_class::PathClass;
use crate::reference::math::Vec3;

/// The contribution of one class to a pixel.
pub struct Share {
    /// row · width + column of the full picture.
    pub pixel: u32,
    /// Number of the class.
    pub class: usize,
    pub value: DVec3,
}

/// The light of one sample, split.
pub struct Sample<'a> {
    classes: &'a [PathClass],
    shares: Shares,
    /// To its own pixel, a value a class.
    pub own: Vec<DVec3>,
    /// From light paths, to any pixel.
    elsewhere: Vec<Share>,
}

impl<'a> Sample<'a> {
    /// No light yet.
    pub fn new(classes: &'a [PathClass]) -> Self {
        Self {
            classes,
            shares: Shares::default(),
            own: vec![DVec3::ZERO; classes.len()],
            elsewhere: Vec::new(),
        }
    }

    /// Adds light that has met these surfaces, listed from the eye on, and reaches the sample's own pixel.
    pub fn add<'s>(
        &mut self,
        light: Vec3<f32>,
        surfaces: impl Iterator<Item = &'s Surface> + Clone,
    ) {
        if light == Vec3::zero() {
            return;
        }
        for (sum, class) in self.own.iter_mut().zip(self.classes) {
            *sum += light.f64() * self.shares.of(class, surfaces.clone());
        }
    }

    /// The same for light that reaches another pixel.
    pub fn splat<'s>(
        &mut self,
        pixel: u32,
        light: Vec3<f32>,
        surfaces: impl Iterator<Item = &'s Surface> + Clone,
    ) {
        for (number, class) in self.classes.iter().enumerate() {
            let value = light.f64() * self.shares.of(class, surfaces.clone());
            if value != DVec3::ZERO {
                self.elsewhere.push(Share {
                    pixel,
                    class: number,
                    value,
                });
            }
        }
    }

    /// All of it; `pixel` is its own.
    pub fn shares(self, pixel: u32) -> impl Iterator<Item = Share> {
        let own = self.own.into_iter().enumerate();
        let own = own.filter(|(_, value)| *value != DVec3::ZERO);
        let own = own.map(move |(class, value)| Share {
            pixel,
            class,
            value,
        });
        self.elsewhere.into_iter().chain(own)
    }
}
