//! A material of a document → a material of vkpt (docs/gltf.md, "Materials").

use glam::DVec3;

use super::document::{Material, MaterialExtensions};
use super::left_out::LeftOut;
use super::legal::{Legal, not_negative, positive};
use super::unread;
use crate::scene::{Brdf, MaterialKind};

/// Converts `material`, which messages call `label`; properties without an equivalent go to `left_out`. Errors are
/// messages.
pub(super) fn kind(
    material: &Material,
    label: &str,
    left_out: &mut LeftOut,
) -> Result<MaterialKind, String> {
    unread::note_of_material(material, label, left_out);
    let mut legal = Legal {
        label,
        left_out: &mut *left_out,
    };
    let radiance = radiance(material)?;
    let surface = Surface::read(material, &mut legal)?;
    if radiance != DVec3::ZERO {
        if surface.reflects() {
            left_out.note(
                "it emits light and reflects nothing: lights are black in vkpt",
                label,
            );
        }
        return Ok(MaterialKind::Light(radiance));
    }
    Ok(MaterialKind::Brdf(surface.brdf(label, left_out)))
}

/// Emitted radiance = emissiveFactor · emissiveStrength.
fn radiance(material: &Material) -> Result<DVec3, String> {
    let strength = material.extensions.emissive_strength.emissive_strength;
    let strength = not_negative("emissiveStrength", strength)?;
    let [r, g, b] = material.emissive_factor;
    let channel = |x| not_negative("emissiveFactor", x).map(|x| x * strength);
    let radiance = DVec3::new(channel(r)?, channel(g)?, channel(b)?);
    match radiance.as_vec3().is_finite() {
        true => Ok(radiance),
        false => Err("its emission is not finite in single precision".to_owned()),
    }
}

/// The supported properties of a material, checked.
struct Surface {
    base: DVec3,
    metallic: f64,
    roughness: f64,
    transmission: f64,
    /// Light is refracted, because the surface bounds a volume.
    is_thick: bool,
    /// Colour after the distance `length`.
    attenuation: DVec3,
    length: f64,
    ior: f64,
    /// Reflectance of the dielectric part at normal incidence.
    f0: DVec3,
}

impl Surface {
    fn read(material: &Material, legal: &mut Legal) -> Result<Self, String> {
        let pbr = &material.pbr_metallic_roughness;
        let MaterialExtensions {
            transmission,
            volume,
            ior,
            specular,
            ..
        } = &material.extensions;
        let [r, g, b, _] = pbr.base_color_factor;
        let thickness = not_negative("thicknessFactor", volume.thickness_factor)?;
        let length = volume.attenuation_distance;
        let length = length.map(|length| positive("attenuationDistance", length));
        // 0 means a dielectric that reflects everything (KHR_materials_ior).
        let ior = match ior.ior {
            0.0 => 0.0,
            ior => positive("ior", ior)?,
        };
        let weight = legal.share("specularFactor", specular.specular_factor)?;
        let tint = specular
            .specular_color_factor
            .map(|x| not_negative("specularColorFactor", x));
        let [tr, tg, tb] = tint;
        // F0 = min(((ior − 1)/(ior + 1))² · specularColor, 1) · specular  (KHR_materials_specular)
        let f0 = ((ior - 1.0) / (ior + 1.0)).powi(2);
        let f0 = (f0 * DVec3::new(tr?, tg?, tb?)).min(DVec3::ONE) * weight;
        Ok(Self {
            base: legal.shares("baseColorFactor", [r, g, b])?,
            metallic: legal.share("metallicFactor", pbr.metallic_factor)?,
            roughness: legal.share("roughnessFactor", pbr.roughness_factor)?,
            transmission: legal.share("transmissionFactor", transmission.transmission_factor)?,
            is_thick: thickness > 0.0,
            attenuation: legal.shares("attenuationColor", volume.attenuation_color)?,
            // With an infinite distance nothing is absorbed.
            length: length.transpose()?.unwrap_or(f64::INFINITY),
            ior,
            f0,
        })
    }

    /// Whether it reflects any incident light.
    fn reflects(&self) -> bool {
        self.base != DVec3::ZERO || self.f0 != DVec3::ZERO
    }

    fn brdf(&self, label: &str, left_out: &mut LeftOut) -> Brdf {
        // Metal transmits nothing.
        let transmission = match self.ior {
            0.0 => 0.0,
            _ => self.transmission * (1.0 - self.metallic),
        };
        if transmission > 0.0 && transmission < 1.0 {
            let taken = if transmission >= 0.5 { "all" } else { "none" };
            let what = format!("it transmits part of the light: taken as {taken}");
            left_out.note(what, label);
        }
        match (transmission >= 0.5, self.is_thick) {
            (false, _) => self.opaque(),
            (true, thick) => {
                if self.base != DVec3::ONE {
                    let what =
                        "its base colour does not tint what it transmits: attenuationColor does";
                    left_out.note(what, label);
                }
                match thick {
                    true => self.solid(),
                    false => {
                        left_out.note(THIN, label);
                        nothing()
                    }
                }
            }
        }
    }

    /// Kd = base · (1 − metallic), Ks = F0 · (1 − metallic) + base · metallic, α = roughness².
    fn opaque(&self) -> Brdf {
        let dielectric = 1.0 - self.metallic;
        Brdf {
            kd: self.base * dielectric,
            ks: (self.f0 * dielectric + self.base * self.metallic).min(DVec3::ONE),
            alpha: self.roughness * self.roughness,
            kt: DVec3::ZERO,
            kt_length: 1.0,
            ior: 1.0,
            distribution: None,
            fresnel: None,
        }
    }

    /// Kt = attenuationColor^(1/attenuationDistance) per unit length, or attenuationColor per attenuationDistance; Ks = F0.
    fn solid(&self) -> Brdf {
        let (kt, kt_length) = match self.length.is_finite() {
            true => (self.attenuation, self.length),
            false => (DVec3::ONE, 1.0),
        };
        Brdf {
            kd: DVec3::ZERO,
            ks: self.f0,
            alpha: self.roughness * self.roughness,
            kt,
            kt_length,
            ior: self.ior,
            distribution: None,
            fresnel: None,
        }
    }
}

/// A surface without any effect on light: index 1, no absorption.
fn nothing() -> Brdf {
    Brdf {
        kd: DVec3::ZERO,
        ks: DVec3::ZERO,
        alpha: 0.0,
        kt: DVec3::ONE,
        kt_length: 1.0,
        ior: 1.0,
        distribution: None,
        fresnel: None,
    }
}

const THIN: &str = "it is thin-walled, because its thicknessFactor is 0: light passes unchanged, without \
    reflection; give solids a thickness (KHR_materials_volume)";

#[cfg(test)]
mod tests {
    use super::*;

    fn read(json: &str) -> (MaterialKind, Vec<String>) {
        let material: Material = serde_json::from_str(json).expect("a material");
        let mut left_out = LeftOut::default();
        let kind = kind(&material, "m", &mut left_out).expect("legal");
        (kind, left_out.sentences().collect())
    }

    #[test]
    fn without_a_distance_nothing_is_absorbed() {
        let (kind, left_out) = read(
            r#"{"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
                "KHR_materials_volume": {"thicknessFactor": 1, "attenuationColor": [0.5, 0, 0]}},
                "pbrMetallicRoughness": {"metallicFactor": 0}}"#,
        );
        let MaterialKind::Brdf(brdf) = kind else {
            panic!("{kind:?}")
        };
        assert_eq!((brdf.kt, brdf.kt_length), (DVec3::ONE, 1.0));
        assert_eq!(left_out, [""; 0]);
    }
}
