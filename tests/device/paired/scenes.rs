//! Every scene: on a CPU driver the device equals cpu-f32 to the bit, and 99.9 % of the paths stay together with cpu-f64.

use std::path::Path;

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::render::{DispatchLimits, Job, Target, render_on};
use vkpt::settings::{Integrator, Settings};

use super::{compared, samples};
use crate::common::render::{job, outcome, prepared, prepared_file};
use crate::common::scenes::{SMOOTH, TABLE, WIDE, scene_files};
use crate::common::settings::{by, estimators, models};
use crate::common::{self, cpu_driver};

/// The share of paths that may part.
const MAY_DIVERGE: f64 = 1e-3;

/// Probability that at least `diverged` of `paths` diverge if each does so with [`MAY_DIVERGE`].
fn at_least(diverged: u64, paths: u64) -> f64 {
    let Some(fewer) = diverged.checked_sub(1) else {
        return 1.0;
    };
    Binomial::new(MAY_DIVERGE, paths)
        .expect("a distribution")
        .sf(fewer)
}

/// Probability that no more than `diverged` of `paths` diverge if each does so with [`MAY_DIVERGE`].
fn at_most(diverged: u64, paths: u64) -> f64 {
    Binomial::new(MAY_DIVERGE, paths)
        .expect("a distribution")
        .cdf(diverged)
}

#[test]
fn the_binomial_statements_are_right() {
    // (1 − p)ⁿ and 1 − (1 − p)ⁿ
    let none = (1.0 - MAY_DIVERGE).powi(5000);
    assert!((at_most(0, 5000) - none).abs() < 1e-12);
    assert!((at_least(1, 5000) - (1.0 - none)).abs() < 1e-12);
    assert_eq!(at_least(0, 5000), 1.0);
    // One in two hundred instead of one in a thousand.
    assert!(at_least(96, 19_200) < 1e-6 && at_most(96, 19_200) > 0.999);
}

/// Paths that diverged from f64, of all; the device must equal f32.
fn diverged(job: &Job, name: &str) -> (u64, u64) {
    let [device, precision] = compared(&samples(job).expect("a device"));
    assert_eq!(
        (device.first_unequal, device.equal),
        (None, device.paths),
        "{name}: the device and cpu-f32 differ"
    );
    assert_eq!((device.broken, precision.broken), (0, 0), "{name}");
    let area = u64::from(job.prepared.camera.width) * u64::from(job.prepared.camera.height);
    assert_eq!(device.paths, area * u64::from(job.spp), "{name}");
    let diverged = precision.paths - precision.together;
    let quantile = |q| precision.closeness.quantile(q).unwrap_or(0.0);
    println!(
        "{name}: {diverged} of {} diverged, relative difference {:.1e}, 99 % below {:.1e}",
        precision.paths,
        quantile(0.5),
        quantile(0.99)
    );
    // A thousand roundings of one sign, an order of magnitude more than the paths of these scenes have on the median.
    assert!(quantile(0.5) < 1000.0 * 2f64.powi(-24), "{name}");
    (diverged, precision.paths)
}

/// Small pictures: none of the scenes may part significantly more often than it may. α = 1e-3 over all, by Šidák.
#[test]
fn every_scene_stays_together() {
    if cpu_driver().is_none() {
        return;
    }
    let files = scene_files();
    let alpha = 1.0 - (1.0 - 1e-3f64).powf(1.0 / files.len() as f64);
    for path in files {
        let settings = Settings::default();
        let scene = prepared_file(&path, &settings, Some([40, 30]));
        let (diverged, paths) = diverged(&job(&scene, settings, 8, 1), &path.display().to_string());
        let p = at_least(diverged, paths);
        assert!(p >= alpha, "{}: p = {p:.1e}", path.display());
    }
}

