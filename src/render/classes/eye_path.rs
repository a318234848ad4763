//! A sample of path tracing, class by class.

use glam::DVec3;

use super::sample::Sample;
use super::surface::Surface;
use crate::path_class::PathClass;
use crate::reference::integrator::path::PathState;
use crate::reference::integrator::path::record::Recorder;
use crate::reference::math::Vec3;
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::Vertex;
use crate::settings::Settings;

/// The path so far, and the light that it has found.
pub struct EyePath<'a> {
    settings: &'a Settings,
    /// The vertices that the path has left.
    surfaces: Vec<Surface>,
    /// The last vertex that it has reached.
    at: Option<Vertex<f32>>,
    sample: Sample<'a>,
}

impl<'a> EyePath<'a> {
    /// At the eye.
    pub fn new(settings: &'a Settings, classes: &'a [PathClass]) -> Self {
        Self {
            settings,
            surfaces: Vec::new(),
            at: None,
            sample: Sample::new(classes),
        }
    }

    /// The light of each class.
    pub fn brought(self) -> Vec<DVec3> {
        self.sample.own
    }
}

impl Recorder<f32> for EyePath<'_> {
    fn hit(&mut self, _: &PathState<f32>, v: &Vertex<f32>) {
        self.at = Some(*v);
    }

    fn emission(&mut self, seen: Vec3<f32>) {
        self.sample.add(seen, self.surfaces.iter());
    }

    fn connection(&mut self, _: &PathState<f32>, c: &ShadowRay<f32>, arrived: Option<Vec3<f32>>) {
        if let (Some(v), Some(light)) = (&self.at, arrived) {
            let last = Surface::towards(self.settings, v, c.ray.d);
            self.sample.add(light, self.surfaces.iter().chain([&last]));
        }
    }

    fn vertex(&mut self, s: &PathState<f32>, v: &Vertex<f32>, lobe: u32) {
        let left = Surface::left(self.settings, v, s.path.ray.d, lobe);
        self.surfaces.push(left);
    }

    fn escape(&mut self, _: &PathState<f32>) {}
}
