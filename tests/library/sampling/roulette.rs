//! Russian roulette: lengths of paths that nothing else ends, inside closed balls.

use vkpt::reference::math::Vec3;
use vkpt::reference::path::roulette::roulette_survival;
use vkpt::settings::Roulette;

use super::{ALPHA, story, world};
use crate::common::settings::independent;
use crate::common::stats::{chi_square, sidak};

/// A scene without light, the eye in a ball whose inside reflects by `brdf`.
fn ball(brdf: &str) -> String {
    format!("screen 1 1\ncamera .2 .1 0 .5\nbrdf {brdf}\nsphere 0 0 0 1\n")
}

/// How many of `paths` paths end at vertex first, first + 1 …, the last count including all beyond.
fn lengths(scene: &str, roulette: Roulette, paths: u32, first: usize) -> Vec<usize> {
    let mut settings = independent();
    settings.estimator.roulette = roulette;
    let world = world(scene, &settings);
    let mut counts = vec![0; 40];
    for sample in 0..paths {
        let story = story(&world, &settings, [0, 0], sample);
        assert!(story.escaped.is_none() && story.vertices >= first);
        counts[(story.vertices - first).min(39)] += 1;
    }
    counts
}

/// Expected counts where the first vertex in question is survived with probability `at_first`, each further one with
/// `then`.
fn geometric(paths: u32, at_first: f64, then: f64) -> Vec<f64> {
    let n = f64::from(paths);
    let mut expected = vec![n * (1.0 - at_first)];
    let mut alive = n * at_first;
    for _ in 1..39 {
        expected.push(alive * (1.0 - then));
        alive *= then;
    }
    expected.push(alive);
    expected
}

struct Case {
    name: &'static str,
    brdf: &'static str,
    roulette: Roulette,
    paths: u32,
    /// Vertices of the shortest path.
    first: usize,
    at_first: f64,
    then: f64,
}

/// Red is the largest channel. On throughput the first two bounces are free: what is left of a path after three
/// is survived with 0.5³, and from there on it has throughput 1 before each bounce and 0.5 after it. A mirror that
/// loses nothing is left at 0.95 from bounce 1000 on, under every setting.
fn cases() -> Vec<Case> {
    let case = |name, brdf, roulette, first, [at_first, then]: [f64; 2]| Case {
        name,
        brdf,
        roulette,
        paths: if first < 1000 { 100_000 } else { 2_000 },
        first,
        at_first,
        then,
    };
    let (half, mirror) = (".5 .3 .1 0 0 0 1", "0 0 0 1 1 1 0");
    let long = [0.95, 0.95];
    vec![
        case("diffuse", half, Roulette::Throughput, 3, [0.125, 0.5]),
        case("constant", half, Roulette::Constant(0.8), 1, [0.8, 0.8]),
        case("long", mirror, Roulette::Throughput, 1001, long),
        case("long, off", mirror, Roulette::Off, 1001, long),
        case(
            "long, constant",
            mirror,
            Roulette::Constant(1.0),
            1001,
            long,
        ),
    ]
}

#[test]
fn paths_survive_as_often_as_they_should() {
    let cases = cases();
    let level = sidak(ALPHA, cases.len());
    for case in cases {
        let counts = lengths(&ball(case.brdf), case.roulette, case.paths, case.first);
        let p = |then| chi_square(&counts, &geometric(case.paths, case.at_first, then));
        assert!(p(case.then) > level, "{}: {counts:?}", case.name);
        // a long path's 0.95 · 1.02 is 0.97, a third fewer ends
        let off = if case.paths > 10_000 { 1.03 } else { 1.02 };
        assert!(p(case.then * off) < level, "{} × {off} passes", case.name);
    }
}

/// In glass throughput is n² smaller and worth as much: a path that loses nothing is never ended, however often it is
/// reflected inside.
#[test]
fn glass_is_not_a_reason_to_end() {
    let scene = "screen 1 1\ncamera 0 0 3 .4\nfresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\n\
                 box -1 -1.1 -1.2 2 2.1 2.3\n";
    let settings = independent();
    let world = world(scene, &settings);
    let (mut most, mut seen) = (0, 0);
    for sample in 0..20_000 {
        let story = story(&world, &settings, [0, 0], sample);
        assert!(story.escaped.is_some(), "sample {sample}");
        most = most.max(story.vertices);
        seen += usize::from(story.vertices >= 4);
    }
    assert!(most > 4 && seen > 100, "{most} {seen}");
    // with the scale left in, more than half of those seen would have ended inside
    let inside = Vec3::splat(1.0 / 2.25);
    assert!(roulette_survival(Roulette::Throughput, inside, 1.0, 2) < 0.5);
}
