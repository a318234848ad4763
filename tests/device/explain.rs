//! The contents of a kernel and the lines that require them: compared with scenes whose lines are known, and with the kernels.

use vkpt::film::Aov;
use vkpt::prepared::Prepared;
use vkpt::render::{Job, KernelChoice, Plan, PlanLimits};
use vkpt::settings::{Connect, Distribution, DistributionRule, Sampler, Settings};
use vkpt_lab::explain::report::Part;
use vkpt_lab::explain::{Preset, Subject, parts};

use crate::common;
use crate::common::render::{job, on_device, prepared_file};
use crate::common::scenes::{LENS, SMOOTH, TABLE, WIDE, scene_files};
use crate::common::settings::{estimators, independent, models};

fn plan(job: &Job) -> Plan {
    Plan::new(job, PlanLimits::default()).expect("a plan")
}

/// The parts of a job whose settings are reported against the defaults.
fn explained(job: &Job, text: &str) -> Vec<Part> {
    let preset = Preset {
        name: "the default",
        settings: Settings::default(),
    };
    parts(&Subject {
        job,
        plan: &plan(job),
        scene: "test.txt",
        text,
        preset,
        device: "",
        auto: None,
    })
}

fn of_text(text: &str, settings: Settings) -> Vec<Part> {
    let prepared = common::render::prepared(text, &settings);
    explained(&job(&prepared, settings, 1, 1), text)
}

fn find<'a>(parts: &'a [Part], group: &str, name: &str) -> &'a Part {
    let found = parts.iter().find(|p| p.group == group && p.name == name);
    found.unwrap_or_else(|| panic!("{group} {name} is not listed"))
}

