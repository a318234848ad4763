//! The film of light paths, whose splats reach any pixel and are added in a fixed order.
//!
//! The light paths of one sample index, one a pixel of the picture, make a picture of their own: a pixel's sample is the sum of
//! its splats, in the order of (light path, vertex). The film adds these samples as it adds a path tracer's, so that its
//! groups, its additional sums and its error estimate are the same. No bit depends on tiles, slices or crops.

use super::{HostFilm, Job, Pixels};
use crate::part::{Counts, Dropped, Part, Scalar, Tally};
use crate::reference::film::{FilmPixel, PixelSum, film_add, is_summable};
use crate::reference::integrator::light::splat::Window;
use crate::reference::integrator::light::{LightCounts, Splat};
use crate::reference::math::{Real, Vec3};

/// The film of a light tracer.
pub struct LightFilm<F> {
    pixels: Pixels<F>,
    /// Sums of the current sample indices.
    sums: Vec<PixelSum<F>>,
    under_way: LightCounts,
    /// Counters of complete samples.
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
    /// The bytes of a pixel, without its additional sums.
    pub const PIXEL_BYTES: u64 = (size_of::<FilmPixel<F>>() + size_of::<PixelSum<F>>()) as u64;

    /// Continues a part of the job's picture.
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

    /// Adds a splat on one of its pixels to the current sample index: must be called in the order of light paths.
    pub fn splat(&mut self, splat: Splat<F>) {
        let at = [splat.pixel % self.width, splat.pixel / self.width];
        let sum = &mut self.sums[self.pixels.area.index(at) as usize];
        *sum = with_splat(*sum, splat.value);
    }

    /// Every light path of the current sample index has added its splats.
    pub fn end_sample(&mut self) {
        let sums = &self.sums;
        self.pixels.add(|i| sums[i].sum);
        self.pixels.settle();
        self.sums.fill(PixelSum::zero());
    }

    /// Adds the counters of light paths of current indices.
    pub fn count(&mut self, of: LightCounts) {
        self.under_way.rays += of.rays;
        self.under_way.long_paths += of.long_paths;
        self.under_way.underflows += of.underflows;
        self.under_way.nan += of.nan;
        self.under_way.infinite += of.infinite;
    }

    /// All current sample indices are complete.
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

    /// Discards the current sample indices.
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
