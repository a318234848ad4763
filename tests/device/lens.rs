//! The lens on a device: the same bits as the reference, for any tiles, dispatches and crops; and kernels with planted errors,
//! which closed forms (`common/defocus.rs`) or the other integrators must notice.

use vkpt::film::Film;
use vkpt::kernel::{OwnFile, file};
use vkpt::render::{Job, KernelChoice, Target};
use vkpt::settings::{Integrator, Sampler};

use crate::common;
use crate::common::defocus::{BALLS, Ball, found};
use crate::common::render::{difference, job, on_device, outcome, pixel_means, prepared};
use crate::common::scenes::LENS;
use crate::common::settings::by;
use crate::common::stats::{p_of_difference, p_of_mean};

const INTEGRATORS: [Integrator; 3] = [
    Integrator::Path,
    Integrator::Light,
    Integrator::Bidirectional,
];

#[test]
fn a_cpu_device_equals_the_reference_bit_for_bit() {
    if common::cpu_driver().is_none() {
        return;
    }
    for integrator in INTEGRATORS {
        for sampler in [Sampler::Sobol, Sampler::Random] {
            let mut settings = by(integrator);
            settings.estimator.sampler = sampler;
            let scene = prepared(LENS, &settings);
            let job = job(&scene, settings, 6, 3);
            let gpu = on_device(&job).expect("a device");
            let cpu = outcome(&job, &Target::CpuF32);
            assert_eq!(difference(&gpu.film, &cpu.film), None, "{integrator:?}");
            assert_eq!(gpu.stats.rays, cpu.stats.rays, "{integrator:?}");
        }
    }
}

/// The full kernels of light paths look for a lens too; those of paths from the eye are in `full_kernel`.
#[test]
fn the_full_kernel_makes_the_picture() {
    if common::cpu_driver().is_none() {
        return;
    }
    let pinhole = LENS.replace("lens .5 4.8\n", "");
    for (text, integrator) in [
        (LENS, Integrator::Bidirectional),
        (&*pinhole, Integrator::Bidirectional),
        (&pinhole, Integrator::Light),
    ] {
        let settings = by(integrator);
        let scene = prepared(text, &settings);
        let job = job(&scene, settings, 3, 1);
        let [composed, full] = [KernelChoice::Composed, KernelChoice::Full]
            .map(|kernel| on_device(&Job { kernel, ..job }).expect("a device"));
        let difference = difference(&composed.film, &full.film);
        assert_eq!(difference, None, "{integrator:?}");
    }
}

/// Pictures of a scene by 8 seeds, by kernels with one file changed.
fn pictures(
    text: &str,
    integrator: Integrator,
    spp: u32,
    planted: Option<(&str, &str, &str)>,
    first_seed: u32,
) -> Option<Vec<Film>> {
    let settings = by(integrator);
    let scene = prepared(text, &settings);
    let changed = planted.map(|(name, right, wrong)| {
        let text = file(name).expect("a shader");
        assert!(text.contains(right), "{name}: {right}");
        (name, text.replace(right, wrong))
    });
    let own: Vec<OwnFile> = (changed.iter())
        .map(|(name, text)| OwnFile { name, text })
        .collect();
    let kernel = match own.as_slice() {
        [] => KernelChoice::Composed,
        own => KernelChoice::Own(own),
    };
    let picture = |seed| {
        let job = Job {
            kernel,
            ..job(&scene, settings, spp, seed)
        };
        Some(on_device(&job)?.film)
    };
    (first_seed..first_seed + 8).map(picture).collect()
}

/// The least p-value for pictures of balls out of focus to be the expected ones; `None` if the run skips devices.
fn ball_p(
    balls: &[Ball],
    integrator: Integrator,
    planted: Option<(&str, &str, &str)>,
) -> Option<f64> {
    let mut least = 1.0;
    for ball in balls {
        let films = pictures(&ball.scene(), integrator, 128, planted, 0)?;
        let found = found(ball, films);
        if found.outside > 0.0 {
            return Some(0.0);
        }
        let p = [found.whole, found.inside].map(|samples| p_of_mean(&samples, 1.0, 1e-5));
        least = p.into_iter().fold(least, f64::min);
    }
    Some(least)
}

/// Points of the lens that crowd its middle, blur to the wrong side, the lens's axes changed over or one of them missing.
#[test]
fn planted_errors_are_noticed_by_a_ball_out_of_focus() {
    for integrator in INTEGRATORS {
        let Some(p) = ball_p(&BALLS, integrator, None) else {
            return;
        };
        assert!(p > 1e-3, "{integrator:?}: p = {p:e}");
    }
    let lens = "camera/lens";
    for (integrator, right, wrong) in [
        (
            Integrator::Path,
            "float along = s * phi.y;",
            "s = s * abs(s); float along = s * phi.y;",
        ),
        (Integrator::Path, "at - q * lens.blur", "at + q * lens.blur"),
        (
            Integrator::Path,
            "lens.right * q.x + lens.up * q.y",
            "lens.right * q.y + lens.up * q.x",
        ),
        (
            Integrator::Light,
            "float along = s * phi.y;",
            "s = s * abs(s); float along = s * phi.y;",
        ),
        (
            Integrator::Light,
            "(camera, to) + q * lens.blur",
            "(camera, to) - q * lens.blur",
        ),
        (
            Integrator::Light,
            "lens.right * q.x + lens.up * q.y",
            "lens.right * q.x",
        ),
    ] {
        let p = ball_p(&BALLS[..1], integrator, Some((lens, right, wrong))).expect("a device");
        println!("{integrator:?}, {wrong}: p = {p:.1e}");
        assert!(p < 1e-3, "{integrator:?}, {wrong}: p = {p:e}");
    }
}

/// A small lamp close to a floor, so that each way finds its light about as often, below a lens five times as wide as it is high:
/// weights that take the eye for the point of the lens that a path began at are off by up to that factor in its density.
const NEAR: &str = "screen 16 16
camera 0 0 3 .6
lens 15 3
light 30 30 30
sphere 0 0 .5 .1
brdf .7 .7 .7 0 0 0 1
box -9 -9 -1 18 18 1
";

#[test]
fn weights_of_another_point_of_the_lens_are_noticed() {
    let whole = |integrator, planted, seed| -> Option<Vec<f64>> {
        let films = pictures(NEAR, integrator, 512, planted, seed)?;
        let mean = |film: &Film| pixel_means(film).iter().sum::<f64>() / 256.0;
        Some(films.iter().map(mean).collect())
    };
    let Some(paths) = whole(Integrator::Path, None, 1) else {
        return;
    };
    let right = whole(Integrator::Bidirectional, None, 101).expect("a device");
    let p = p_of_difference(&paths, &right);
    assert!(p > 1e-3, "p = {p:e}");
    let planted = (
        "integrator/bidirectional/eye_path",
        "x.v.p - traced.origin",
        "x.v.p - camera.eye",
    );
    let wrong = whole(Integrator::Bidirectional, Some(planted), 101).expect("a device");
    let p = p_of_difference(&paths, &wrong);
    println!("p = {p:.1e}");
    assert!(p < 1e-3, "p = {p:e}");
}
