//! Settings: every word there is, freely combined.

use proptest::prelude::*;
use proptest::sample::select;
use vkpt::settings::{
    Absorption, Connect, Distribution, DistributionRule, Estimator, Fresnel, Integrator, Lights,
    LobeChoice, Model, Normals, Roulette, Sampler, Settings,
};

fn model() -> impl Strategy<Value = Model> {
    let rules = Distribution::EVERY.map(DistributionRule::Always);
    (
        prop_oneof![4 => Just(None), 1 => select(Fresnel::EVERY.map(Some).to_vec())],
        prop_oneof![
            4 => Just(DistributionRule::Scene),
            1 => Just(DistributionRule::Auto),
            1 => select(rules.to_vec()),
        ],
        select(vec![Absorption::Segment, Absorption::Term]),
        any::<bool>(),
        prop_oneof![3 => Just(None), 1 => (0..6u32).prop_map(Some)],
    )
        .prop_map(
            |(fresnel, distribution, absorption, radiance_scaling, max_depth)| Model {
                fresnel,
                distribution,
                absorption,
                radiance_scaling,
                max_depth,
            },
        )
}

fn estimator() -> impl Strategy<Value = Estimator> {
    let constant = prop_oneof![Just(1.0), Just(0.8), 1e-3..1.0f64];
    (
        select(vec![LobeChoice::Fresnel, LobeChoice::Norms]),
        select(vec![Normals::Visible, Normals::Distribution]),
        prop_oneof![
            2 => Just(Roulette::Throughput),
            1 => constant.prop_map(Roulette::Constant),
            1 => Just(Roulette::Off),
        ],
        select(vec![Connect::Mis, Connect::Light, Connect::Bsdf]),
        select(vec![Lights::Contribution, Lights::Power]),
        select(vec![Sampler::Sobol, Sampler::Random]),
    )
        .prop_map(
            |(lobe, normals, roulette, connect, lights, sampler)| Estimator {
                integrator: Integrator::Path,
                lobe,
                normals,
                roulette,
                connect,
                lights,
                sampler,
            },
        )
}

/// Any settings; the defaults not rarely.
pub fn settings() -> impl Strategy<Value = Settings> {
    prop_oneof![
        1 => Just(Settings::default()),
        4 => (model(), estimator()).prop_map(|(model, estimator)| Settings { model, estimator }),
    ]
}
