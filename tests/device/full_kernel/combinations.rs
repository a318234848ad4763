//! Every combination of members compiles; one that does not is named.

use std::collections::HashSet;

use vkpt::features::Features;
use vkpt::kernel::Spirv;
use vkpt::prepared::{LightKind, ShapeKind};
use vkpt::render::{Job, KernelChoice, RenderError, kernels};
use vkpt::settings::Settings;

use super::scenes::{DIFFUSE, small_scenes};
use super::{extra, full};
use crate::common::device;
use crate::common::render::{job, prepared};
use crate::common::spirv_tools::tool;

/// The kernels of these features, compiled but not run; `None` if the run skips devices.
fn compiled(job: &Job, features: &Features) -> Option<Result<Vec<Spirv>, RenderError>> {
    let job = Job {
        kernel: KernelChoice::Given(features),
        ..*job
    };
    Some(kernels(&job, device()?))
}

/// Two members more than the scene needs, and two less than there are.
fn pairs(job: &Job) -> HashSet<Features> {
    let (composed, full, extra) = (job.features(), full(job), extra(job));
    let mut all = HashSet::new();
    for &a in &extra {
        for &b in extra.range(a..) {
            all.insert(composed.with(a).with(b));
            all.insert(full.without(a).without(b));
        }
    }
    all
}

#[test]
fn every_pair_of_members_compiles_for_a_scene_of_much() {
    every_pair_compiles(|name| name == "table");
}

#[test]
#[ignore = "a minute or two: 1,500 kernels for naga"]
fn every_pair_of_members_compiles() {
    every_pair_compiles(|_| true);
}

fn every_pair_compiles(wanted: impl Fn(&str) -> bool) {
    let settings = Settings::default();
    let scenes = small_scenes(&settings).into_iter();
    for (name, scene) in scenes.filter(|(name, _)| wanted(name)) {
        let job = job(&scene, settings, 1, 1);
        for features in pairs(&job) {
            let Some(kernel) = compiled(&job, &features) else {
                return;
            };
            kernel.unwrap_or_else(|e| panic!("{name}: {e}"));
        }
    }
}

#[test]
fn spirv_val_passes_every_member_alone_on_and_alone_off() {
    let settings = Settings::default();
    for (name, scene) in small_scenes(&settings) {
        let job = job(&scene, settings, 1, 1);
        let alone = |member| [job.features().with(member), full(&job).without(member)];
        let all = extra(&job).into_iter().flat_map(alone).chain([full(&job)]);
        for features in all.collect::<HashSet<_>>() {
            let Some(kernels) = compiled(&job, &features) else {
                return;
            };
            for kernel in kernels.unwrap_or_else(|e| panic!("{name}: {e}")) {
                tool("spirv-val", &["--target-env", "vulkan1.1"], kernel.bytes());
            }
        }
    }
}

/// A light of a kind whose shapes the kernel does not know.
#[test]
fn a_combination_that_does_not_compile_is_named() {
    let settings = Settings::default();
    let scene = prepared(DIFFUSE, &settings);
    let job = job(&scene, settings, 1, 1);
    let mut torn = job.features();
    assert!(torn.lights.insert(LightKind::Box) && !torn.shapes.contains(&ShapeKind::Box));
    let Some(kernel) = compiled(&job, &torn) else {
        return;
    };
    let error = kernel.expect_err("boxes[] is not declared").to_string();
    for part in [
        "boxes",
        "<light>",
        "Its features: shapes: sphere; ",
        "lights: sphere, box",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
}
