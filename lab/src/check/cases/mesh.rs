//! Triangles of zero area, needles, a mesh of one triangle, a mesh of a million.

use std::f64::consts::PI;

use glam::{DQuat, DVec3};

use crate::check::case::{Case, Stiffness};
use crate::check::closed::polygon::irradiance;
use vkpt::scene::Mesh;

pub fn cases() -> Vec<Case> {
    let corners = [[-4.0, -4.0, 0.0], [4.0, -4.0, 0.0], [0.0, 8.0, 0.0]];
    let needle = [
        [-500.0, -5e-4, 0.0],
        [500.0, -5e-4, 0.0],
        [500.0, 5e-4, 0.0],
    ];
    let flat = [
        [-4.0, -4.0, 0.0],
        [4.0, -4.0, 0.0],
        [0.0, 8.0, 0.0],
        [0.0, -4.0, 0.0],
        [1.0, 2.0, 0.0],
    ];
    vec![
        lit(
            "one-triangle",
            "a mesh of one triangle",
            "0 0 1 .1",
            1.0,
            mesh(&corners, vec![[0, 1, 2]]),
        ),
        lit(
            "no-area",
            "a triangle among others of zero area",
            "0 0 1 .1",
            1.0,
            mesh(
                &flat,
                vec![[3, 3, 3], [0, 3, 1], [0, 1, 2], [4, 4, 0], [2, 2, 2]],
            ),
        ),
        lit(
            "needle",
            "a triangle a million times as long as wide",
            "100 0 1 1e-9",
            1e6,
            mesh(&needle, vec![[0, 1, 2]]),
        ),
        glowing(
            "no-area-light",
            "a light of triangles, most of zero area",
            mesh(
                &flat,
                vec![[3, 3, 3], [0, 3, 1], [0, 1, 2], [4, 4, 0], [2, 2, 2]],
            ),
        ),
        needle_light(),
        coarse("mirror", "a mirror", "0 0 0 1 1 1 0"),
        coarse("glass", "smooth glass", "0 0 0 .04 .04 .04 0 1 1 1 1.5"),
        lit(
            "million",
            "a plane of a million triangles",
            "0 0 1 .5",
            1.0,
            grid(708),
        )
        .slow(),
    ]
}

/// A flat, diffuse mesh under a sky of radiance 1 reflects Kd, wherever it is seen.
fn lit(name: &str, about: &str, camera: &str, condition: f64, mesh: Mesh) -> Case {
    let text = format!("screen 16 16\ncamera {camera}\nbackground 1 1 1\nbrdf .5 .5 .5 0 0 0 1\n");
    let stiff = Stiffness::new(
        2.0,
        condition,
        1.0,
        "barycentric coordinates lose the ratio of the sides",
    );
    Case::new(format!("mesh/{name}"), about, text, stiff)
        .mesh(mesh)
        .mean(
            0.5,
            "Kd: a plane sees half of the sky and nothing of itself",
        )
}

fn glowing(name: &str, about: &str, mesh: Mesh) -> Case {
    let text = "screen 16 16\ncamera 0 0 1 .1\nlight 1 1 1\n";
    let stiff = Stiffness::new(1.0, 1.0, 1.0, "one hit");
    Case::new(format!("mesh/{name}"), about, text, stiff)
        .mesh(mesh)
        .mean(1.0, "its own radiance")
}

/// A light a million times as long as wide, 3 above a diffuse floor.
fn needle_light() -> Case {
    let corners = [[-5.0, -5e-6, 3.0], [5.0, 5e-6, 3.0], [5.0, -5e-6, 3.0]];
    let text = "screen 16 16\ncamera 0 0 1 1e-9\nbrdf .5 .5 .5 0 0 0 1\nbox -9 -9 -1 18 18 1\nlight 1e5 1e5 1e5\n";
    let why = "its width is next to 0, where f32 is fine, and its area one product";
    let stiff = Stiffness::new(2.0, 1.0, 1.0, why);
    let irradiance = irradiance(&corners.map(DVec3::from_array), DVec3::Z);
    Case::new(
        "mesh/needle-light",
        "a light a million times as long as wide",
        text,
        stiff,
    )
    .mesh(mesh(&corners, vec![[0, 1, 2]]))
    .spp(64)
    .mean(0.5 / PI * 1e5 * irradiance, "Kd/π E by Lambert's formula")
}

fn mesh(corners: &[[f64; 3]], triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh {
        path: "mesh".into(),
        files: Vec::new(),
        positions: corners.iter().map(|c| DVec3::from_array(*c)).collect(),
        normals: None,
        triangles,
        translate: DVec3::ZERO,
        scale: 1.0,
        rotate: DQuat::IDENTITY,
    }
}

/// A coarse ball with the normals of a sphere: towards its rim mirrored directions would lie below the faces, and normals
/// turn away.
fn coarse(name: &str, what: &str, brdf: &str) -> Case {
    let view = "screen 32 32\ncamera 0 -6 1 .22 x 81\nbackground 1 1 1\nfresnel exact\n";
    let stiff = Stiffness::new(2.0, 64.0, 1.0, "edges, and the rim; all weights are 1");
    Case::new(
        format!("mesh/coarse-{name}"),
        format!("{what}, a coarse mesh with the normals of a sphere"),
        format!("{view}brdf {brdf}\n"),
        stiff,
    )
    .mesh(ball(5, 8))
    .weight(1.0, "smooth surfaces only deflect light")
    .mean(1.0, "a surface that absorbs nothing is invisible")
}

/// A ball of radius 1: `rings` circles of `n` corners between two poles, its normals those of the sphere.
fn ball(rings: u32, n: u32) -> Mesh {
    let corner = |ring: u32, k: u32| {
        let (sin, cos) = (PI * f64::from(ring) / f64::from(rings + 1)).sin_cos();
        let (y, x) = (2.0 * PI * f64::from(k) / f64::from(n)).sin_cos();
        [sin * x, sin * y, cos]
    };
    let mut corners = vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    corners.extend((1..=rings).flat_map(|ring| (0..n).map(move |k| corner(ring, k))));
    let at = |ring: u32, k: u32| 2 + (ring - 1) * n + k % n;
    let caps = (0..n).flat_map(|k| {
        [
            [0, at(1, k), at(1, k + 1)],
            [1, at(rings, k + 1), at(rings, k)],
        ]
    });
    let bands = (1..rings).flat_map(|r| {
        (0..n).flat_map(move |k| {
            let [a, b, c, d] = [at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)];
            [[a, b, c], [a, c, d]]
        })
    });
    let mut mesh = mesh(&corners, caps.chain(bands).collect());
    mesh.normals = Some(mesh.positions.clone());
    mesh
}

/// 2n² triangles of a plane from −4 to 4.
fn grid(n: u32) -> Mesh {
    let at = |k: u32| 8.0 * f64::from(k) / f64::from(n) - 4.0;
    let corners: Vec<[f64; 3]> = (0..=n)
        .flat_map(|j| (0..=n).map(move |i| [at(i), at(j), 0.0]))
        .collect();
    let cell = |i: u32, j: u32| {
        let [a, b] = [j * (n + 1) + i, (j + 1) * (n + 1) + i];
        [[a, a + 1, b + 1], [a, b + 1, b]]
    };
    let triangles = (0..n)
        .flat_map(|j| (0..n).flat_map(move |i| cell(i, j)))
        .collect();
    mesh(&corners, triangles)
}
