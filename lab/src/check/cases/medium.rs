//! Beer's law at its limits: transmittance from 0 to 1, paths from 1e-6 to 1e6, along the normal of a slab; and materials
//! that contradict themselves.

use crate::check::case::{Case, Expectation, Stiffness};
use crate::check::closed::slab::{attenuation, slab};
use vkpt::settings::{Roulette, Settings};

const TRANSMITTANCES: [f64; 4] = [1e-6, 0.5, 1.0 - 1e-6, 1.0];
const LENGTHS: [f64; 5] = [1e-6, 1e-3, 1.0, 1e3, 1e6];

pub fn cases() -> Vec<Case> {
    let pairs = || {
        TRANSMITTANCES
            .into_iter()
            .flat_map(|kt| LENGTHS.map(|t| (kt, t)))
    };
    let matched = pairs().map(|(kt, t)| {
        let case = seen(&format!("matched-{kt}/{t:e}"), [kt; 3], 1.0, t);
        case.mean(attenuation(kt, t), "Kt^t: there is no surface")
    });
    let glass = pairs().map(|(kt, t)| {
        let case = seen(&format!("glass-{kt}/{t:e}"), [kt; 3], 1.5, t);
        // A path of throughput 0.999 would end by roulette once in a thousand times and contribute nothing: that may
        // happen to none of 4096 samples, and the spread of the others does not show it.
        let mut settings = Settings::default();
        settings.estimator.roulette = Roulette::Off;
        case.spp(64)
            .settings(settings)
            .mean(slab(1.5, kt, t), "F + (1 − F)²A/(1 − FA)")
    });
    let black = LENGTHS.into_iter().map(|t| {
        let case = seen(&format!("one-channel-black/{t:e}"), [0.0, 1.0, 1.0], 1.0, t);
        case.mean(
            2.0 / 3.0,
            "one of three channels transmits nothing, the others everything",
        )
    });
    matched
        .chain(glass)
        .chain(black)
        .chain(contradictions())
        .collect()
}

/// A slab from z = −t to 0 under a sky of radiance 1 on both sides, seen from 1 above.
fn seen(name: &str, kt: [f64; 3], ior: f64, t: f64) -> Case {
    let about = format!("Kt {} over a length of {t:e}, ior {ior}", kt[0]);
    Case::new(
        format!("medium/{name}"),
        about,
        text("exact", [0.04; 3], kt, ior, t),
        stiffness(kt, t),
    )
}

fn text(fresnel: &str, ks: [f64; 3], kt: [f64; 3], ior: f64, t: f64) -> String {
    let colour = |c: [f64; 3]| format!("{} {} {}", c[0], c[1], c[2]);
    format!(
        "screen 8 8\ncamera 0 0 1 1e-9\nbackground 1 1 1\nfresnel {fresnel}\nbrdf 0 0 0 {} 0 {} {ior}\nbox -2 -2 -{t} 4 4 {t}\n",
        colour(ks),
        colour(kt)
    )
}

/// A relative error of the length t is one of σt in exp(−σt), and t is the difference of places up to 1 + t from the
/// origin. Where σt is above 44, all is dark: exp(−44) is below 2⁻⁶³.
fn stiffness(kt: [f64; 3], t: f64) -> Stiffness {
    let exponents = kt
        .iter()
        .filter(|k| **k > 0.0)
        .map(|k| (-k.ln() * t).min(44.0));
    let exponent = exponents.fold(0.0, f64::max);
    Stiffness::new(
        3.0,
        1.0,
        1.0 + exponent * (1.0 + (1.0 + t) / t),
        "σt, and its length t between places that are 1 + t large",
    )
}

fn contradictions() -> Vec<Case> {
    let with = |name: &str, about: &str, text: String| {
        Case::new(
            format!("medium/{name}"),
            about,
            text,
            stiffness([0.5; 3], 1.0),
        )
        .spp(64)
    };
    let kd = "screen 8 8\ncamera 0 0 4 .3\nbackground 1 1 1\nbrdf .5 .5 .5 .04 .04 .04 .3 .9 .9 .9 1.5\nsphere 0 0 0 1\n";
    let curved = Stiffness::new(4.0, 64.0, 64.0, "4 per hit of a curved body, 3 hits");
    vec![
        with(
            "ks-0",
            "Ks 0 where the ior says .04, by Schlick",
            text("schlick", [0.0; 3], [0.5; 3], 1.5, 1.0),
        )
        .mean(
            0.5,
            "Schlick's F is Ks = 0 along the normal: everything is transmitted, Kt^t",
        ),
        with(
            "ks-1",
            "Ks 1 where the ior says .04, by Schlick",
            text("schlick", [1.0; 3], [0.5; 3], 1.5, 1.0),
        )
        .mean(1.0, "Schlick's F is Ks = 1: nothing enters"),
        Case::new("medium/kd-and-kt", "glass that is diffuse too", kd, curved)
            .spp(64)
            .expect(Expectation::Warning("Kd".into())),
    ]
}
