//! One interface of glass seen along its normal, from both sides: index of refraction and width, each alone and in difficult
//! pairs. Light comes from everywhere, so that the picture is R + T.

use crate::check::case::{Case, Stiffness};
use crate::check::closed::interface::dielectric;
use vkpt::report::names::Named;
use vkpt::settings::{Distribution, Settings};

const IORS: [f64; 10] = [
    1.0,
    1.0 + 2e-6,
    1.0001,
    1.1,
    1.5,
    2.5,
    10.0,
    1.0 / 1.5,
    0.4,
    0.1,
];
const WIDTHS: [f64; 5] = [0.0, 1.1e-4, 1e-2, 0.3, 1.0];

pub fn cases() -> Vec<Case> {
    let sides = |ior| [true, false].map(|outside| (ior, outside));
    let all = Distribution::EVERY.into_iter().flat_map(move |d| {
        WIDTHS.into_iter().flat_map(move |w| {
            IORS.into_iter()
                .flat_map(sides)
                .map(move |(ior, outside)| (d, w, ior, outside))
        })
    });
    // Smooth surfaces have no distribution.
    all.filter(|(d, w, ..)| *w > 0.0 || *d == Distribution::Ggx)
        .map(|(d, w, ior, outside)| case(d, w, ior, outside))
        .collect()
}

fn case(distribution: Distribution, width: f64, ior: f64, outside: bool) -> Case {
    // A black body inside the glass is a light; for the view from inside, the camera is between it and the interface.
    let camera = if outside {
        "0 0 1 1e-6"
    } else {
        "0 0 -.01 1e-6 x 180"
    };
    let word = distribution.name();
    let text = format!(
        "screen 8 8\ncamera {camera}\nbackground 1 1 1\nlight 1 1 1\nbox -90 -90 -1 180 180 .98\nfresnel exact\n\
         distribution {word}\nbrdf 0 0 0 .04 .04 .04 {width} 1 1 1 {ior}\nbox -100 -100 -2 200 200 2\n"
    );
    let mut settings = Settings::default();
    // Radiance 1 in the glass would count as 1/n² outside.
    settings.model.radiance_scaling = false;
    let [from, to] = if outside { [1.0, ior] } else { [ior, 1.0] };
    let stiff = Stiffness::new(3.0, 1.0, condition(width, from, to), WHY);
    let smooth = width == 0.0 || ior == 1.0;
    let expected = if smooth {
        1.0
    } else {
        dielectric(distribution, width, from, to)
    };
    let side = if outside { "out" } else { "in" };
    let name = format!("interface/{word}-{width}/{}/{side}", short(ior));
    let about = format!("R + T of width {width} and ior {ior}, seen from {side}side");
    Case::new(name, about, text, stiff)
        .settings(settings)
        .spp(64)
        .mean(expected, "quadrature of F G1(wi) and (1 − F) G1(wt)")
}

/// `1.5`, `0.666667`, `1.000002`.
fn short(ior: f64) -> String {
    let digits = format!("{ior:.6}");
    digits
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

const WHY: &str = "that of a connection's contribution: see `condition`";

/// The condition of a connection's contribution, the larger of two.
///
/// Where light goes nearly straight on, the half vector eta·wo + wi is |n − 1| long: an ulp of wo or wi turns it by
/// 1/|n − 1|.
///
/// Into the rarer side, eta > 1, the radicand r = 1 − eta² + eta²c² is a difference of terms eta² large, and √r, which is
/// in the refracted direction and in 1 − F, is off by ½ eta²/r. r lies anywhere in [0, 1], so that a path in a hundred
/// has r < 1/100: 50 eta². Along the normal of a smooth interface r is 1.
fn condition(width: f64, from: f64, to: f64) -> f64 {
    let eta = from / to;
    let critical = match (eta > 1.0, width > 0.0) {
        (false, _) => 1.0,
        (true, false) => eta * eta,
        (true, true) => 50.0 * eta * eta,
    };
    let contrast = (1.0 - eta).abs().min((1.0 - 1.0 / eta).abs());
    // delta, or refraction that keeps one direction (model.md, "Limits"): no half vector
    let straight = if width * contrast < 1e-5 {
        1.0
    } else {
        1.0 / contrast.min(1.0)
    };
    straight.max(critical)
}
