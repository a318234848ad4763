//! The width of the micro-normals, from perfectly smooth to rough, on metal in a furnace: a plate seen along its normal
//! reflects the value of one integral (`closed::interface`).

use crate::check::case::{Case, Stiffness};
use crate::check::closed::interface::mirror;
use vkpt::report::names::Named;
use vkpt::settings::Distribution;

/// Across the limit of smoothness, 1e-4, with both of its neighbours.
const WIDTHS: [&str; 13] = [
    "0", "1e-6", "1e-5", "9.9e-5", "1e-4", "1.1e-4", "1e-3", "1e-2", ".05", ".1", ".3", ".6", "1",
];
/// Across the limit of smoothness, 2e8.
const EXPONENTS: [&str; 9] = [
    "1.001", "2", "10", "100", "1e4", "1e6", "1e8", "1.99e8", "2.01e8",
];

pub fn cases() -> Vec<Case> {
    let widths = Distribution::EVERY
        .into_iter()
        .flat_map(|d| WIDTHS.map(|alpha| (d, alpha)));
    let exponents = Distribution::EVERY
        .into_iter()
        .flat_map(|d| EXPONENTS.map(|alpha| (d, alpha)));
    widths
        .chain(exponents)
        .map(|(distribution, alpha)| case(distribution, alpha))
        .collect()
}

fn case(distribution: Distribution, alpha: &str) -> Case {
    let word = distribution.name();
    let number: f64 = alpha.parse().unwrap_or(0.0);
    // the hand-out's relation of exponents and widths
    let width = if number > 1.0 {
        (2.0 / (number + 2.0)).sqrt()
    } else {
        number
    };
    let text = format!(
        "screen 16 16\ncamera 0 0 1 1e-6\nbackground 1 1 1\ndistribution {word}\nbrdf 0 0 0 1 1 1 {alpha}\nbox -2 -2 -1 4 4 1\n"
    );
    // One vertex of metal and the sky. A width divides the sine of a micro-normal and is multiplied back: no form of D, G1
    // or of the sampling has a cancellation left in it, at any width.
    let stiff = Stiffness::new(
        2.0,
        1.0,
        1.0,
        "one reflection; sampled angles carry no cancellation",
    );
    let about = match width {
        0.0 => "a mirror seen along the normal".to_owned(),
        _ => format!("lobe of width {width:.1e} seen along the normal"),
    };
    // MIS: a sample of the lobe contributes at most its weight, a connection at most half of it, because
    // w f/p ≤ f/(2 p_lobe) by the power heuristic.
    let (most, by) = match distribution {
        Distribution::Ggx => (1.5, "1 by the lobe, ½ by the connection"),
        Distribution::Beckmann => (1.5001, "1.000062 by the lobe, half of it by the connection"),
        Distribution::Phong => (
            1.5 * 1.0329,
            r#"1.0328 · 1.000062 by the lobe (model.md, "Visible micro-normals"), half of it by the connection"#,
        ),
    };
    let albedo = if width == 0.0 {
        1.0
    } else {
        mirror(distribution, width)
    };
    Case::new(format!("alpha/{word}/{alpha}"), about, text, stiff)
        .spp(32)
        .weight(most, by)
        .mean(albedo, "quadrature of D(m)(m·N)G1(wi)")
}
