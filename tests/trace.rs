//! `--trace`: the device and the reference in f32 tell the same story of a path, event by event.

mod common;

use common::render::{job, prepared};
use common::scenes::{SMOOTH, TABLE, WIDE};
use vkpt::gpu::DeviceKind;
use vkpt::render::{Target, trace};
use vkpt::settings::Settings;

#[test]
fn the_device_tells_the_same_story_as_the_reference() {
    if common::device().is_none_or(|d| d.info().kind != DeviceKind::Cpu) {
        println!("skipped: no CPU driver");
        return;
    }
    let target = Target::Vulkan(common::selector());
    let mut told = String::new();
    for text in [TABLE, SMOOTH, WIDE] {
        let scene = prepared(text, &Settings::default());
        let job = job(&scene, Settings::default(), 8, 1);
        for (pixel, index) in [([9, 12], 0), ([22, 13], 3), ([16, 20], 7), ([3, 1], 1)] {
            let trace = trace(&job, &target, pixel, index)
                .expect("a trace")
                .to_string();
            assert!(
                trace.ends_with("the two paths are the same"),
                "pixel {pixel:?}, sample {index}:\n{trace}"
            );
            told += &trace;
        }
    }
    for event in [
        "diffuse",
        "reflection",
        "transmission",
        "delta",
        "arrives",
        "is blocked",
        "leaves the scene",
    ] {
        assert!(told.contains(event), "no path of these has this: {event}");
    }
}

/// f32 and f64 part at last, within the tolerance or in their decisions; both are told from the camera on.
#[test]
fn the_two_references_are_told_side_by_side() {
    let scene = prepared(SMOOTH, &Settings::default());
    let job = job(&scene, Settings::default(), 1, 1);
    let trace = trace(&job, &Target::CpuF64, [16, 20], 0)
        .expect("a trace")
        .to_string();
    let first = trace.lines().next().unwrap_or_default();
    assert!(
        first.starts_with("cpu-f64") && first.ends_with("cpu-f32"),
        "{trace}"
    );
    assert_eq!(
        trace
            .lines()
            .nth(1)
            .map(|l| l.matches("vertex on shape").count()),
        Some(2),
        "{trace}"
    );
}
