//! The film on the host, in the reference's scalar.

use rayon::prelude::*;

use super::HostFilm;
use super::tiles::Tile;
use crate::part::{Beside, BesideMut, Counts, Dropped, Part, PixelSums, Scalar, Sums, Tally};
use crate::reference::film::{FilmPixel, film_sample};
use crate::reference::math::Vec3;
use crate::sample::{Address, Largest};

/// The accumulated pixels, row by row.
pub struct Pixels<F> {
    pub area: Tile,
    /// All samples before the current block.
    closed: Part<F>,
    /// The film of the current block.
    film: Vec<FilmPixel<F>>,
    beside: Beside<F>,
}

/// From this many pixels on, adding a sample to each is faster on all cores than on one.
const MANY: usize = 1 << 14;

/// A pixel and its additional sums.
pub struct PixelMut<'a, F> {
    pub film: &'a mut FilmPixel<F>,
    beside: BesideMut<'a, F>,
}

impl<F: Scalar> PixelMut<'_, F> {
    /// Adds the next sample.
    pub fn add(&mut self, radiance: Vec3<F>) {
        film_sample(self.film, radiance);
        self.beside.add(radiance, self.film.samples);
    }
}

impl<F: Scalar> Pixels<F> {
    /// Continues a part of the pixels of `area`.
    pub fn new(area: Tile, part: Part<F>) -> Self {
        let (closed, tail) = part.without_tail();
        let pixels = area.pixels() as usize;
        let open = tail.map_or_else(
            || Sums::zero(pixels, closed.keeps()),
            |tail| (*tail).clone(),
        );
        let film = |sums: &PixelSums<F>| FilmPixel {
            samples: open.samples,
            ..FilmPixel::from(sums)
        };
        Self {
            area,
            closed,
            film: open.pixels.iter().map(film).collect(),
            beside: open.beside,
        }
    }

    /// The index of the next sample.
    pub fn done(&self) -> u32 {
        self.closed.range().end + self.film.first().map_or(0, |pixel| pixel.samples)
    }

    /// The index at which the sums are to be [settled](Self::settle), at most `to`.
    pub fn stop(&self, to: u32) -> u32 {
        self.closed.stop(self.done(), to)
    }

    /// Adds a sample to every pixel, by its number in the area.
    pub fn add(&mut self, radiance: impl Fn(usize) -> Vec3<F> + Sync) {
        if self.film.len() >= MANY {
            return self.each(|i, mut pixel| pixel.add(radiance(i)));
        }
        for (i, film) in self.film.iter_mut().enumerate() {
            let beside = self.beside.at(i);
            PixelMut { film, beside }.add(radiance(i));
        }
    }

    /// Every pixel by its number in the area, on all cores.
    pub fn each(&mut self, visit: impl Fn(usize, PixelMut<F>) + Sync) {
        let film = self.film.par_iter_mut().enumerate();
        match &mut self.beside {
            Beside::Nothing => film.for_each(|(i, film)| {
                let beside = BesideMut::Nothing;
                visit(i, PixelMut { film, beside });
            }),
            Beside::Moments(moments) => film.zip(moments).for_each(|((i, film), moments)| {
                let beside = BesideMut::Moments(moments);
                visit(i, PixelMut { film, beside });
            }),
            Beside::Quarters(quarters) => film.zip(quarters).for_each(|((i, film), quarters)| {
                let beside = BesideMut::Quarters(quarters);
                visit(i, PixelMut { film, beside });
            }),
        }
    }

    /// Moves the sums into the part where a block ends; must be called at each [stop](Self::stop).
    pub fn settle(&mut self) {
        if !self.closed.ends_at(self.done()) {
            return;
        }
        self.closed.tally = self.closed.tally.plus(self.tally());
        self.closed.close(self.sums());
        self.film.fill(FilmPixel::default());
        self.beside.clear();
    }

    /// The sums of the current block.
    fn sums(&self) -> Sums<F> {
        Sums {
            samples: self.film.first().map_or(0, |pixel| pixel.samples),
            pixels: self.film.par_iter().map(PixelSums::from).collect(),
            beside: self.beside.clone(),
        }
    }

    fn count(&self, of: fn(&FilmPixel<F>) -> u64) -> u64 {
        self.film.iter().map(of).sum()
    }

    /// The counters of the current block.
    fn tally(&self) -> Tally {
        Tally {
            counts: Counts {
                rays: self.count(|p| p.rays),
                long_paths: self.count(|p| p.long_paths),
                underflows: self.count(|p| p.underflows),
                dropped: Dropped {
                    nan: self.count(|p| p.nan),
                    infinite: self.count(|p| p.infinite),
                    loops: 0,
                },
            },
            largest: self.largest(),
        }
    }

    fn largest(&self) -> Option<Largest> {
        let begin = self.closed.range().end;
        let of = |(i, p): (u32, &FilmPixel<F>)| Largest {
            address: Address {
                pixel: self.area.pixel(i),
                index: begin + p.largest_sample,
            },
            radiance: p.largest.f64(),
        };
        let all = (0..).zip(&self.film).map(of);
        all.reduce(Largest::or).filter(|l| l.radiance > 0.0)
    }
}

impl<F: Scalar> HostFilm for Pixels<F> {
    type Scalar = F;

    fn part(&self) -> Part<F> {
        let mut part = self.closed.with_tail(self.sums());
        part.tally = part.tally.plus(self.tally());
        part
    }
}
