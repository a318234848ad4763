//! A smooth interface seen at grazing angles and at the critical one, from both sides: R + T is 1 at each.

use crate::check::case::{Case, Stiffness};
use vkpt::settings::Settings;

const IOR: f64 = 1.5;

const COSINES: [(&str, f64); 6] = [
    ("1e-7", 1e-7),
    ("1e-5", 1e-5),
    ("1e-3", 1e-3),
    (".1", 0.1),
    (".5", 0.5),
    (".9", 0.9),
];

/// An ulp of f32 in [½, 1).
const ULP: f64 = 1.0 / 16_777_216.0;

pub fn cases() -> Vec<Case> {
    let sides = |(name, cos)| [("out", true), ("in", false)].map(|side| seen(name, cos, side));
    let critical = (1.0 - 1.0 / (IOR * IOR)).sqrt();
    let next = [
        ("critical-ulp", critical - ULP),
        ("critical", critical),
        ("critical+ulp", critical + ULP),
    ];
    let within = next.map(|(name, cos)| at_critical(name, cos));
    COSINES.into_iter().flat_map(sides).chain(within).collect()
}

/// Directions within 1e-3 of one of this cosine.
fn seen(name: &str, cos: f64, (side, outside): (&str, bool)) -> Case {
    let why = "an ulp of a direction changes a fraction of those within 1e-3; all weights are 1";
    case(
        format!("angle/{name}/{side}"),
        cos,
        outside,
        1e-3,
        Stiffness::new(3.0, 1e3, 1.0, why),
    )
}

/// One direction, where 1 − F goes as √r (Fresnel's equations for small cosines of refraction): an error δ of r is √δ in F.
fn at_critical(name: &str, cos: f64) -> Case {
    let why = "F goes as the root of the distance to the critical angle: √2²⁴; all weights are 1";
    case(
        format!("angle/{name}/in"),
        cos,
        false,
        1e-9,
        Stiffness::new(3.0, 4096.0, 1.0, why),
    )
}

fn case(name: String, cos: f64, outside: bool, aperture: f64, stiff: Stiffness) -> Case {
    let (degrees, sin) = (cos.acos().to_degrees(), (1.0 - cos * cos).sqrt());
    let camera = if outside {
        format!("0 {} {cos} {aperture} x {degrees}", -sin)
    } else {
        // 50 from the interface, or as deep as the light inside allows.
        let distance = (0.01 / cos).min(50.0);
        let (y, z) = (-distance * sin, -distance * cos);
        format!("0 {y} {z} {aperture} x {}", 180.0 - degrees)
    };
    // A black body is a light inside the glass, below the eye.
    let text = format!(
        "screen 16 16\ncamera {camera}\nbackground 1 1 1\nlight 1 1 1\nbox -90 -90 -1 180 180 .98\nfresnel exact\n\
         brdf 0 0 0 .04 .04 .04 0 1 1 1 {IOR}\nbox -100 -100 -2 200 200 2\n"
    );
    let mut settings = Settings::default();
    // Radiance 1 in the glass would count as 1/n² outside.
    settings.model.radiance_scaling = false;
    let side = if outside { "out" } else { "in" };
    let about = format!("smooth glass at cos θ = {cos:.7}, seen from {side}side");
    Case::new(name, about, text, stiff)
        .settings(settings)
        .weight(1.0, "smooth glass only deflects light")
        .mean(1.0, "R + T = 1")
}
