//! The size and position of a scene.

use glam::DVec3;

use crate::scene::MeshFile;

/// The ball around the bounding box of a mesh.
pub(super) struct Ball {
    pub(super) centre: DVec3,
    pub(super) radius: f64,
}

/// The ball about all triangles.
pub(super) fn around(mesh: &MeshFile) -> Ball {
    let corners = mesh.triangles.as_flattened().iter();
    let points = corners.map(|i| mesh.positions[*i as usize]);
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (lo, hi) = points.fold(none, |(lo, hi), p| (lo.min(p), hi.max(p)));
    Ball {
        centre: 0.5 * (lo + hi),
        radius: 0.5 * (hi - lo).length(),
    }
}

/// Ratio of a lamp's radius to the scene's.
const LAMP: f64 = 1e-3;

impl Ball {
    /// The radius of the balls that replace point lights.
    pub(super) fn lamp_radius(&self) -> f64 {
        match LAMP * self.radius {
            radius if radius as f32 > 0.0 => radius,
            _ => LAMP,
        }
    }
}
