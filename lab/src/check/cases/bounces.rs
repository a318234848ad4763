//! A thousand bounces: between mirrors, and in a box of glass that light can't leave.

use crate::check::case::{Case, Stiffness};

pub fn cases() -> Vec<Case> {
    vec![
        mirrors(990, 1.0),
        mirrors(1020, 1.0),
        mirrors(20, 0.9),
        dark(),
        lit(),
    ]
}

/// Two mirrors 1 apart; the eye between them sees the sky after `n` bounces, each .01 further along.
fn mirrors(n: u32, ks: f64) -> Case {
    let end = 0.01 * f64::from(n);
    let degrees = 0.01f64.atan().to_degrees();
    let mirror = |z: f64| format!("box -1 -1 {z} {} 2 1\n", 1.0 + end);
    // x 180 looks up, y turns towards +x
    let text = format!(
        "screen 8 8\ncamera 0 0 .5 1e-9 y {degrees} x 180\nbackground 1 1 1\nbrdf 0 0 0 {ks} {ks} {ks} 0\n{}{}",
        mirror(-1.0),
        mirror(1.0)
    );
    let stiff = Stiffness::new(
        f64::from(n),
        1.0,
        1.0,
        "flat mirrors reflect a direction without rounding",
    );
    let beyond = n.saturating_sub(1000);
    let case = Case::new(
        format!("bounces/mirrors-{n}"),
        format!("{n} bounces between mirrors of Ks {ks}"),
        text,
        stiff,
    );
    case.spp(64)
        .weight(
            0.95f64.powi(-(beyond as i32)),
            "roulette takes at most .05 from bounce 1000 on",
        )
        .mean(ks.powi(n as i32), "Ks to the power of the bounces")
}

/// An angle of 54.7° on each face: always above the critical one, 41.8°.
fn dark() -> Case {
    let text = "screen 8 8\ncamera .25 .125 0 .05 z 45 x 54.735610317245346\nbackground 1 1 1\nfresnel exact\n\
                brdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\nbox -1 -1 -1 2 2 2\n";
    let stiff = Stiffness::new(
        1020.0,
        1.0,
        1.0,
        "flat faces reflect a direction without rounding",
    );
    Case::new(
        "bounces/trapped",
        "light that cannot leave a box of glass",
        text,
        stiff,
    )
    .spp(4)
    .mean(
        0.0,
        "no path leaves, and roulette ends them after 1000 bounces",
    )
}

/// The sky of radiance 1 counts as n² = 2.25 within, as much as the light there: every path finds the same.
fn lit() -> Case {
    let text = "screen 8 8\ncamera .25 .125 0 2\nbackground 1 1 1\nlight 2.25 2.25 2.25\nbox -.9 -.9 -.9 .5 .5 .5\n\
                fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\nbox -1 -1 -1 2 2 2\n";
    let stiff = Stiffness::new(
        64.0,
        8.0,
        1.0,
        "64 faces, and the edges of a box among them; all weights are 1",
    );
    Case::new(
        "bounces/glass-box",
        "a light in a box of glass that traps most of its light",
        text,
        stiff,
    )
    .mean(2.25, "n² times the sky's radiance, or the light's own")
}
