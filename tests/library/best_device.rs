//! The device that renders if none is named.

use vkpt::gpu::DeviceKind::{Cpu, Discrete, Integrated};
use vkpt::gpu::{DeviceKind, Selector};
use vkpt::render::{Job, Target, Until, best_of};
use vkpt::settings::{Integrator, Settings};

use crate::common::render::{job, prepared};
use crate::common::scenes::TABLE;
use crate::common::settings::by;

const VULKAN: Target = Target::Vulkan(Selector::Best);

/// The device that renders 400 × 300 pixels with that many samples, and whether a reason is given.
fn chosen(text: &str, settings: Settings, spp: u32, kinds: &[DeviceKind]) -> (Target, bool) {
    within(text, settings, spp, kinds, None)
}

fn within(
    text: &str,
    settings: Settings,
    spp: u32,
    kinds: &[DeviceKind],
    seconds: Option<f64>,
) -> (Target, bool) {
    let text = text.replace("screen 32 24", "screen 400 300");
    let prepared = prepared(&text, &settings);
    assert_eq!(prepared.camera.width, 400);
    let job = Job {
        until: Until {
            seconds,
            rel_mse: None,
        },
        ..job(&prepared, settings, spp, 0)
    };
    let best = best_of(&job, kinds, 2);
    (best.target, best.why.is_some())
}

fn path() -> Settings {
    by(Integrator::Path)
}

/// So many spheres more; of more than 24 a kernel searches them.
fn many(count: i32) -> String {
    let sphere = |i: i32| format!("sphere {} 0 0 .1\n", i - 20);
    TABLE.to_owned() + &(0..count).map(sphere).collect::<String>()
}

#[test]
fn a_gpu_always_renders() {
    for spp in [1, 4096] {
        for kinds in [&[Cpu, Discrete][..], &[Integrated]] {
            for text in [TABLE.to_owned(), many(100)] {
                assert_eq!(chosen(&text, path(), spp, kinds), (VULKAN, false));
            }
        }
    }
}

/// 400 × 300 × 4096 samples take the reference minutes, one sample takes a tenth of a second.
#[test]
fn a_cpu_driver_renders_few_primitives_with_many_samples() {
    let reference = (Target::CpuF32, true);
    assert_eq!(chosen(TABLE, path(), 4096, &[Cpu]), (VULKAN, true));
    assert_eq!(chosen(TABLE, path(), 1, &[Cpu]), reference);
    assert_eq!(chosen(&many(40), path(), 4096, &[Cpu]), (VULKAN, true));
    assert_eq!(chosen(&many(100), path(), 4096, &[Cpu]), reference);
    let both = by(Integrator::Bidirectional);
    assert_eq!(chosen(TABLE, both, 64, &[Cpu]), reference);
    assert_eq!(chosen(TABLE, both, 4096, &[Cpu]), (VULKAN, true));
}

#[test]
fn a_time_limit_counts_and_an_error_does_not() {
    let reference = (Target::CpuF32, true);
    let limit = |seconds| within(TABLE, path(), u32::MAX, &[Cpu], seconds);
    assert_eq!(limit(Some(1.0)), reference);
    assert_eq!(limit(Some(60.0)), (VULKAN, true));
    assert_eq!(limit(None), (VULKAN, true));
}

#[test]
fn without_vulkan_the_reference_renders() {
    assert_eq!(chosen(TABLE, path(), 4096, &[]), (Target::CpuF32, true));
}
