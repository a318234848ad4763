//! Beer's law; twin of `shaders/path/medium/`.

use crate::prepared::NONE;
use crate::reference::math::{Real, Vec3, vec3};
use crate::reference::world::World;
use crate::settings::Absorption;

/// Beer's law, `sigma` = −ln Kt per unit length ≥ 0, `t` ≥ 0 a length: A(t) = Kt^t = exp(−σt), and 1 where σ or t is 0
/// (model.md, "Absorption").
pub fn beer<F: Real>(sigma: F, t: F) -> F {
    if sigma == F::zero() || t == F::zero() {
        F::one()
    } else {
        F::exp(-(sigma * t))
    }
}

/// [`beer`] for each channel.
pub fn beer3<F: Real>(sigma: Vec3<F>, t: F) -> Vec3<F> {
    vec3(beer(sigma.x, t), beer(sigma.y, t), beer(sigma.z, t))
}

/// Transmittance of a segment of length `t` in `medium`, a material or `NONE`; 1 with `term`.
pub fn stretch_transmittance<F: Real>(
    world: &World<F>,
    absorption: Absorption,
    medium: u32,
    t: F,
) -> Vec3<F> {
    match absorption {
        Absorption::Segment if medium != NONE => beer3(world.materials[medium as usize].sigma, t),
        _ => Vec3::one(),
    }
}

/// The hand-out's A(t), at the end of a segment of length `t` that meets the inside of a surface.
pub fn term_attenuation<F: Real>(
    world: &World<F>,
    absorption: Absorption,
    material: u32,
    outside: bool,
    t: F,
) -> Vec3<F> {
    match absorption {
        Absorption::Term if !outside => beer3(world.materials[material as usize].sigma, t),
        _ => Vec3::one(),
    }
}
