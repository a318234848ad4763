//! The inputs of the rows: interactions, directions, random numbers.

use glam::DVec3;
use vkpt::prepared::{MaterialKind, material::material};
use vkpt::reference::bsdf::{BsdfSample, BsdfValue, Interaction, Material, interaction};
use vkpt::reference::math::{Real, Vec3, vec3};
use vkpt::scene::Brdf;
use vkpt::settings::{Distribution, Fresnel, Settings};

use crate::twins::harness::{In, Out, Rng, Row};

/// Appends an interaction to a row.
pub fn put(row: Row, outside: bool, at: &Interaction<f32>) -> Row {
    let m = &at.material;
    row.vec3(m.kd)
        .f(m.kd_mean)
        .vec3(m.f0)
        .f(m.alpha)
        .f(m.width)
        .vec2(m.eta)
        .vec2(m.one_minus_eta2)
        .vec2(m.d)
        .f(m.p_d)
        .f(m.p_r)
        .u(m.kind as u32)
        .u(m.distribution as u32)
        .u(m.fresnel as u32)
        .u(outside.into())
        .vec3(at.wo)
        .vec3(at.attenuation)
}

const KINDS: [MaterialKind; 8] = MaterialKind::EVERY;
const DISTRIBUTIONS: [Distribution; 3] = Distribution::EVERY;

/// Reads the data that [`put`] has written.
pub fn take(i: &mut In) -> Interaction<f32> {
    let material = Material {
        kd: i.vec3(),
        kd_mean: i.f(),
        f0: i.vec3(),
        alpha: i.f(),
        sigma: Vec3::zero(),
        width: i.f(),
        radiance: Vec3::zero(),
        eta: i.vec2(),
        one_minus_eta2: i.vec2(),
        d: i.vec2(),
        p_d: i.f(),
        p_r: i.f(),
        kind: KINDS[i.u() as usize],
        distribution: DISTRIBUTIONS[i.u() as usize],
        fresnel: [Fresnel::Schlick, Fresnel::Exact][i.u() as usize],
    };
    let outside = i.b();
    let wo = i.vec3();
    interaction(material, outside, wo, i.vec3())
}

pub fn out_sample(o: &mut Out, s: BsdfSample<f32>) {
    o.vec3(s.wi);
    o.vec3(s.weight);
    o.f(s.pdf);
    o.u(s.lobe);
}

pub fn out_value(o: &mut Out, v: BsdfValue<f32>) {
    o.vec3(v.value);
    o.f(v.pdf);
}

/// Writes a `BsdfSample s`, a `BsdfValue v`.
pub const OUT_SAMPLE: &str = "out_vec3(s.wi); out_vec3(s.weight); out_f(s.pdf); out_u(s.lobe);";
pub const OUT_VALUE: &str = "out_vec3(v.value); out_f(v.pdf);";

/// One of `of`.
pub fn pick<T: Copy>(r: &mut Rng, of: &[T]) -> T {
    of[r.below(of.len() as u32) as usize]
}

/// A random number, at its ends every eighth time.
pub fn uniform(r: &mut Rng) -> f32 {
    match r.below(16) {
        0 => 0.0,
        1 => 1.0 - 1.0 / 16_777_216.0,
        _ => r.unit(),
    }
}

pub fn uniform2(r: &mut Rng) -> [f32; 2] {
    [uniform(r), uniform(r)]
}

/// A direction on wo's side: anywhere, grazing, along N', or an ulp about the critical angle of ior 1.5; a shading
/// normal may also turn away from it.
pub fn wo(r: &mut Rng) -> Vec3<f32> {
    let z = match r.below(10) {
        8 => 0.0,
        9 => -r.log_range(1e-7, 0.5),
        0 => r.log_range(1e-7, 1e-2),
        1 => 1.0,
        2 => f32::from_bits(0.745_356f32.to_bits() + r.below(8) - 4),
        _ => return r.hemisphere(),
    };
    let (s, phi) = ((1.0 - z * z).max(0.0).sqrt(), r.range(0.0, 6.3));
    vec3(s * phi.cos(), s * phi.sin(), z)
}

/// A prepared material of any kind that scatters; with `kd`, some have a diffuse lobe as well as others.
fn random_material(r: &mut Rng, kd: bool) -> Material<f32> {
    let colour = |r: &mut Rng| match r.below(3) {
        0 => DVec3::splat(f64::from(r.unit())),
        _ => r.vec3(0.0, 1.0).f64(),
    };
    let transmits = r.below(4) > 0;
    let width = match r.below(5) {
        0 => 0.0,
        1 => 1.0,
        _ => f64::from(r.log_range(1e-4, 1.0)),
    };
    let near_one = 1.0 + f64::from(r.log_range(1e-7, 1e-3));
    let brdf = Brdf {
        kd: if kd && r.bool() {
            colour(r)
        } else {
            DVec3::ZERO
        },
        ks: if r.below(4) > 0 {
            colour(r)
        } else {
            DVec3::ZERO
        },
        alpha: width,
        kt: if transmits { colour(r) } else { DVec3::ZERO },
        kt_length: 1.0,
        ior: pick(r, &[1.5, 1.5, 2.5, 10.0, 1.0 / 1.5, near_one]),
        distribution: Some(pick(r, &DISTRIBUTIONS)),
        fresnel: Some(pick(r, &[Fresnel::Schlick, Fresnel::Exact])),
    };
    Material::rounded(&material(&brdf, &Settings::default().model, 1), f32::new)
}

/// A random surface, seen from a random side.
pub fn surface(r: &mut Rng, kd: bool) -> (bool, Interaction<f32>) {
    let outside = r.bool();
    let attenuation = if r.bool() {
        Vec3::one()
    } else {
        r.vec3(0.0, 1.0)
    };
    let m = random_material(r, kd);
    (outside, interaction(m, outside, wo(r), attenuation))
}

/// The same, of a material of one of these kinds.
pub fn surface_of(r: &mut Rng, kd: bool, kinds: &[MaterialKind]) -> (bool, Interaction<f32>) {
    let mut found = surface(r, kd);
    while !kinds.contains(&found.1.material.kind) {
        found = surface(r, kd);
    }
    found
}
