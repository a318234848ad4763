//! A scene's kernel on a device, in one pipeline or two, and one dispatch of it.

use std::time::{Duration, Instant};

use super::rendering::Costs;
use super::scene_buffers::SceneBuffers;
use crate::features::Features;
use crate::gpu::{Buffer, BufferUse, Device, GpuError, Pipeline, Statistic};
use crate::kernel::Spirv;
use crate::kernel::scene::Recording;
use crate::layout::GpuStruct;
use crate::layout::constants::workgroup::WORKGROUP;
use crate::render::plan::{PlanLimits, ScenePlan, StatePlan, compiled, composed, hierarchy};
use crate::render::{Job, Plan, RenderError};

/// The pipelines of an integrator, with the arrays of the scene.
pub struct Kernel<'a> {
    device: &'a Device,
    /// One for each [`Side`](crate::kernel::scene::Side) of the integrator.
    pipelines: Vec<Pipeline>,
    pub scene: SceneBuffers,
    pub costs: Costs,
}

impl<'a> Kernel<'a> {
    /// Composes and compiles it, uploads the scene. `state`: the arrays that its pipelines write.
    pub fn new(
        job: &Job,
        device: &'a Device,
        features: &Features,
        recording: Recording,
        limits: PlanLimits,
        state: &StatePlan,
    ) -> Result<Self, RenderError> {
        let mut costs = Costs::default();
        let start = Instant::now();
        let bvh = hierarchy(job.prepared, features);
        costs.set_up.hierarchy = start.elapsed().as_secs_f64();
        let start = Instant::now();
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
        let pipelines = pipelines(device, &spirv, &scene.uses(), state)?;
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

/// The driver's statistics of each kernel of a plan, compiled to `spirv`: nothing is uploaded, nothing runs. Empty if
/// the driver has none.
pub fn statistics(
    plan: &Plan,
    spirv: &[Spirv],
    device: &Device,
) -> Result<Vec<Vec<Statistic>>, GpuError> {
    if !device.counts() {
        return Ok(Vec::new());
    }
    let scene: Vec<_> = plan.scene.iter().map(|a| a.binding.buffer_use).collect();
    let pipelines = pipelines(device, spirv, &scene, &plan.state)?;
    pipelines.iter().map(Pipeline::statistics).collect()
}

/// A pipeline for each kernel: the arrays that it writes follow those of the scene.
fn pipelines(
    device: &Device,
    spirv: &[Spirv],
    scene: &[BufferUse],
    state: &StatePlan,
) -> Result<Vec<Pipeline>, GpuError> {
    let pipeline = |(spirv, written): (_, usize)| {
        let mut uses = scene.to_vec();
        uses.resize(scene.len() + written, BufferUse::Storage);
        device.pipeline(spirv, &uses, state.push_bytes() as u32)
    };
    spirv.iter().zip(state.bound()).map(pipeline).collect()
}
