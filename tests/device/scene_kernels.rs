//! The kernels of whole scenes: valid, silent under the validation layer, and without unneeded features.

use std::sync::atomic::AtomicBool;

use vkpt::film::Aov;
use vkpt::gpu::Device;
use vkpt::kernel::{KernelError, OwnFile, file};
use vkpt::prepared::Prepared;
use vkpt::render::{
    DISPATCH_TIME, DispatchLimits, Job, KernelChoice, Plan, PlanLimits, RenderError, kernels,
    render_on,
};
use vkpt::settings::Settings;

use crate::common;
use crate::common::needs::Need;
use crate::common::render::{job, prepared, prepared_file};
use crate::common::scenes::{SMOOTH, TABLE, WIDE, scene_files};
use crate::common::settings::{estimators, independent, models};
use crate::common::spirv_tools::tool;

/// Diffuse surfaces and a light.
const DIFFUSE: &str = "screen 16 12
camera 0 -6 3 .35 x 65
light 6 5 4
sphere 0 0 4 1
brdf .6 .5 .4 0 0 0 1
box -5 -5 -.1 10 10 .1
sphere 0 0 1 1
";

#[test]
fn spirv_val_passes_the_kernel_of_every_scene() {
    let Some(device) = common::device() else {
        return;
    };
    let check_job = |job: &Job| {
        for kernel in kernels(job, device).expect("kernels") {
            tool("spirv-val", &["--target-env", "vulkan1.1"], kernel.bytes());
        }
    };
    let check = |scene: &Prepared, settings| check_job(&job(scene, settings, 1, 1));
    for path in scene_files() {
        for settings in [Settings::default(), Settings::handout()] {
            check(&prepared_file(&path, &settings, None), settings);
        }
    }
    for (_, settings) in estimators().into_iter().chain(models()) {
        for text in [TABLE, SMOOTH, WIDE] {
            check(&prepared(text, &settings), settings);
        }
    }
    let scene = prepared(TABLE, &Settings::default());
    check_job(&Job {
        aovs: &[Aov::Stderr],
        ..job(&scene, independent(), 2, 1)
    });
}

/// A device of the test's own: messages of the shared one may be other tests'.
#[test]
fn the_validation_layer_is_silent() {
    let Some(device) = common::open(Default::default()) else {
        return;
    };
    if Need::Validation.skips() {
        return;
    }
    // Small tiles and budgets, so that films move to and from the device and paths continue in further dispatches.
    let limits = [
        DispatchLimits::of(&device).expect("a probe"),
        DispatchLimits {
            tile_pixels: 100,
            budget: 20,
            read_first: false,
            storage_buffer: 1 << 27,
            dispatch_time: DISPATCH_TIME,
        },
    ];
    for text in [DIFFUSE, TABLE, SMOOTH, WIDE] {
        for limits in limits {
            let scene = prepared(text, &Settings::default());
            let plain = job(&scene, independent(), 2, 1);
            for aovs in [&[][..], &[Aov::Stderr]] {
                let job = Job { aovs, ..plain };
                let stop = AtomicBool::new(false);
                render_on(&job, &device, limits, &stop, &mut |_| {}).expect("a rendering");
            }
        }
    }
    let messages = device.validation_messages();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
}

/// Parts of the names of functions that only specular surfaces need.
const SPECULAR: [&str; 14] = [
    "ggx",
    "beckmann",
    "phong",
    "fresnel",
    "snell",
    "total_reflection",
    "normals_",
    "facet",
    "half_vector",
    "jacobian",
    "reflect",
    "refract",
    "log1p",
    "beer",
];

/// The functions of a path tracer's kernel.
fn functions_of(job: &Job, device: &Device) -> Vec<String> {
    let [kernel] = <[_; 1]>::try_from(kernels(job, device).expect("a kernel")).expect("one");
    kernel.functions
}

