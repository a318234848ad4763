//! Materials: the BSDF with the same value for every pair of directions, and the interior medium.

use glam::DVec3;

use super::document::Node;
use super::{Reason, Remark};
use crate::export::seen::{absorbs, used};
use vkpt::prepared::{Material, MaterialKind, OPAQUE_SIGMA, Prepared};
use vkpt::settings::{Distribution, Fresnel};

/// The minimum width of Mitsuba's `principled`.
const LEAST_WIDTH: f64 = 1e-3;

/// The id of a material's BSDF.
pub fn bsdf_id(material: &Material) -> String {
    format!("bsdf-{}", material.line)
}

/// The id of the interior medium.
pub fn medium_id(material: &Material) -> String {
    format!("medium-{}", material.line)
}

/// The BSDFs and media of all visible shapes; adds refusals to `refusals`.
pub fn nodes(prepared: &Prepared, refusals: &mut Vec<Remark<Reason>>) -> Vec<Node> {
    let mut nodes = Vec::new();
    for material in used(prepared) {
        match bsdf(material) {
            Ok(node) => nodes.push(node.attribute("id", bsdf_id(material))),
            Err(reason) => refusals.push(Remark::new(material.line, reason)),
        }
        nodes.extend(absorbs(material).then(|| medium(material, prepared.space.unit)));
    }
    nodes
}

fn bsdf(m: &Material) -> Result<Node, Reason> {
    use MaterialKind::{
        Black, Diffuse, Glossy, Mirror, NullInterface, RoughDielectric, SmoothDielectric,
        WeakDielectric,
    };
    if !matches!(m.kind, Diffuse | NullInterface) && m.kd != DVec3::ZERO {
        return Err(Reason::Sum);
    }
    match m.kind {
        Black | Diffuse => Ok(both_sides(
            Node::plugin("bsdf", "diffuse").rgb("reflectance", m.kd),
        )),
        Mirror if m.f0 == DVec3::ONE => Ok(both_sides(lossless("conductor"))),
        Mirror => Err(Reason::SchlickMirror),
        Glossy => gloss(m).map(both_sides),
        NullInterface => Ok(Node::plugin("bsdf", "null")),
        SmoothDielectric => glass(m, "dielectric"),
        RoughDielectric => Ok(ggx(m, glass(m, "roughdielectric")?)?.float("alpha", m.alpha)),
        WeakDielectric => Err(Reason::WeakGlass),
    }
}

/// Mitsuba's opaque surfaces are black on the inside, vkpt's are the same on both sides.
fn both_sides(bsdf: Node) -> Node {
    Node::plugin("bsdf", "twosided").with(bsdf)
}

/// Reflects all light.
fn lossless(kind: &str) -> Node {
    Node::plugin("bsdf", kind).string("material", "none")
}

/// `principled`, all metal, has Schlick's reflectance with F0 = `base_color`, and α = `roughness`².
fn gloss(m: &Material) -> Result<Node, Reason> {
    if m.f0 == DVec3::ONE {
        return Ok(ggx(m, lossless("roughconductor"))?.float("alpha", m.alpha));
    }
    let principled = Node::plugin("bsdf", "principled")
        .rgb("base_color", m.f0)
        .float("metallic", 1.0)
        .float("roughness", m.alpha.sqrt());
    let principled = plain_ggx(m, principled)?;
    match m.alpha < LEAST_WIDTH {
        true => Err(Reason::NarrowGloss(m.alpha)),
        false => Ok(principled),
    }
}

/// Every object is surrounded by air, whose index is 1 here; Mitsuba's default is 1.00028.
fn glass(m: &Material, kind: &str) -> Result<Node, Reason> {
    let [_, ior] = m.eta;
    match m.fresnel {
        Fresnel::Schlick => Err(Reason::SchlickGlass),
        Fresnel::Exact => Ok(Node::plugin("bsdf", kind)
            .float("int_ior", ior)
            .float("ext_ior", 1.0)),
    }
}

fn ggx(m: &Material, bsdf: Node) -> Result<Node, Reason> {
    Ok(plain_ggx(m, bsdf)?.string("distribution", "ggx"))
}

/// Passes the plugin through if the material's distribution is GGX.
fn plain_ggx(m: &Material, bsdf: Node) -> Result<Node, Reason> {
    match m.distribution {
        Distribution::Ggx => Ok(bsdf),
        Distribution::Beckmann => Err(Reason::Beckmann),
        Distribution::Phong => Err(Reason::Phong),
    }
}

/// Beer's law without scattering. `unit` is the length of rendering space's unit in the scene.
fn medium(m: &Material, unit: f64) -> Node {
    let sigma = (m.sigma / unit).min(DVec3::splat(OPAQUE_SIGMA));
    // A colour of Mitsuba's is at most 1, so the scale is separate.
    let scale = sigma.max_element();
    Node::plugin("medium", "homogeneous")
        .attribute("id", medium_id(m))
        .float("albedo", 0.0)
        .rgb("sigma_t", sigma / scale)
        .float("scale", scale)
        // Nothing scatters in the medium, so no point in it is connected to emitters.
        .boolean("sample_emitters", false)
}
