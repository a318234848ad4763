//! Light that comes to any pixel: the splats of light paths, added to the film in one order.
//!
//! The light paths of one sample index, one a pixel of the picture, make a picture of their own: a pixel's sample is the sum
//! of its splats, in the order of (light path, vertex). The film adds these samples as it adds a path tracer's, so that
//! its groups, its moments and its error estimate are the same. No bit depends on tiles, slices or crops.

use super::course::Halves;
use super::{Counts, HostFilm, Job, Pixels};
use crate::film::Film;
use crate::reference::film::{FilmPixel, PixelSum, film_add, is_summable};
use crate::reference::integrator::light::splat::Window;
use crate::reference::integrator::light::{LightCounts, Splat};
use crate::reference::math::Real;
use crate::sample::Largest;

/// The film of a light tracer.
pub struct LightFilm<F> {
    pixels: Pixels<F>,
    /// Of the sample index under way.
    sums: Vec<PixelSum<F>>,
    /// Pixels in a row of the full picture.
    width: u32,
    counts: LightCounts,
    samples: u32,
}

impl<F: Real> LightFilm<F> {
    /// What it keeps of each pixel, moments not counted.
    pub const PIXEL_BYTES: u64 = (size_of::<FilmPixel<F>>() + size_of::<PixelSum<F>>()) as u64;

    /// No samples yet.
    pub fn new(job: &Job) -> Self {
        let pixels = Pixels::new(job);
        Self {
            sums: vec![PixelSum::zero(); pixels.area.pixels() as usize],
            pixels,
            width: job.prepared.camera.width,
            counts: LightCounts::default(),
            samples: 0,
        }
    }

    /// Samples that each of its pixels has.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// The pixels that it has.
    pub fn window(&self) -> Window {
        self.pixels.area.window()
    }

    /// Adds a splat on one of its pixels to the sample index under way: to be called in the order of light paths.
    pub fn splat(&mut self, splat: Splat<F>) {
        let area = self.pixels.area;
        let (x, y) = (splat.pixel % self.width, splat.pixel / self.width);
        let sum = &mut self.sums[((y - area.y) * area.width + x - area.x) as usize];
        if is_summable(splat.value) && is_summable(sum.sum) {
            *sum = film_add(*sum, splat.value);
        } else {
            // Breaks the pixel's sample, which the film then drops and counts.
            sum.sum += splat.value;
        }
    }

    /// Every light path of the sample index under way has brought its splats.
    pub fn end_sample(&mut self) {
        let sums = &self.sums;
        self.pixels.add(|i| sums[i].sum, self.samples);
        self.sums.fill(PixelSum::zero());
        self.samples += 1;
    }

    /// Adds what light paths took.
    pub fn count(&mut self, of: LightCounts) {
        self.counts.rays += of.rays;
        self.counts.long_paths += of.long_paths;
        self.counts.underflows += of.underflows;
        self.counts.nan += of.nan;
        self.counts.infinite += of.infinite;
    }
}

impl<F: Real> HostFilm for LightFilm<F> {
    fn picture(&self, spp: u32) -> Film {
        self.pixels.picture(spp)
    }

    fn halves(&self, spp: u32) -> Halves {
        self.pixels.halves(spp)
    }

    fn spread(&self, spp: u32) -> Option<Film> {
        self.pixels.spread(spp)
    }

    fn counts(&self) -> Counts {
        let mut counts = self.pixels.counts();
        counts.rays += self.counts.rays;
        counts.long_paths += self.counts.long_paths;
        counts.underflows += self.counts.underflows;
        counts.dropped.nan += self.counts.nan;
        counts.dropped.infinite += self.counts.infinite;
        counts
    }

    fn largest(&self) -> Option<Largest> {
        self.pixels.largest()
    }
}
