//! From the films of all tiles to the picture, and to the sums of what was counted.

use super::tile_film::{PathFilm, TileFilm};
use crate::film::Film;
use crate::layout::{FilmMoments, FilmPixel};
use crate::reference::film::{self, PixelSum, film_half_difference, film_mean, film_stderr};
use crate::reference::math::{Vec3, vec3};
use crate::render::course::Halves;
use crate::render::tiles::Tile;
use crate::render::{Counts, HostFilm};
use crate::sample::{Address, Largest};

impl HostFilm for PathFilm {
    fn picture(&self, spp: u32) -> Film {
        let mean = |p: &FilmPixel| film_mean(parts(p.sum, p.comp), spp);
        assemble(&self.tiles, self.area, |t, k| mean(&t.pixels[k]))
    }

    fn halves(&self, spp: u32) -> Halves {
        let half_difference = |p: &FilmPixel| {
            let [x, y, z] = p.contrast;
            let sum = parts(p.sum, p.comp);
            film_half_difference(sum, vec3(x, y, z), spp)
        };
        Halves {
            mean: self.picture(spp),
            half_difference: assemble(&self.tiles, self.area, |t, k| half_difference(&t.pixels[k])),
        }
    }

    fn spread(&self, spp: u32) -> Option<Film> {
        let stderr = |m: &FilmMoments| {
            let moments = film::FilmMoments {
                mean: parts(m.mean, m.mean_comp),
                m2: parts(m.m2, m.m2_comp),
            };
            film_stderr(&moments, spp)
        };
        let kept = self.tiles.iter().all(|t| !t.moments.is_empty());
        kept.then(|| assemble(&self.tiles, self.area, |t, k| stderr(&t.moments[k])))
    }

    fn counts(&self) -> Counts {
        let mut counts = Counts::default();
        for p in self.tiles.iter().flat_map(|t| &t.pixels) {
            counts.rays += u64::from(p.rays);
            counts.long_paths += u64::from(p.long_paths);
            counts.underflows += u64::from(p.underflows);
            counts.dropped.nan += u64::from(p.nan);
            counts.dropped.infinite += u64::from(p.infinite);
            counts.dropped.loops += u64::from(p.loops);
        }
        counts
    }

    fn largest(&self) -> Option<Largest> {
        let of = |tile: &Tile, (i, p): (u32, &FilmPixel)| Largest {
            address: Address {
                pixel: tile.pixel(i),
                index: p.largest_sample,
            },
            radiance: p.largest.into(),
        };
        let tiles = self.tiles.iter();
        let all = tiles.flat_map(|t| (0..).zip(&t.pixels).map(move |p| of(&t.tile, p)));
        all.reduce(Largest::or).filter(|l| l.radiance > 0.0)
    }
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
