//! Choice of lobe by Fresnel's share; twin of `shaders/bsdf/choice/fresnel.glsl`.

use crate::prepared::MaterialKind;
use crate::reference::bsdf::fresnel::fresnel;
use crate::reference::bsdf::interaction::Interaction;
use crate::reference::math::{Real, max2, mean3, min2};
use crate::reference::sampler::chance;

/// p_d = K̄d/(K̄d + 1) of a transmissive material, where reflection and refraction share the 1. Opaque: K̄d/(K̄d + S),
/// S = F̄(wo·N), kept within [0.1, 0.9] where both lobes exist (model.md, "Choice of lobe").
pub fn diffuse_probability<F: Real>(at: &Interaction<F>) -> F {
    let kd = at.material.kd_mean;
    let opaque = at.material.kind < MaterialKind::RoughDielectric;
    let specular = if opaque {
        mean3(fresnel(at, at.wo.z))
    } else {
        F::one()
    };
    let share = kd / (kd + specular);
    let kept = min2(max2(share, F::new(0.1)), F::new(0.9));
    let chosen = if opaque { kept } else { chance(share) };
    // 0/0 if S has vanished too
    if kd > F::zero() { chosen } else { F::zero() }
}

/// R = F̄(c), rounded to a probability that can be drawn; 1 for opaque materials.
pub fn reflect_probability<F: Real>(at: &Interaction<F>, _c: F, f_mean: F) -> F {
    if at.material.kind < MaterialKind::RoughDielectric {
        F::one()
    } else {
        chance(f_mean)
    }
}
