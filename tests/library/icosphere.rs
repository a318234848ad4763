//! The generator of large meshes, `examples/icosphere`.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::path::Path;

use glam::DVec3;
use vkpt::scene::parse_mesh;

use crate::common::icosphere::mesh::{Icosphere, frequency, ply};

/// How often each directed edge is used.
fn edges(triangles: &[[u32; 3]]) -> HashMap<[u32; 2], usize> {
    let mut uses = HashMap::new();
    for [a, b, c] in triangles {
        for edge in [[*a, *b], [*b, *c], [*c, *a]] {
            *uses.entry(edge).or_default() += 1;
        }
    }
    uses
}

/// Σ v₀·(v₁ × v₂)/6
fn volume(mesh: &Icosphere) -> f64 {
    let six = |[a, b, c]: &[DVec3; 3]| a.dot(b.cross(*c));
    mesh.corners().iter().map(six).sum::<f64>() / 6.0
}

#[test]
fn closed_outward_and_of_one_piece_without_handles() {
    for f in [1, 2, 3, 7, 30] {
        let mesh = Icosphere::new(f, 0.3, 5);
        let (f, v, t) = (f as usize, mesh.positions.len(), mesh.triangles.len());
        assert_eq!((v, t), (10 * f * f + 2, 20 * f * f));
        let edges = edges(&mesh.triangles);
        for ([a, b], uses) in &edges {
            assert_eq!((*uses, edges.get(&[*b, *a])), (1, Some(&1)), "edge {a} {b}");
        }
        // Euler: V − E + F = 2.
        assert_eq!(v + t, edges.len() / 2 + 2);
        for [a, b, c] in mesh.corners() {
            assert!(a.dot(b.cross(c)) > 0.0, "star-shaped about the origin");
        }
        for (p, n) in mesh.positions.iter().zip(mesh.normals()) {
            assert!((0.7..=1.3).contains(&p.length()) && n.is_normalized());
            assert!(n.dot(*p) > 0.0, "normals point out");
        }
        let distinct: HashMap<_, _> = mesh
            .positions
            .iter()
            .map(|p| (p.as_vec3().to_array().map(f32::to_bits), ()))
            .collect();
        assert_eq!(distinct.len(), v);
    }
}

#[test]
fn undisplaced_it_has_the_volume_of_an_icosahedron_and_then_that_of_a_sphere() {
    // 5(3 + √5)/12 a³ with the edge a = 4/√(10 + 2√5) of circumradius 1.
    let edge = 4.0 / (10.0 + 2.0 * 5f64.sqrt()).sqrt();
    let exact = 5.0 * (3.0 + 5f64.sqrt()) / 12.0 * edge.powi(3);
    assert!((volume(&Icosphere::new(1, 0.0, 0)) - exact).abs() < 1e-14);
    let sphere = 4.0 * PI / 3.0;
    let missing = |f| sphere - volume(&Icosphere::new(f, 0.0, 0));
    // A chord's sagitta falls with the square of its length.
    let ratio = missing(20) / missing(40);
    assert!((3.9..4.1).contains(&ratio), "{ratio}");
}

#[test]
fn the_count_asked_for_is_met_within_a_step() {
    for (asked, f) in [
        (1, 1),
        (20, 1),
        (1000, 7),
        (100_000, 71),
        (1_000_000, 224),
        (50_000_000, 1581),
    ] {
        assert_eq!(frequency(asked), f);
    }
}

#[test]
fn a_seed_makes_one_shape() {
    let shape = |seed| ply::bytes(&Icosphere::new(9, 0.1, seed), None);
    assert_eq!(shape(4), shape(4));
    assert_ne!(shape(4), shape(5));
    let heights: Vec<f64> = Icosphere::new(40, 0.1, 4)
        .positions
        .iter()
        .map(|p| p.length() - 1.0)
        .collect();
    let most = heights.iter().fold(0.0, |most: f64, h| most.max(h.abs()));
    assert!((0.03..=0.1).contains(&most), "{most}");
}

#[test]
fn its_file_is_read_back() {
    let mesh = Icosphere::new(5, 0.2, 1);
    let normals = mesh.normals();
    for given in [None, Some(&normals[..])] {
        let read = parse_mesh(&ply::bytes(&mesh, given), Path::new("blob.ply")).expect("a mesh");
        let single: Vec<DVec3> = mesh
            .positions
            .iter()
            .map(|p| p.as_vec3().as_dvec3())
            .collect();
        assert_eq!(
            (read.positions, read.triangles),
            (single, mesh.triangles.clone())
        );
        assert_eq!(read.normals.is_some(), given.is_some());
        for (n, expected) in read.normals.iter().flatten().zip(&normals) {
            assert!(n.distance(*expected) < 2.0 * f64::from(f32::EPSILON));
        }
    }
}
