//! Slopes of visible normals: how near the inversion comes to the requested share.

use vkpt::reference::bsdf::normals::visible::beckmann::beckmann_view;
use vkpt::reference::bsdf::normals::visible::phong::phong_law;
use vkpt::reference::bsdf::normals::visible::slope::{
    SlopeLaw, slope_sample, slope_share, slope_start, slope_step,
};
use vkpt::reference::math::{Real, Vec3};

use super::support::surface::direction;

/// The laws of Beckmann and of Phong's exponents, from grazing to normal incidence.
fn laws<F: Real>() -> Vec<SlopeLaw<F>> {
    let exponents = [0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0, 1e4, 2e8];
    let cosines = (1..200).map(|i| f64::from(i) / 200.0);
    let ends = [0.0, 1e-6, 1e-3, 0.999_99, 0.999_999_9, 1.0];
    let seen = cosines.chain(ends).flat_map(|z| {
        let wo: Vec3<F> = Vec3::new(direction(z, 0.0).f64());
        // the sine of a rounded direction
        let sine = wo.x;
        let width = [1e-4, 1e-2, 0.1, 0.3, 1.0].map(|a| beckmann_view(wo, sine, F::new(a)).law);
        let exponent = exponents.map(|n| phong_law(wo, sine, F::new(n)));
        width.into_iter().chain(exponent)
    });
    seen.collect()
}

/// Uniform numbers, denser at both ends.
fn uniforms() -> Vec<f64> {
    let ends = (1..=24).flat_map(|k| [0.5f64.powi(k), 1.0 - 0.5f64.powi(k)]);
    let between = (1..100).map(|i| f64::from(i) / 100.0);
    ends.chain(between).collect()
}

/// G(t)/G(−limit) in f64.
fn share<F: Real>(law: SlopeLaw<F>, t: F) -> f64 {
    let law = SlopeLaw {
        p: law.p.f64(),
        r: law.r.f64(),
        gamma: law.gamma.f64(),
        limit: law.limit.f64(),
    };
    slope_share(law, t.f64()).share / slope_share(law, -law.limit).share
}

/// The largest error of the share, over all laws and numbers, of slopes that `sample` finds.
fn worst<F: Real>(sample: impl Fn(SlopeLaw<F>, F) -> F) -> f64 {
    let uniforms = uniforms();
    let pairs = laws()
        .into_iter()
        .flat_map(|l| uniforms.iter().map(move |u| (l, *u)));
    let error = |(law, u): (SlopeLaw<F>, f64)| {
        let u = F::new(u);
        let off = (share(law, sample(law, u)) - u.f64()).abs();
        // a broken slope is no small error
        if off.is_nan() { f64::INFINITY } else { off }
    };
    pairs.map(error).fold(0.0, f64::max)
}

#[test]
fn slopes_have_the_share_that_is_asked_for() {
    let single = worst::<f32>(slope_sample);
    assert!(single < 3e-7, "{single:e}");
    let double = worst::<f64>(slope_sample);
    assert!(double < 4e-9, "{double:e}");
    // a step less is not enough
    let two_steps = worst::<f64>(|law, u| {
        let whole = slope_share(law, -law.limit);
        let goal = u * whole.share;
        let t = slope_step(law, goal, slope_start(law, whole, u));
        slope_step(law, goal, t)
    });
    assert!(two_steps > 1e-7, "{two_steps:e}");
}

/// 0, which represents a cell of 2⁻²⁴, is drawn as its neighbour.
#[test]
fn the_ends_of_the_uniform_numbers_have_slopes() {
    let last = 1.0 - 1.0 / 16_777_216.0;
    for law in laws::<f32>() {
        assert_eq!(
            slope_sample(law, 0.0),
            slope_sample(law, 1.0 / 16_777_216.0)
        );
        let (steep, flat) = (slope_sample(law, 0.0), slope_sample(law, last));
        assert!(steep < 5.0 && steep > 3.0, "{law:?}: {steep}");
        assert!(flat >= -law.limit && flat < steep, "{law:?}: {flat}");
    }
}
