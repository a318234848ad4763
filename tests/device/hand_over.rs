//! A thousand bounces in a deep hierarchy: more loop steps than Mesa 22 lets a subgroup take in one dispatch, which it
//! ends in silence after 65,535. The picture is right because paths continue in another dispatch before that.
//!
//! The room is a closed mesh of perfect mirrors, bumpy at several scales, around a small light. It is chaotic: after a
//! few dozen bounces one rounding done otherwise shows in every digit.

use std::sync::atomic::AtomicBool;

use crate::common::icosphere::mesh::{Icosphere, ply};
use tempfile::NamedTempFile;
use vkpt::gpu::DeviceKind;
use vkpt::prepared::Prepared;
use vkpt::render::{DispatchLimits, Progress, RenderError, Target, render_on};
use vkpt::settings::{Roulette, Settings};

use crate::common;
use crate::common::render::{difference, job, outcome, prepared};

fn settings() -> Settings {
    let mut settings = Settings::default();
    settings.estimator.roulette = Roulette::Off;
    settings
}

/// 20·24² = 11,520 triangles of mirror around a camera and a light of radius 0.012: thousands of bounces lie between
/// one visit to the light and the next.
fn mirror_room() -> Prepared {
    let file = bumpy_ball(24);
    let text = format!(
        "screen 16 12\ncamera .2 .1 0 .5\nlight 3 2 1\nsphere -.3 .2 .1 .012\n\
         brdf 0 0 0 1 1 1 0\nmesh {} 0 0 0 1\n",
        file.path().display()
    );
    prepared(&text, &settings())
}

/// The displaced sphere of 20·n² triangles.
fn bumpy_ball(n: u32) -> NamedTempFile {
    let file = tempfile::Builder::new().suffix(".ply").tempfile();
    let file = file.expect("a temporary file");
    let ball = ply::bytes(&Icosphere::new(n, 0.1, 7), None);
    std::fs::write(file.path(), ball).expect("a temporary file");
    file
}

#[test]
fn a_thousand_bounces_in_a_deep_hierarchy_make_the_picture_of_the_reference() {
    let scene = mirror_room();
    let job = job(&scene, settings(), 2, 1);
    let reference = outcome(&job, &Target::CpuF32);
    let samples = reference.stats.samples;
    println!(
        "{} of {samples} paths reached a thousand bounces, {} rays",
        reference.stats.long_paths, reference.stats.rays
    );
    assert!(reference.stats.long_paths > samples / 2);
    let Some(device) = common::device() else {
        return;
    };
    let stop = AtomicBool::new(false);
    let render = |limits, progress: &mut dyn FnMut(Progress)| {
        render_on(&job, device, limits, &stop, progress)
    };
    let limits = DispatchLimits::of(device).expect("a probe");
    let ours = render(limits, &mut |_| {}).expect("a rendering");
    assert_eq!(ours.stats.dropped, Default::default());
    if device.info().kind == DeviceKind::Cpu {
        assert_eq!(difference(&ours.film, &reference.film), None);
        assert_eq!(ours.stats.rays, reference.stats.rays);
        assert_eq!(ours.stats.long_paths, reference.stats.long_paths);
    }

    // Planted: no hand-over. A driver that ends loops must be caught at it, in the first slice; another makes the same
    // picture.
    let mut slices = 0;
    let unlimited = DispatchLimits {
        budget: u32::MAX,
        ..limits
    };
    let planted = render(unlimited, &mut |_| slices += 1);
    match device.loop_limit().expect("a probe") {
        Some(limit) => {
            println!("limit of {limit} loop steps, budget {}", limits.budget);
            assert!(matches!(planted, Err(RenderError::Loops(1..))));
            assert_eq!(slices, 0);
        }
        None => {
            let film = planted.expect("a rendering").film;
            assert_eq!(difference(&film, &ours.film), None);
        }
    }
}
