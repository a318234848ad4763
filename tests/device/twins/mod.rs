//! Every GLSL function against its Rust twin: equal bits in `f32` on a CPU driver. See `twins/harness.rs`.

mod harness;

mod bidirectional;
mod bsdf;
mod camera;
mod elementary;
mod emission;
mod film;
mod light;
mod light_tree;
mod math;
mod path;
mod platform;
mod sampler;
mod shape;
mod surroundings;

use std::collections::BTreeSet;

use harness::{Row, Twin, check, compare};
use vkpt::kernel::{file, files};

use crate::common;

#[test]
fn bidirectional_functions() {
    check(&bidirectional::twins());
}

#[test]
fn bsdf_functions() {
    check(&bsdf::twins());
}

#[test]
fn camera_functions() {
    check(&camera::twins());
}

#[test]
fn elementary_functions() {
    check(&elementary::twins());
}

#[test]
fn film_functions() {
    check(&film::twins());
}

#[test]
fn light_functions() {
    check(&light::twins());
}

#[test]
fn math_functions() {
    check(&math::twins());
}

#[test]
fn surroundings_functions() {
    check(&surroundings::twins());
}

#[test]
fn path_functions() {
    check(&path::twins());
}

#[test]
fn platform_arithmetic() {
    check(&platform::twins());
}

#[test]
fn emission_functions() {
    check(&emission::twins());
}

#[test]
fn sampler_functions() {
    check(&sampler::twins());
}

#[test]
fn shape_functions() {
    check(&shape::twins());
}

// ---- no function without a row

/// Files without a row, by the start of their names, and why.
const EXCUSED: &[(&str, &str)] = &[
    ("camera/lens/", READS_THE_SCENE),
    (
        "film/moments/",
        "the buffer's side of film_moments; tests/device/same_bits.rs compares standard errors to the bit",
    ),
    ("integrator/bidirectional/aim/", READS_THE_SCENE),
    ("integrator/bidirectional/background/", READS_THE_SCENE),
    ("integrator/bidirectional/bend", READS_THE_SCENE),
    ("integrator/bidirectional/direct/", READS_THE_SCENE),
    ("integrator/bidirectional/emission/", READS_THE_SCENE),
    ("integrator/bidirectional/eye_", READS_THE_SCENE),
    ("integrator/bidirectional/first/", READS_THE_SCENE),
    ("integrator/bidirectional/join", READS_THE_SCENE),
    ("integrator/bidirectional/light_path", READS_THE_SCENE),
    ("integrator/bidirectional/to_light", READS_THE_SCENE),
    ("integrator/path/background/", READS_THE_SCENE),
    ("integrator/path/begin", READS_THE_SCENE),
    (
        "path/crossing/",
        "as path/vertex, whose types they take: a comparison with 0 and two choices",
    ),
    (
        "path/depth/",
        "a comparison with a constant; tests of --max-depth see it",
    ),
    ("integrator/path/direct/", READS_THE_SCENE),
    ("integrator/path/emission/", READS_THE_SCENE),
    ("integrator/path/pick/candidate", READS_THE_SCENE),
    ("integrator/path/pick/any", READS_THE_SCENE),
    ("integrator/path/pick/every", READS_THE_SCENE),
    ("integrator/path/pick/few", READS_THE_SCENE),
    ("integrator/path/pick/many", READS_THE_SCENE),
    ("integrator/path/pick/none", "constants"),
    ("integrator/path/pick/power", READS_THE_SCENE),
    ("integrator/path/pick/tree", READS_THE_SCENE),
    ("integrator/light/", READS_THE_SCENE),
    ("light/emission/point", "a constant"),
    ("bsdf/scaling/both", "one of two that have rows"),
    ("path/blocks/", "a sum, and none"),
    ("path/correction/", READS_THE_SCENE),
    ("path/extend", READS_THE_SCENE),
    ("path/trace", READS_THE_SCENE),
    ("path/medium/none", "a constant"),
    ("path/medium/segment", READS_THE_SCENE),
    ("path/medium/term", READS_THE_SCENE),
    ("integrator/path/record/", READS_THE_SCENE),
    ("integrator/bidirectional/record/", READS_THE_SCENE),
    ("path/self_distance/", READS_THE_SCENE),
    ("integrator/path/shade", READS_THE_SCENE),
    ("integrator/path/weigh", "a function of fewer arguments"),
    ("path/spawn", READS_THE_SCENE),
    ("path/null_interface/", READS_THE_SCENE),
    ("path/valid/flat", "its arguments"),
    ("path/vertex", READS_THE_SCENE),
    (
        "shape/bvh/",
        "tests/device/bvh compares their hits with brute force",
    ),
    ("shape/cover/none", "constants"),
    ("shape/triangle/corner", READS_THE_SCENE),
];

