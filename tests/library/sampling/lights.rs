//! The choice of a light by its power, and of a triangle in a mesh by its area: against powers and areas computed here.

use std::f64::consts::PI;

use vkpt::prepared::LightKind;
use vkpt::reference::math::Vec3;
use vkpt::reference::sampler::random::sampler_block;
use vkpt::reference::sampler::{light_block, unit_float};
use vkpt::reference::world::World;
use vkpt::settings::Settings;

use super::{ALPHA, world};
use crate::common::meshes::ply;
use crate::common::stats::{chi_square, sidak};

const SAMPLES: u32 = 200_000;

/// A tetrahedron on three edges of lengths 1, 2 and 3 along the axes.
fn tetrahedron() -> tempfile::NamedTempFile {
    ply(
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         element face 4\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
    )
}

/// Areas of the tetrahedron's faces; the last by Heron's formula, or De Gua's: the root of the squares' sum.
fn face_areas() -> [f64; 4] {
    let legs = [1.0, 1.5, 3.0f64];
    let [a, b, c] = legs;
    [a, b, c, legs.iter().map(|x| x * x).sum::<f64>().sqrt()]
}

/// All five kinds of light, and the power of each over π, summed over RGB. The floor and the sphere bound the scene:
/// 10 × 10 × 8.
fn scene() -> (World<f64>, [(LightKind, f64); 5]) {
    let mesh = tetrahedron();
    let text = format!(
        "screen 4 3\ncamera 0 -4 3 .5 x 70\nbackground .01 .02 .03\n\
         brdf .5 .5 .5 0 0 0 1\nbox -5 -5 -2 10 10 1\n\
         light 4 5 6\nsphere 0 0 5 1\nlight 1 2 3\nbox 2 2 1 1 2 3\n\
         light 9 0 0\ncylinder -3 -3 1 0 0 2 .5\nlight 3 3 3\nmesh {} -3 2 0 .5\n",
        mesh.path().display()
    );
    let radius = 0.5 * (10.0f64.powi(2) * 2.0 + 8.0 * 8.0).sqrt();
    let sphere = |r: f64| 4.0 * PI * r * r;
    let mesh_area = 0.25 * face_areas().iter().sum::<f64>();
    let powers = [
        (LightKind::Sphere, sphere(1.0) * 15.0),
        (LightKind::Box, 2.0 * (2.0 + 3.0 + 6.0) * 6.0),
        (LightKind::Cylinder, 2.0 * PI * 0.5 * (0.5 + 2.0) * 9.0),
        (LightKind::Mesh, mesh_area * 9.0),
        (LightKind::Background, sphere(radius) * 0.06),
    ];
    (world(&text, &Settings::default()), powers)
}

/// The light block of a path's first bounce.
fn block(sample: u32) -> [u32; 4] {
    sampler_block(7, sample, light_block(0), 1)
}

/// p-value of counts for entries of these weights.
fn p_value(counts: &[usize], weights: &[f64]) -> f64 {
    let total: f64 = weights.iter().sum();
    let expected: Vec<f64> = weights
        .iter()
        .map(|w| w / total * f64::from(SAMPLES))
        .collect();
    chi_square(counts, &expected)
}

#[test]
fn lights_are_chosen_by_their_power() {
    let (world, powers) = scene();
    let index = |kind| world.lights.iter().position(|l| l.kind == kind);
    let mut weights = vec![0.0; powers.len()];
    for (kind, power) in powers {
        weights[index(kind).expect("a light of each kind")] = power;
    }
    let total: f64 = weights.iter().sum();
    for (i, w) in weights.iter().enumerate() {
        // a count of 2^-24 up or down
        assert!((world.light_pmf(i) - w / total).abs() < 1e-6, "light {i}");
    }
    let mut counts = vec![0; weights.len()];
    for sample in 0..SAMPLES {
        counts[world.light_choice(block(sample)[0] >> 8)] += 1;
    }
    let p = p_value(&counts, &weights);
    assert!(p > ALPHA, "p = {p:e}");
    weights[0] *= 1.05;
    assert!(p_value(&counts, &weights) < ALPHA, "5 % more passes");
}

#[test]
fn triangles_are_chosen_by_their_area() {
    let (world, _) = scene();
    let mesh = (world.lights.iter()).position(|l| l.kind == LightKind::Mesh);
    let mesh = mesh.expect("a mesh");
    let mut counts = vec![0; 4];
    for sample in 0..SAMPLES {
        let u = block(sample);
        let uv = [unit_float(u[2]), unit_float(u[3])];
        let l = world.light_sample(mesh, Vec3::zero(), u[1] >> 8, uv);
        counts[(l.prim - world.lights[mesh].first) as usize] += 1;
    }
    let mut weights = face_areas();
    let level = sidak(ALPHA, 1);
    assert!(p_value(&counts, &weights) > level);
    weights[3] *= 1.05;
    assert!(p_value(&counts, &weights) < level, "5 % more passes");
}
