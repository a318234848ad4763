//! What every single sample comes to on a device, before the film adds it up.

use super::limits::DispatchLimits;
use super::path::PathRun;
use super::tile_film::TileFilm;
use crate::gpu::Device;
use crate::kernel::scene::Recording;
use crate::layout::PathOutcome;
use crate::render::tiles::Tile;
use crate::render::{Job, RenderError};

/// A kernel that tells each sample, and room for the samples of one tile.
pub struct Outcomes<'a> {
    run: PathRun<'a>,
    /// Samples a pixel that there is room for.
    room: u32,
}

impl<'a> Outcomes<'a> {
    /// Tiles of at most `tile_pixels`, `room` samples a pixel at a time.
    pub fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        tile_pixels: u32,
        room: u32,
    ) -> Result<Self, RenderError> {
        let features = job.features();
        let limits = DispatchLimits::of(device)?;
        let limits = DispatchLimits {
            tile_pixels: limits.tile_pixels.min(tile_pixels),
            ..limits
        };
        let recording = Recording::Outcomes(room);
        Ok(Self {
            run: PathRun::recording(job, device, &features, limits, recording)?,
            room,
        })
    }

    pub fn tiles(&self) -> Vec<Tile> {
        self.run.host.tiles.iter().map(|t| t.tile).collect()
    }

    /// The samples from `first` on of each pixel of a tile, row by row: `count` ≤ `room` of them, one after the other.
    pub fn of(
        &mut self,
        tile: usize,
        first: u32,
        count: u32,
    ) -> Result<Vec<Vec<PathOutcome>>, RenderError> {
        self.run.restart(tile, first)?;
        self.run.advance_tile(tile, count)?;
        let TileFilm { tile, .. } = &self.run.host.tiles[tile];
        let all = self.run.outcomes()?;
        let pixels = all.chunks(self.room as usize).take(tile.pixels() as usize);
        Ok(pixels
            .map(|samples| samples[..count as usize].to_vec())
            .collect())
    }
}
