//! Vertices of a light path that eye paths are joined to.

use super::partial::Partial;
use crate::prepared::MaterialKind;
use crate::reference::bsdf::Material;
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::vertex::Vertex;

/// Vertices of a light path that are kept: two bring 92 to 97 % of what all would.
pub const KEPT: usize = 2;

/// A vertex of a light path.
#[derive(Clone, Copy, Debug)]
pub struct LightVertex<F> {
    pub v: Vertex<F>,
    /// Whence the path came, of unit length.
    pub wo: Vec3<F>,
    /// Power that arrives, W; with the factor by which a kept vertex stands for those that were not.
    pub power: Vec3<F>,
    /// The medium that the path came through.
    pub medium: u32,
    pub partial: Partial<F>,
    /// Vertices of the path up to this one, the light's own among them.
    pub count: u32,
}

/// Vertices that were kept, each with the same probability.
#[derive(Clone, Debug)]
pub struct Reservoir<F> {
    kept: [Option<LightVertex<F>>; KEPT],
    seen: u32,
}

impl<F: Real> Reservoir<F> {
    /// None yet.
    pub fn empty() -> Self {
        Self {
            kept: [None; KEPT],
            seen: 0,
        }
    }

    /// Keeps a vertex with the probability KEPT/seen in place of an older one, by the uniform number `u` (Vitter, Random Sampling
    /// with a Reservoir, 1985, algorithm R).
    pub fn offer(&mut self, vertex: LightVertex<F>, u: F) {
        let place = if (self.seen as usize) < KEPT {
            self.seen as usize
        } else {
            (u * F::from_u32(self.seen + 1)).to_u32() as usize
        };
        if let Some(slot) = self.kept.get_mut(place) {
            *slot = Some(vertex);
        }
        self.seen += 1;
    }

    /// Those that are there, each with the number of vertices that it stands for.
    pub fn vertices(&self) -> impl Iterator<Item = (&LightVertex<F>, F)> {
        let shares = F::from_u32(self.seen.max(KEPT as u32)) / F::from_u32(KEPT as u32);
        self.kept.iter().flatten().map(move |v| (v, shares))
    }
}

/// Whether a material has a lobe with a density, at which paths can be joined.
pub fn has_density<F: Real>(material: &Material<F>) -> bool {
    match material.kind {
        MaterialKind::Black | MaterialKind::NullInterface => false,
        MaterialKind::Mirror | MaterialKind::SmoothDielectric => !is_black(material.kd),
        MaterialKind::Diffuse
        | MaterialKind::Glossy
        | MaterialKind::RoughDielectric
        | MaterialKind::WeakDielectric => true,
    }
}
