//! Numbers over their whole legal range, with the edges made likely.

use proptest::prelude::*;
use proptest::sample::select;

/// 2⁻²⁴: half an ulp of 1 in single precision.
const HALF_ULP: f64 = 1.0 / 16_777_216.0;

/// 10ˣ, x from `low` to `high`.
pub fn decades(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..=high).prop_map(|x| 10f64.powf(x))
}

/// A component of Kd, Ks or Kt: any number from 0 on, taken as 1 above it.
fn share() -> impl Strategy<Value = f64> {
    let edges = [
        1e-45,
        1e-38,
        1e-30,
        1e-6,
        1.0 - 1e-6,
        1.0 - HALF_ULP,
        1.5,
        3e38,
    ];
    prop_oneof![
        3 => Just(0.0),
        3 => Just(1.0),
        2 => select(edges.to_vec()),
        3 => 0.0..=1.0f64,
        1 => decades(-40.0, 0.0),
    ]
}

/// Kd, Ks or Kt, grey or coloured.
pub fn colour() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![grey(), [share(), share(), share()]]
}

/// The same in each channel.
pub fn grey() -> impl Strategy<Value = [f64; 3]> {
    share().prop_map(|x| [x; 3])
}

/// alpha: any number from 0 on. A width to 1, across the limit of smooth surfaces; above 1 a Phong exponent, smooth
/// above 2e8 (model.md, "Limits").
pub fn alpha() -> impl Strategy<Value = f64> {
    let edges = [
        1e-300,
        1e-30,
        1e-6,
        1e-4 * (1.0 - 1e-6),
        1e-4,
        1e-4 * (1.0 + 1e-6),
        1.0 - 1e-15,
        1.0 + 1e-15,
        1.001,
        2e8,
        2e8 * (1.0 + 1e-6),
        1e30,
        3e38,
    ];
    prop_oneof![
        2 => Just(0.0),
        2 => Just(1.0),
        3 => select(edges.to_vec()),
        4 => decades(-5.0, 0.0),
        2 => decades(0.0, 9.0),
    ]
}

/// An index of refraction: any number above 0 whose square, and that of its inverse, single precision represents; across the
/// limit below which an interface is index-matched (model.md, "Limits").
pub fn ior() -> impl Strategy<Value = f64> {
    let off = [1e-9, 0.9e-7, 1.1e-7, 2e-6, 1e-4, 0.1];
    let near_one = (select(off.to_vec()), any::<bool>());
    prop_oneof![
        2 => Just(1.0),
        6 => select(vec![1.5, 2.5, 10.0, 1.0 / 1.5]),
        3 => near_one.prop_map(|(off, below)| if below { 1.0 - off } else { 1.0 + off }),
        2 => decades(-1.0, 1.0),
        2 => decades(-19.2, 19.2),
    ]
}

/// A radiance: any number from 0 to 1e19. A sample of 2⁹⁶ is dropped and counted; that leaves 2³² to a path's weight, each
/// vertex up to 256 by choice of lobes by norms.
pub fn radiance() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(1.0), 0.0..10.0f64, decades(-45.0, 19.0)]
}

/// A coordinate: often one that others have too, so that surfaces touch and coincide.
pub fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (-2..=2i32).prop_map(|k| 0.5 * f64::from(k)),
        4 => -2.0..2.0f64,
        1 => select(vec![1e-7, -1e-4, 1.0 + 1e-7, 20.0]),
    ]
}

/// A length.
pub fn length() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (1..=3i32).prop_map(|k| 0.5 * f64::from(k)),
        3 => 0.01..3.0f64,
        1 => select(vec![1e-6, 1e-4, 1e-3, 30.0]),
        1 => decades(-5.0, 2.0),
    ]
}

/// A number with an exponent where that is shorter: either way, all of its digits.
pub fn written(v: f64) -> String {
    let [plain, scientific] = [format!("{v}"), format!("{v:e}")];
    if plain.len() <= scientific.len() {
        plain
    } else {
        scientific
    }
}

/// Numbers as a line has them.
pub fn row(numbers: &[f64]) -> String {
    numbers
        .iter()
        .map(|v| written(*v))
        .collect::<Vec<_>>()
        .join(" ")
}
