//! Light that comes to any pixel: the splats of light paths, added to the film in one order.
//!
//! The light paths of one sample index, one a pixel of the picture, make a picture of their own: a pixel's sample is the sum
//! of its splats, in the order of (light path, vertex). The film adds these samples as it adds a path tracer's, so that
//! its groups, what it keeps beside them and its error estimate are the same. No bit depends on tiles, slices or crops.

use super::{HostFilm, Job, Pixels};
use crate::part::{Counts, Dropped, Part, Scalar, Tally};
use crate::reference::film::{FilmPixel, PixelSum, film_add, is_summable};
use crate::reference::integrator::light::splat::Window;
use crate::reference::integrator::light::{LightCounts, Splat};
use crate::reference::math::{Real, Vec3};

/// The film of a light tracer.
pub struct LightFilm<F> {
    pixels: Pixels<F>,
    /// Of the sample indices under way.
    sums: Vec<PixelSum<F>>,
    under_way: LightCounts,
    /// Of samples that are complete.
    counts: Counts,
    /// Pixels in a row of the full picture.
    width: u32,
}

/// The sum of one more splat.
pub fn with_splat<F: Real>(mut sum: PixelSum<F>, splat: Vec3<F>) -> PixelSum<F> {
    if is_summable(splat) && is_summable(sum.sum) {
        return film_add(sum, splat);
    }
    // Breaks the pixel's sample, which the film then drops and counts.
    sum.sum += splat;
    sum
}

impl<F: Scalar> LightFilm<F> {
    /// What it keeps of each pixel, what is kept beside its sums not counted.
    pub const PIXEL_BYTES: u64 = (size_of::<FilmPixel<F>>() + size_of::<PixelSum<F>>()) as u64;

    /// Goes on from a part of the job's picture.
    pub fn new(job: &Job, part: Part<F>) -> Self {
        Self {
            sums: vec![PixelSum::zero(); job.area().pixels() as usize],
            pixels: Pixels::new(job.area(), part),
            under_way: LightCounts::default(),
            counts: Counts::default(),
            width: job.prepared.camera.width,
        }
    }

    /// The index of the next sample.
    pub fn done(&self) -> u32 {
        self.pixels.done()
    }

    /// The pixels that it has.
    pub fn window(&self) -> Window {
        self.pixels.area.window()
    }

    /// Adds a splat on one of its pixels to the sample index under way: to be called in the order of light paths.
    pub fn splat(&mut self, splat: Splat<F>) {
        let at = [splat.pixel % self.width, splat.pixel / self.width];
        let sum = &mut self.sums[self.pixels.area.index(at) as usize];
        *sum = with_splat(*sum, splat.value);
    }

    /// Every light path of the sample index under way has brought its splats.
    pub fn end_sample(&mut self) {
        let sums = &self.sums;
        self.pixels.add(|i| sums[i].sum);
        self.pixels.settle();
        self.sums.fill(PixelSum::zero());
    }

    /// Adds what light paths of indices under way took.
    pub fn count(&mut self, of: LightCounts) {
        self.under_way.rays += of.rays;
        self.under_way.long_paths += of.long_paths;
        self.under_way.underflows += of.underflows;
        self.under_way.nan += of.nan;
        self.under_way.infinite += of.infinite;
    }

    /// All sample indices that were under way are complete.
    pub fn end_pass(&mut self) {
        let of = std::mem::take(&mut self.under_way);
        self.counts = self.counts.plus(Counts {
            rays: of.rays,
            long_paths: of.long_paths,
            underflows: of.underflows,
            dropped: Dropped {
                nan: of.nan,
                infinite: of.infinite,
                loops: 0,
            },
        });
    }

    /// Forgets the sample indices under way.
    pub fn give_up_pass(&mut self) {
        self.under_way = LightCounts::default();
        self.sums.fill(PixelSum::zero());
    }
}

impl<F: Scalar> HostFilm for LightFilm<F> {
    type Scalar = F;

    fn part(&self) -> Part<F> {
        let mut part = self.pixels.part();
        part.tally = part.tally.plus(Tally {
            counts: self.counts,
            largest: None,
        });
        part
    }
}
