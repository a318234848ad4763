//! What the host keeps of a tile: the film of its pixels, row by row, and all that goes with it.

use crate::gpu::{Buffer, Device};
use crate::layout::{FilmMoments, FilmPixel, PathState};
use crate::render::RenderError;
use crate::render::plan::{ArrayPlan, PathPlan};
use crate::render::tiles::Tile;

/// A tile between two of its slices.
pub struct TileFilm {
    pub tile: Tile,
    pub pixels: Vec<FilmPixel>,
    /// Empty where no standard errors come from them.
    pub moments: Vec<FilmMoments>,
}

impl TileFilm {
    /// No samples yet.
    pub fn new(tile: Tile, moments: bool) -> Self {
        let pixels = tile.pixels() as usize;
        Self {
            tile,
            pixels: vec![FilmPixel::default(); pixels],
            moments: vec![FilmMoments::default(); if moments { pixels } else { 0 }],
        }
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        self.pixels.fill(FilmPixel::default());
        self.moments.fill(FilmMoments::default());
    }
}

/// The film of a path tracer, all tiles of it.
pub struct PathFilm {
    pub area: Tile,
    pub tiles: Vec<TileFilm>,
}

impl PathFilm {
    /// No samples yet.
    pub fn new(area: Tile, tiles: Vec<Tile>, moments: bool) -> Self {
        let film = |tile| TileFilm::new(tile, moments);
        Self {
            area,
            tiles: tiles.into_iter().map(film).collect(),
        }
    }

    /// Another of the same tiles, without samples.
    pub fn empty(&self) -> Self {
        let film = |t: &TileFilm| TileFilm::new(t.tile, !t.moments.is_empty());
        Self {
            area: self.area,
            tiles: self.tiles.iter().map(film).collect(),
        }
    }
}

/// The paths and the film of the tile under way, on the device.
pub struct DeviceFilm {
    paths: Buffer,
    film: Buffer,
    moments: Option<Buffer>,
}

impl DeviceFilm {
    /// As planned, zeros.
    pub fn new(device: &Device, plan: &PathPlan) -> Result<Self, RenderError> {
        Ok(Self {
            paths: buffer(device, &plan.paths)?,
            film: buffer(device, &plan.film)?,
            moments: plan.moments.map(|m| buffer(device, &m)).transpose()?,
        })
    }

    /// In the order of their bindings.
    pub fn buffers(&self) -> impl Iterator<Item = &Buffer> {
        [&self.paths, &self.film].into_iter().chain(&self.moments)
    }

    /// Takes up a tile. No path is under way, of it or of the one before: all its threads need is the film.
    pub fn upload(&self, from: &TileFilm) -> Result<(), RenderError> {
        self.film.write(bytemuck::cast_slice(&from.pixels))?;
        if let Some(moments) = &self.moments {
            moments.write(bytemuck::cast_slice(&from.moments))?;
        }
        Ok(())
    }

    /// Reads the film alone, which tells whether the tile is done.
    pub fn read_pixels(&self, to: &mut TileFilm) -> Result<(), RenderError> {
        Ok(self
            .film
            .read_into(bytemuck::cast_slice_mut(&mut to.pixels))?)
    }

    /// Reads what else goes with the film.
    pub fn read_moments(&self, to: &mut TileFilm) -> Result<(), RenderError> {
        if let Some(moments) = &self.moments {
            moments.read_into(bytemuck::cast_slice_mut(&mut to.moments))?;
        }
        Ok(())
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
