//! Scenes that the grammar allows, with numbers from all over the legal range: each is read as it was written, and neither
//! these nor their mutations break a promise of the reader.

use std::path::Path;

use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::RngSeed;
use vkpt::scene::{Geometry, Read, Shape, parse};

use super::fuzz::NASTY;
use crate::bodies;

/// Runs with the same cases each time: a failure shrinks to a small scene, which becomes a separate test.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(6),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Any number that single precision represents: of everyday size, or of any exponent.
fn number() -> impl Strategy<Value = f64> {
    let whole_range = prop::num::f32::ANY.prop_filter("finite", |v| v.is_finite());
    prop_oneof![
        4 => -10.0..10.0f64,
        1 => (-99..99i32).prop_map(f64::from),
        2 => whole_range.prop_map(f64::from),
    ]
}

/// Above 0 in single precision too.
fn positive() -> impl Strategy<Value = f64> {
    number().prop_map(|v| v.abs().max(f64::from(f32::from_bits(1))))
}

/// From 0 to 1, the ends not rarely.
fn share() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0f64, Just(1e-30)]
}

/// `count` numbers of a kind, as a line has them.
fn row<S: Strategy<Value = f64> + 'static>(of: fn() -> S, count: usize) -> BoxedStrategy<String> {
    prop::collection::vec(of(), count)
        .prop_map(|row| row.iter().map(written).collect::<Vec<_>>().join(" "))
        .boxed()
}

/// A number with an exponent where that is shorter: either way, all of its digits.
fn written(v: &f64) -> String {
    let [plain, scientific] = [format!("{v}"), format!("{v:e}")];
    if plain.len() <= scientific.len() {
        plain
    } else {
        scientific
    }
}

/// Rotations; the axis of one about any axis is kept from being zero.
fn orientation() -> impl Strategy<Value = String> {
    let about =
        (select(vec!["x", "y", "z"]), row(number, 1)).prop_map(|(axis, by)| format!("{axis} {by}"));
    let any = (row(number, 1), row(positive, 3)).prop_map(|(by, axis)| format!("a {by} {axis}"));
    let quaternion = row(positive, 4).prop_map(|q| format!("q {q}"));
    prop::collection::vec(prop_oneof![about, any, quaternion], 0..4).prop_map(|all| all.join(" "))
}

/// A line after the first two.
fn statement() -> impl Strategy<Value = String> {
    let brdf = (row(share, 6), row(positive, 1))
        .prop_map(|(colours, alpha)| format!("brdf {colours} {alpha}"));
    let glass = (
        row(share, 6),
        row(positive, 1),
        row(share, 3),
        row(positive, 1),
    )
        .prop_map(|(colours, alpha, kt, ior)| format!("brdf {colours} {alpha} {kt} {ior}"));
    let words = [
        "distribution auto",
        "distribution phong",
        "distribution beckmann",
        "distribution ggx",
        "fresnel schlick",
        "fresnel exact",
        "",
        "# a comment",
        "ambient .1 .1 .1",
    ];
    let mesh = (row(number, 3), row(positive, 1), orientation()).prop_map(|(at, scale, turn)| {
        format!("mesh tests/data/scene/tetrahedron.ply {at} {scale} {turn}")
    });
    prop_oneof![
        brdf,
        glass,
        select(words.map(str::to_owned).to_vec()),
        row(positive, 3).prop_map(|v| format!("light {v}")),
        row(positive, 3).prop_map(|v| format!("background {v}")),
        row(positive, 2).prop_map(|v| format!("lens {v}")),
        (row(number, 3), row(positive, 1)).prop_map(|(c, r)| format!("sphere {c} {r}")),
        (row(number, 3), row(positive, 3)).prop_map(|(c, d)| format!("box {c} {d}")),
        (row(number, 3), row(positive, 4)).prop_map(|(b, ar)| format!("cylinder {b} {ar}")),
        mesh,
    ]
}

/// A legal scene, as lines.
fn scene() -> impl Strategy<Value = Vec<String>> {
    let camera = (row(number, 3), row(positive, 1), orientation());
    let size = (1..=16384u32, 1..=16384u32);
    let rest = prop::collection::vec(statement(), 0..12);
    (size, camera, rest).prop_map(|((w, h), (eye, ry, turn), mut lines)| {
        lines.insert(0, format!("screen {w} {h}"));
        lines.insert(1, format!("camera {eye} {ry} {turn}"));
        lines
    })
}

fn read(text: &str) -> Read {
    parse(text, Path::new("grammar.scn"), false)
        .unwrap_or_else(|e| panic!("{e}: {:?}\n{text}", e.diagnostics))
}

/// The words of a mutation: which line, which token of it, and its replacement.
fn mutation() -> impl Strategy<Value = (Index, Index, &'static str)> {
    (any::<Index>(), any::<Index>(), select(NASTY.to_vec()))
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn a_legal_scene_is_read_and_keeps_its_promises(lines in scene()) {
        let text = lines.join("\n");
        read(&text);
        bodies::scene(text.as_bytes());
    }

    /// White space is blanks, tabs, and the ends of lines of any system.
    #[test]
    fn white_space_says_nothing(
        lines in scene(),
        blank in select(vec!["\t", "  ", " \t "]),
        end in select(vec!["\n", "\r\n", "\r", " \n"]),
    ) {
        let wide = lines.iter().map(|line| format!("{blank}{}", line.replace(' ', blank)));
        let wide = wide.collect::<Vec<_>>().join(end);
        let [one, other] = [lines.join("\n"), wide].map(|text| format!("{:?}", read(&text).scene));
        prop_assert_eq!(one, other);
    }

    /// All digits of a number count, in any notation.
    #[test]
    fn numbers_are_read_as_they_were_written(
        [x, y, z] in [number(), number(), number()],
        r in positive(),
    ) {
        for written in [format!("{x} {y} {z} {r}"), format!("{x:e} {y:e} {z:e} {r:e}")] {
            let read = read(&format!("screen 4 3\ncamera 0 0 5 0.5\nsphere {written}"));
            let [Shape { geometry: Geometry::Sphere { centre, radius }, .. }] = read.scene.shapes[..] else {
                panic!("one sphere");
            };
            let bits = |v: [f64; 4]| v.map(f64::to_bits);
            prop_assert_eq!(bits([centre.x, centre.y, centre.z, radius]), bits([x, y, z, r]));
        }
    }

    /// Up to three tokens give way to others that are likely to hurt, then a line is lost.
    #[test]
    fn a_mutated_scene_keeps_its_promises(
        mut lines in scene(),
        mutations in prop::collection::vec(mutation(), 1..4),
        lost in any::<Index>(),
    ) {
        for (line, token, nasty) in mutations {
            let line = line.get_mut(&mut lines[..]);
            let mut words: Vec<_> = line.split(' ').collect();
            *token.get_mut(&mut words[..]) = nasty;
            *line = words.join(" ");
        }
        bodies::scene(lines.join("\n").as_bytes());
        lines.remove(lost.index(lines.len()));
        bodies::scene(lines.join("\n").as_bytes());
    }
}
