//! Rendering scenes that a test writes down as text.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use vkpt::film::Film;
use vkpt::prepared::{Prepared, prepare};
use vkpt::render::{
    DispatchLimits, Engine, Job, KernelChoice, Outcome, Replicates, Target, Until, render,
    render_on,
};
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
        classes: &[],
        kernel: KernelChoice::Composed,
    }
}

pub fn outcome(job: &Job, target: &Target) -> Outcome {
    render(job, target, &AtomicBool::new(false), &mut |_| {}).expect("a rendering")
}

/// Renders on the tests' device, which the validation layer watches; `None` if the run skips devices.
pub fn on_device(job: &Job) -> Option<Outcome> {
    let limits = DispatchLimits::of(super::device()?).expect("a probe");
    on_device_within(job, limits)
}

/// The same within given limits of a dispatch.
pub fn on_device_within(job: &Job, limits: DispatchLimits) -> Option<Outcome> {
    let stop = AtomicBool::new(false);
    let outcome = render_on(job, super::device()?, limits, &stop, &mut |_| {});
    Some(outcome.expect("a rendering"))
}

pub fn film(text: &str, settings: Settings, spp: u32, seed: u32, target: &Target) -> Film {
    let prepared = prepared(text, &settings);
    outcome(&job(&prepared, settings, spp, seed), target).film
}

/// For each seed, pixel and channel: the variance that the mean of the job's samples would have if they were independent,
/// Σ (x − x̄)²/(n (n − 1)). A sample is the change that it makes to a picture; by cpu-f32.
pub fn spread_of_samples(job: &Job, seeds: &[u32]) -> Vec<Vec<[f64; 3]>> {
    let mut replicates = Replicates::new(job, &Engine::CpuF32, seeds).expect("ready");
    let mut of = |i: usize| {
        let size = job.size();
        let mut sum = vec![[0f64; 3]; (size[0] * size[1]) as usize];
        let mut squares = sum.clone();
        for n in 1..=job.spp {
            replicates
                .advance(i, n, &AtomicBool::new(false))
                .expect("a sample");
            let picture = replicates.picture(i);
            let pixels = picture.rgb.iter().zip(sum.iter_mut().zip(&mut squares));
            for (mean, (sum, squares)) in pixels {
                for c in 0..3 {
                    let x = f64::from(n) * f64::from(mean[c]) - sum[c];
                    sum[c] += x;
                    squares[c] += x * x;
                }
            }
        }
        let n = f64::from(job.spp);
        let variance = |(s, q): (&[f64; 3], &[f64; 3])| {
            [0, 1, 2].map(|c| (q[c] - s[c] * s[c] / n) / (n * (n - 1.0)))
        };
        sum.iter().zip(&squares).map(variance).collect()
    };
    (0..seeds.len()).map(&mut of).collect()
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