/// (group, name, lines): the features of this scene and the lines that require them.
type Row = (&'static str, &'static str, &'static [usize]);

/// Exactly these rows have lines, and these lines.
fn check(text: &str, expected: &[Row]) {
    let parts = of_text(text, Settings::default());
    let found: Vec<(&str, &str, &[usize])> = parts
        .iter()
        .filter(|p| p.present && !p.lines.is_empty())
        .map(|p| (p.group, p.name.as_str(), &p.lines[..]))
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn every_member_has_the_lines_that_brought_it_in() {
    // TABLE: 1 screen, 2 camera, 3 light, 4 sphere, 5 brdf, 6 box, 7 distribution, 8 brdf, 9 sphere, 10 brdf, 11 box.
    let table: [Row; 11] = [
        ("shape", "sphere", &[4, 9]),
        ("shape", "box", &[6, 11]),
        ("material", "black", &[3]),
        ("material", "diffuse", &[5]),
        ("material", "glossy", &[10]),
        ("material", "rough dielectric", &[8]),
        ("diffuse lobe", "and specular", &[10]),
        ("distribution", "ggx", &[8, 10]),
        ("fresnel", "schlick", &[8, 10]),
        ("light", "sphere", &[4]),
        ("absorption", "segment", &[8]),
    ];
    check(TABLE, &table);
    // SMOOTH: 3 background, 4 light, 5 box, 6 brdf, 7 box, 8 fresnel, 9 brdf, 10 sphere, 11 brdf, 12 cylinder.
    let smooth: [Row; 13] = [
        ("shape", "sphere", &[10]),
        ("shape", "box", &[5, 7]),
        ("shape", "cylinder", &[12]),
        ("material", "black", &[4]),
        ("material", "diffuse", &[6]),
        ("material", "mirror", &[11]),
        ("material", "smooth dielectric", &[9]),
        ("fresnel", "schlick", &[11]),
        ("fresnel", "exact", &[9]),
        ("light", "box", &[5]),
        ("light", "background", &[3]),
        ("light choice", "among few", &[3, 5]),
        ("absorption", "segment", &[9]),
    ];
    check(SMOOTH, &smooth);
}

#[test]
fn a_lens_has_its_line() {
    let lens = |text: &str| {
        let parts = of_text(text, Settings::default());
        let part = find(&parts, "camera", "lens");
        (
            part.present,
            part.lines.clone(),
            part.quote.clone(),
            part.why.clone(),
        )
    };
    assert_eq!(
        lens(LENS),
        (true, vec![3], "lens .5 4.8".into(), String::new())
    );
    let pinhole = (
        false,
        vec![],
        String::new(),
        "the camera is a pinhole".into(),
    );
    assert_eq!(lens(TABLE), pinhole);
}

#[test]
fn the_word_the_alpha_or_the_flag_is_named() {
    let why =
        |text: &str, settings, group, name| find(&of_text(text, settings), group, name).why.clone();
    let default = Settings::default();
    assert_eq!(
        why(TABLE, default, "distribution", "ggx"),
        "line 7: distribution ggx"
    );
    assert_eq!(
        why(SMOOTH, default, "fresnel", "exact"),
        "line 8: fresnel exact"
    );
    assert_eq!(why(SMOOTH, default, "light", "box"), "line 4: light 5 5 4");
    assert_eq!(
        why(TABLE, default, "absorption", "segment"),
        "Kt 0.9 0.5 0.3 per unit"
    );
    let auto = TABLE.replace("distribution ggx", "distribution auto");
    assert_eq!(
        why(&auto, default, "distribution", "ggx"),
        "alpha 0.3 is a width"
    );
    let exponent = auto.replace(".3 .9 .5", "30 .9 .5");
    assert_eq!(
        why(&exponent, default, "distribution", "phong"),
        "alpha 30 is an exponent"
    );

    let mut flags = default;
    flags.model.distribution = DistributionRule::Always(Distribution::Beckmann);
    flags.model.max_depth = Some(7);
    flags.estimator.connect = Connect::Light;
    flags.estimator.sampler = Sampler::Random;
    assert_eq!(
        why(TABLE, flags, "distribution", "beckmann"),
        "--distribution beckmann"
    );
    assert_eq!(
        why(TABLE, flags, "longest path", "7 bounces"),
        "--max-depth 7"
    );
    assert_eq!(
        why(TABLE, flags, "light sampling", "by connections"),
        "--connect light"
    );
    assert_eq!(why(TABLE, flags, "roulette", "throughput"), "the default");
    assert_eq!(why(TABLE, flags, "sampler", "random"), "--sampler random");
    assert_eq!(why(TABLE, default, "sampler", "sobol"), "the default");
}

#[test]
fn a_shape_before_any_material_is_listed_without_a_line() {
    let parts = of_text(
        "screen 8 6\ncamera 0 0 5 .3\nsphere 0 0 0 1\n",
        Settings::default(),
    );
    let default = find(&parts, "material", "glossy");
    assert!(default.present && default.lines.is_empty(), "{default:?}");
    assert_eq!(default.quote, "no material precedes the shape");
}

#[test]
fn parts_that_a_scene_lacks_are_left_out_with_the_reason() {
    let parts = of_text(
        "screen 8 6\ncamera 0 0 5 .3\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1\n",
        Settings::default(),
    );
    for (group, name, word) in [
        ("shape", "mesh", "mesh"),
        ("search", "hierarchy", "one by one"),
        ("material", "smooth dielectric", "Kt"),
        ("material", "glossy", "Ks"),
        ("diffuse lobe", "and specular", "Kd"),
        ("distribution", "ggx", "rough"),
        ("fresnel", "exact", "reflects"),
        ("light", "background", "black"),
        ("light choice", "among many", "no light"),
        ("absorption", "segment", "Kt"),
        ("normals", "of meshes", "no mesh"),
        ("micronormals", "visible", "rough"),
        ("lobe choice", "fresnel", "two lobes"),
        ("light sampling", "by connections", "no light"),
        ("longest path", "capped", "--max-depth"),
        ("film data", "spread of samples", "--aov"),
    ] {
        let part = find(&parts, group, name);
        assert!(!part.present, "{part:?}");
        assert!(part.why.contains(word), "{part:?}");
    }
}

/// Exactly the features are in the kernel, each by some line; all else has a reason.
fn check_whole(job: &Job, text: &str, name: &str) {
    for part in explained(job, text) {
        let is_explained = !part.why.is_empty() || !part.quote.is_empty();
        assert!(is_explained, "{name}: nothing explains {part:?}");
        assert!(part.present || part.lines.is_empty(), "{name}: {part:?}");
        assert!(!part.why.contains("--kernel"), "{name}: {part:?}");
        assert!(part.lines.is_sorted(), "{name}: {part:?}");
    }
}

#[test]
fn the_lines_and_the_features_agree_on_every_scene() {
    for path in scene_files() {
        for settings in [Settings::default(), Settings::handout()] {
            let scene: Prepared = prepared_file(&path, &settings, None);
            let text = std::fs::read_to_string(&path).expect("a scene");
            check_whole(
                &job(&scene, settings, 1, 1),
                &text,
                &path.display().to_string(),
            );
        }
    }
    for (name, settings) in estimators().into_iter().chain(models()) {
        for text in [TABLE, SMOOTH, WIDE] {
            let scene = common::render::prepared(text, &settings);
            check_whole(&job(&scene, settings, 1, 1), text, name);
        }
    }
}

/// The comparator above sees a member that no line asks for.
#[test]
fn a_planted_member_is_found() {
    let settings = Settings::default();
    let scene = common::render::prepared(TABLE, &settings);
    let planted = Job {
        kernel: KernelChoice::Full,
        ..job(&scene, settings, 1, 1)
    };
    let parts = explained(&planted, TABLE);
    let full = find(&parts, "material", "smooth dielectric");
    assert!(full.present && full.why == "--kernel full", "{full:?}");
    assert_eq!(find(&parts, "search", "hierarchy").why, "--kernel full");
    assert!(std::panic::catch_unwind(|| check_whole(&planted, TABLE, "planted")).is_err());
}

#[test]
fn a_plan_includes_requested_standard_errors() {
    let settings = independent();
    let scene = common::render::prepared(TABLE, &settings);
    let plain = job(&scene, settings, 2, 1);
    let asked = Job {
        aovs: &[Aov::Stderr],
        ..plain
    };
    let (without, with) = (plan(&plain), plan(&asked));
    let keeps_moments = |plan: &Plan| {
        let mut written = plan.state.plans().into_iter();
        written.any(|array| array.binding.name == "moments")
    };
    assert_eq!(
        (keeps_moments(&without), keeps_moments(&with)),
        (false, true)
    );
    // Four times three floats and a word to pad them, for each of 32 × 24 pixels.
    assert_eq!(with.device_bytes() - without.device_bytes(), 32 * 24 * 64);
    let beside = |job: &Job| find(&explained(job, TABLE), "film data", "spread of samples").clone();
    assert!(beside(&asked).present);
    let of_sobol = Job {
        settings: Settings::default(),
        ..asked
    };
    assert!(!keeps_moments(&plan(&of_sobol)));
    let part = beside(&of_sobol);
    assert!(!part.present && part.why.contains("two groups"), "{part:?}");
}

#[test]
fn buffers_are_made_as_planned() {
    let Some(device) = common::device() else {
        return;
    };
    let settings = Settings::default();
    for name in ["furnace", "glass-table", "glass-mesh", "many-lights"] {
        let path = format!("scenes/{name}.txt");
        let scene = prepared_file(path.as_ref(), &settings, Some([9, 7]));
        let plain = job(&scene, settings, 1, 1);
        let full = Job {
            kernel: KernelChoice::Full,
            aovs: &[Aov::Stderr],
            crop: Some([3, 4, 8, 6]),
            ..plain
        };
        for job in [plain, full] {
            let plan = Plan::new(&job, PlanLimits::of(device)).expect("a plan");
            let arrays = plan.scene.iter().copied().chain(plan.state.plans());
            let planned: Vec<_> = arrays
                .map(|a| (a.binding.name.to_owned(), a.bytes))
                .collect();
            let made = on_device(&job).expect("a device").stats.buffers;
            assert_eq!(made, planned, "{name} {:?}", job.kernel);
        }
    }
}
