//! Contact: thin slabs, balls at a point, faces on one another, glass exactly on a table.

use crate::check::case::{Case, Stiffness};
use vkpt::settings::Settings;

pub const GLASS: &str = "fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\n";

pub fn cases() -> Vec<Case> {
    let slanted = "0 -4 4 .2 x 45";
    let above = "0 0 4 .1";
    vec![
        furnace(
            "slab-1e-4",
            "a slab of glass 1e-4 thick, seen at 45°",
            slanted,
            "box -9 -9 -.00005 18 18 .0001\n",
        ),
        furnace(
            "slab-1e-6",
            "a slab of glass 1e-6 thick, seen at 45°",
            slanted,
            "box -9 -9 -.0000005 18 18 .000001\n",
        ),
        furnace(
            "balls",
            "two balls of glass that touch",
            above,
            "sphere -1 0 0 1\nsphere 1 0 0 1\n",
        ),
        boxes(),
        coplanar(),
        table(),
    ]
}

fn furnace(name: &str, about: &str, camera: &str, shapes: &str) -> Case {
    let text = format!("screen 16 16\ncamera {camera}\nbackground 1 1 1\n{GLASS}{shapes}");
    let stiff = Stiffness::new(
        6.0,
        64.0,
        1.0,
        "4 per hit of a curved body, 3 hits; all weights are 1",
    );
    Case::new(format!("contact/{name}"), about, text, stiff)
        .weight(1.0, "smooth glass only deflects light")
        .mean(1.0, "smooth glass that absorbs nothing is invisible")
}

/// Out of one, through air of no thickness, into the other.
fn boxes() -> Case {
    let text = format!(
        "screen 16 16\ncamera 4 .25 .125 .1 y 90\nbackground 1 1 1\n{GLASS}box -1 -1 -1 1 2 2\nbox 0 -1 -1 1 2 2\n"
    );
    let stiff = Stiffness::new(6.0, 8.0, 1.0, "flat faces; all weights are 1 and n²");
    Case::new(
        "contact/boxes",
        "two boxes of glass that share a face, seen through it",
        text,
        stiff,
    )
    .mean(1.0, "smooth glass that absorbs nothing is invisible")
}

/// For faces at the same distance, the first in the file is hit.
fn coplanar() -> Case {
    let text = "screen 16 16\ncamera 0 -4 4 .2 x 45\nlight 1 1 1\nbox -9 -9 -1 18 18 1\nlight 3 3 3\nbox -9 -9 -2 18 18 2\n";
    let stiff = Stiffness::new(1.0, 1.0, 1.0, "one hit of equal numbers");
    Case::new(
        "contact/coplanar",
        "two lights whose faces coincide",
        text,
        stiff,
    )
    .mean(1.0, "the first in the file")
}

/// At equal distance the opaque table is hit, not the glass's own face: no path finds air between them.
fn table() -> Case {
    let text = format!(
        "screen 16 16\ncamera 0 -4 4 .2 x 45\nbackground 1 1 1\nlight 1 1 1\nbox -9 -9 -1 18 18 1\n{GLASS}box -1 -1 0 2 2 1\n"
    );
    let mut settings = Settings::default();
    settings.model.radiance_scaling = false;
    let stiff = Stiffness::new(6.0, 8.0, 1.0, "flat faces at an angle; all weights are 1");
    Case::new(
        "contact/table",
        "a block of glass exactly on a table of light",
        text,
        stiff,
    )
    .settings(settings)
    .weight(1.0, "smooth glass only deflects light")
    .mean(1.0, "all light has radiance 1, and nothing is lost")
}
