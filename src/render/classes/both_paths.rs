//! A sample of light tracing or of bidirectional path tracing, class by class. Light paths are read backwards: a string
//! begins at the eye.

use super::sample::Sample;
use super::surface::Surface;
use crate::path_class::PathClass;
use crate::reference::integrator::bidirectional::joint::Joint;
use crate::reference::integrator::bidirectional::record::{Far, Recorder};
use crate::reference::integrator::light::{self, Splat};
use crate::reference::math::{Vec3, length3};
use crate::reference::path::Subpath;
use crate::reference::path::blocks::Origin;
use crate::reference::path::vertex::Vertex;
use crate::settings::Settings;

/// Both paths so far, and the light that they have found.
pub struct BothPaths<'a> {
    settings: &'a Settings,
    adjoint: &'a Settings,
    /// The vertices that each path has left.
    eye: Vec<Surface>,
    light: Vec<Surface>,
    /// The last vertex of either path.
    at: Option<Joint<f32>>,
    pub sample: Sample<'a>,
}

impl<'a> BothPaths<'a> {
    /// No path yet; `adjoint` are the settings of light paths.
    pub fn new(settings: &'a Settings, adjoint: &'a Settings, classes: &'a [PathClass]) -> Self {
        Self {
            settings,
            adjoint,
            eye: Vec::new(),
            light: Vec::new(),
            at: None,
            sample: Sample::new(classes),
        }
    }
}

/// The direction from a vertex to a point.
fn direction(from: &Vertex<f32>, to: Vec3<f32>) -> Vec3<f32> {
    let way = to - from.p;
    way / length3(way)
}

impl Recorder<f32> for BothPaths<'_> {
    fn hit(&mut self, _: Origin, x: &Joint<f32>) {
        self.at = Some(*x);
    }

    fn emission(&mut self, _: Option<&Joint<f32>>, _: &Subpath<f32>, seen: Vec3<f32>) {
        self.sample.add(seen, self.eye.iter());
    }

    fn connection(&mut self, far: Far<f32>, arrived: Option<Vec3<f32>>) {
        let (Some(Joint { v, .. }), Some(light)) = (&self.at, arrived) else {
            return;
        };
        match far {
            Far::Eye { pixel, point } => {
                let first = Surface::towards(self.adjoint, v, direction(v, point));
                let surfaces = [&first].into_iter().chain(self.light.iter().rev());
                self.sample.splat(pixel, light, surfaces);
            }
            Far::Light(candidate) => {
                let last = Surface::towards(self.settings, v, candidate.point.wi);
                self.sample.add(light, self.eye.iter().chain([&last]));
            }
            Far::Vertex(y) => {
                let ends = [
                    Surface::towards(self.settings, v, direction(v, y.v.p)),
                    Surface::towards(self.adjoint, &y.v, direction(&y.v, v.p)),
                ];
                // The light's point is counted, and so is y.
                let before = &self.light[..y.count as usize - 2];
                let surfaces = self.eye.iter().chain(&ends).chain(before.iter().rev());
                self.sample.add(light, surfaces);
            }
        }
    }

    fn scattered(&mut self, from: Origin, path: &Subpath<f32>, lobe: u32) {
        let Some(Joint { v, .. }) = &self.at else {
            return;
        };
        let (surfaces, settings) = match from {
            Origin::Eye => (&mut self.eye, self.settings),
            Origin::Light => (&mut self.light, self.adjoint),
        };
        surfaces.push(Surface::left(settings, v, path.ray.d, lobe));
    }
}

impl light::record::Recorder<f32> for BothPaths<'_> {
    fn splat(&mut self, from: Option<(&Vertex<f32>, Vec3<f32>)>, splat: Splat<f32>) {
        let first = from.map(|(v, wi)| Surface::towards(self.adjoint, v, wi));
        let surfaces = first.iter().chain(self.light.iter().rev());
        self.sample.splat(splat.pixel, splat.value, surfaces);
    }

    fn scattered(&mut self, path: &Subpath<f32>, v: &Vertex<f32>, lobe: u32) {
        let left = Surface::left(self.adjoint, v, path.ray.d, lobe);
        self.light.push(left);
    }
}
