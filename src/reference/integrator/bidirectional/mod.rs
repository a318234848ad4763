//! Bidirectional path tracing: a path from the eye and one from a light are joined at every pair of vertices, and each
//! technique is weighted against all others.
//!
//! Sample i of a pixel is an eye path and, with its own random numbers, a light path; the light path's contributions to
//! the eye are splats on any pixel. Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, chapter 10.

pub mod aim;
pub mod bend;
pub mod eye_path;
pub mod join;
pub mod joint;
pub mod light_path;
pub mod partial;
pub mod record;
pub mod reservoir;
pub mod signature;
pub mod to_light;

use super::light::splat::Window;
use super::light::{LightCounts, Splat};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::SampleId;
use crate::reference::world::World;
use crate::settings::Settings;
use eye_path::eye_path;
use light_path::light_path;
use record::Recorder;

/// The techniques that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ways {
    /// All, by their weights.
    All,
    /// The one with `light` vertices of the light path, including its point of a light, and `eye` vertices of the eye
    /// path, including the eye; with the weight 1.
    Only { light: u32, eye: u32 },
}

impl Ways {
    /// The weight of a technique with these numbers of vertices, `weight` where all count.
    pub fn weight<F: Real>(self, light: u32, eye: u32, weight: F) -> F {
        match self {
            Self::All => weight,
            _ if self == (Self::Only { light, eye }) => F::one(),
            Self::Only { .. } => F::zero(),
        }
    }
}

/// The inputs of both paths of a sample.
#[derive(Clone, Copy)]
pub struct Transport<'a, F> {
    pub world: &'a World<F>,
    /// For paths from the eye.
    pub settings: &'a Settings,
    /// For the adjoint, [`Settings::adjoint`].
    pub adjoint: &'a Settings,
    pub ways: Ways,
}

/// Follows both paths of a pixel and sample index to their ends, and passes the splats of the light path to `take`, in the
/// order of its vertices. Returns the eye path's radiance at its own pixel, W·sr⁻¹·m⁻². Only pixels within `window` count.
pub fn trace_bidirectional<F: Real>(
    transport: Transport<F>,
    window: Window,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
    take: &mut impl FnMut(Splat<F>),
) -> (Option<Vec3<F>>, LightCounts) {
    let mut counts = LightCounts::default();
    let light = light_path(transport, window, id, &mut counts, recorder, take);
    let (x, y) = (
        id.column.wrapping_sub(window.x),
        id.row.wrapping_sub(window.y),
    );
    let rendered = x < window.width && y < window.height;
    let radiance = rendered.then(|| eye_path(transport, &light, id, &mut counts, recorder));
    (radiance, counts)
}
