//! Every way to find one path: its density, multiplied out vertex by vertex, and its weight by the power heuristic.
//!
//! The integrators never do this: their weights come from quantities that each path collects on its way
//! (`reference::integrator::bidirectional::partial`). This module computes the same weights directly. Veach, Robust
//! Monte Carlo Methods for Light Transport Simulation, 1997, section 10.2.

use super::chain::Chain;

/// One way to find a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Technique {
    /// Vertices from the light, including its point, and from the eye, including the eye.
    pub light: usize,
    pub eye: usize,
    /// Per area of all vertices together; for paths to the background, per solid angle of its direction.
    pub density: f64,
    pub weight: f64,
}

impl Chain {
    /// Density per area, of all vertices together, with which `eye` vertices from the eye and the rest from the light make this
    /// path; `None` where they cannot.
    pub fn density(&self, eye: usize) -> Option<f64> {
        let (n, k) = (&self.nodes, self.nodes.len());
        let light = k + 2 - eye;
        // Vertex j ≥ 1 is node j − 1; the last vertex, k + 1, lies on the light.
        let meets = |j: usize| n.get(j.wrapping_sub(1)).is_none_or(|node| !node.delta);
        let possible = match light {
            0 => true,
            1 => meets(k) && self.source.connection > 0.0,
            _ => self.source.start > 0.0 && meets(eye - 1) && meets(eye),
        };
        if !possible {
            return None;
        }
        let eyes: f64 = (1..eye).map(|j| self.eye_density(j)).product();
        let lights: f64 = (eye..k + 2).map(|j| self.light_density(j, light)).product();
        let paths = if eye == 1 { self.light_paths } else { 1.0 };
        Some(eyes * lights * paths)
    }

    /// From vertex j to the one before.
    fn distance(&self, j: usize) -> f64 {
        self.nodes
            .get(j - 1)
            .map_or(self.source.distance, |node| node.distance)
    }

    /// Density per area of vertex j, reached from the one before.
    fn eye_density(&self, j: usize) -> f64 {
        let cosine = self
            .nodes
            .get(j - 1)
            .map_or(self.source.cosine, |node| node.to_eye);
        let per_angle = match j {
            1 => self.importance * self.light_paths * self.distance(1).powi(2),
            _ => self.nodes[j - 2].onwards,
        };
        per_angle * cosine / self.distance(j).powi(2)
    }

    /// Density per area of vertex j, reached from the one after; the light's own point by a path of `light` vertices from it.
    fn light_density(&self, j: usize, light: usize) -> f64 {
        let (k, source) = (self.nodes.len(), self.source);
        if j == k + 1 {
            return match light {
                1 => source.connection * source.cosine / source.distance.powi(2),
                _ => source.start,
            };
        }
        let per_angle = match j == k {
            true => source.leaving * source.cosine,
            false => self.nodes[j].back,
        };
        per_angle * self.nodes[j - 1].to_light / self.distance(j + 1).powi(2)
    }

    /// All ways that can find the path, from the one that hits the light on: p and p²/Σp² (Veach 1997, equation 9.12).
    pub fn techniques(&self) -> Vec<Technique> {
        let count = self.nodes.len() + 2;
        let densities = (1..=count)
            .rev()
            .filter_map(|eye| Some((eye, self.density(eye)?)));
        let densities: Vec<(usize, f64)> = densities.collect();
        // Squares of ratios: those of densities themselves may overflow.
        let most = densities.iter().fold(0.0, |most, d| f64::max(most, d.1));
        let square = |p: f64| (p / most).powi(2);
        let sum: f64 = densities.iter().map(|d| square(d.1)).sum();
        let technique = |(eye, density)| Technique {
            light: count - eye,
            eye,
            density,
            weight: square(density) / sum,
        };
        densities.into_iter().map(technique).collect()
    }
}
