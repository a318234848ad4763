//! Materials, as the lines of a scene file.

use proptest::prelude::*;
use proptest::sample::select;

use super::number::{alpha, colour, grey, ior, radiance, row};

/// The words before a material: they apply to all that follow, so one is always given.
fn words() -> impl Strategy<Value = String> {
    let distributions = vec!["auto", "phong", "beckmann", "ggx"];
    (select(distributions), select(vec!["schlick", "exact"]))
        .prop_map(|(d, f)| format!("distribution {d}\nfresnel {f}\n"))
}

/// Any material that reflects or transmits; Kd and Kt together not rarely.
pub fn brdf() -> impl Strategy<Value = String> {
    let none = || Just([0.0; 3]);
    let kd = prop_oneof![2 => none(), 1 => colour()];
    let kt = prop_oneof![1 => none(), 2 => colour()];
    (words(), kd, colour(), alpha(), kt, ior()).prop_map(|(words, kd, ks, alpha, kt, ior)| {
        let [kd, ks, kt] = [kd, ks, kt].map(|c| row(&c));
        format!(
            "{words}brdf {kd}  {ks}  {}  {kt}  {}",
            row(&[alpha]),
            row(&[ior])
        )
    })
}

/// A material whose only colour is that of its inside, whose micro-normals are GGX's: none of its interfaces adds to a path's
/// light.
pub fn lossy() -> impl Strategy<Value = String> {
    let kt = prop_oneof![1 => Just([0.0; 3]), 1 => Just([1.0; 3]), 2 => colour()];
    (select(vec!["schlick", "exact"]), grey(), alpha(), kt, ior()).prop_map(
        |(fresnel, ks, alpha, kt, ior)| {
            let [ks, kt] = [ks, kt].map(|c| row(&c));
            format!(
                "distribution ggx\nfresnel {fresnel}\nbrdf 0 0 0  {ks}  {}  {kt}  {}",
                row(&[alpha]),
                row(&[ior])
            )
        },
    )
}

/// An emitter.
pub fn light() -> impl Strategy<Value = String> {
    let colour = prop_oneof![
        radiance().prop_map(|x| [x; 3]),
        [radiance(), radiance(), radiance()]
    ];
    colour.prop_map(|c| format!("light {}", row(&c)))
}
