//! What a rendering keeps on the device, and one dispatch of it.

use std::time::{Duration, Instant};

use super::limits::DispatchLimits;
use super::scene_buffers::SceneBuffers;
use crate::features::Features;
use crate::gpu::{Buffer, BufferUse, Device, Pipeline};
use crate::kernel::{self, Spirv};
use crate::layout::{FilmPixel, PathState, Record, Slice};
use crate::render::tiles::{Tile, tiles};
use crate::render::{Job, RenderError};

/// Threads of a workgroup; `local_size_x` of `shaders/path_trace.comp`.
const WORKGROUP: u32 = 64;

/// A scene's kernel, its buffers, and the films of all tiles.
///
/// The device holds the film of the tile under way, the host all of them: 8192 × 8192 pixels would not fit the
/// memory of many a device.
pub struct Run<'a> {
    job: &'a Job<'a>,
    device: &'a Device,
    pipeline: Pipeline,
    scene: SceneBuffers,
    paths: Buffer,
    film: Buffer,
    records: Option<Buffer>,
    /// Each tile and its film, row by row.
    pub tiles: Vec<(Tile, Vec<FilmPixel>)>,
    /// The device's own time for all dispatches.
    pub gpu_time: Duration,
    budget: u32,
    /// Index of the first sample.
    pub sample_begin: u32,
}

impl<'a> Run<'a> {
    /// `records`: how many events of paths to write down.
    pub fn new(
        job: &'a Job,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
        records: Option<u32>,
    ) -> Result<Self, RenderError> {
        let (scene, spirv) = scene_and_kernel(job, device, features, records)?;
        let mut uses = scene.uses();
        uses.extend([BufferUse::Storage; 2]);
        uses.extend(records.map(|_| BufferUse::Storage));
        let pipeline = device.pipeline(&spirv, &uses, size_of::<Slice>() as u32)?;
        let tiles = tiles(job.area(), limits.tile_pixels.max(1));
        let largest = tiles.iter().map(Tile::pixels).max().unwrap_or(1);
        Ok(Self {
            job,
            device,
            pipeline,
            scene,
            paths: array::<PathState>(device, "paths", largest)?,
            film: array::<FilmPixel>(device, "film", largest)?,
            records: records
                .map(|n| array::<Record>(device, "records", n))
                .transpose()?,
            tiles: tiles.into_iter().map(fresh_film).collect(),
            gpu_time: Duration::ZERO,
            budget: limits.budget.max(1),
            sample_begin: 0,
        })
    }

    /// The first dispatch, on which drivers compile: asks for no sample.
    pub fn compile(&mut self) -> Result<Duration, RenderError> {
        let start = Instant::now();
        self.dispatch(0, 0)?;
        Ok(start.elapsed())
    }

    /// Brings every pixel of a tile to `sample_end` samples; returns the longest dispatch.
    pub fn advance(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        if self.tiles.len() > 1 {
            self.upload(tile)?;
        }
        let mut longest = Duration::ZERO;
        loop {
            longest = longest.max(self.dispatch(tile, sample_end)?);
            let film = &mut self.tiles[tile].1;
            self.film.read_into(bytemuck::cast_slice_mut(film))?;
            let failed = film.iter().any(|p| p.loops > 0);
            if failed || film.iter().all(|p| p.samples == sample_end) {
                return Ok(longest);
            }
        }
    }

    /// Takes up a tile of which no path is under way: its threads need to know only how many samples they have
    /// begun.
    fn upload(&mut self, tile: usize) -> Result<(), RenderError> {
        let film = &self.tiles[tile].1;
        let fresh = |p: &FilmPixel| PathState {
            index: p.samples,
            ..PathState::default()
        };
        let paths: Vec<PathState> = film.iter().map(fresh).collect();
        self.film.write(bytemuck::cast_slice(film))?;
        Ok(self.paths.write(bytemuck::cast_slice(&paths))?)
    }

    fn dispatch(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        let tile = &self.tiles[tile].0;
        let slice = Slice {
            tile_x: tile.x,
            tile_y: tile.y,
            tile_width: tile.width,
            tile_height: tile.height,
            sample_begin: self.sample_begin,
            sample_end,
            budget: self.budget,
            eye_medium: self.job.prepared.eye_medium,
        };
        let mut buffers = self.scene.buffers();
        buffers.extend([&self.paths, &self.film]);
        buffers.extend(&self.records);
        let groups = [tile.pixels().div_ceil(WORKGROUP), 1, 1];
        let push = bytemuck::bytes_of(&slice);
        let time = self
            .device
            .dispatch(&self.pipeline, &buffers, push, groups)?;
        self.gpu_time += time;
        Ok(time)
    }

    /// The events written down, in order.
    pub fn records(&self) -> Result<Vec<Record>, RenderError> {
        let paths: Vec<PathState> = bytemuck::pod_collect_to_vec(&self.paths.read()?);
        let Some(buffer) = &self.records else {
            return Ok(Vec::new());
        };
        let mut records: Vec<Record> = bytemuck::pod_collect_to_vec(&buffer.read()?);
        records.truncate(paths[0].recorded as usize);
        Ok(records)
    }
}

fn fresh_film(tile: Tile) -> (Tile, Vec<FilmPixel>) {
    (tile, vec![FilmPixel::default(); tile.pixels() as usize])
}

/// The scene's buffers on the device, and the kernel that is composed for them.
pub fn scene_and_kernel(
    job: &Job,
    device: &Device,
    features: &Features,
    records: Option<u32>,
) -> Result<(SceneBuffers, Spirv), RenderError> {
    let scene = SceneBuffers::new(device, job.prepared, features, job.seed)?;
    let composed = kernel::scene::compose(features, &scene.parameters(job, records))?;
    Ok((scene, kernel::compile(&composed)?))
}

fn array<T>(device: &Device, name: &str, count: u32) -> Result<Buffer, RenderError> {
    let bytes = u64::from(count) * size_of::<T>() as u64;
    Ok(device.buffer(name, BufferUse::Storage, bytes)?)
}
