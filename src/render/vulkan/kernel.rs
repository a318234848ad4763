//! A scene's kernel on a device, in one pipeline or two, and one dispatch of it.

use std::time::{Duration, Instant};

use super::rendering::Costs;
use super::scene_buffers::SceneBuffers;
use crate::features::Features;
use crate::gpu::{Buffer, BufferUse, Device, Pipeline};
use crate::kernel::scene::Recording;
use crate::layout::GpuStruct;
use crate::layout::constants::workgroup::WORKGROUP;
use crate::render::plan::{PlanLimits, ScenePlan, compiled, composed, hierarchy};
use crate::render::{Job, RenderError};

/// What an integrator dispatches, the arrays of the scene with it.
pub struct Kernel<'a> {
    device: &'a Device,
    /// One for each [`Side`](crate::kernel::scene::Side) of the integrator.
    pipelines: Vec<Pipeline>,
    pub scene: SceneBuffers,
    pub costs: Costs,
}

impl<'a> Kernel<'a> {
    /// Composes and compiles it, uploads the scene. `state`: how many arrays each of its pipelines writes, all of them in
    /// storage; `Slice`: what a dispatch is told.
    pub fn new<Slice: GpuStruct>(
        job: &Job,
        device: &'a Device,
        features: &Features,
        recording: Recording,
        read_first: bool,
        state: &[usize],
    ) -> Result<Self, RenderError> {
        let mut costs = Costs::default();
        let start = Instant::now();
        let bvh = hierarchy(job.prepared, features);
        costs.set_up.hierarchy = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let limits = PlanLimits {
            read_first,
            ..PlanLimits::of(device)
        };
        let plan = ScenePlan::new(job, features, bvh.as_ref(), limits);
        let composed = composed(&plan, features, recording)?;
        let spirv: Vec<_> = (composed.iter())
            .map(|kernel| compiled(kernel, features))
            .collect::<Result<_, _>>()?;
        costs.spirv_bytes = spirv.iter().map(|s| s.bytes().len() as u64).sum();
        costs.set_up.compose = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let scene = SceneBuffers::new(device, &plan)?;
        costs.set_up.upload = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let pipeline = |(spirv, &state): (_, &usize)| {
            let mut uses = scene.uses();
            uses.resize(uses.len() + state, BufferUse::Storage);
            device.pipeline(spirv, &uses, size_of::<Slice>() as u32)
        };
        let pipelines: Vec<_> = (spirv.iter().zip(state))
            .map(pipeline)
            .collect::<Result<_, _>>()?;
        costs.set_up.pipeline = start.elapsed().as_secs_f64();
        Ok(Self {
            device,
            pipelines,
            scene,
            costs,
        })
    }

    /// Runs `threads` threads of a pipeline on the scene's buffers and `state`, in the order of their bindings.
    pub fn dispatch<'b>(
        &'b mut self,
        pipeline: usize,
        state: impl Iterator<Item = &'b Buffer>,
        slice: &impl GpuStruct,
        threads: u32,
    ) -> Result<Duration, RenderError> {
        let mut buffers = self.scene.buffers();
        buffers.extend(state);
        let groups = [threads.div_ceil(WORKGROUP), 1, 1];
        let push = bytemuck::bytes_of(slice);
        let time = self
            .device
            .dispatch(&self.pipelines[pipeline], &buffers, push, groups)?;
        self.costs.gpu_time += time;
        Ok(time)
    }

    /// Names and bytes of the scene's buffers and of `state`.
    pub fn buffers<'b>(&'b self, state: impl Iterator<Item = &'b Buffer>) -> Vec<(String, u64)> {
        let scene = self.scene.buffers().into_iter();
        let entry = |b: &Buffer| (b.name().to_owned(), b.bytes());
        scene.chain(state).map(entry).collect()
    }
}
