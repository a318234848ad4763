//! Light tracing: light → path loop → splats on the pixels from which the eye sees the path's vertices. Twin of
//! `shaders/integrator/light/`.
//!
//! It finds the light of surfaces that scatter: no mirrors, nothing behind smooth glass, and no light of the
//! background. Light leaves a surface to its outside only. Veach, Robust Monte Carlo Methods for Light Transport
//! Simulation, 1997, section 10.3, s ≥ 1 and t = 1.

pub mod begin;
pub mod record;
pub mod splat;

use crate::prepared::MaterialKind;
use crate::reference::math::finite::{has_nan, is_black};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::extend::{Extension, extend};
use crate::reference::path::roulette::LONG_PATH;
use crate::reference::path::trace::{extend_ray, shadow_ray};
use crate::reference::path::vertex::path_vertex;
use crate::reference::path::{SampleId, Subpath, depth_reached};
use crate::reference::world::World;
use crate::settings::Settings;
use begin::{begin_light_path, light_start};
use record::Recorder;
use splat::{SplatRay, Window, splat_light, splat_vertex};

/// Light that has arrived at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splat<F> {
    /// The light path's contribution to the pixel's mean of one sample index, W·sr⁻¹·m⁻².
    pub value: Vec3<F>,
    /// row · width + column of the full picture.
    pub pixel: u32,
}

/// Counters of one light path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LightCounts {
    pub rays: u64,
    pub long_paths: u64,
    pub underflows: u64,
    /// Paths that ended because their throughput was NaN.
    pub nan: u64,
    pub infinite: u64,
}

/// Counts the outcome of a path's extension.
pub fn count_extension<F: Real>(path: &Subpath<F>, e: Extension, counts: &mut LightCounts) {
    counts.underflows += u64::from(e.underflow);
    counts.long_paths += u64::from(e.alive && path.bounce == LONG_PATH);
    let nan = e.broken && has_nan(path.throughput);
    counts.nan += u64::from(nan);
    counts.infinite += u64::from(e.broken && !nan);
}

/// Follows the light path of a pixel and sample index to its end, and passes its splats within `window` to `take`, in
/// the order of its vertices. `settings` are those of the adjoint, [`Settings::adjoint`].
pub fn trace_light<F: Real>(
    world: &World<F>,
    settings: &Settings,
    window: Window,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
    take: &mut impl FnMut(Splat<F>),
) -> LightCounts {
    let mut counts = LightCounts::default();
    let Some(start) = light_start(world, settings, id) else {
        return counts;
    };
    let mut path = begin_light_path(world, settings, &start, id);
    let power = start.radiance * F::new(std::f64::consts::PI);
    let splat = splat_light(world, settings, window, &start, id);
    if let Some((_, splat)) = arrived_splat(world, settings, splat, &mut counts) {
        recorder.splat(None, splat);
        take(splat);
    }
    let mut alive = true;
    while alive {
        let (hit, distance) = extend_ray(world, settings, &mut path, &mut counts.rays);
        let Some(hit) = hit else { break };
        let v = path_vertex(world, settings, path.ray, hit, distance, path.throughput);
        let black = world.materials[v.material as usize].kind == MaterialKind::Black;
        // A path starts with some light: a path with none has lost it to absorption.
        let absorbed = is_black(path.throughput);
        counts.underflows += u64::from(absorbed);
        if black || depth_reached(settings, path.bounce) || absorbed {
            break;
        }
        let splat = splat_vertex(world, settings, window, power, &path, &v, id);
        let e = extend(settings, Origin::Light, &mut path, &v, id);
        if let Some((wi, splat)) = arrived_splat(world, settings, splat, &mut counts) {
            recorder.splat(Some((&v, wi)), splat);
            take(splat);
        }
        recorder.scattered(&path, &v, e.lobe);
        count_extension(&path, e, &mut counts);
        alive = e.alive;
    }
    counts
}

/// The direction of a connection to the eye, and the light that arrives over it.
fn arrived_splat<F: Real>(
    world: &World<F>,
    settings: &Settings,
    splat: Option<SplatRay<F>>,
    counts: &mut LightCounts,
) -> Option<(Vec3<F>, Splat<F>)> {
    let SplatRay { shadow, pixel } = splat?;
    let value = shadow_ray(world, settings, shadow, &mut counts.rays)?;
    Some((shadow.ray.d, Splat { value, pixel }))
}
