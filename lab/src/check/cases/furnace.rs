//! Solids of glass in a world of radiance 1, at scales from 1e-30 to 1e30 and far from the origin: no length is special.

use glam::{DQuat, DVec3};

use crate::check::case::{Case, Expectation, Stiffness};
use vkpt::scene::Mesh;

const SCALES: [&str; 10] = [
    "1e-30", "1e-5", "1e-4", "1e-2", "1", "1e2", "1e5", "1e30", "2^-17", "2^17",
];
const SHAPES: [&str; 4] = ["sphere", "box", "cylinder", "mesh"];

/// The faces of a cube whose corner i has the coordinates of i's bits, x first.
pub const CUBE: [[u32; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

pub fn cases() -> Vec<Case> {
    let solids = SHAPES
        .into_iter()
        .flat_map(|shape| [false, true].map(|rough| (shape, rough)));
    let scaled = solids.flat_map(|(shape, rough)| {
        SCALES.map(|scale| {
            Furnace {
                shape,
                rough,
                scale,
                shift: 0.0,
            }
            .case()
        })
    });
    let far = SHAPES.into_iter().flat_map(|shape| {
        [false, true].map(|rough| {
            Furnace {
                shape,
                rough,
                scale: "1",
                shift: 1e4,
            }
            .case()
        })
    });
    scaled.chain(far).collect()
}

struct Furnace {
    shape: &'static str,
    rough: bool,
    scale: &'static str,
    /// Along all three axes.
    shift: f64,
}

impl Furnace {
    fn case(&self) -> Case {
        let word = if self.rough { "rough" } else { "smooth" };
        let place = if self.shift == 0.0 { self.scale } else { "far" };
        let about = match self.shift == 0.0 {
            true => format!("{word} {}, {} across", self.shape, self.scale),
            false => format!("{word} {}, {} from the origin", self.shape, self.shift),
        };
        let case = Case::new(
            format!("furnace/{word}-{}/{place}", self.shape),
            about,
            self.text(),
            self.stiffness(),
        );
        let case = self.same(if self.rough {
            case.spp(32)
        } else {
            self.smooth(case)
        });
        if self.shape == "mesh" {
            case.mesh(self.cube())
        } else {
            case
        }
    }

    fn smooth(&self, case: Case) -> Case {
        case.weight(1.0, "smooth glass only deflects light")
            .mean(1.0, "smooth glass that absorbs nothing is invisible")
    }

    fn same(&self, case: Case) -> Case {
        let word = if self.rough { "rough" } else { "smooth" };
        let unit = format!("furnace/{word}-{}/1", self.shape);
        if self.scale.starts_with("2^") {
            case.expect(Expectation::SameBits {
                case: unit,
                why: "a power of two scales every number and rounds none".into(),
            })
        } else if self.shift != 0.0 {
            let why = "every length in the file is a dyadic number, and the scene is moved to the origin in f64";
            case.expect(Expectation::SameBits {
                case: unit,
                why: why.into(),
            })
        } else if self.rough && self.scale != "1" {
            case.expect(Expectation::SameMean {
                case: unit,
                why: "no length is special".into(),
            })
        } else {
            case
        }
    }

    /// Errors of position grow by up to 4 from one hit of a curved body to the next, and one in a hundred of the
    /// contributing paths has more than three hits inside.
    fn stiffness(&self) -> Stiffness {
        let curved = matches!(self.shape, "sphere" | "cylinder");
        let decisions = if curved { 64.0 } else { 8.0 };
        let why = if curved {
            "4 per hit of a curved body, 3 hits"
        } else {
            "2 per hit between flat faces at an angle, 3 hits"
        };
        // The weights of smooth glass are 1 wherever it is hit.
        Stiffness::new(
            4.0,
            decisions,
            if self.rough { decisions } else { 1.0 },
            why,
        )
    }

    fn scale(&self) -> f64 {
        match self.scale.strip_prefix("2^") {
            Some(power) => power.parse().map_or(1.0, f64::exp2),
            None => self.scale.parse().unwrap_or(1.0),
        }
    }

    /// The eye looks along (−1, 2, −2)/3 from 3 away; all numbers of the unit scene are dyadic.
    fn text(&self) -> String {
        let s = self.scale();
        let at = |x: f64| s * x + self.shift;
        let shape = match self.shape {
            "sphere" => format!("sphere {} {} {} {s}", at(0.0), at(0.0), at(0.0)),
            "box" => format!("box {0} {0} {0} {s} {s} {s}", at(-0.5)),
            "cylinder" => format!(
                "cylinder {} {} {} 0 {s} {} {}",
                at(0.0),
                at(-0.5),
                at(-0.25),
                s / 2.0,
                s / 2.0
            ),
            _ => String::new(),
        };
        let alpha = if self.rough { 0.3 } else { 0.0 };
        format!(
            "screen 16 16\ncamera {} {} {} .25 z 26.565051177077994 x 48.189685104221404\nbackground 1 1 1\nfresnel exact\n\
             brdf 0 0 0 .04 .04 .04 {alpha} 1 1 1 1.5\n{shape}\n",
            at(1.0),
            at(-2.0),
            at(2.0)
        )
    }

    /// The closed cube of side 1, turned and scaled and moved as a mesh is.
    fn cube(&self) -> Mesh {
        let corner =
            |i: u32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)) - 0.5;
        Mesh {
            path: "cube".into(),
            files: Vec::new(),
            positions: (0..8).map(corner).collect(),
            normals: None,
            triangles: CUBE.to_vec(),
            translate: DVec3::splat(self.shift),
            scale: self.scale(),
            rotate: DQuat::from_rotation_x(0.5),
        }
    }
}
