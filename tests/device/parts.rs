//! Parts of a picture on a device: the sums of cpu-f32, with any tiles and dispatches.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use vkpt::film::Aov;
use vkpt::render::{DISPATCH_TIME, DispatchLimits, Job, Progress, Start, Target, render_from};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common::cpu_driver;
use crate::common::render::{job, on_device_within, outcome, prepared};
use crate::common::scenes::TABLE;

/// More than two blocks and a piece of one.
const SPP: u32 = 700;

#[test]
fn sums_of_many_blocks_are_those_of_the_reference() {
    if cpu_driver().is_none() {
        return;
    }
    for (integrator, aov) in [
        (Integrator::Path, Aov::Stderr),
        (Integrator::Path, Aov::Denoised),
        (Integrator::Light, Aov::Denoised),
        (Integrator::Bidirectional, Aov::Stderr),
    ] {
        let mut settings = Settings::default();
        settings.estimator.integrator = integrator;
        settings.estimator.sampler = match aov {
            Aov::Stderr => Sampler::Random,
            _ => Sampler::SobolQuarters,
        };
        let text = TABLE.replace("screen 32 24", "screen 7 5");
        let scene = prepared(&text, &settings);
        let job = Job {
            aovs: &[aov],
            ..job(&scene, settings, SPP, 1)
        };
        let one = outcome(&job, &Target::CpuF32);
        for (tile_pixels, dispatch_time) in
            [(1 << 16, DISPATCH_TIME), (8, Duration::from_micros(1))]
        {
            let limits = DispatchLimits {
                tile_pixels,
                budget: 500,
                read_first: true,
                storage_buffer: 1 << 27,
                dispatch_time,
            };
            let made = on_device_within(&job, limits).expect("the same device");
            assert!(
                made.state.part == one.state.part,
                "{integrator:?} {limits:?}"
            );
            assert!(made.film == one.film && made.stderr == one.stderr);
        }
        // Some of it by cpu-f32, the rest on the device, and the other way round.
        let half = Job { spp: 300, ..job };
        let device = Target::Vulkan(crate::common::selector());
        for (first, then) in [(&Target::CpuF32, &device), (&device, &Target::CpuF32)] {
            let start = Start::After(outcome(&half, first).state);
            let stop = AtomicBool::new(false);
            let whole = render_from(&job, then, &start, &stop, &mut |_: Progress| {});
            let whole = whole.expect("a rendering");
            assert!(
                whole.state.part == one.state.part,
                "{integrator:?} {then:?}"
            );
        }
    }
}
