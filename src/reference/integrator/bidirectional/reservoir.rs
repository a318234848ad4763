//! Vertices of a light path to which eye paths are joined.

use super::joint::Joint;
use crate::layout::constants::bidirectional::KEPT;
use crate::prepared::MaterialKind;
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3};

/// Vertices that were kept, each with the same probability.
#[derive(Clone, Debug)]
pub struct Reservoir<F> {
    kept: [Option<Joint<F>>; KEPT as usize],
    seen: u32,
}

impl<F: Real> Reservoir<F> {
    /// An empty reservoir.
    pub fn empty() -> Self {
        Self {
            kept: [None; KEPT as usize],
            seen: 0,
        }
    }

    /// Keeps a vertex, or does not, by the uniform number `u`.
    pub fn offer(&mut self, vertex: Joint<F>, u: F) {
        if let Some(slot) = self.kept.get_mut(kept_place(self.seen, u) as usize) {
            *slot = Some(vertex);
        }
        self.seen += 1;
    }

    /// The kept vertices, each with the number of vertices that it represents.
    pub fn vertices(&self) -> impl Iterator<Item = (&Joint<F>, F)> {
        let share = kept_share(self.seen);
        self.kept.iter().flatten().map(move |v| (v, share))
    }
}

/// Where a vertex is to be kept after `seen` others; [`KEPT`] or more means not at all. All have the same probability,
/// by the uniform number `u` (Vitter, Random Sampling with a Reservoir, 1985, algorithm R).
pub fn kept_place<F: Real>(seen: u32, u: F) -> u32 {
    if seen < KEPT {
        seen
    } else {
        (u * F::from_u32(seen + 1)).to_u32()
    }
}

/// The number of vertices that each kept one represents.
pub fn kept_share<F: Real>(seen: u32) -> F {
    F::from_u32(seen.max(KEPT)) / F::from_u32(KEPT)
}

/// Whether a material has a lobe with a density, at which paths can be joined.
pub fn has_density<F: Real>(kind: MaterialKind, kd: Vec3<F>) -> bool {
    match kind {
        MaterialKind::Black | MaterialKind::NullInterface => false,
        MaterialKind::Mirror | MaterialKind::SmoothDielectric => !is_black(kd),
        MaterialKind::Diffuse
        | MaterialKind::Glossy
        | MaterialKind::RoughDielectric
        | MaterialKind::WeakDielectric => true,
    }
}