const READS_THE_SCENE: &str =
    "its functions read a scene's buffers: whole paths are compared with the reference";

fn excused(file: &str) -> bool {
    EXCUSED.iter().any(|(start, _)| file.starts_with(start))
}

/// All rows of functions.
fn all() -> Vec<Twin> {
    let twins = [
        bidirectional::twins(),
        bsdf::twins(),
        camera::twins(),
        elementary::twins(),
        emission::twins(),
        film::twins(),
        light::twins(),
        light_tree::twins(),
        math::twins(),
        path::twins(),
        sampler::twins(),
        shape::twins(),
        surroundings::twins(),
    ];
    twins.into_iter().flatten().collect()
}

/// Dispatch that is generated for a scene. Each branch calls a function that has a row; that it is the right one show
/// whole paths in `tests/device/same_bits.rs`.
const GENERATED: [&str; 20] = [
    "box_covered",
    "bsdf_eval",
    "bsdf_sample",
    "cylinder_covered",
    "distribution_d",
    "distribution_g1",
    "distribution_sample",
    "face_point",
    "fresnel",
    "hit_surface",
    "light_pdf",
    "light_radiance",
    "light_sample",
    "mesh_covered",
    "nearest",
    "outside_seen",
    "read_primitives",
    "sphere_covered",
    "visible_pdf",
    "visible_sample",
];

#[test]
fn every_function_has_a_row() {
    let twins = all();
    let tested: BTreeSet<(String, &str)> = twins.iter().flat_map(Twin::tested).collect();
    let library = files().filter(|f| !f.ends_with(".comp") && !excused(f));
    let missing: Vec<String> = library
        .flat_map(|f| functions(file(f).unwrap_or_default()).map(move |name| (f.to_owned(), name)))
        .filter(|function| !tested.contains(function))
        .map(|(file, name)| format!("{file}: {name}"))
        .collect();
    assert!(
        missing.is_empty(),
        "without a row in tests/device/twins/:\n{}",
        missing.join("\n")
    );
}

/// naga's own list of the functions of whole kernels: each has a row or is in an excused file, or it is generated
/// and calls one of several that do.
#[test]
fn every_function_that_naga_lists_is_accounted_for() {
    let Some(device) = common::device() else {
        return;
    };
    let twins = all();
    let tested = twins.iter().flat_map(Twin::tested).map(|(_, name)| name);
    let read = files().filter(|f| f.ends_with(".comp") || excused(f));
    let read = read.flat_map(|f| functions(file(f).unwrap_or_default()));
    let known: BTreeSet<&str> = tested.chain(read).chain(GENERATED).collect();
    let settings = common::settings::estimators().into_iter();
    let mut missing = BTreeSet::new();
    for (_, settings) in settings.chain(common::settings::models()) {
        for text in [
            common::scenes::TABLE,
            common::scenes::SMOOTH,
            common::scenes::WIDE,
            common::scenes::FLUSH,
            common::scenes::MANY,
        ] {
            let scene = common::render::prepared(text, &settings);
            let job = common::render::job(&scene, settings, 1, 1);
            let kernels = vkpt::render::kernels(&job, device).expect("kernels");
            let listed = kernels.into_iter().flat_map(|kernel| kernel.functions);
            missing.extend(listed.filter(|f| !known.contains(f.as_str())));
        }
    }
    assert_eq!(missing, BTreeSet::new());
}

/// The functions that a GLSL file defines: a definition starts its line, `type name(`.
fn functions(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let (head, _) = line.split_once('(')?;
        let (ty, name) = head.split_once(' ')?;
        let word =
            |w: &str| !w.is_empty() && w.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        (word(ty) && word(name) && !line.trim_end().ends_with(';')).then_some(name)
    })
}

#[test]
fn functions_are_found_in_a_file() {
    let text = "// float no(float x) {\nconst float K = f(1.0);\nvec3 one(vec3 v) {\n    return two(v);\n}\nfloat two() { return 2.0; }\n";
    assert_eq!(functions(text).collect::<Vec<_>>(), ["one", "two"]);
}

