//! Which faces coincide, by hand; and how they look, by closed forms.

use std::path::Path;

use vkpt::prepared::{Prepared, prepare};
use vkpt::settings::Settings;

use crate::common::meshes::{cube, square};

/// Radius, corners, angles: one of each kind.
const VIEW: &str = "screen 8 8\ncamera 0 -6 2 .2 x 72\n";
const MATTE: &str = "brdf .5 .5 .5 0 0 0 1\n";
const GLASS: &str = "brdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\n";

fn prepared(text: &str) -> Prepared {
    let text = format!("{VIEW}{text}");
    let read = vkpt::scene::parse(&text, Path::new("test.txt"), false).expect("a good scene");
    prepare(&read.scene, &Settings::default(), None).expect("few lights")
}

/// Every entry: (line of the shape, face) of the list, the same of the entry, whether they touch.
fn entries(scene: &Prepared) -> Vec<([usize; 2], [usize; 2], bool)> {
    let line = |shape: u32| scene.shapes[shape as usize].line - 2;
    let mut all = Vec::new();
    for (i, shape) in (0..).zip(&scene.shapes) {
        for prim in shape.faces() {
            for c in scene.primitives.coincident.of(i, prim) {
                let (of, entry) = ([line(i), prim as usize], [line(c.shape), c.prim as usize]);
                all.push((of, entry, c.touches != 0));
            }
        }
    }
    all
}

fn of(text: &str) -> Vec<([usize; 2], [usize; 2], bool)> {
    entries(&prepared(text))
}

#[test]
fn a_lamp_flush_with_the_ceiling_and_a_ceiling_flush_with_the_lamp() {
    let lamp = "light 6 6 6\nbox -1 -1 3 2 2 .1\n";
    let ceiling = "brdf .7 .7 .7 0 0 0 1\nbox -5 -5 3 10 10 .2\n";
    // Lower faces across z have number 4; the one that comes later is in the list of none.
    assert_eq!(of(&format!("{lamp}{ceiling}")), [([4, 4], [2, 4], false)]);
    assert_eq!(of(&format!("{ceiling}{lamp}")), [([4, 4], [2, 4], false)]);
    let lower = lamp.replace("-1 -1 3 ", "-1 -1 2.999 ");
    assert_eq!(of(&format!("{lower}{ceiling}")), []);
}

