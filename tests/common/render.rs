//! Rendering scenes that a test writes down as text.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use vkpt::film::Film;
use vkpt::prepared::{Prepared, prepare};
use vkpt::render::{Job, Outcome, Target, render};
use vkpt::settings::Settings;

/// A scene from text, prepared.
pub fn prepared(text: &str, settings: &Settings) -> Prepared {
    let read = vkpt::scene::parse(text, Path::new("test.txt"), false).expect("a good scene");
    prepare(&read.scene, settings, None).expect("a scene that can be rendered")
}

/// A scene file of the project or of the course; `None` where it is not there.
pub fn prepared_file(path: &Path, settings: &Settings, size: Option<[u32; 2]>) -> Option<Prepared> {
    if !path.exists() {
        println!("skipped: {} is not there", path.display());
        return None;
    }
    let read = vkpt::scene::read(path, false).expect("a good scene");
    Some(prepare(&read.scene, settings, size).expect("a scene that can be rendered"))
}

pub fn job(prepared: &Prepared, settings: Settings, spp: u64, seed: u32) -> Job<'_> {
    Job {
        prepared,
        settings,
        spp,
        seed,
        crop: None,
    }
}

pub fn outcome(job: &Job, target: &Target) -> Outcome {
    render(job, target, &AtomicBool::new(false), &mut |_| {}).expect("a rendering")
}

pub fn film(text: &str, settings: Settings, spp: u64, seed: u32, target: &Target) -> Film {
    let prepared = prepared(text, &settings);
    outcome(&job(&prepared, settings, spp, seed), target).film
}

/// The mean over RGB of each pixel.
pub fn pixel_means(film: &Film) -> Vec<f64> {
    film.rgb
        .iter()
        .map(|p| p.iter().map(|&x| f64::from(x)).sum::<f64>() / 3.0)
        .collect()
}