// ---- the harness itself: it agrees where it should, and fails on planted errors

const SQUARE: &str = "float square(float x, float y) { return x * x + y; }\n";
const CALL: &str = "float x = in_f(); float y = in_f(); out_f(square(x, y));";

fn square(glsl: &str, rust: impl Fn(f32, f32) -> f32 + 'static) -> Twin {
    Twin::new("square", "test/square")
        .source("test/square", SQUARE)
        .glsl(glsl)
        .rust(move |i, o| {
            let (x, y) = (i.f(), i.f());
            o.f(rust(x, y));
        })
        .edge([-0.0, -0.0])
        .edge([f32::MAX, f32::NEG_INFINITY])
        .edge([f32::NAN, 0.0])
        .seeded(200, |r| Row::new().f(r.range(-9.0, 9.0)).f(r.finite()))
}

/// The failure's text, or `None` if the run skips devices.
fn failure(twin: &Twin) -> Option<String> {
    Some(compare(twin, common::device()?).expect_err("a planted error was not found"))
}

#[test]
fn equal_twins_pass() {
    check(&[square(CALL, |x, y| x * x + y)]);
}

#[test]
fn one_ulp_fails_and_prints_a_row_to_paste() {
    let off = || {
        square(CALL, |x, y| {
            let z = x * x + y;
            if x == 3.0 {
                f32::from_bits(z.to_bits() + 1)
            } else {
                z
            }
        })
    };
    let Some(text) = failure(&off().edge([3.0, 0.5])) else {
        return;
    };
    assert!(text.starts_with("square: 1 of 204 rows differ\n"), "{text}");
    assert!(
        text.contains(".edge([0x40400000 /* 3e0 */, 0x3f000000 /* 5e-1 */])"),
        "{text}"
    );
    assert!(
        text.contains("device 0x41180000 (9.5e0), Rust 0x41180001 (9.500001e0), 1 ulps apart"),
        "{text}"
    );
    // pasted as it was printed
    let pasted = off().edge([0x40400000 /* 3e0 */, 0x3f000000 /* 5e-1 */]);
    assert_eq!(failure(&pasted).as_deref(), Some(text.as_str()));
}

#[test]
fn a_zero_of_the_other_sign_fails() {
    let Some(text) = failure(&square(
        CALL,
        |x, y| if x == 0.0 { -0.0 } else { x * x + y },
    )) else {
        return;
    };
    assert!(text.contains("square: 1 of 203 rows differ"), "{text}");
}

#[test]
fn a_number_for_a_nan_fails() {
    let Some(text) = failure(&square(
        CALL,
        |x, y| if x.is_nan() { 1.0 } else { x * x + y },
    )) else {
        return;
    };
    assert!(text.contains("1 of 203 rows differ"), "{text}");
}

#[test]
fn an_unwritten_output_fails_even_where_a_nan_is_due() {
    let skips = "float x = in_f(); float y = in_f(); if (x == x) { out_f(square(x, y)); }";
    let skips = skips.replace("x == x", "floatBitsToUint(x) != 0x7fc00000u");
    let Some(text) = failure(&square(&skips, |x, y| x * x + y)) else {
        return;
    };
    assert!(
        text.contains("not written") && text.contains("1 of 203 rows differ"),
        "{text}"
    );
}

#[test]
fn inputs_left_unread_and_outputs_too_many_fail() {
    let Some(text) = failure(&square("float x = in_f(); out_f(square(x, x));", |x, _| {
        x * x + x
    })) else {
        return;
    };
    assert!(
        text.contains("the kernel read 1 words and wrote 1, Rust 2 and 1"),
        "{text}"
    );
    let Some(text) = failure(&square(&format!("{CALL} out_f(y);"), |x, y| x * x + y)) else {
        return;
    };
    assert!(
        text.contains("the kernel read 2 words and wrote 2, Rust 2 and 1"),
        "{text}"
    );
}

#[test]
fn a_write_before_the_outputs_fails() {
    let Some(text) = failure(&square(
        &format!("{CALL} twin_out.words[3] = 0u;"),
        |x, y| x * x + y,
    )) else {
        return;
    };
    assert!(text.contains("wrote before its outputs"), "{text}");
}
