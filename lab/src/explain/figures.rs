//! Sizes: of kernels, of buffers, of memory.

use super::Compiled;
use crate::explain::report::{Buffer, Hierarchy, KernelSize, Memory};
use vkpt::film::Aov;
use vkpt::flat::bvh::NODE_WORDS;
use vkpt::layout::BufferUse;
use vkpt::prepared::{Footprint, Prepared};
use vkpt::render::{ArrayPlan, HierarchyPlan, Job, Plan};

pub fn kernel((plan, spirv): Compiled) -> KernelSize {
    KernelSize {
        files: plan.kernels.iter().map(|k| k.files().count()).sum(),
        lines: plan.kernels.iter().map(|k| k.text().lines().count()).sum(),
        functions: spirv.iter().map(|s| s.functions.len()).sum(),
        spirv_bytes: spirv.iter().map(|s| s.bytes().len()).sum(),
        instructions: spirv.iter().map(|s| s.instructions().count()).sum(),
    }
}

pub fn buffers(plan: &Plan) -> Vec<Buffer> {
    let buffer = |array: ArrayPlan, written: bool| Buffer {
        name: array.binding.name,
        element: array.binding.element.glsl(),
        count: array.binding.count,
        bytes: array.bytes,
        uniform: array.binding.buffer_use == BufferUse::Uniform,
        written,
    };
    let read = plan.scene.iter().map(|&a| buffer(a, false));
    read.chain(plan.state.plans().into_iter().map(|a| buffer(a, true)))
        .collect()
}

pub fn hierarchy(h: &HierarchyPlan) -> Hierarchy {
    Hierarchy {
        nodes: h.nodes,
        node_bytes: NODE_WORDS * size_of::<u32>(),
        primitives: h.primitives,
        stack: h.stack,
        node_visits: h.cost.nodes,
        primitive_tests: h.cost.primitives,
    }
}

pub fn memory(job: &Job, plan: &Plan) -> Memory {
    let films = 1 + job.aovs.contains(&Aov::Stderr) as u64;
    Memory {
        device: plan.device_bytes(),
        tile_pixels: plan.tile_pixels,
        tiles: plan.tiles,
        scene: scene(job.prepared),
        peak: Footprint::of_prepared(job.prepared).peak(),
        films: plan.pixels * plan.state.film_bytes(&plan.features),
        pictures: films * plan.pixels * size_of::<[f32; 3]>() as u64,
    }
}

/// Triangles, and shapes that are no mesh.
pub fn primitives(p: &Prepared) -> usize {
    p.shapes.iter().map(|s| s.count as usize).sum()
}

/// Bytes of the arrays of the prepared scene.
fn scene(p: &Prepared) -> u64 {
    let surroundings = p.surroundings.as_ref();
    let arrays = [
        size_of_val(&p.shapes[..]),
        p.primitives.bytes(),
        size_of_val(&p.materials[..]),
        size_of_val(&p.lights[..]),
        size_of_val(&p.light_cdf[..]),
        size_of_val(&p.light_tree.nodes[..]),
        size_of_val(&p.light_tree.trails[..]),
        size_of_val(&p.triangle_cdf[..]),
        surroundings.map_or(0, |s| size_of_val(&s.picture.rgb[..])),
        surroundings.map_or(0, |s| size_of_val(&s.ends[..])),
    ];
    arrays.iter().sum::<usize>() as u64
}
