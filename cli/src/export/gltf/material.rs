//! A material: the glTF material that vkpt's reader converts back to the scene's own (docs/gltf.md, "Materials").

use glam::DVec3;
use serde_json::{Value, json};

use super::Reason;
use vkpt::prepared::{Material, MaterialKind, Prepared};
use vkpt::scene::{self, Brdf};
use vkpt::settings::{Distribution, Fresnel};

/// Converts the material `own`; `prepared` is the same with the settings applied.
pub fn material(own: &scene::Material, prepared: &Material) -> Result<Value, Reason> {
    let mut material = match &own.kind {
        scene::MaterialKind::Light(radiance) => light(*radiance),
        scene::MaterialKind::Brdf(brdf) => {
            let roughness = roughness(prepared)?;
            match Prepared::is_transmissive(prepared) {
                true => glass(brdf, prepared, roughness)?,
                false => opaque(brdf, roughness),
            }
        }
    };
    material["name"] = json!(format!("line {}", prepared.line));
    Ok(material)
}

/// Black except for its emission: a factor of at most 1, times a strength.
fn light(radiance: DVec3) -> Value {
    let strength = radiance.max_element().max(1.0);
    let mut extensions = json!({ "KHR_materials_specular": { "specularFactor": 0.0 } });
    if strength > 1.0 {
        extensions["KHR_materials_emissive_strength"] = json!({ "emissiveStrength": strength });
    }
    json!({
        "pbrMetallicRoughness": pbr(DVec3::ZERO, 0.0, 1.0),
        "emissiveFactor": (radiance / strength).to_array(),
        "doubleSided": true,
        "extensions": extensions,
    })
}

/// Ks alone is a metal; otherwise Kd is the base colour of a non-metal. Its F0 is Ks if the index is 0, which means a
/// dielectric that reflects everything.
fn opaque(brdf: &Brdf, roughness: f64) -> Value {
    if brdf.kd == DVec3::ZERO && brdf.ks != DVec3::ZERO {
        return json!({
            "pbrMetallicRoughness": pbr(brdf.ks, 1.0, roughness),
            "doubleSided": true,
        });
    }
    let extensions = match brdf.ks == DVec3::ZERO {
        true => json!({ "KHR_materials_specular": { "specularFactor": 0.0 } }),
        false => json!({
            "KHR_materials_ior": { "ior": 0.0 },
            "KHR_materials_specular": { "specularColorFactor": brdf.ks.to_array() },
        }),
    };
    json!({
        "pbrMetallicRoughness": pbr(brdf.kd, 0.0, roughness),
        "doubleSided": true,
        "extensions": extensions,
    })
}

/// A solid: Kt is the transmittance over the length `kt_length`, and F0 = Ks.
fn glass(brdf: &Brdf, prepared: &Material, roughness: f64) -> Result<Value, Reason> {
    let has_surface = prepared.kind != MaterialKind::NullInterface;
    if brdf.kd != DVec3::ZERO && has_surface {
        return Err(Reason::Sum);
    }
    if prepared.fresnel == Fresnel::Exact && has_surface {
        return Err(Reason::ExactGlass);
    }
    if brdf.ior < 1.0 && has_surface {
        return Err(Reason::ThinIndex);
    }
    let ior = if has_surface { brdf.ior } else { 1.0 };
    // The reflectance at normal incidence, from the index alone.
    let by_index = ((ior - 1.0) / (ior + 1.0)).powi(2);
    let tint = match has_surface {
        true => brdf.ks / by_index,
        false => DVec3::ONE,
    };
    // Only the presence of a thickness matters: the triangles define it.
    let mut volume = json!({ "thicknessFactor": 1.0 });
    if brdf.kt != DVec3::ONE {
        volume["attenuationColor"] = json!(brdf.kt.to_array());
        volume["attenuationDistance"] = json!(brdf.kt_length);
    }
    Ok(json!({
        "pbrMetallicRoughness": pbr(DVec3::ONE, 0.0, roughness),
        "extensions": {
            "KHR_materials_ior": { "ior": ior },
            "KHR_materials_specular": { "specularColorFactor": tint.to_array() },
            "KHR_materials_transmission": { "transmissionFactor": 1.0 },
            "KHR_materials_volume": volume,
        },
    }))
}

fn pbr(base: DVec3, metallic: f64, roughness: f64) -> Value {
    json!({
        "baseColorFactor": base.extend(1.0).to_array(),
        "metallicFactor": metallic,
        "roughnessFactor": roughness,
    })
}

/// α = roughness²; 1 for surfaces without facets.
fn roughness(m: &Material) -> Result<f64, Reason> {
    use MaterialKind::{Glossy, Mirror, RoughDielectric, SmoothDielectric, WeakDielectric};
    match (m.kind, m.distribution) {
        (Mirror | SmoothDielectric, _) => Ok(0.0),
        (Glossy | RoughDielectric | WeakDielectric, Distribution::Ggx) => Ok(m.alpha.sqrt()),
        (Glossy | RoughDielectric | WeakDielectric, Distribution::Phong) => Err(Reason::Phong),
        (Glossy | RoughDielectric | WeakDielectric, Distribution::Beckmann) => {
            Err(Reason::Beckmann)
        }
        _ => Ok(1.0),
    }
}
