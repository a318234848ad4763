//! The paths and the film of the current tile, on the device.

use super::beside;
use super::path_film::TileFilm;
use crate::film::Keeps;
use crate::gpu::{Buffer, Device};
use crate::layout::{self, PathState};
use crate::part::{Beside, Counts, Dropped, PixelSums, Sums, Tally};
use crate::reference::film::PixelSum;
use crate::reference::math::{Vec3, vec3};
use crate::render::RenderError;
use crate::render::plan::{ArrayPlan, PathPlan};
use crate::render::tiles::Tile;
use crate::sample::{Address, Largest};

/// The device stores the film of one tile, the host all of them: 8192 × 8192 pixels would not fit the memory of many devices.
pub struct DeviceFilm {
    paths: Buffer,
    film: Buffer,
    beside: Option<Buffer>,
    /// The counters of the tile before it was uploaded: the device counts from 0.
    counted: Tally,
    /// As last read.
    pixels: Vec<layout::FilmPixel>,
}

impl DeviceFilm {
    /// As planned, filled with zeros.
    pub fn new(device: &Device, plan: &PathPlan) -> Result<Self, RenderError> {
        Ok(Self {
            paths: buffer(device, &plan.paths)?,
            film: buffer(device, &plan.film)?,
            beside: plan.beside.map(|b| buffer(device, &b)).transpose()?,
            counted: Tally::default(),
            pixels: Vec::new(),
        })
    }

    /// In the order of their bindings.
    pub fn buffers(&self) -> impl Iterator<Item = &Buffer> {
        [&self.paths, &self.film].into_iter().chain(&self.beside)
    }

    /// Uploads a tile. No path is in flight, in it or in the one before: the film is all that its threads need.
    pub fn upload(&mut self, from: &TileFilm) -> Result<(), RenderError> {
        let Sums {
            samples,
            pixels,
            beside,
        } = &from.sums;
        let pixel = |sums: &PixelSums<f32>| layout::FilmPixel {
            sum: array(sums.sum.sum),
            comp: array(sums.sum.comp),
            contrast: array(sums.contrast),
            samples: *samples,
            ..layout::FilmPixel::default()
        };
        self.pixels.clear();
        self.pixels.extend(pixels.iter().map(pixel));
        self.film.write(bytemuck::cast_slice(&self.pixels))?;
        if let Some(buffer) = &self.beside {
            beside::write(beside, buffer)?;
        }
        self.counted = from.tally;
        Ok(())
    }

    /// Reads the film of a tile; whether every pixel has `samples` samples.
    pub fn read_pixels(&mut self, tile: Tile, samples: u32) -> Result<bool, RenderError> {
        let count = tile.pixels() as usize;
        self.pixels.resize(count, layout::FilmPixel::default());
        self.film
            .read_into(bytemuck::cast_slice_mut(&mut self.pixels))?;
        let loops: u64 = self.pixels.iter().map(|p| u64::from(p.loops)).sum();
        if loops > 0 {
            return Err(RenderError::Loops(loops));
        }
        Ok(self.pixels.iter().all(|p| p.samples == samples))
    }

    /// The tile as it was last read, with the additional sums that `keeps` names. `begin`: the index of
    /// the block's first sample.
    pub fn read(&self, tile: Tile, begin: u32, keeps: Keeps) -> Result<TileFilm, RenderError> {
        let sums = |p: &layout::FilmPixel| PixelSums {
            sum: parts(p.sum, p.comp),
            contrast: vector(p.contrast),
        };
        Ok(TileFilm {
            tile,
            sums: Sums {
                samples: self.pixels.first().map_or(0, |p| p.samples),
                pixels: self.pixels.iter().map(sums).collect(),
                beside: match &self.beside {
                    None => Beside::Nothing,
                    Some(buffer) => beside::read(keeps, buffer, self.pixels.len())?,
                },
            },
            tally: self.counted.plus(tally(&self.pixels, tile, begin)),
        })
    }

    pub fn read_paths(&self) -> Result<Vec<PathState>, RenderError> {
        Ok(bytemuck::pod_collect_to_vec(&self.paths.read()?))
    }
}

/// Zeros, as many as planned.
pub fn buffer(device: &Device, plan: &ArrayPlan) -> Result<Buffer, RenderError> {
    let binding = plan.binding;
    Ok(device.buffer(binding.name, binding.buffer_use, plan.bytes)?)
}

/// The counters of the pixels of a tile, for samples from index `begin` on.
fn tally(pixels: &[layout::FilmPixel], tile: Tile, begin: u32) -> Tally {
    let mut counts = Counts::default();
    for p in pixels {
        counts = counts.plus(Counts {
            rays: p.rays.into(),
            long_paths: p.long_paths.into(),
            underflows: p.underflows.into(),
            dropped: Dropped {
                nan: p.nan.into(),
                infinite: p.infinite.into(),
                loops: p.loops.into(),
            },
        });
    }
    let of = |(i, p): (u32, &layout::FilmPixel)| Largest {
        address: Address {
            pixel: tile.pixel(i),
            index: begin + p.largest_sample,
        },
        radiance: p.largest.into(),
    };
    let largest = (0..).zip(pixels).map(of).reduce(Largest::or);
    Tally {
        counts,
        largest: largest.filter(|l| l.radiance > 0.0),
    }
}

pub fn parts(sum: [f32; 3], comp: [f32; 3]) -> PixelSum<f32> {
    PixelSum {
        sum: vector(sum),
        comp: vector(comp),
    }
}

pub fn vector([x, y, z]: [f32; 3]) -> Vec3<f32> {
    vec3(x, y, z)
}

pub fn array(v: Vec3<f32>) -> [f32; 3] {
    [v.x, v.y, v.z]
}
