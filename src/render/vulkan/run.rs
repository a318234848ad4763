//! What a rendering keeps on the device, and one dispatch of it.

use std::time::{Duration, Instant};

use super::limits::DispatchLimits;
use super::scene_buffers::SceneBuffers;
use super::tile_film::{DeviceFilm, TileFilm, buffer};
use crate::features::Features;
use crate::gpu::{Buffer, Device, Pipeline};
use crate::kernel::Spirv;
use crate::kernel::scene::Recording;
use crate::layout::{PathOutcome, Record, Slice};
use crate::render::plan::{PlanLimits, ScenePlan, StatePlan, compiled, composed, hierarchy};
use crate::render::tiles::{Tile, tiles};
use crate::render::{Job, RenderError, SetUp};

/// Threads of a workgroup; `local_size_x` of `shaders/integrator/path/path_trace.comp`.
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
    film: DeviceFilm,
    /// Events of one path, or outcomes of all.
    recorded: Option<Buffer>,
    pub tiles: Vec<TileFilm>,
    /// How long all this took to make; opening the device is not in it.
    pub set_up: SetUp,
    pub spirv_bytes: u64,
    /// The device's own time for all dispatches.
    pub gpu_time: Duration,
    budget: u32,
    /// Index of the first sample.
    pub sample_begin: u32,
}

impl<'a> Run<'a> {
    pub fn new(
        job: &'a Job,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
        recording: Recording,
    ) -> Result<Self, RenderError> {
        let mut set_up = SetUp::default();
        let (scene, spirv) = scene_and_kernel(
            job,
            device,
            features,
            recording,
            limits.read_first,
            &mut set_up,
        )?;
        let tiles = tiles(job.area(), limits.tile_pixels.max(1));
        let largest = tiles.iter().map(Tile::pixels).max().unwrap_or(1);
        let moments = features.keeps_moments();
        let state = StatePlan::new(features, largest, recording);
        let start = Instant::now();
        let film = DeviceFilm::new(device, &state)?;
        let recorded = state.recorded.map(|r| buffer(device, &r)).transpose()?;
        set_up.upload += start.elapsed().as_secs_f64();
        let mut uses = scene.uses();
        uses.extend(state.plans().map(|array| array.binding.buffer_use));
        let start = Instant::now();
        let pipeline = device.pipeline(&spirv, &uses, size_of::<Slice>() as u32)?;
        set_up.pipeline = start.elapsed().as_secs_f64();
        Ok(Self {
            job,
            device,
            pipeline,
            scene,
            film,
            recorded,
            tiles: tiles
                .into_iter()
                .map(|tile| TileFilm::new(tile, moments))
                .collect(),
            set_up,
            spirv_bytes: spirv.bytes().len() as u64,
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
    ///
    /// # Errors
    /// [`RenderError::Loops`] after the first dispatch that did not end its loops itself: what comes after would
    /// be wrong too.
    pub fn advance(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        if self.tiles.len() > 1 {
            self.film.upload(&self.tiles[tile])?;
        }
        let mut longest = Duration::ZERO;
        loop {
            longest = longest.max(self.dispatch(tile, sample_end)?);
            let kept = &mut self.tiles[tile];
            self.film.read_pixels(kept)?;
            let loops: u64 = kept.pixels.iter().map(|p| u64::from(p.loops)).sum();
            if loops > 0 {
                return Err(RenderError::Loops(loops));
            }
            if kept.pixels.iter().all(|p| p.samples == sample_end) {
                self.film.read_moments(kept)?;
                return Ok(longest);
            }
        }
    }

    /// Begins a tile anew, at the sample of index `sample_begin`.
    pub fn restart(&mut self, tile: usize, sample_begin: u32) -> Result<(), RenderError> {
        self.sample_begin = sample_begin;
        self.tiles[tile].clear();
        self.film.upload(&self.tiles[tile])
    }

    /// Takes up other tiles, of which no path is under way, by other random numbers; gives back those so far.
    pub fn exchange(
        &mut self,
        tiles: Vec<TileFilm>,
        seed: u32,
    ) -> Result<Vec<TileFilm>, RenderError> {
        self.scene.reseed(self.job.prepared, seed)?;
        let before = std::mem::replace(&mut self.tiles, tiles);
        // Of several tiles, each is uploaded when its turn comes.
        if let [tile] = &self.tiles[..] {
            self.film.upload(tile)?;
        }
        Ok(before)
    }

    fn dispatch(&mut self, tile: usize, sample_end: u32) -> Result<Duration, RenderError> {
        let tile = &self.tiles[tile].tile;
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
        buffers.extend(self.film.buffers());
        buffers.extend(&self.recorded);
        let groups = [tile.pixels().div_ceil(WORKGROUP), 1, 1];
        let push = bytemuck::bytes_of(&slice);
        let time = self
            .device
            .dispatch(&self.pipeline, &buffers, push, groups)?;
        self.gpu_time += time;
        Ok(time)
    }

    /// Names and bytes of all buffers, in the order of their bindings.
    pub fn buffers(&self) -> Vec<(String, u64)> {
        let mut buffers = self.scene.buffers();
        buffers.extend(self.film.buffers());
        buffers.extend(&self.recorded);
        let told = |b: &Buffer| (b.name().to_owned(), b.bytes());
        buffers.into_iter().map(told).collect()
    }

    /// What the samples of the tile that was advanced last came to: as many a pixel as the kernel has room for.
    pub fn outcomes(&self) -> Result<Vec<PathOutcome>, RenderError> {
        let buffer = self.recorded.as_ref();
        let bytes = buffer.map_or(Ok(Vec::new()), Buffer::read)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

    /// The events written down, in order.
    pub fn records(&self) -> Result<Vec<Record>, RenderError> {
        let paths = self.film.read_paths()?;
        let Some(buffer) = &self.recorded else {
            return Ok(Vec::new());
        };
        let mut records: Vec<Record> = bytemuck::pod_collect_to_vec(&buffer.read()?);
        records.truncate(paths[0].recorded as usize);
        Ok(records)
    }
}

/// The scene's buffers on the device, and the kernel that is composed for them.
fn scene_and_kernel(
    job: &Job,
    device: &Device,
    features: &Features,
    recording: Recording,
    read_first: bool,
    set_up: &mut SetUp,
) -> Result<(SceneBuffers, Spirv), RenderError> {
    let start = Instant::now();
    let bvh = hierarchy(job.prepared, features);
    set_up.hierarchy = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let limits = PlanLimits {
        read_first,
        ..PlanLimits::of(device)
    };
    let plan = ScenePlan::new(job, features, bvh.as_ref(), limits);
    let spirv = compiled(&composed(&plan, features, recording)?, features)?;
    set_up.compose = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let buffers = SceneBuffers::new(device, &plan)?;
    set_up.upload = start.elapsed().as_secs_f64();
    Ok((buffers, spirv))
}
