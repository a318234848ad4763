//! The optional members of a kernel.

use std::collections::BTreeSet;

use super::{Features, LightPick};
use crate::prepared::{LightKind, MaterialKind, ShapeKind};
use crate::settings::{Absorption, Distribution, Fresnel, Settings};

/// One member of a kernel that some scenes need and others do not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Member {
    Shape(ShapeKind),
    /// Shapes of this kind are found through the hierarchy.
    InBvh(ShapeKind),
    Material(MaterialKind),
    DiffuseBeside,
    Distribution(Distribution),
    Fresnel(Fresnel),
    Light(LightKind),
    LightPick(LightPick),
    Absorption(Absorption),
    ShadingNormals,
    Aims,
    Lens,
    /// Faces of this kind of shape may be covered by others.
    Covered(ShapeKind),
}

impl Member {
    /// Every possible member under these settings.
    pub fn all(settings: &Settings) -> BTreeSet<Self> {
        let mut all = BTreeSet::from([
            Self::DiffuseBeside,
            Self::Absorption(settings.model.absorption),
            Self::ShadingNormals,
            Self::Lens,
        ]);
        all.extend(Features::aims(settings).then_some(Self::Aims));
        all.extend(ShapeKind::EVERY.map(Self::Shape));
        all.extend(ShapeKind::EVERY.map(Self::InBvh));
        all.extend(ShapeKind::EVERY.map(Self::Covered));
        all.extend(MaterialKind::EVERY.map(Self::Material));
        all.extend(Distribution::EVERY.map(Self::Distribution));
        all.extend(Fresnel::EVERY.map(Self::Fresnel));
        all.extend(LightKind::EVERY.map(Self::Light));
        all.extend(
            LightPick::all(settings)
                .iter()
                .copied()
                .map(Self::LightPick),
        );
        all
    }
}

impl Features {
    /// The members present.
    pub fn members(&self) -> BTreeSet<Member> {
        let flags = [
            (self.diffuse_beside, Member::DiffuseBeside),
            (self.shading_normals, Member::ShadingNormals),
            (self.aims, Member::Aims),
            (self.lens, Member::Lens),
        ];
        let mut all: BTreeSet<Member> = flags.iter().filter(|f| f.0).map(|f| f.1).collect();
        all.extend(self.shapes.iter().copied().map(Member::Shape));
        all.extend(self.in_bvh.iter().copied().map(Member::InBvh));
        all.extend(self.covered.iter().copied().map(Member::Covered));
        all.extend(self.materials.iter().copied().map(Member::Material));
        all.extend(self.distributions.iter().copied().map(Member::Distribution));
        all.extend(self.fresnel.iter().copied().map(Member::Fresnel));
        all.extend(self.lights.iter().copied().map(Member::Light));
        all.extend(self.picks.iter().copied().map(Member::LightPick));
        all.extend(self.absorption.map(Member::Absorption));
        all
    }

    /// These features with one more member, and everything that it requires.
    #[must_use]
    pub fn with(&self, member: Member) -> Self {
        let mut features = self.clone();
        features.shapes.extend(shape_needed(member));
        features.put(member, true);
        features
    }

    /// These features without a member, and without everything that requires it.
    #[must_use]
    pub fn without(&self, member: Member) -> Self {
        let mut features = self.clone();
        if let Member::Shape(kind) = member {
            let needs = |m: &Member| shape_needed(*m) == Some(kind);
            self.members()
                .into_iter()
                .filter(needs)
                .for_each(|m| features.put(m, false));
        }
        features.put(member, false);
        features
    }

    fn put(&mut self, member: Member, there: bool) {
        match member {
            Member::Shape(kind) => put(&mut self.shapes, kind, there),
            Member::InBvh(kind) => put(&mut self.in_bvh, kind, there),
            Member::Material(kind) => put(&mut self.materials, kind, there),
            Member::Distribution(distribution) => put(&mut self.distributions, distribution, there),
            Member::Fresnel(form) => put(&mut self.fresnel, form, there),
            Member::Light(kind) => put(&mut self.lights, kind, there),
            Member::DiffuseBeside => self.diffuse_beside = there,
            Member::LightPick(pick) => put(&mut self.picks, pick, there),
            Member::Absorption(rule) => self.absorption = there.then_some(rule),
            Member::ShadingNormals => self.shading_normals = there,
            Member::Aims => self.aims = there,
            Member::Lens => self.lens = there,
            Member::Covered(kind) => put(&mut self.covered, kind, there),
        }
    }
}

fn put<T: Ord>(set: &mut BTreeSet<T>, member: T, there: bool) {
    if there {
        set.insert(member);
    } else {
        set.remove(&member);
    }
}

/// The kind of shape whose buffers a member reads.
fn shape_needed(member: Member) -> Option<ShapeKind> {
    match member {
        Member::InBvh(kind) | Member::Covered(kind) => Some(kind),
        Member::Light(kind) => kind.shape(),
        Member::ShadingNormals => Some(ShapeKind::Mesh),
        _ => None,
    }
}
