//! The settings' names, as the command line and every record spell them.

use crate::film::Aov;
use crate::image::Format;
use crate::render::KernelChoice;
use crate::settings::{
    Absorption, Connect, Distribution, Fresnel, Integrator, Lights, LobeChoice, Normals, Sampler,
};

/// A choice among a few named values.
pub trait Named: Copy + PartialEq + Send + Sync + 'static {
    /// All of them with their names, in the order of listing.
    const ALL: &'static [(Self, &'static str)];

    /// The name.
    fn name(self) -> &'static str {
        Self::ALL
            .iter()
            .find(|(value, _)| *value == self)
            .map_or("unnamed", |(_, name)| name)
    }
}

impl Named for KernelChoice<'static> {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Composed, "composed"), (Self::Full, "full")];
}

impl Named for Format {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Png, "png"), (Self::Hdr, "hdr"), (Self::Exr, "exr")];
}

impl Named for Fresnel {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Schlick, "schlick"), (Self::Exact, "exact")];
}

impl Named for Distribution {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Phong, "phong"),
        (Self::Beckmann, "beckmann"),
        (Self::Ggx, "ggx"),
    ];
}

impl Named for Absorption {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Segment, "segment"), (Self::Term, "term")];
}

impl Named for LobeChoice {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Fresnel, "fresnel"), (Self::Norms, "norms")];
}

impl Named for Normals {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Visible, "visible"),
        (Self::Distribution, "distribution"),
    ];
}

impl Named for Integrator {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Path, "path"),
        (Self::Light, "light"),
        (Self::Bidirectional, "bidirectional"),
    ];
}

impl Named for Connect {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Mis, "mis"),
        (Self::Light, "light"),
        (Self::Bsdf, "bsdf"),
    ];
}

impl Named for Lights {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Contribution, "contribution"), (Self::Power, "power")];
}

impl Named for Sampler {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Random, "random"),
        (Self::Sobol, "sobol"),
        (Self::SobolQuarters, "sobol-quarters"),
    ];
}

impl Named for Aov {
    const ALL: &'static [(Self, &'static str)] = &[
        (Self::Stderr, "stderr"),
        (Self::Albedo, "albedo"),
        (Self::Normal, "normal"),
        (Self::Depth, "depth"),
        (Self::Position, "position"),
        (Self::Shape, "shape"),
        (Self::Material, "material"),
        (Self::Samples, "samples"),
        (Self::AlbedoBehind, "albedo*"),
        (Self::NormalBehind, "normal*"),
    ];
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distinct<T: Named + std::fmt::Debug>(values: &[T]) {
        assert_eq!(
            T::ALL.iter().map(|(value, _)| *value).collect::<Vec<_>>(),
            values
        );
        let mut names: Vec<_> = values.iter().map(|value| value.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), values.len());
        assert!(!names.contains(&"unnamed"));
    }

    #[test]
    fn every_value_has_a_name_of_its_own() {
        distinct(&[Fresnel::Schlick, Fresnel::Exact]);
        distinct(&[
            Distribution::Phong,
            Distribution::Beckmann,
            Distribution::Ggx,
        ]);
        distinct(&[Absorption::Segment, Absorption::Term]);
        distinct(&[LobeChoice::Fresnel, LobeChoice::Norms]);
        distinct(&[Normals::Visible, Normals::Distribution]);
        distinct(&[
            Aov::Stderr,
            Aov::Albedo,
            Aov::Normal,
            Aov::Depth,
            Aov::Position,
            Aov::Shape,
            Aov::Material,
            Aov::Samples,
            Aov::AlbedoBehind,
            Aov::NormalBehind,
        ]);
        distinct(&[Connect::Mis, Connect::Light, Connect::Bsdf]);
        distinct(&[Lights::Contribution, Lights::Power]);
        distinct(&[Sampler::Random, Sampler::Sobol, Sampler::SobolQuarters]);
        distinct(&[
            Integrator::Path,
            Integrator::Light,
            Integrator::Bidirectional,
        ]);
    }
}
