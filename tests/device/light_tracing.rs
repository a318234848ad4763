//! Light paths on a device, alone and with eye paths: the same bits as the reference in f32, for any tiles, dispatches and
//! crops; and kernels with planted errors, which the comparison with path tracing must notice.

use std::path::Path;

use tempfile::NamedTempFile;
use vkpt::film::Aov;
use vkpt::kernel::{OwnFile, file};
use vkpt::render::{Job, KernelChoice, Outcome, Target};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common;
use crate::common::render::{job, on_device, outcome, pixel_means, prepared};
use crate::common::scenes::{FLUSH, LENS, MANY, SMOOTH, TABLE, WIDE};
use crate::common::settings::by;
use crate::common::stats::p_of_difference;
use crate::same_bits::{crops_are_pieces, limits_leave_no_trace, same};

fn light() -> Settings {
    by(Integrator::Light)
}

fn bidirectional() -> Settings {
    by(Integrator::Bidirectional)
}

/// A cube whose corners have their own normals, so shading and geometric normals differ.
fn rounded_cube() -> NamedTempFile {
    common::meshes::ply(
        "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         element face 6\nproperty list uchar int vertex_indices\nend_header\n\
         -1 -1 -1 -1 -1 -1\n1 -1 -1 1 -1 -1\n1 1 -1 1 1 -1\n-1 1 -1 -1 1 -1\n\
         -1 -1 1 -1 -1 1\n1 -1 1 1 -1 1\n1 1 1 1 1 1\n-1 1 1 -1 1 1\n\
         4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
    )
}

/// The same cube, lit by another.
fn meshes(cube: &Path) -> String {
    format!(
        "screen 32 24\ncamera 0 -6 2.5 .35 x 70\nlight 3 4 5\nmesh {0} 1.5 0 2 .5\n\
         brdf .5 .5 .5 0 0 0 1\nbox -5 -5 -.1 10 10 .1\nbrdf .2 .3 .4 .3 .3 .3 .3\nmesh {0} -1 0 .8 .6\n",
        cube.display()
    )
}

/// No light; with a background only that.
const DARK: &str = "screen 16 12
camera 0 -6 2 .35 x 75
brdf .5 .5 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
brdf 0 0 0 .04 .04 .04 .2 .9 .9 .9 1.5
sphere 0 0 .8 .8
";

/// The eye and a lamp in a ball of haze, a background, a null interface, a mirror.
const HAZY: &str = "screen 24 24
camera 0 -2 1.5 .5 x 80
background .2 .3 .4
brdf 0 0 0 .04 .04 .04 .2 .8 .9 .7 1.3
sphere 0 -1 1.5 2.5
light 6 5 4
sphere -.8 -.5 2.2 .2
brdf 0 0 0 0 0 0 0 .9 .9 .5 1
box .3 -.6 1 .5 .5 .5
brdf .1 .1 .1 .8 .8 .8 0
sphere .6 .2 1.3 .3
brdf .6 .5 .4 0 0 0 1
box -5 -5 -1 10 10 .9
";

#[test]
fn a_cpu_device_equals_the_reference_bit_for_bit() {
    same_as_the_reference(light());
}

#[test]
fn bidirectional_paths_of_a_cpu_device_equal_the_references_bit_for_bit() {
    same_as_the_reference(bidirectional());
}

fn same_as_the_reference(settings: Settings) {
    if common::cpu_driver().is_none() {
        return;
    }
    let cube = rounded_cube();
    let meshes = meshes(cube.path());
    for (name, text) in [
        ("table", TABLE),
        ("smooth", SMOOTH),
        ("wide", WIDE),
        ("flush", FLUSH),
        ("many", MANY),
        ("meshes", &meshes),
        ("hazy", HAZY),
        ("lens", LENS),
        ("dark", DARK),
        ("sky", &format!("{DARK}background .4 .5 .6\n")),
    ] {
        for (scaling, sampler) in [(true, Sampler::Sobol), (false, Sampler::Random)] {
            let mut settings = settings;
            settings.estimator.sampler = sampler;
            settings.model.radiance_scaling = scaling;
            settings.model.max_depth = (!scaling).then_some(4);
            let scene = prepared(text, &settings);
            let job = Job {
                aovs: &[Aov::Stderr],
                ..job(&scene, settings, 5, 3)
            };
            let cpu = outcome(&job, &Target::CpuF32);
            let gpu = on_device(&job).expect("a device");
            same(&gpu.film, &cpu.film, name);
            let errors = |o: &Outcome| o.stderr.clone().expect("standard errors");
            same(&errors(&gpu), &errors(&cpu), name);
            assert_eq!(gpu.stats.rays, cpu.stats.rays, "{name}");
        }
    }
}

/// With 24 samples a thread makes more splats than it has slots for.
#[test]
fn tiles_and_dispatches_leave_no_trace() {
    limits_leave_no_trace(light(), 24);
    limits_leave_no_trace(bidirectional(), 24);
}

#[test]
fn a_crop_is_a_piece_of_the_picture() {
    crops_are_pieces(light());
    crops_are_pieces(bidirectional());
}

/// Two lamps that the eye sees, and surfaces that they light.
const LAMPS: &str = "screen 32 24
camera 0 -6 2 .35 x 75
light 3 2 1
sphere .8 0 1.6 .5
light 1 2 3
sphere -1.2 .5 1 .4
brdf .5 .5 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
brdf .6 .4 .3 0 0 0 1
sphere 0 -1 .5 .5
";

/// Means of whole pictures by 16 seeds.
fn whole(settings: Settings, first_seed: u32, kernel: KernelChoice) -> Option<Vec<f64>> {
    let scene = prepared(LAMPS, &settings);
    let mean = |seed| {
        let job = Job {
            kernel,
            ..job(&scene, settings, 64, seed)
        };
        let pixels = pixel_means(&on_device(&job)?.film);
        Some(pixels.iter().sum::<f64>() / pixels.len() as f64)
    };
    (first_seed..first_seed + 16).map(mean).collect()
}

/// A cosine too few at the camera and at the light, a distance forgotten, the light's choice missing in the density.
#[test]
fn planted_errors_are_noticed() {
    let Some(paths) = whole(Settings::default(), 1, KernelChoice::Composed) else {
        return;
    };
    let right = whole(light(), 101, KernelChoice::Composed).expect("a device");
    let p = p_of_difference(&paths, &right);
    assert!(p > 1e-3, "p = {p:e}");
    for (name, right, wrong) in [
        ("camera/eye", "* (z * z * z)", "* (z * z * distance)"),
        ("camera/eye", "distance / (4.0", "1.0 / (4.0"),
        (
            "integrator/light/splat",
            "(cosine * eye.importance)",
            "eye.importance",
        ),
        (
            "integrator/light/start/sample",
            "light_pmf(light) * start.point.area_pdf",
            "start.point.area_pdf",
        ),
    ] {
        let text = file(name).expect("a shader");
        assert!(text.contains(right), "{name}: {right}");
        let text = text.replace(right, wrong);
        let own = [OwnFile { name, text: &text }];
        let planted = whole(light(), 101, KernelChoice::Own(&own)).expect("a device");
        let p = p_of_difference(&paths, &planted);
        println!("{name}, {wrong}: p = {p:.1e}");
        assert!(p < 1e-3, "{name}, {wrong}: p = {p:e}");
    }
}
