//! Renders a scene file to a picture, by the library alone:
//!
//! ```sh
//! cargo run --release --example render -- scenes/room.txt room.png
//! ```
//!
//! The four steps are those of the program: read, prepare, render, encode.

#![allow(clippy::print_stderr, reason = "a program of its own")]

use std::error::Error;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use vkpt::image::file::write_whole;
use vkpt::image::{Format, Frame, Labels, encode};
use vkpt::prepared::prepare;
use vkpt::render::{Job, KernelChoice, Target, Until, render};
use vkpt::report::SOFTWARE;
use vkpt::scene;
use vkpt::settings::Settings;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(scene), Some(picture)) = (arguments.next(), arguments.next()) else {
        return Err("usage: render SCENE PICTURE".into());
    };
    let format = Format::of(&picture).ok_or("PICTURE must end in .png, .hdr or .exr")?;

    // 1. Text, meshes and surroundings → names, units and f64.
    let read = scene::read(&scene, false)?;
    for warning in &read.warnings {
        eprintln!("warning: {warning}");
    }

    // 2. The data that all renderers share.
    let settings = Settings::default();
    let prepared = prepare(&read.scene, &settings, None)?;

    // 3. 64 samples per pixel. `Target::Vulkan(Selector::Best)` renders on the best Vulkan device.
    let job = Job {
        prepared: &prepared,
        settings,
        spp: 64,
        until: Until::default(),
        seed: 0,
        crop: None,
        aovs: &[],
        classes: &[],
        kernel: KernelChoice::Composed,
    };
    let stop = AtomicBool::new(false);
    let outcome = render(&job, &Target::CpuF32, &stop, &mut |progress| {
        eprint!("\r{:3.0} %", 100.0 * progress.fraction);
    })?;
    let last = outcome.state.errors.last();
    if let Some(error) = last.and_then(|error| error.rel_mse) {
        eprintln!("\rrelMSE about {:.1e}", error.estimate);
    }

    // 4. A picture file that is there whole or not at all.
    let labels = Labels {
        exposure: 0.0,
        software: SOFTWARE,
        notes: &[],
    };
    let frame = Frame::whole(&outcome.film);
    write_whole(&picture, |out| encode(&frame, format, &labels, out))?;
    Ok(())
}
