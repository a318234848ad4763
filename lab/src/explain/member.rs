//! The scene's decisions: each member of the features, with the lines that need it.

use super::Subject;
use super::lines::{lines, materials};
use super::reasons::reason;
use super::setting::by;
use crate::explain::report::Part;
use vkpt::features::{LightPick, Member, words};
use vkpt::prepared::{LightKind, Material, NONE};
use vkpt::report::names::Named;
use vkpt::settings::{Distribution, DistributionRule, Fresnel};

/// The member as a part of the kernel: present or omitted.
pub fn part(subject: &Subject, member: Member) -> Part {
    let present = subject.plan.features.members().contains(&member);
    let found = lines(subject.job.prepared, member);
    let why = match (present, found.is_empty()) {
        (true, false) => remark(subject, member),
        (true, true) => "--kernel full".to_owned(),
        (false, _) => reason(subject, member),
    };
    let (group, name) = name(member);
    let first = found.first().copied().unwrap_or(0);
    let default_material = first == 0 && !found.is_empty();
    Part {
        group,
        name,
        present,
        quote: match default_material {
            true => "no material precedes the shape".to_owned(),
            false => subject.quote(first),
        },
        lines: found.into_iter().filter(|&line| line > 0).collect(),
        why,
    }
}

fn name(member: Member) -> (&'static str, String) {
    match member {
        Member::Shape(kind) => ("shape", kind.description().name.to_owned()),
        Member::InBvh(kind) => ("search", kind.description().name.to_owned()),
        Member::Material(kind) => ("material", words(&kind)),
        Member::DiffuseBeside => ("diffuse lobe", "and specular".to_owned()),
        Member::Distribution(distribution) => ("distribution", distribution.name().to_owned()),
        Member::Fresnel(form) => ("fresnel", form.name().to_owned()),
        Member::Light(kind) => ("light", words(&kind)),
        Member::LightPick(pick) => {
            let among = match pick {
                LightPick::Power => "by power",
                LightPick::Every => "among few",
                LightPick::Tree => "among many",
            };
            ("light choice", among.to_owned())
        }
        Member::Absorption(rule) => ("absorption", rule.name().to_owned()),
        Member::ShadingNormals => ("normals", "of meshes".to_owned()),
        Member::Aims => ("light paths", "aimed".to_owned()),
        Member::Lens => ("camera", "lens".to_owned()),
        Member::Covered(kind) => ("covered", kind.description().name.to_owned()),
    }
}

/// Information that the quoted line does not give.
fn remark(subject: &Subject, member: Member) -> String {
    let first = materials(subject.job.prepared, member).next();
    match (member, first) {
        (Member::Distribution(distribution), Some(m)) => chosen(subject, m, distribution),
        (Member::Fresnel(form), Some(m)) => form_of(subject, m, form),
        (Member::Light(LightKind::Surroundings), _) => surroundings(subject),
        (Member::Light(kind), _) if !kind.is_outside() => light(subject, kind),
        (Member::LightPick(pick), _) => format!(
            "{} lights: {}",
            subject.job.prepared.lights.len(),
            how(pick)
        ),
        (Member::Absorption(_), Some(m)) => absorbing(subject, m),
        (Member::Covered(_), _) => {
            "where faces coincide, the first in the file is visible".to_owned()
        }
        _ => String::new(),
    }
}

/// The source of a material's distribution: a flag, a word of the scene, or its alpha.
fn chosen(subject: &Subject, m: &Material, distribution: Distribution) -> String {
    let kind = match distribution {
        Distribution::Phong => "an exponent",
        _ => "a width",
    };
    let own = format!("alpha {} is {kind}", shortest(m.alpha));
    match (
        subject.job.settings.model.distribution,
        m.words.distribution,
    ) {
        (DistributionRule::Always(d), _) => format!("--distribution {}", d.name()),
        (DistributionRule::Auto, _) => format!("--distribution auto: {own}"),
        (DistributionRule::Scene, 0) => own,
        (DistributionRule::Scene, line) => format!("line {line}: {}", subject.quote(line)),
    }
}

/// The source of the form of Fresnel's reflectance: a flag, a word of the scene, or the default.
fn form_of(subject: &Subject, m: &Material, form: Fresnel) -> String {
    use vkpt::prepared::MaterialKind::{Glossy, Mirror};
    match (subject.job.settings.model.fresnel, m.words.fresnel) {
        _ if matches!(m.kind, Glossy | Mirror) => {
            "opaque: the exact form needs an index".to_owned()
        }
        (Some(_), _) => format!("--fresnel {}", form.name()),
        (None, 0) => "the default".to_owned(),
        (None, line) => format!("line {line}: {}", subject.quote(line)),
    }
}

/// The transmittance of a material, and the flag that sets the rule of absorption.
fn absorbing(subject: &Subject, m: &Material) -> String {
    let kt = m.transmittance(&subject.job.prepared.space);
    let [r, g, b] = kt.to_array().map(shortest);
    let kt = format!("Kt {r} {g} {b} per unit");
    match by(subject, "absorption", |s| s.absorption.to_owned()) {
        flag if flag.starts_with("--") => format!("{flag}; {kt}"),
        _ => kt,
    }
}

fn light(subject: &Subject, kind: LightKind) -> String {
    let prepared = subject.job.prepared;
    let shapes = prepared
        .lights
        .iter()
        .filter(|l| l.kind == kind && l.shape != NONE);
    let line = shapes
        .map(|l| &prepared.shapes[l.shape as usize])
        .min_by_key(|s| s.line)
        .map_or(0, |s| prepared.materials[s.material as usize].line);
    format!("line {line}: {}", subject.quote(line))
}

/// The size of the picture of surroundings.
fn surroundings(subject: &Subject) -> String {
    let surroundings = subject.job.prepared.surroundings.as_ref();
    surroundings.map_or(String::new(), |s| {
        format!("{} × {} texels", s.map.width, s.map.height)
    })
}

/// Up to six decimals, without trailing zeros.
fn shortest(x: f64) -> String {
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// How one of several lights is picked for a connection.
fn how(pick: LightPick) -> &'static str {
    match pick {
        LightPick::Power => "by power, independent of the vertex",
        LightPick::Every => "a candidate on each light, one kept by its contribution",
        LightPick::Tree => "down a tree, by power, distance and angles",
    }
}
