//! Plans a rendering without a device: its arrays, its hierarchy, its kernel.

mod absent;
mod array;
mod limits;
mod scene;
mod state;

pub use array::ArrayPlan;
pub use limits::PlanLimits;
pub use scene::{CAMERA, ScenePlan, hierarchy};
pub use state::{EyePlan, LightPlan, PathPlan, StatePlan, thread_tiles};

use super::tiles::Tile;
use super::{Job, RenderError};
use crate::features::Features;
use crate::flat::bvh::Cost;
use crate::kernel::scene::Recording;
use crate::kernel::{self, Composed, KernelError, Spirv};

/// A rendering before it begins.
#[derive(Clone, Debug)]
pub struct Plan {
    pub features: Features,
    /// The arrays that the kernel reads: those of the scene, in the order of bindings.
    pub scene: Vec<ArrayPlan>,
    /// The arrays that it writes: paths and film of a tile, in the order of bindings.
    pub state: StatePlan,
    pub hierarchy: Option<HierarchyPlan>,
    /// Pixels of the picture, or of its crop.
    pub pixels: u64,
    /// The tiles, rendered one after the other; each has at most `tile_pixels` pixels.
    pub tiles: usize,
    pub tile_pixels: u32,
    /// One, or two for an integrator that follows paths from both ends.
    pub kernels: Vec<Composed>,
}

/// A bounding volume hierarchy in figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HierarchyPlan {
    pub nodes: usize,
    pub primitives: usize,
    /// Entries of a traversal's stack.
    pub stack: u32,
    pub cost: Cost,
}

impl Plan {
    /// The plan for rendering `job` on a device of these limits.
    ///
    /// # Errors
    /// If the integrator has no kernel; if it can't be composed, which would be a bug in this program.
    pub fn new(job: &Job, limits: PlanLimits) -> Result<Self, RenderError> {
        let features = job.features();
        let bvh = hierarchy(job.prepared, &features);
        let scene = ScenePlan::new(job, &features, bvh.as_ref(), limits);
        let kernels = composed(&scene, &features, Recording::Nothing)?;
        let tiles = thread_tiles(job, limits.tile_pixels);
        let tile_pixels = tiles.iter().map(Tile::pixels).max().unwrap_or(1);
        Ok(Self {
            scene: scene.plans().collect(),
            state: StatePlan::new(&features, tile_pixels, Recording::Nothing),
            hierarchy: bvh.as_ref().map(|bvh| HierarchyPlan {
                nodes: bvh.nodes.len(),
                primitives: bvh.references.len(),
                stack: bvh.stack,
                cost: bvh.cost,
            }),
            pixels: u64::from(job.area().pixels()),
            tiles: tiles.len(),
            tile_pixels,
            kernels,
            features,
        })
    }

    /// The compiled kernels.
    pub fn compile(&self) -> Result<Vec<Spirv>, RenderError> {
        let compile = |kernel| compiled(kernel, &self.features);
        self.kernels.iter().map(compile).collect()
    }

    /// The bytes of all buffers on the device.
    pub fn device_bytes(&self) -> u64 {
        let arrays = self.scene.iter().copied().chain(self.state.plans());
        arrays.map(|a| a.bytes).sum()
    }
}

/// The kernels of these features for the arrays of `scene`, in the order of their dispatches.
pub fn composed(
    scene: &ScenePlan,
    features: &Features,
    recording: Recording,
) -> Result<Vec<Composed>, RenderError> {
    kernel::scene::compose(features, &scene.parameters(recording)).map_err(mistake(features))
}

/// The compiled kernel of these features.
pub fn compiled(kernel: &Composed, features: &Features) -> Result<Spirv, RenderError> {
    kernel::compile(kernel).map_err(mistake(features))
}

fn mistake(features: &Features) -> impl FnOnce(KernelError) -> RenderError {
    let features = Box::new(features.clone());
    move |error| RenderError::Kernel { error, features }
}
