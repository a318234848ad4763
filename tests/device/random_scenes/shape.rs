//! Shapes of every kind, in units of a scene's scale.

use proptest::prelude::*;
use proptest::sample::select;

use super::number::{coordinate, length, row};

const MESHES: [&str; 3] = [
    "tests/data/scene/tetrahedron.ply",
    "tests/data/scene/trimesh/gem.obj",
    "tests/data/scene/trimesh/family.ply",
];

/// The contents of a shape's line.
#[derive(Clone, Debug)]
pub enum Shape {
    Sphere {
        centre: [f64; 3],
        radius: f64,
    },
    Box {
        corner: [f64; 3],
        diagonal: [f64; 3],
    },
    Cylinder {
        base: [f64; 3],
        axis: [f64; 3],
        radius: f64,
    },
    Mesh {
        file: &'static str,
        at: [f64; 3],
        scale: f64,
        turn: String,
    },
}

impl Shape {
    /// Its line, everything `scale` times as large, then moved by `offset` along each axis.
    pub fn line(&self, scale: f64, offset: f64) -> String {
        let point = |p: &[f64; 3]| row(&p.map(|x| scale * x + offset));
        let vector = |v: &[f64; 3]| row(&v.map(|x| scale * x));
        let length = |l: f64| row(&[scale * l]);
        match self {
            Self::Sphere { centre, radius } => {
                format!("sphere {}  {}", point(centre), length(*radius))
            }
            Self::Box { corner, diagonal } => {
                format!("box {}  {}", point(corner), vector(diagonal))
            }
            Self::Cylinder { base, axis, radius } => {
                format!(
                    "cylinder {}  {}  {}",
                    point(base),
                    vector(axis),
                    length(*radius)
                )
            }
            Self::Mesh {
                file,
                at,
                scale,
                turn,
            } => {
                format!("mesh {file} {}  {}  {turn}", point(at), length(*scale))
            }
        }
    }
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [coordinate(), coordinate(), coordinate()]
}

/// The axis of a cylinder, along an axis of the world or not.
fn axis() -> impl Strategy<Value = [f64; 3]> {
    let along = vec![
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.3, -0.5, 0.8],
        [1e-9, 0.0, 1.0],
    ];
    (select(along), length()).prop_map(|(along, length)| along.map(|x| x * length))
}

pub fn shape() -> impl Strategy<Value = Shape> {
    let sphere = (point(), length()).prop_map(|(centre, radius)| Shape::Sphere { centre, radius });
    let cuboid = (point(), [length(), length(), length()], [any::<bool>(); 3]).prop_map(
        |(corner, size, back)| Shape::Box {
            corner,
            diagonal: [0, 1, 2].map(|k| if back[k] { -size[k] } else { size[k] }),
        },
    );
    let cylinder = (point(), axis(), length()).prop_map(|(base, axis, radius)| Shape::Cylinder {
        base,
        axis,
        radius,
    });
    let turns = vec!["", "x 90", "z 33 x -20"]
        .into_iter()
        .map(str::to_owned)
        .collect::<Vec<_>>();
    let mesh = (select(MESHES.to_vec()), point(), length(), select(turns)).prop_map(
        |(file, at, scale, turn)| Shape::Mesh {
            file,
            at,
            scale,
            turn,
        },
    );
    prop_oneof![3 => sphere, 3 => cuboid, 2 => cylinder, 2 => mesh]
}