/// The same of bidirectional paths, with their splats. Their kernels take seconds each: a scene of each kind.
#[test]
fn bidirectional_paths_stay_together() {
    if cpu_driver().is_none() {
        return;
    }
    let names = ["glass-mesh", "many-lights", "rough-pane", "room"];
    let alpha = 1.0 - (1.0 - 1e-3f64).powf(1.0 / names.len() as f64);
    for name in names {
        let settings = by(Integrator::Bidirectional);
        let path = format!("scenes/{name}.txt");
        let scene = prepared_file(Path::new(&path), &settings, Some([40, 30]));
        let (diverged, paths) = diverged(&job(&scene, settings, 4, 1), name);
        let p = at_least(diverged, paths);
        assert!(p >= alpha, "{name}: p = {p:.1e}");
    }
}

/// The radiance of all bidirectional samples, on any pixel, is the picture.
#[test]
fn bidirectional_samples_are_the_light_of_the_picture() {
    let settings = by(Integrator::Bidirectional);
    let scene = prepared(TABLE, &settings);
    let job = job(&scene, settings, 19, 3);
    let Some(samples) = samples(&job) else { return };
    let brought: f64 = samples.iter().map(|s| s.device.radiance[1]).sum();
    let film = outcome(&job, &Target::CpuF32).film;
    let seen: f64 = film.rgb.iter().map(|rgb| f64::from(rgb[1]) * 19.0).sum();
    // The film's sums keep 48 bits; the rest is the rounding of means to f32.
    assert!(
        (brought - seen).abs() <= 2f64.powi(-23) * seen,
        "{brought} and {seen}"
    );
}

/// Larger ones: each scene is shown to part less often than it may, with the same α.
#[test]
#[ignore = "two minutes"]
fn every_scene_is_shown_to_stay_together() {
    if cpu_driver().is_none() {
        return;
    }
    let files = scene_files();
    let alpha = 1.0 - (1.0 - 1e-3f64).powf(1.0 / files.len() as f64);
    for path in files {
        let settings = Settings::default();
        let scene = prepared_file(&path, &settings, Some([120, 90]));
        let (diverged, paths) =
            diverged(&job(&scene, settings, 64, 1), &path.display().to_string());
        let p = at_most(diverged, paths);
        assert!(p < alpha, "{}: p = {p:.1e}", path.display());
    }
}

/// Connections that never are, paths that end otherwise, two lights to choose from: the signatures are the same.
#[test]
fn the_device_equals_the_reference_with_each_setting() {
    if cpu_driver().is_none() {
        return;
    }
    for (name, settings) in estimators().into_iter().chain(models()) {
        diverged(&job(&prepared(WIDE, &settings), settings, 2, 1), name);
    }
    for text in [TABLE, SMOOTH] {
        let settings = Settings::default();
        diverged(&job(&prepared(text, &settings), settings, 4, 1), text);
    }
}

/// The samples one by one are those that a rendering adds up, over two slices and in a crop.
#[test]
fn the_samples_are_those_of_the_picture() {
    let settings = Settings::default();
    let scene = prepared(TABLE, &settings);
    let job = Job {
        crop: Some([5, 3, 21, 15]),
        ..job(&scene, settings, 19, 3)
    };
    let Some(samples) = samples(&job) else { return };
    let device = common::device().expect("a device");
    let limits = DispatchLimits::of(device).expect("a probe");
    let stop = std::sync::atomic::AtomicBool::new(false);
    let film = render_on(&job, device, limits, &stop, &mut |_| {})
        .expect("a rendering")
        .film;
    let mut sums = vec![[0.0; 3]; film.rgb.len()];
    let mut next = vec![0; film.rgb.len()];
    for s in &samples {
        let [x, y] = s.address.pixel;
        let pixel = ((y - 3) * 16 + x - 5) as usize;
        assert_eq!(s.address.index, next[pixel], "out of order at {x},{y}");
        next[pixel] += 1;
        (0..3).for_each(|c| sums[pixel][c] += s.device.radiance[c] / 19.0);
    }
    assert!(next.iter().all(|n| *n == 19));
    for (sum, mean) in sums.iter().flatten().zip(film.rgb.iter().flatten()) {
        let mean = f64::from(*mean);
        // The film's sum keeps 48 bits; the rest is the mean's rounding to f32, twice.
        assert!(
            (sum - mean).abs() <= 2f64.powi(-23) * mean,
            "{sum} and {mean}"
        );
    }
}
