//! Whether a mesh bounds a solid: what a transmissive material asks of it (model.md, "Media").

use std::collections::HashMap;

use glam::DVec3;

use super::Mesh;

/// Edges that keep a mesh from bounding a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Edges {
    /// Used by one triangle only: the mesh has a hole there.
    pub open: usize,
    /// Used by more, but not as often in one direction as in the other: neighbours are wound differently.
    pub torn: usize,
}

/// Counts the edges that keep the mesh from bounding a solid.
///
/// Vertices at exactly the same place are one (files repeat a vertex that has several normals), and triangles
/// with two corners at one place have no inside and are left out. With no open and no torn edge the triangles'
/// boundary is zero as a chain, so a ray that comes from outside enters as often as it leaves.
pub fn edges(mesh: &Mesh) -> Edges {
    // Adding 0 turns −0 into +0.
    let key = |p: DVec3| (p + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut ids = HashMap::new();
    let vertices: Vec<usize> = mesh
        .positions
        .iter()
        .map(|p| {
            let fresh = ids.len();
            *ids.entry(key(*p)).or_insert(fresh)
        })
        .collect();
    // Lower vertex, higher vertex → uses upwards, uses downwards.
    let mut uses: HashMap<(usize, usize), [usize; 2]> = HashMap::new();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| vertices[i as usize]);
        if a == b || b == c || c == a {
            continue;
        }
        for (from, to) in [(a, b), (b, c), (c, a)] {
            uses.entry((from.min(to), from.max(to))).or_default()[usize::from(from > to)] += 1;
        }
    }
    let mut edges = Edges::default();
    for [up, down] in uses.into_values() {
        edges.open += usize::from(up + down == 1);
        edges.torn += usize::from(up + down > 1 && up != down);
    }
    edges
}

/// The number of edges that one triangle only uses: 0 for a closed mesh. See [`edges`].
pub fn open_edges(mesh: &Mesh) -> usize {
    edges(mesh).open
}

/// Volume in the file's units, negative where the triangles are wound inside out: Σ v₀·(v₁ × v₂)/6, by the
/// divergence theorem.
///
/// Taken about the vertices' mean, which only matters to rounding in a closed mesh; an open one has no volume,
/// and its sign tells what most of its surface faces, seen from there.
pub fn signed_volume(mesh: &Mesh) -> f64 {
    let middle = mesh.positions.iter().sum::<DVec3>() / mesh.positions.len().max(1) as f64;
    let volume = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|i| mesh.positions[i as usize] - middle);
        a.dot(b.cross(c)) / 6.0
    };
    mesh.triangles.iter().map(volume).sum()
}

/// Turns the mesh inside out: every triangle is wound the other way. Shading normals stay as they are: they
/// make a frame only, turned to the side of the geometric normal that the ray comes from.
pub fn flip(mesh: &mut Mesh) {
    for triangle in &mut mesh.triangles {
        triangle.swap(1, 2);
    }
}
