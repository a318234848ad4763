//! The same bits with more members, others with fewer.

use std::collections::BTreeSet;

use vkpt::features::{Features, Member};
use vkpt::film::{Aov, Film};
use vkpt::prepared::{MaterialKind, Prepared};
use vkpt::render::{Job, KernelChoice, Outcome};
use vkpt::settings::Settings;

use super::scenes::{DARK, EMPTY, small_scenes};
use super::{extra, full};
use crate::common::cpu_driver;
use crate::common::render::{difference, job, on_device, prepared, prepared_file};
use crate::common::scenes::{SMOOTH, scene_files};
use crate::common::settings::{estimators, models};

/// The picture of a kernel that contains `features`.
fn film(job: &Job, features: &Features) -> Film {
    let job = Job {
        kernel: KernelChoice::Given(features),
        ..*job
    };
    on_device(&job).expect("a device").film
}

/// Picture, standard errors and counts of both kernels, which must be two.
fn full_equals_composed(scene: &Prepared, settings: Settings, name: &str) {
    let job = Job {
        aovs: &[Aov::Stderr],
        ..job(scene, settings, 4, 1)
    };
    let [composed, full] = [KernelChoice::Composed, KernelChoice::Full]
        .map(|kernel| on_device(&Job { kernel, ..job }).expect("a device"));
    assert_eq!(difference(&composed.film, &full.film), None, "{name}");
    let stderr = |o: Outcome| o.stderr.expect("four samples");
    let counts = |o: &Outcome| {
        (
            o.stats.rays,
            o.stats.long_paths,
            o.stats.underflows,
            o.stats.dropped,
            o.stats.largest,
        )
    };
    assert_eq!(counts(&composed), counts(&full), "{name}");
    assert_ne!(composed.stats.features, full.stats.features, "{name}");
    let errors = difference(&stderr(composed), &stderr(full));
    assert_eq!(errors, None, "{name}, standard errors");
}

/// The project's scenes, one in the dark, one without shapes.
#[test]
fn the_full_kernel_makes_the_picture_of_every_scene() {
    if cpu_driver().is_none() {
        return;
    }
    let settings = Settings::default();
    for path in scene_files() {
        let scene = prepared_file(&path, &settings, Some([40, 30]));
        full_equals_composed(&scene, settings, &path.display().to_string());
    }
    for text in [DARK, EMPTY] {
        full_equals_composed(&prepared(text, &settings), settings, text);
    }
}

/// The settings that put other files around the full kernel's members.
#[test]
fn the_full_kernel_makes_the_picture_of_other_settings() {
    if cpu_driver().is_none() {
        return;
    }
    let names = [
        "connect light",
        "connect bsdf",
        "max-depth 3",
        "sampler random",
        "the hand-out's",
    ];
    let all = estimators().into_iter().chain(models());
    for (name, settings) in all.filter(|(name, _)| names.contains(name)) {
        full_equals_composed(&prepared(SMOOTH, &settings), settings, name);
    }
}

/// The composed kernel with one member more and the full kernel with one less, for members that the scene does not
/// need and that `choose` takes.
fn one_more_or_less(names: &[&str], mut choose: impl FnMut(Member) -> bool) {
    let settings = Settings::default();
    let scenes = small_scenes(&settings);
    for (name, scene) in scenes.iter().filter(|(name, _)| names.contains(name)) {
        let job = job(scene, settings, 2, 1);
        let (composed, full) = (job.features(), full(&job));
        let right = film(&job, &composed);
        for member in extra(&job).into_iter().filter(|&m| choose(m)) {
            let with = difference(&right, &film(&job, &composed.with(member)));
            assert_eq!(with, None, "{name} with {member:?}");
            let without = difference(&right, &film(&job, &full.without(member)));
            assert_eq!(without, None, "{name}, all but {member:?}");
        }
    }
}

/// Each member once, on the first of these scenes that lacks it.
#[test]
fn each_member_alone_on_and_alone_off_changes_no_bit() {
    if cpu_driver().is_none() {
        return;
    }
    let mut tried = BTreeSet::new();
    one_more_or_less(&["diffuse", "clear", "flat mesh"], |member| {
        tried.insert(member)
    });
    // No scene is without a diffuse surface.
    tried.insert(Member::Material(MaterialKind::Diffuse));
    assert_eq!(tried, Features::full(&Settings::default(), &[]).members());
}

/// Every member, on scenes that have most and least of them and a mesh.
#[test]
#[ignore = "a quarter of an hour: 80 kernels to compile"]
fn each_member_alone_on_and_alone_off_changes_no_bit_of_two_scenes() {
    if cpu_driver().is_some() {
        one_more_or_less(&["wide", "smooth mesh"], |_| true);
    }
}

/// SplitMix64 (Steele, Lea, Flood 2014).
fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Any number of members more than the scene needs, drawn at random: errors that no pair shows.
#[test]
#[ignore = "a quarter of an hour: 80 kernels to compile"]
fn any_members_more_change_no_bit() {
    if cpu_driver().is_none() {
        return;
    }
    let settings = Settings::default();
    let mut state = 1;
    for (name, scene) in small_scenes(&settings) {
        let job = job(&scene, settings, 2, 1);
        let right = film(&job, &job.features());
        for _ in 0..12 {
            let coins = random(&mut state);
            let more = (0..).zip(extra(&job)).filter(|(i, _)| coins >> i & 1 == 1);
            let features = more.fold(job.features(), |f, (_, member)| f.with(member));
            let difference = difference(&right, &film(&job, &features));
            assert_eq!(difference, None, "{name}: {features}");
        }
    }
}

/// Members without which a kernel does the same: a path ends at a black surface before any dispatch, and the weak interface,
/// which is then the last of the kinds, treats an opaque material as `opaque` does.
const UNNOTICED: [Member; 2] = [
    Member::Material(MaterialKind::Black),
    Member::Material(MaterialKind::Glossy),
];

/// The comparison can fail: the full kernel without one member that the scene needs, each member once.
#[test]
fn a_member_that_is_missing_is_noticed() {
    if cpu_driver().is_none() {
        return;
    }
    let settings = Settings::default();
    let mut tried: BTreeSet<Member> = UNNOTICED.into();
    for (name, scene) in small_scenes(&settings).into_iter().rev() {
        let job = job(&scene, settings, 2, 1);
        let right = film(&job, &job.features());
        for member in job.features().members() {
            // Whether a shape is searched in the hierarchy or alone changes no picture.
            if !matches!(member, Member::InBvh(_)) && tried.insert(member) {
                let wrong = film(&job, &full(&job).without(member));
                assert_ne!(
                    difference(&right, &wrong),
                    None,
                    "{name} without {member:?}"
                );
            }
        }
    }
    assert!(tried.len() > 20, "{tried:?}");
}
