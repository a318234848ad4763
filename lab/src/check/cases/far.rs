//! Bodies that stay 1e4 from the origin of rendering space, because there is as much on the other side: the spacing of f32
//! there is 1e-3 of their size.

use glam::{DQuat, DVec3};

use crate::check::case::{Case, Stiffness};
use vkpt::scene::Mesh;

const AWAY: f64 = 1e4;

const CHALK: &str = "brdf .5 .5 .5 0 0 0 1";
const GLASS: &str = "fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5";

pub fn cases() -> Vec<Case> {
    let shapes = ["sphere", "box", "cylinder", "mesh"];
    let of = |shape: &'static str| [("matte", CHALK), ("smooth", GLASS)].map(|m| case(shape, m));
    shapes.into_iter().flat_map(of).collect()
}

fn case(shape: &str, (word, material): (&str, &str)) -> Case {
    let body = match shape {
        "sphere" => format!("sphere {AWAY} 0 0 1\n"),
        "box" => format!("box {} -1 -1 2 2 2\n", AWAY - 1.0),
        "cylinder" => format!("cylinder {AWAY} 0 -1 0 0 2 1\n"),
        _ => String::new(),
    };
    // The body on the other side is black, and hit by no ray from here.
    let other = format!("brdf 0 0 0 0 0 0 1\nsphere {} 0 0 1\n", -AWAY);
    let text =
        format!("screen 16 16\ncamera {AWAY} 0 4 .15\nbackground 1 1 1\n{other}{material}\n{body}");
    // All pixels see the body, because .15·√2 is less than tan arcsin ¼. A convex one of Kd reflects Kd of the sky, and smooth
    // glass is invisible.
    let (value, by) = match word {
        "matte" => (0.5, "Kd: a convex body sees none of itself"),
        _ => (1.0, "smooth glass that absorbs nothing is invisible"),
    };
    let (most, reason) = match word {
        "matte" => (0.75, "Kd by the lobe, half of it by the connection"),
        _ => (1.0, "smooth glass only deflects light"),
    };
    let why = "places 1e4 times as large as the body; all weights are Kd, or 1";
    let case = Case::new(
        format!("far/{word}-{shape}"),
        format!("a {word} {shape}, 1e4 from the middle of the scene"),
        text,
        Stiffness::new(4.0, 64.0 * AWAY, 1.0, why),
    )
    .weight(most, reason)
    .mean(value, by);
    if shape == "mesh" {
        case.mesh(cube())
    } else {
        case
    }
}

fn cube() -> Mesh {
    let corner = |i: u32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2));
    Mesh {
        path: "cube".into(),
        files: Vec::new(),
        positions: (0..8).map(|i| 2.0 * corner(i) - 1.0).collect(),
        normals: None,
        triangles: super::furnace::CUBE.to_vec(),
        translate: DVec3::new(AWAY, 0.0, 0.0),
        scale: 1.0,
        rotate: DQuat::IDENTITY,
    }
}
