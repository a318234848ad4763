//! Moments of the mean over RGB of a sample's weight, by quadrature over its distribution.

use vkpt::reference::bsdf::choice::reflect_probability;
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::kind::rough_dielectric::rough_dielectric_at;
use vkpt::reference::bsdf::normals::visible::{ggx, visible_pdf, visible_sample};
use vkpt::reference::bsdf::reflection::reflect_about;
use vkpt::reference::bsdf::refraction::refract_about;
use vkpt::reference::bsdf::{Interaction, carried_mean};
use vkpt::reference::math::{Vec3, dot3, mean3};
use vkpt::settings::Settings;

/// A micro-normal and the density with which it was drawn.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    pub m: Vec3<f64>,
    pub pdf: f64,
}

/// As the renderer draws them.
pub fn own(at: &Interaction<f64>, u: [f64; 2]) -> Drawn {
    let m = visible_sample(at, u);
    Drawn {
        m,
        pdf: visible_pdf(at, m),
    }
}

/// From the GGX of the same width.
pub fn by_ggx(at: &Interaction<f64>, u: [f64; 2]) -> Drawn {
    let m = ggx::visible_ggx_sample(at, u);
    Drawn {
        m,
        pdf: ggx::visible_ggx_pdf(at, m),
    }
}

/// A direction that a micro-normal leads to.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    pub probability: f64,
    pub wi: Vec3<f64>,
    pub weight: Vec3<f64>,
}

/// The reflection about a rough dielectric's micro-normal, and the refraction; of weight 0 where `wo` does not see it or the
/// direction is on the wrong side.
pub fn ways(settings: &Settings, at: &Interaction<f64>, drawn: Drawn) -> [Way; 2] {
    let c = dot3(at.wo, drawn.m);
    let p = reflect_probability(settings, at, c, carried_mean(at, fresnel(at, c)));
    let way = |probability: f64, wi: Vec3<f64>, right: bool| {
        let value = rough_dielectric_at(settings, at, wi, drawn.m);
        // the value's density is that of the renderer's own normals
        let ratio = visible_pdf(at, drawn.m) / drawn.pdf;
        let lit = right && c > 0.0 && value.pdf > 0.0 && drawn.pdf > 0.0;
        let weight = if lit {
            value.value / value.pdf * ratio
        } else {
            Vec3::zero()
        };
        Way {
            probability,
            wi,
            weight,
        }
    };
    let near = reflect_about(at.wo, drawn.m, c);
    let far = refract_about(at, drawn.m, c);
    [
        way(p, near, near.z > 0.0),
        way(1.0 - p, far, p < 1.0 && far.z < 0.0),
    ]
}

/// Midpoints of a grid over the unit square.
pub fn nodes(side: u32) -> impl Iterator<Item = [f64; 2]> {
    let at = move |i: u32| (f64::from(i) + 0.5) / f64::from(side);
    (0..side * side).map(move |i| [at(i % side), at(i / side)])
}

/// Of the mean over RGB of a weight.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moments {
    pub mean: f64,
    pub square: f64,
    pub largest: f64,
}

/// By 48 × 48 nodes, both ways from each.
pub fn moments(
    settings: &Settings,
    at: &Interaction<f64>,
    draw: impl Fn(&Interaction<f64>, [f64; 2]) -> Drawn,
) -> Moments {
    const SIDE: u32 = 48;
    let mut found = Moments::default();
    for way in nodes(SIDE).flat_map(|u| ways(settings, at, draw(at, u))) {
        let (share, weight) = (way.probability / f64::from(SIDE * SIDE), mean3(way.weight));
        found.mean += share * weight;
        found.square += share * weight * weight;
        if way.probability > 0.0 {
            found.largest = found.largest.max(weight);
        }
    }
    found
}
