//! The film on the host, in the reference's scalar.

use rayon::prelude::*;

use super::course::Halves;
use super::tiles::Tile;
use super::{Counts, Dropped, HostFilm, Job};
use crate::film::Film;
use crate::reference::film::{
    FilmMoments, FilmPixel, film_half_difference, film_mean, film_moments, film_sample, film_stderr,
};
use crate::reference::math::{Real, Vec3};
use crate::sample::{Address, Largest};

/// The pixels under way, row by row.
pub struct Pixels<F> {
    pub area: Tile,
    film: Vec<FilmPixel<F>>,
    /// Where standard errors are to come from them.
    moments: Option<Vec<FilmMoments<F>>>,
}

/// From so many pixels on, adding a sample to each is faster on all cores than on one.
const MANY: usize = 1 << 14;

/// A pixel, and its moments where they are kept.
pub struct PixelMut<'a, F> {
    pub film: &'a mut FilmPixel<F>,
    moments: Option<&'a mut FilmMoments<F>>,
}

impl<F: Real> PixelMut<'_, F> {
    /// Adds the sample of index `sample`.
    pub fn add(&mut self, radiance: Vec3<F>, sample: u32) {
        film_sample(self.film, radiance);
        if let Some(moments) = &mut self.moments {
            film_moments(moments, radiance, sample + 1);
        }
    }
}

impl<F: Real> Pixels<F> {
    /// No samples yet.
    pub fn new(job: &Job) -> Self {
        let area = job.area();
        let pixels = area.pixels() as usize;
        let kept = job.features().keeps_moments();
        Self {
            area,
            film: vec![FilmPixel::default(); pixels],
            moments: kept.then(|| vec![FilmMoments::default(); pixels]),
        }
    }

    /// Adds sample `sample` to every pixel, by its number in the area.
    pub fn add(&mut self, radiance: impl Fn(usize) -> Vec3<F> + Sync, sample: u32) {
        if self.film.len() >= MANY {
            return self.each(|i, mut pixel| pixel.add(radiance(i), sample));
        }
        let mut moments = self.moments.iter_mut().flatten();
        for (i, film) in self.film.iter_mut().enumerate() {
            let moments = moments.next();
            PixelMut { film, moments }.add(radiance(i), sample);
        }
    }

    /// Every pixel by its number in the area, on all cores.
    pub fn each(&mut self, visit: impl Fn(usize, PixelMut<F>) + Sync) {
        let film = self.film.par_iter_mut().enumerate();
        match &mut self.moments {
            None => film.for_each(|(i, film)| {
                let moments = None;
                visit(i, PixelMut { film, moments });
            }),
            Some(moments) => film.zip(moments).for_each(|((i, film), moments)| {
                let moments = Some(moments);
                visit(i, PixelMut { film, moments });
            }),
        }
    }

    fn count(&self, of: fn(&FilmPixel<F>) -> u64) -> u64 {
        self.film.iter().map(of).sum()
    }

    fn develop(&self, values: impl Iterator<Item = Vec3<F>>) -> Film {
        Film {
            width: self.area.width,
            height: self.area.height,
            rgb: values.map(|v| v.f64().as_vec3().to_array()).collect(),
        }
    }
}

impl<F: Real> HostFilm for Pixels<F> {
    fn picture(&self, spp: u32) -> Film {
        self.develop(self.film.iter().map(|p| film_mean(p.sum, spp)))
    }

    fn halves(&self, spp: u32) -> Halves {
        let half = |p: &FilmPixel<F>| film_half_difference(p.sum, p.contrast, spp);
        Halves {
            mean: self.picture(spp),
            half_difference: self.develop(self.film.iter().map(half)),
        }
    }

    fn spread(&self, spp: u32) -> Option<Film> {
        let moments = self.moments.as_ref()?;
        Some(self.develop(moments.iter().map(|m| film_stderr(m, spp))))
    }

    fn counts(&self) -> Counts {
        Counts {
            rays: self.count(|p| p.rays),
            long_paths: self.count(|p| p.long_paths),
            underflows: self.count(|p| p.underflows),
            dropped: Dropped {
                nan: self.count(|p| p.nan),
                infinite: self.count(|p| p.infinite),
                loops: 0,
            },
        }
    }

    fn largest(&self) -> Option<Largest> {
        let of = |(i, p): (u32, &FilmPixel<F>)| Largest {
            address: Address {
                pixel: self.area.pixel(i),
                index: p.largest_sample,
            },
            radiance: p.largest.f64(),
        };
        let all = (0..).zip(&self.film).map(of);
        all.reduce(Largest::or).filter(|l| l.radiance > 0.0)
    }
}
