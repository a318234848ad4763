//! From the films of all tiles to the picture, and to the sums of what was counted.

use super::tile_film::TileFilm;
use crate::film::Film;
use crate::layout::{FilmMoments, FilmPixel};
use crate::reference::film::{self, PixelSum, film_half_difference, film_mean, film_stderr};
use crate::reference::math::{Vec3, vec3};
use crate::render::Dropped;
use crate::render::course::Halves;
use crate::render::tiles::Tile;

/// Sums over the pixels.
#[derive(Default)]
pub struct Counts {
    pub rays: u64,
    pub long_paths: u64,
    pub underflows: u64,
    pub dropped: Dropped,
}

impl Counts {
    pub fn of(tiles: &[TileFilm]) -> Self {
        let mut counts = Self::default();
        let pixels = tiles.iter().flat_map(|t| &t.pixels);
        pixels.for_each(|p| counts.add(p));
        counts
    }

    fn add(&mut self, p: &FilmPixel) {
        self.rays += u64::from(p.rays);
        self.long_paths += u64::from(p.long_paths);
        self.underflows += u64::from(p.underflows);
        self.dropped.nan += u64::from(p.nan);
        self.dropped.infinite += u64::from(p.infinite);
        self.dropped.loops += u64::from(p.loops);
    }
}

/// The picture of `spp` samples a pixel.
pub fn picture(tiles: &[TileFilm], area: Tile, spp: u32) -> Film {
    let mean = |p: &FilmPixel| film_mean(parts(p.sum, p.comp), spp);
    assemble(tiles, area, |t, k| mean(&t.pixels[k]))
}

/// That picture, with half the difference of its two groups of samples; `spp` ≥ 2.
pub fn halves(tiles: &[TileFilm], area: Tile, spp: u32) -> Halves {
    let half_difference = |p: &FilmPixel| {
        let [x, y, z] = p.contrast;
        let sum = parts(p.sum, p.comp);
        film_half_difference(sum, vec3(x, y, z), spp)
    };
    Halves {
        mean: picture(tiles, area, spp),
        half_difference: assemble(tiles, area, |t, k| half_difference(&t.pixels[k])),
    }
}

/// The standard errors of the mean of `spp` ≥ 2 samples a pixel, whose moments were kept.
pub fn standard_errors(tiles: &[TileFilm], area: Tile, spp: u32) -> Film {
    let stderr = |m: &FilmMoments| {
        let moments = film::FilmMoments {
            mean: parts(m.mean, m.mean_comp),
            m2: parts(m.m2, m.m2_comp),
        };
        film_stderr(&moments, spp)
    };
    assemble(tiles, area, |t, k| stderr(&t.moments[k]))
}

/// Puts pixel k of each tile in its place.
fn assemble(tiles: &[TileFilm], area: Tile, value: impl Fn(&TileFilm, usize) -> Vec3<f32>) -> Film {
    let mut rgb = vec![[0.0; 3]; area.pixels() as usize];
    for part in tiles {
        let tile = &part.tile;
        for k in 0..part.pixels.len() {
            let x = tile.x - area.x + k as u32 % tile.width;
            let y = tile.y - area.y + k as u32 / tile.width;
            let v = value(part, k);
            rgb[(y * area.width + x) as usize] = [v.x, v.y, v.z];
        }
    }
    Film {
        width: area.width,
        height: area.height,
        rgb,
    }
}

fn parts(sum: [f32; 3], comp: [f32; 3]) -> PixelSum<f32> {
    let rgb = |[r, g, b]: [f32; 3]| vec3(r, g, b);
    PixelSum {
        sum: rgb(sum),
        comp: rgb(comp),
    }
}
