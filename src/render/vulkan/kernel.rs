//! A scene's kernel on a device, and one dispatch of it.

use std::time::{Duration, Instant};

use super::rendering::Costs;
use super::scene_buffers::SceneBuffers;
use crate::features::Features;
use crate::gpu::{Buffer, Device, Pipeline};
use crate::kernel::scene::Recording;
use crate::layout::GpuStruct;
use crate::layout::constants::workgroup::WORKGROUP;
use crate::render::plan::{ArrayPlan, PlanLimits, ScenePlan, compiled, composed, hierarchy};
use crate::render::{Job, RenderError};

/// What an integrator dispatches, the arrays of the scene with it.
pub struct Kernel<'a> {
    device: &'a Device,
    pipeline: Pipeline,
    pub scene: SceneBuffers,
    pub costs: Costs,
}

impl<'a> Kernel<'a> {
    /// Composes and compiles it, uploads the scene. `state`: the arrays that it writes; `Slice`: what a dispatch is told.
    pub fn new<Slice: GpuStruct>(
        job: &Job,
        device: &'a Device,
        features: &Features,
        recording: Recording,
        read_first: bool,
        state: impl Iterator<Item = ArrayPlan>,
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
        let spirv = compiled(&composed(&plan, features, recording)?, features)?;
        costs.spirv_bytes = spirv.bytes().len() as u64;
        costs.set_up.compose = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let scene = SceneBuffers::new(device, &plan)?;
        costs.set_up.upload = start.elapsed().as_secs_f64();
        let mut uses = scene.uses();
        uses.extend(state.map(|array| array.binding.buffer_use));
        let start = Instant::now();
        let pipeline = device.pipeline(&spirv, &uses, size_of::<Slice>() as u32)?;
        costs.set_up.pipeline = start.elapsed().as_secs_f64();
        Ok(Self {
            device,
            pipeline,
            scene,
            costs,
        })
    }

    /// Runs `threads` threads on the scene's buffers and `state`, in the order of their bindings.
    pub fn dispatch<'b>(
        &'b mut self,
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
            .dispatch(&self.pipeline, &buffers, push, groups)?;
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