#[test]
fn solids_that_stand_twice() {
    let sphere = "sphere .137 .291 .173 1.01\n";
    assert_eq!(
        of(&format!("{MATTE}{sphere}{sphere}")),
        [([3, 0], [2, 0], false)]
    );
    let other = "sphere .137 .291 .173 1.0101\n";
    assert_eq!(of(&format!("{MATTE}{sphere}{other}")), []);
    let cylinder = "cylinder .1 .2 .3 1 2 3 .7\n";
    let twice = of(&format!("{MATTE}{cylinder}{cylinder}"));
    assert_eq!(twice, [0, 1, 2].map(|part| ([3, part], [2, part], false)));
    // The same solid begun at its other end: base and top change places.
    let turned = of(&format!(
        "{MATTE}{cylinder}cylinder 1.1 2.2 3.3 -1 -2 -3 .7\n"
    ));
    assert_eq!(
        turned,
        [[0, 0], [1, 2], [2, 1]].map(|[a, b]| ([3, a], [2, b], false))
    );
    let r#box = "box 0 0 0 1 2 3\n";
    let twice = of(&format!("light 1 1 1\n{}{}", r#box, r#box));
    assert_eq!(
        twice,
        [0, 1, 2, 3, 4, 5].map(|face| ([3, face], [2, face], false))
    );
}

/// Between two opaque solids there is no ray; of glass on a table the table's face is the one; glass that touches glass is
/// in both lists.
#[test]
fn faces_that_look_at_each_other() {
    let below = "box -1 -1 -1 2 2 1\n";
    let above = "box -1 -1 0 1 1 1\n";
    let cylinder = "cylinder .5 .5 0 0 0 1 .4\n";
    assert_eq!(of(&format!("{MATTE}{below}{above}{cylinder}")), []);
    let table = [([4, 4], [2, 5], false)];
    assert_eq!(of(&format!("{MATTE}{below}{GLASS}{above}")), table);
    let table = [([4, 4], [2, 5], false)];
    // Opaque shapes come first, wherever they are in the file.
    assert_eq!(
        of(&format!("{GLASS}{above}{MATTE}{below}")),
        [([2, 4], [4, 5], false)]
    );
    assert_eq!(
        of(&format!("{MATTE}{below}{GLASS}{cylinder}")),
        table.map(|_| ([4, 1], [2, 5], false))
    );
    let touch = [([2, 5], [3, 4], true), ([3, 4], [2, 5], true)];
    assert_eq!(of(&format!("{GLASS}{below}{above}")), touch);
}

/// Two triangles of a square each: those that overlap, and not those that only share an edge.
#[test]
fn meshes_on_solids_and_on_each_other() {
    let file = square();
    let mesh = file.path().display();
    assert_eq!(of(&format!("{MATTE}mesh {mesh} 0 0 0 1\n")), []);
    let poster = of(&format!(
        "{MATTE}box -9 -9 -1 18 18 1\nmesh {mesh} 0 0 0 1\n"
    ));
    assert_eq!(poster, [0, 1].map(|k| ([3, k], [2, 5], false)));
    let before = of(&format!(
        "{MATTE}mesh {mesh} 0 0 0 1\nbox -9 -9 -1 18 18 1\n"
    ));
    assert_eq!(before, [0, 1].map(|k| ([3, 5], [2, k], false)));
    let above = of(&format!(
        "{MATTE}box -9 -9 -1 18 18 1\nmesh {mesh} 0 0 .001 1\n"
    ));
    assert_eq!(above, []);
    // Turned by 10° in a place that no coordinate of single precision has, small on large: each of the small one's triangles
    // lies across the diagonal of the large one.
    let tilted = of(&format!(
        "{MATTE}mesh {mesh} 0 0 .3 9 y 10\nmesh {mesh} 0 0 .3 1 y 10 z 40\n"
    ));
    let pairs = [[2, 0], [2, 1], [3, 0], [3, 1]];
    assert_eq!(tilted, pairs.map(|[a, b]| ([3, a], [2, b], false)));
    let beside = of(&format!(
        "{MATTE}mesh {mesh} 0 0 0 1\nmesh {mesh} 2 0 0 1\n"
    ));
    assert_eq!(beside, []);
}

/// Cubes of glass in one mesh or two: faces that touch coincide, corners do not.
#[test]
fn cubes_that_touch() {
    let file = cube();
    let mesh = file.path().display();
    let beside = of(&format!(
        "{GLASS}mesh {mesh} 0 0 0 1\nmesh {mesh} 2 0 0 1\n"
    ));
    assert!(
        !beside.is_empty() && beside.iter().all(|e| e.2),
        "{beside:?}"
    );
    let corner = of(&format!(
        "{GLASS}mesh {mesh} 0 0 0 1\nmesh {mesh} 2 2 0 1\n"
    ));
    assert_eq!(corner, []);
}

/// Up to the rounding of turned shapes; a gap that single precision represents is one.
#[test]
fn glass_touches_glass_in_every_shape() {
    let cube = cube();
    let mesh = format!("mesh {} 0 0 -1 1", cube.path().display());
    let touch = |shapes: &str| {
        let scene = prepared(&format!("background 1 1 1\n{GLASS}{shapes}"));
        assert_eq!(scene.warnings, Vec::<String>::new());
        let touches = entries(&scene).iter().filter(|e| e.2).count();
        assert!(touches.is_multiple_of(2), "each is in the other's list");
        touches > 0
    };
    let on_top = "box -1 -1 0  2 2 1\n";
    for below in [
        "box -1 -1 -1  2 2 1",
        "box -3 -3 -1  2.5 2.5 1",
        "cylinder 0 0 -1  0 0 1  .5",
        "cylinder 0 0 -1  1e-9 0 1  .5",
        &mesh,
    ] {
        assert!(touch(&format!("{on_top}{below}\n")), "{below}");
        assert!(touch(&format!("{below}\n{on_top}")), "{below}");
    }
    for apart in [
        "box -1 -1 -1  2 2 .999",
        "box -1 -1 -1  2 2 .99999999",
        "box 1 1 -1  2 2 1",
        "sphere 0 0 -1  1",
        "cylinder -1 0 -.5  2 0 0  .5",
    ] {
        assert!(!touch(&format!("{on_top}{apart}\n")), "{apart}");
    }
}