#[test]
fn the_kernel_of_a_diffuse_scene_has_no_microfacets_nor_refraction() {
    let Some(device) = common::device() else {
        return;
    };
    let functions = |text| {
        let scene = prepared(text, &Settings::default());
        let job = job(&scene, Settings::default(), 1, 1);
        functions_of(&job, device)
    };
    let (diffuse, wide, table) = (functions(DIFFUSE), functions(WIDE), functions(TABLE));
    for part in SPECULAR {
        let found = |functions: &[String]| functions.iter().any(|f| f.contains(part));
        assert!(!found(&diffuse), "{part} in a diffuse kernel: {diffuse:?}");
        let somewhere = found(&wide) || found(&table);
        assert!(somewhere, "{part}: no such function any more");
    }
    // A kernel of GGX contains no other distribution.
    for other in ["beckmann", "phong", "log1p"] {
        assert!(
            !table.iter().any(|f| f.contains(other)),
            "{other}: {table:?}"
        );
    }
}

#[test]
fn a_kernel_keeps_only_the_requested_sums_beside_its_film() {
    let Some(device) = common::device() else {
        return;
    };
    let scene = prepared(DIFFUSE, &Settings::default());
    let contains = |function: &str, settings, aovs| {
        let job = Job {
            aovs,
            ..job(&scene, settings, 2, 1)
        };
        let functions = functions_of(&job, device);
        functions.iter().any(|f| f == function)
    };
    let (stderr, denoised) = (&[Aov::Stderr], &[Aov::Denoised]);
    assert!(contains("film_moments", independent(), stderr));
    assert!(!contains("film_moments", independent(), &[]));
    // Samples by Sobol are not independent.
    assert!(!contains("film_moments", Settings::default(), stderr));
    assert!(contains("film_quarters", Settings::default(), denoised));
    assert!(!contains("film_quarters", Settings::default(), stderr));
}

/// A scene whose numbers are edited is found again in the drivers' caches: of up to 24 primitives the kernel's text knows
/// how many there are, and no value.
#[test]
fn values_are_not_in_the_text() {
    let settings = Settings::default();
    let text = |scene: &str| {
        let scene = prepared(scene, &settings);
        let plan = Plan::new(&job(&scene, settings, 1, 1), PlanLimits::default());
        plan.expect("a kernel").kernels[0].text().to_owned()
    };
    let edited = DIFFUSE
        .replace("6 5 4", "7 2 1")
        .replace("sphere 0 0 4 1", "sphere .5 0 3.5 .7")
        .replace(".6 .5 .4", ".1 .2 .3")
        .replace("camera 0 -6", "camera 1 -5");
    assert_eq!(text(DIFFUSE), text(&edited));
    let more = format!("{DIFFUSE}sphere 2 0 1 1\n");
    assert_ne!(text(DIFFUSE), text(&more));
}

/// A custom file replaces its namesake, with a further one that it uses; one that nothing uses is
/// an error, because it would belong to no estimator.
#[test]
fn a_kernel_includes_custom_files() {
    let settings = Settings::default();
    let scene = prepared(DIFFUSE, &settings);
    let plain = job(&scene, settings, 1, 1);
    let text = |files: &[OwnFile]| {
        let own = Job {
            kernel: KernelChoice::Own(files),
            ..plain
        };
        Plan::new(&own, PlanLimits::default()).map(|plan| plan.kernels[0].text().to_owned())
    };
    let none = text(&[]).expect("a kernel");
    let own = |name, text| OwnFile { name, text };
    let same = file("integrator/path/connect/mis").expect("a shader");
    assert_eq!(
        text(&[own("integrator/path/connect/mis", same)]).expect("a kernel"),
        none
    );
    let half = "// uses: half\nfloat connection_weight(float light_pdf, float bsdf_pdf) { return HALF; }\n\
                float hit_weight(bool delta, float bsdf_pdf, float light_pdf) { return delta ? 1.0 : HALF; }\n";
    let files = [
        own("integrator/path/connect/mis", half),
        own("half", "const float HALF = 0.5;\n"),
    ];
    let with = text(&files).expect("a kernel");
    assert!(with.contains("return HALF") && !with.contains("power_heuristic"));
    let unused = text(&[own("integrator/path/connect/light", half)]);
    let Err(RenderError::Kernel { error, .. }) = unused else {
        panic!("{unused:?}");
    };
    let name = "integrator/path/connect/light".to_owned();
    assert_eq!(error, KernelError::Unused { name });
}
