//! Checks whether a mesh bounds a solid, which transmissive materials require (model.md, "Media").

use glam::DVec3;
use rayon::prelude::*;

use super::Mesh;

/// Edges that keep a mesh from bounding a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Edges {
    /// Used by only one triangle: the mesh has a hole there.
    pub open: usize,
    /// Used by more, but not equally often in both directions: neighbours are wound differently.
    pub torn: usize,
}

/// Counts the edges that keep the mesh from bounding a solid.
///
/// Vertices at exactly the same position count as one (files repeat a vertex that has several normals). Triangles with
/// two corners at one position have no inside and are ignored. If no edge is open or torn, the triangles' boundary is
/// zero as a chain, so a ray that comes from outside enters as often as it leaves.
pub fn edges(mesh: &Mesh) -> Edges {
    let places = places(&mesh.positions);
    // (lower place, higher place, whether it is used upwards): sorting puts the uses of an edge next to each other.
    let uses_of = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|i| places[i as usize]);
        let flat = a == b || b == c || c == a;
        let sides = if flat {
            None
        } else {
            Some([(a, b), (b, c), (c, a)])
        };
        let ordered = |(from, to): (u32, u32)| (from.min(to), from.max(to), from < to);
        sides.into_iter().flatten().map(ordered)
    };
    let mut uses: Vec<(u32, u32, bool)> =
        mesh.triangles.par_iter().flat_map_iter(uses_of).collect();
    uses.par_sort_unstable();
    let mut edges = Edges::default();
    for edge in uses.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let up = edge.iter().filter(|side| side.2).count();
        edges.open += usize::from(edge.len() == 1);
        edges.torn += usize::from(edge.len() > 1 && 2 * up != edge.len());
    }
    edges
}

/// The place number of each vertex: vertices at exactly the same position share one.
fn places(positions: &[DVec3]) -> Vec<u32> {
    // Adding 0 turns −0 into +0.
    let key = |i: u32| {
        (positions[i as usize] + DVec3::ZERO)
            .to_array()
            .map(f64::to_bits)
    };
    let mut order: Vec<u32> = (0..positions.len() as u32).collect();
    order.par_sort_unstable_by_key(|&i| key(i));
    let mut places = vec![0; positions.len()];
    for (place, vertices) in (0..).zip(order.chunk_by(|&a, &b| key(a) == key(b))) {
        vertices.iter().for_each(|&i| places[i as usize] = place);
    }
    places
}

/// The number of edges used by only one triangle: 0 for a closed mesh. See [`edges`].
pub fn open_edges(mesh: &Mesh) -> usize {
    edges(mesh).open
}

/// Volume in the file's units, negative if the triangles are wound inside out: Σ v₀·(v₁ × v₂)/6, by the divergence
/// theorem.
///
/// It is computed about the mean of the vertices, which only affects rounding in a closed mesh. An open mesh has no
/// volume; the sign then says which way most of its surface faces, seen from there.
pub fn signed_volume(mesh: &Mesh) -> f64 {
    let middle = mesh.positions.iter().sum::<DVec3>() / mesh.positions.len().max(1) as f64;
    let volume = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|i| mesh.positions[i as usize] - middle);
        a.dot(b.cross(c)) / 6.0
    };
    mesh.triangles.iter().map(volume).sum()
}

/// Turns the mesh inside out by reversing the winding of every triangle. Shading normals stay unchanged: they only
/// define a frame, which is turned to the side of the geometric normal that the ray comes from.
pub fn flip(mesh: &mut Mesh) {
    for triangle in &mut mesh.triangles {
        triangle.swap(1, 2);
    }
}
