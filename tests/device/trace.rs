//! `--trace`: the device and the reference in f32 report the same path, event by event.

use vkpt::render::{Target, trace};
use vkpt::settings::{Integrator, Settings};

use crate::common;
use crate::common::render::{job, prepared};
use crate::common::scenes::{LENS, SMOOTH, TABLE, WIDE};
use crate::common::settings::by;

#[test]
fn the_device_traces_the_same_events_as_the_reference() {
    if common::cpu_driver().is_none() {
        return;
    }
    let target = Target::Vulkan(common::selector());
    let mut traces = String::new();
    for text in [TABLE, SMOOTH, WIDE, LENS] {
        let scene = prepared(text, &Settings::default());
        let job = job(&scene, Settings::default(), 8, 1);
        for (pixel, index) in [
            ([9, 12], 0),
            ([22, 13], 3),
            ([16, 20], 7),
            ([3, 1], 1),
            ([3, 20], 2),
            ([3, 20], 5),
            ([4, 21], 6),
        ] {
            let trace = trace(&job, &target, pixel, index)
                .expect("a trace")
                .to_string();
            assert!(
                trace.ends_with("the two paths are the same"),
                "pixel {pixel:?}, sample {index}:\n{trace}"
            );
            traces += &trace;
        }
    }
    for event in [
        "diffuse",
        "reflection",
        "transmission",
        "delta",
        "(box of line 6)",
        "(sphere of line 9)",
        "connection to shape",
        "connection to the background",
        "arrives",
        "is blocked",
        "leaves the scene",
    ] {
        assert!(traces.contains(event), "no path of these has this: {event}");
    }
}

/// A connection comes after the vertex that it starts from, and the radiance grows by its light in between.
#[test]
fn a_connection_follows_its_vertex() {
    let scene = prepared(SMOOTH, &Settings::default());
    let job = job(&scene, Settings::default(), 64, 1);
    let mut arrived = 0;
    for sample in 0..64 {
        let found = trace(&job, &Target::CpuF64, [3, 20], sample).expect("a trace");
        let text = found.to_string();
        let f32_side = text
            .lines()
            .skip(1)
            .map(|l| l.get(70..).unwrap_or_default().trim());
        let lines: Vec<&str> = f32_side.collect();
        let events: Vec<usize> = (0..lines.len())
            .filter(|&i| {
                ["vertex", "connection", "leaves"]
                    .iter()
                    .any(|w| lines[i].starts_with(w))
            })
            .collect();
        let red = |from: usize, name: &str| {
            let line = lines[from..].iter().find(|l| l.starts_with(name));
            let number = line.and_then(|l| l.split_whitespace().nth(1));
            number
                .and_then(|x| x.parse::<f64>().ok())
                .expect("a number")
        };
        assert!(lines[events[0]].starts_with("vertex"), "{text}");
        for pair in events
            .windows(2)
            .filter(|p| lines[p[1]].contains("arrives"))
        {
            assert!(lines[pair[0]].starts_with("vertex"), "{text}");
            let (before, after) = (red(pair[0], "radiance"), red(pair[1], "radiance"));
            let light = red(pair[1], "light");
            assert!((after - before - light).abs() <= 1e-6 * after, "{text}");
            arrived += 1;
        }
    }
    assert!(arrived > 10, "{arrived}");
}

/// f32 and f64 diverge at last, within the tolerance or in their decisions; both are reported from the camera on.
#[test]
fn the_two_references_are_printed_side_by_side() {
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

/// Devices record no events of bidirectional paths: the radiance of a sample, and the hash of its decisions, are compared.
#[test]
fn both_paths_are_printed_with_every_way_to_find_light() {
    let settings = by(Integrator::Bidirectional);
    if common::cpu_driver().is_some() {
        let scene = prepared(SMOOTH, &settings);
        let job = job(&scene, settings, 32, 1);
        let target = Target::Vulkan(common::selector());
        let text = trace(&job, &target, [16, 20], 3)
            .expect("a trace")
            .to_string();
        let equal = "the same decisions and radiance as cpu-f32, to the bit";
        assert!(text.contains(equal), "{text}");
    }
    // Light paths of the first begin at its lamp; most of those of the second at its sky, which emits none.
    let mut traces = String::new();
    for text in [TABLE, SMOOTH] {
        let scene = prepared(text, &settings);
        let job = job(&scene, settings, 32, 1);
        for index in 0..32 {
            let trace = trace(&job, &Target::CpuF64, [16, 20], index).expect("a trace");
            let text = trace.to_string();
            assert!(text.ends_with("the two paths are the same"), "{text}");
            traces += &text;
        }
    }
    for event in [
        "the light path leaves shape",
        "light vertex 2 on",
        "eye vertex 3 on",
        "t=1: a splat on pixel",
        "s=1 t=2: to shape",
        "to light vertex",
        "is blocked",
        "the eye path leaves the scene",
        "weight ",
        "delta",
    ] {
        assert!(traces.contains(event), "no path of these has this: {event}");
    }
}
