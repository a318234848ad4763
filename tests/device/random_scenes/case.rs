//! A scene and how it is rendered.

use std::fmt;
use std::path::Path;

use proptest::prelude::*;
use proptest::sample::select;
use vkpt::prepared::{Prepared, prepare};
use vkpt::settings::Settings;

use super::material::{brdf, light};
use super::number::{coordinate, decades, radiance, row};
use super::settings::settings;
use super::shape::{Shape, shape};

/// The input of a rendering.
#[derive(Clone)]
pub struct Case {
    /// A scene file.
    pub text: String,
    pub settings: Settings,
    pub seed: u32,
}

/// The same as the source of a named test.
impl fmt::Debug for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "seed {}, {:?}\n{}", self.seed, self.settings, self.text)
    }
}

impl Case {
    /// The scene for both renderers. Legal it is, and not beyond single precision.
    pub fn prepared(&self) -> Prepared {
        let read = vkpt::scene::parse(&self.text, Path::new("random.txt"), false)
            .unwrap_or_else(|e| panic!("{e}: {:?}\n{self:?}", e.diagnostics));
        prepare(&read.scene, &self.settings, None).unwrap_or_else(|e| panic!("{e}\n{self:?}"))
    }
}

/// Shapes with the lines of their materials, all `scale` as large and `offset` away from the origin.
#[derive(Clone, Debug)]
pub struct World {
    pub scale: f64,
    pub offset: f64,
    pub shapes: Vec<(String, Shape)>,
}

impl World {
    pub fn lines(&self) -> String {
        let one = |(material, shape): &(String, Shape)| {
            format!("{material}\n{}\n", shape.line(self.scale, self.offset))
        };
        self.shapes.iter().map(one).collect()
    }
}

/// Up to six shapes of these materials, at any scale, mostly that of everyday units; up to 1e8 times as far from
/// the origin as they are large.
pub fn world(material: impl Strategy<Value = String> + 'static) -> impl Strategy<Value = World> {
    let scale = prop_oneof![
        4 => Just(1.0),
        2 => select(vec![1e-5, 1e-3, 1e3, 1e5]),
        1 => decades(-25.0, 25.0),
    ];
    let offset = prop_oneof![4 => Just(0.0), 1 => select(vec![1.0, 1e4, 1e8])];
    (
        scale,
        offset,
        prop::collection::vec((material, shape()), 0..6),
    )
        .prop_map(|(scale, offset, shapes)| World {
            scale,
            offset: scale * offset,
            shapes,
        })
}

/// The position of the eye, in units of the world's scale, and its target.
#[derive(Clone, Debug)]
pub struct Eye {
    pub at: [f64; 3],
    pub ry: f64,
    pub turn: String,
    /// Radius of a lens, and the distance that is sharp.
    pub lens: Option<[f64; 2]>,
}

impl Eye {
    pub fn line(&self, scale: f64, offset: f64) -> String {
        let at = self.at.map(|x| scale * x + offset);
        let camera = format!("camera {}  {}  {}", row(&at), row(&[self.ry]), self.turn);
        match self.lens {
            Some(lens) => format!("{camera}\nlens {}", row(&lens.map(|x| scale * x))),
            None => camera,
        }
    }
}

fn field_of_view() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.2..1.0f64, 1 => select(vec![1e-6, 1e-3, 30.0])]
}

/// `distance` from the origin, which it looks at.
pub fn looking_in(distance: impl Strategy<Value = f64>) -> impl Strategy<Value = Eye> {
    (distance, 0.0..360.0f64, 0.0..180.0f64, field_of_view()).prop_map(|(distance, z, x, ry)| {
        let ((sin_z, cos_z), (sin_x, cos_x)) = (z.to_radians().sin_cos(), x.to_radians().sin_cos());
        Eye {
            at: [sin_x * sin_z, -sin_x * cos_z, cos_x].map(|v| distance * v),
            ry,
            turn: format!("z {z} x {x}"),
            lens: None,
        }
    })
}

/// Anywhere: before the shapes, among them, within them or on their surfaces.
fn eye() -> impl Strategy<Value = Eye> {
    let turns = vec!["", "x 90", "y -90", "x 45 y 10"];
    let among = (
        [coordinate(), coordinate(), coordinate()],
        field_of_view(),
        select(turns),
    )
        .prop_map(|(at, ry, turn)| Eye {
            at,
            ry,
            turn: turn.to_owned(),
            lens: None,
        });
    let pinhole = prop_oneof![2 => looking_in(0.1..8.0f64), 1 => among];
    (pinhole, lens()).prop_map(|(eye, lens)| Eye { lens, ..eye })
}

/// Now and then; narrow, as wide as the scene, wider; focused anywhere.
fn lens() -> impl Strategy<Value = Option<[f64; 2]>> {
    let some = [decades(-6.0, 2.0), decades(-3.0, 6.0)].prop_map(Some);
    prop_oneof![3 => Just(None), 1 => some]
}

/// Any scene, with any settings.
pub fn any_case() -> impl Strategy<Value = Case> {
    let material = prop_oneof![4 => brdf(), 1 => light()];
    let background = prop_oneof![
        Just([0.0; 3]),
        Just([1.0; 3]),
        [radiance(), radiance(), radiance()]
    ];
    let size = (1..=4u32, 1..=4u32);
    (
        size,
        eye(),
        background,
        world(material),
        settings(),
        any::<u32>(),
    )
        .prop_map(|((w, h), eye, background, world, settings, seed)| {
            let camera = eye.line(world.scale, world.offset);
            let background = row(&background);
            Case {
                text: format!(
                    "screen {w} {h}\n{camera}\nbackground {background}\n{}",
                    world.lines()
                ),
                settings,
                seed,
            }
        })
}
