//! Rendering scenes that a test writes down as text.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use vkpt::film::Film;
use vkpt::prepared::{Prepared, prepare};
use vkpt::render::{DispatchLimits, Job, KernelChoice, Outcome, Target, Until, render, render_on};
use vkpt::settings::Settings;

/// A scene from text, prepared.
pub fn prepared(text: &str, settings: &Settings) -> Prepared {
    let read = vkpt::scene::parse(text, Path::new("test.txt"), false).expect("a good scene");
    prepare(&read.scene, settings, None).expect("a scene that can be rendered")
}

/// A scene file, prepared.
pub fn prepared_file(path: &Path, settings: &Settings, size: Option<[u32; 2]>) -> Prepared {
    let read = vkpt::scene::read(path, false).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    prepare(&read.scene, settings, size).expect("a scene that can be rendered")
}

pub fn job(prepared: &Prepared, settings: Settings, spp: u32, seed: u32) -> Job<'_> {
    Job {
        prepared,
        settings,
        spp,
        until: Until::default(),
        seed,
        crop: None,
        aovs: &[],
        kernel: KernelChoice::Composed,
    }
}

pub fn outcome(job: &Job, target: &Target) -> Outcome {
    render(job, target, &AtomicBool::new(false), &mut |_| {}).expect("a rendering")
}

/// Renders on the tests' device, which the validation layer watches; `None` where the run goes without.
pub fn on_device(job: &Job) -> Option<Outcome> {
    let limits = DispatchLimits::of(super::device()?).expect("a probe");
    on_device_within(job, limits)
}

/// The same within limits of a dispatch of one's own.
pub fn on_device_within(job: &Job, limits: DispatchLimits) -> Option<Outcome> {
    let stop = AtomicBool::new(false);
    let outcome = render_on(job, super::device()?, limits, &stop, &mut |_| {});
    Some(outcome.expect("a rendering"))
}

pub fn film(text: &str, settings: Settings, spp: u32, seed: u32, target: &Target) -> Film {
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

/// Says where two pictures differ in a bit; `None` where they do not.
pub fn difference(a: &Film, b: &Film) -> Option<String> {
    if (a.width, a.height) != (b.width, b.height) {
        return Some(format!(
            "{}×{} and {}×{}",
            a.width, a.height, b.width, b.height
        ));
    }
    let differs = |i: &usize| a.rgb[*i].map(f32::to_bits) != b.rgb[*i].map(f32::to_bits);
    let different: Vec<usize> = (0..a.rgb.len()).filter(differs).collect();
    let first = *different.first()?;
    let (column, row) = (first % a.width as usize, first / a.width as usize);
    Some(format!(
        "{} of {} pixels, first at {column},{row}: {:?} and {:?}",
        different.len(),
        a.rgb.len(),
        a.rgb[first],
        b.rgb[first]
    ))
}
