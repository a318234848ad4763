//! The letter of a surface on a path, or its share of two.

use glam::DVec3;

use crate::path_class::Side;
use crate::reference::bsdf::diffuse::lambert::lambert_lobe;
use crate::reference::bsdf::{LOBE_DELTA, LOBE_TRANSMISSION, bsdf_eval};
use crate::reference::math::Vec3;
use crate::reference::math::frame::to_local;
use crate::reference::path::vertex::Vertex;
use crate::settings::Settings;

/// How a surface scatters from one direction of a path to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// By a lobe without a density: S.
    Smooth(Side),
    /// By lobes with a density. A path's light is that of all of them, not only of the one from which its direction was
    /// drawn, so it has the letter D by this share in each channel, and G by the rest.
    Rough { diffuse: DVec3, side: Side },
}

impl Surface {
    /// At `v`, left along `wi` by a lobe with a density; `settings` are those of the path's end.
    pub fn towards(settings: &Settings, v: &Vertex<f32>, wi: Vec3<f32>) -> Self {
        let local = to_local(v.frame, wi);
        let diffuse = lambert_lobe(&v.interaction, local).value.f64();
        let all = bsdf_eval(settings, &v.interaction, local).value.f64();
        // f_D/(f_D + f_G); if both are 0, the path has no light either.
        let share = |d: f64, all: f64| match all > 0.0 {
            true => (d / all).min(1.0),
            false => 0.0,
        };
        let share = |i| share(diffuse[i], all[i]);
        Self::Rough {
            diffuse: DVec3::new(share(0), share(1), share(2)),
            side: if local.z > 0.0 { Side::R } else { Side::T },
        }
    }

    /// At `v`, left along `wi`, which was drawn from `lobe`.
    pub fn left(settings: &Settings, v: &Vertex<f32>, wi: Vec3<f32>, lobe: u32) -> Self {
        match lobe.checked_sub(LOBE_DELTA) {
            Some(LOBE_TRANSMISSION) => Self::Smooth(Side::T),
            Some(_) => Self::Smooth(Side::R),
            None => Self::towards(settings, v, wi),
        }
    }
}
