//! Coloured glass: the throughput of a path in each channel, when it is reflected within and refracted again and again.
//!
//! Chosen by the mean of F, a reflection weighs F/F̄ in each channel, whose square means 1 + (F − F̄)²/(F̄ (1 − F̄)): a product of n
//! has a variance that grows with n without end. Chosen by the mean of F weighted by the path's throughput, Σ βF/Σ β, it leaves
//! the mean of the throughput as it is, and no channel is above three times that.

use glam::DVec3;
use vkpt::prepared::{Material, MaterialKind};
use vkpt::reference::bsdf::{Interaction, LOBE_NONE, bsdf_sample};
use vkpt::reference::math::{Vec3, mean3};
use vkpt::reference::path::throughput::channel_shares;
use vkpt::settings::{Distribution, Fresnel, LobeChoice, Normals};

use super::support::albedo::flux;
use super::support::random::{Random, random};
use super::support::surface::{DISTRIBUTIONS, dielectric, direction, parameter, seen};
use crate::common::facets::{excess, facets, most_g1};

const VERTICES: usize = 200;
const PATHS: usize = 60;

/// Red is mostly reflected, blue mostly refracted.
fn coloured(distribution: Distribution, width: f64) -> Material {
    let mut glass = dielectric(distribution, parameter(distribution, width), 1.5);
    (glass.f0, glass.fresnel) = (DVec3::new(0.6, 0.2, 0.02), Fresnel::Schlick);
    glass
}

type Carried = fn(Vec3<f64>) -> Vec3<f64>;

/// The most energy that the model gains where glass is seen at this cosine.
fn gain(glass: &Material, cos: f64) -> f64 {
    match (glass.kind, glass.distribution) {
        (MaterialKind::SmoothDielectric, _) | (_, Distribution::Ggx) => 1.0,
        (_, d) => {
            let facets = facets(d, glass.width, cos) * (1.0 + 1e-5);
            facets * most_g1(d) * excess(d, glass.width)
        }
    }
}

/// The most that the mean of a path's throughput comes to, and that a channel does, each over the energy that the model
/// has gained by then, over many paths in and out of balls of this glass.
fn most(glass: &Material, carried: Carried) -> [f64; 2] {
    let settings = flux(LobeChoice::Fresnel, Normals::Visible);
    let mut r = Random::new(11);
    let mut most = [0.0f64; 2];
    for _ in 0..PATHS {
        let (mut outside, mut cos) = (false, 1.0 - r.unit());
        let (mut throughput, mut energy) = (Vec3::<f64>::one(), 1.0);
        for _ in 0..VERTICES {
            let at = Interaction {
                carried: carried(throughput),
                ..seen(glass, outside, direction(cos, 0.4))
            };
            let u = random(r.unit(), r.unit(), r.pair(), r.pair());
            let s = bsdf_sample(&settings, &at, u);
            if s.lobe == LOBE_NONE {
                break;
            }
            throughput *= s.weight;
            energy *= gain(glass, cos);
            most[0] = most[0].max(mean3(throughput) / energy);
            most[1] = most[1].max(throughput.f64().max_element() / energy);
            // light that stays within meets the ball at the angle at which it left it; light that leaves meets another
            outside ^= s.wi.z < 0.0;
            cos = if outside {
                1.0 - r.unit()
            } else {
                s.wi.z.abs()
            };
        }
    }
    most
}

#[test]
fn no_channel_grows() {
    for distribution in DISTRIBUTIONS {
        for width in [1e-5, 0.1, 0.3] {
            let [mean, channel] = most(&coloured(distribution, width), channel_shares);
            assert!(mean < 1.0 + 1e-9, "{distribution:?} {width}: {mean}");
            assert!(channel < 3.0 + 1e-9, "{distribution:?} {width}: {channel}");
        }
    }
}

#[test]
fn channels_grow_when_chosen_by_the_plain_mean() {
    let [mean, channel] = most(&coloured(Distribution::Ggx, 1e-5), |_| Vec3::one());
    assert!(mean > 5.0 && channel > 15.0, "{mean} {channel}");
}

/// The choice moves no mean: the reflected and the refracted part, each by its probability, come to F and 1 − F.
#[test]
fn the_choice_leaves_the_mean() {
    let settings = flux(LobeChoice::Fresnel, Normals::Visible);
    let glass = coloured(Distribution::Ggx, 1e-5);
    for carried in [[1.0; 3], [2.0, 0.7, 0.3], [0.0, 0.0, 3.0], [0.1, 2.8, 0.1]] {
        let at = Interaction {
            carried: Vec3::new(DVec3::from_array(carried)),
            ..seen(&glass, true, direction(0.4, 0.3))
        };
        let sample = |u| bsdf_sample(&settings, &at, random(0.5, u, [0.5; 2], [0.5; 2]));
        let (near, far) = (sample(0.0), sample(1.0 - f64::EPSILON));
        let sum = near.weight * near.pdf + far.weight * far.pdf;
        assert!((sum.f64() - DVec3::ONE).abs().max_element() < 1e-14);
        // by throughput: near.pdf is the probability of the reflection
        let f = near.weight.f64() * near.pdf;
        let expected = f.dot(DVec3::from_array(carried)) / 3.0;
        assert!(
            (near.pdf - expected).abs() < 1e-14,
            "{} {expected}",
            near.pdf
        );
    }
}
