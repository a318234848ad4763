//! Materials: the pbrt material with the same value for every pair of directions, masking aside, and the interior
//! medium.

use glam::DVec3;

use super::statement::Statement;
use super::{Reason, Remark};
use crate::export::seen::{absorbs, used};
use vkpt::prepared::{Material, MaterialKind, OPAQUE_SIGMA, Prepared};
use vkpt::settings::{Distribution, Fresnel};

/// pbrt treats narrower lobes as smooth.
const LEAST_WIDTH: f64 = 1e-3;

/// The name of a material.
pub fn name(material: &Material) -> String {
    format!("material-{}", material.line)
}

/// The name of the interior medium.
pub fn medium_name(material: &Material) -> String {
    format!("medium-{}", material.line)
}

/// The materials of all visible shapes; adds refusals to `refusals`.
pub fn statements(prepared: &Prepared, refusals: &mut Vec<Remark<Reason>>) -> Vec<Statement> {
    let mut statements = Vec::new();
    for material in used(prepared) {
        let named = Statement::new("MakeNamedMaterial").word(&name(material));
        match surface(named, material) {
            Ok(statement) => statements.push(statement),
            Err(reason) => refusals.push(Remark::new(material.line, reason)),
        }
        if is_opaque_in_a_channel(material) {
            refusals.push(Remark::new(material.line, Reason::OpaqueChannel));
        }
    }
    statements
}

/// The interior media of absorbing materials.
pub fn media(prepared: &Prepared) -> Vec<Statement> {
    let absorbing = used(prepared).filter(|material| absorbs(material));
    absorbing
        .map(|material| medium(material, prepared.space.unit))
        .collect()
}

fn surface(named: Statement, m: &Material) -> Result<Statement, Reason> {
    use MaterialKind::{
        Black, Diffuse, Glossy, Mirror, NullInterface, RoughDielectric, SmoothDielectric,
        WeakDielectric,
    };
    if !matches!(m.kind, Diffuse | NullInterface) && m.kd != DVec3::ZERO {
        return Err(Reason::Sum);
    }
    match m.kind {
        Black | Diffuse => Ok(named.string("type", "diffuse").rgb("reflectance", m.kd)),
        Mirror => lossless(named, m),
        Glossy => rough(lossless(named, m)?, m),
        NullInterface => Ok(named.string("type", "interface")),
        SmoothDielectric => glass(named, m),
        RoughDielectric => rough(glass(named, m)?, m),
        WeakDielectric => Err(Reason::WeakGlass),
    }
}

/// A metal of the index 0 + i reflects all light at every angle; pbrt reduces a `reflectance` of 1 to .9999.
fn lossless(named: Statement, m: &Material) -> Result<Statement, Reason> {
    match m.f0 == DVec3::ONE {
        true => Ok(named
            .string("type", "conductor")
            .flat("eta", 0.0)
            .flat("k", 1.0)),
        false => Err(Reason::SchlickMetal),
    }
}

fn glass(named: Statement, m: &Material) -> Result<Statement, Reason> {
    let [_, ior] = m.eta;
    match m.fresnel {
        Fresnel::Schlick => Err(Reason::SchlickGlass),
        Fresnel::Exact => Ok(named.string("type", "dielectric").float("eta", ior)),
    }
}

/// pbrt's only distribution is GGX, named after Trowbridge and Reitz.
fn rough(smooth: Statement, m: &Material) -> Result<Statement, Reason> {
    match m.distribution {
        Distribution::Beckmann => Err(Reason::Beckmann),
        Distribution::Phong => Err(Reason::Phong),
        Distribution::Ggx if m.alpha < LEAST_WIDTH => Err(Reason::Narrow(m.alpha)),
        Distribution::Ggx => Ok(smooth
            .float("roughness", m.alpha)
            .boolean("remaproughness", false)),
    }
}

/// A smooth spectrum cannot be infinite at one colour and finite at the others.
fn is_opaque_in_a_channel(m: &Material) -> bool {
    absorbs(m) && m.sigma.max_element() >= OPAQUE_SIGMA
}

/// Beer's law without scattering. `unit` is the length of rendering space's unit in the scene.
fn medium(m: &Material, unit: f64) -> Statement {
    Statement::new("MakeNamedMedium")
        .word(&medium_name(m))
        .string("type", "homogeneous")
        .rgb("sigma_a", m.sigma / unit)
        .rgb("sigma_s", DVec3::ZERO)
}
