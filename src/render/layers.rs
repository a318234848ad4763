//! Layers: the surfaces in the pixels of a picture, not their light.
//!
//! They are means over the same points of a pixel as the picture's samples, made by the reference for every device: so
//! they are the same to the bit on all of them, and kernels have no code for them.

use glam::DVec3;
use rayon::prelude::*;

use super::Job;
use crate::film::{Aov, Channel};
use crate::prepared::Prepared;
use crate::reference::integrator::layers::{First, Seen, first_seen};
use crate::reference::world::World;
use crate::sample::Address;

/// The number of samples over which layers are means, for a picture of `spp`: the first half, and at most 64. A pixel's
/// surfaces converge sooner than its light, so layers take a small part of the time.
pub fn layer_samples(spp: u32) -> u32 {
    spp.div_ceil(2).min(64)
}

/// The layers that `job` requests, for a picture of `spp` samples: a value a pixel of its area in each channel.
pub fn layers(job: &Job, spp: u32) -> Vec<Channel> {
    let asked = || job.aovs.iter().copied().filter(|aov| aov.is_layer());
    if asked().next().is_none() {
        return Vec::new();
    }
    let world = World::<f32>::new(job.prepared);
    let pixels: Vec<Pixel> = (0..job.area().pixels())
        .into_par_iter()
        .map(|i| Pixel::new(job, &world, job.area().pixel(i), spp))
        .collect();
    let mut channels: Vec<Channel> = Vec::new();
    for (name, value) in asked().flat_map(named) {
        if channels.iter().all(|channel| channel.name != name) {
            let values = pixels.iter().map(|pixel| value(pixel) as f32).collect();
            let name = name.into();
            channels.push(Channel { name, values });
        }
    }
    channels
}

/// Means of a pixel: for properties of hits over the samples with a hit, else over all.
#[derive(Clone, Copy, Debug, Default)]
struct Pixel {
    albedo: DVec3,
    albedo_behind: DVec3,
    ns_behind: DVec3,
    n: DVec3,
    ns: DVec3,
    p: DVec3,
    depth: f64,
    /// Lines of the shape and the material that the first of those samples hit.
    shape: usize,
    material: usize,
    /// Samples of the picture.
    samples: u32,
}

impl Pixel {
    fn new(job: &Job, world: &World<f32>, pixel: [u32; 2], spp: u32) -> Self {
        let samples = layer_samples(spp);
        let mut sum = Self {
            samples: spp,
            ..Self::default()
        };
        let mut hits = 0;
        for index in 0..samples {
            let id = job.sample(Address { pixel, index });
            let seen = first_seen(world, &job.settings, id);
            sum.add(&seen, job.prepared, hits == 0);
            hits += u32::from(seen.first.is_some());
        }
        sum.mean(f64::from(samples.max(1)), f64::from(hits.max(1)))
    }

    fn add(&mut self, seen: &Seen<f32>, prepared: &Prepared, is_first: bool) {
        self.albedo += seen.albedo.f64();
        self.albedo_behind += seen.albedo_behind.f64();
        self.ns_behind += seen.ns_behind.f64();
        let Some(First {
            depth,
            p,
            n,
            ns,
            shape,
            material,
        }) = seen.first
        else {
            return;
        };
        self.n += n.f64();
        self.ns += ns.f64();
        self.p += prepared.space.scene_point(p.f64());
        self.depth += prepared.space.unit * f64::from(depth);
        if is_first {
            self.shape = prepared.shapes[shape as usize].line;
            self.material = prepared.materials[material as usize].line;
        }
    }

    fn mean(self, samples: f64, hits: f64) -> Self {
        Self {
            albedo: self.albedo / samples,
            albedo_behind: self.albedo_behind / samples,
            ns_behind: self.ns_behind / samples,
            n: self.n / hits,
            ns: self.ns / hits,
            p: self.p / hits,
            depth: self.depth / hits,
            ..self
        }
    }
}

type Value = fn(&Pixel) -> f64;

/// The channels of a layer, by pbrt's names where it has them.
fn named(aov: Aov) -> Vec<(&'static str, Value)> {
    match aov {
        Aov::Stderr | Aov::Denoised => vec![],
        Aov::Albedo => vec![
            ("Albedo.R", |p| p.albedo.x),
            ("Albedo.G", |p| p.albedo.y),
            ("Albedo.B", |p| p.albedo.z),
        ],
        Aov::Normal => vec![
            ("N.X", |p| p.n.x),
            ("N.Y", |p| p.n.y),
            ("N.Z", |p| p.n.z),
            ("Ns.X", |p| p.ns.x),
            ("Ns.Y", |p| p.ns.y),
            ("Ns.Z", |p| p.ns.z),
        ],
        Aov::Depth => vec![("Z", |p| p.depth)],
        Aov::Position => vec![("P.X", |p| p.p.x), ("P.Y", |p| p.p.y), ("P.Z", |p| p.p.z)],
        Aov::Shape => vec![("Shape.Line", |p| p.shape as f64)],
        Aov::Material => vec![("Material.Line", |p| p.material as f64)],
        Aov::Samples => vec![("Samples.N", |p| f64::from(p.samples))],
        Aov::AlbedoBehind => vec![
            ("AlbedoBehind.R", |p| p.albedo_behind.x),
            ("AlbedoBehind.G", |p| p.albedo_behind.y),
            ("AlbedoBehind.B", |p| p.albedo_behind.z),
        ],
        Aov::NormalBehind => vec![
            ("NsBehind.X", |p| p.ns_behind.x),
            ("NsBehind.Y", |p| p.ns_behind.y),
            ("NsBehind.Z", |p| p.ns_behind.z),
        ],
    }
}
