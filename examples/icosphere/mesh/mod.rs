//! Displaced icospheres: closed meshes of 20 f² triangles, the same to the bit on every machine.
//!
//! Each face of an icosahedron is cut into f² triangles, whose corners are pushed onto the unit sphere and then along
//! the radius by [`noise`]. Only + − × ÷ √ are used, and sums have one order.

mod noise;
pub mod ply;

use std::collections::HashMap;

use glam::DVec3;

/// A closed mesh around the origin, wound so that its normals point out; every ray from there meets it once.
pub struct Icosphere {
    /// 10 f² + 2 of them: neighbouring triangles share theirs.
    pub positions: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
}

/// The frequency whose 20 f² comes nearest to a number of triangles; at least 1.
pub fn frequency(triangles: u32) -> u32 {
    (f64::from(triangles) / 20.0).sqrt().round().max(1.0) as u32
}

impl Icosphere {
    /// The icosphere of frequency `f` ≥ 1 and radius 1, displaced by at most `displace` < 1; `seed` picks the bumps.
    pub fn new(f: u32, displace: f64, seed: u64) -> Self {
        let corners = corners();
        let mut vertices = Vertices {
            known: HashMap::new(),
            positions: Vec::new(),
            displaced: |p: DVec3| p * (1.0 + displace * noise::fractal(p, seed)),
        };
        let mut triangles = Vec::with_capacity(20 * f as usize * f as usize);
        for [a, b, c] in faces(&corners) {
            let mut at = |i: u32, j: u32| vertices.at(&corners, [(a, f - i - j), (b, i), (c, j)]);
            for i in 0..f {
                for j in 0..f - i {
                    triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                    if i + j + 1 < f {
                        triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                    }
                }
            }
        }
        Self {
            positions: vertices.positions,
            triangles,
        }
    }

    /// The corners of the triangles.
    pub fn corners(&self) -> Vec<[DVec3; 3]> {
        let corners = |t: &[u32; 3]| t.map(|i| self.positions[i as usize]);
        self.triangles.iter().map(corners).collect()
    }

    /// A unit normal for each vertex: the mean over its triangles, weighted by their areas.
    pub fn normals(&self) -> Vec<DVec3> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (triangle, [a, b, c]) in self.triangles.iter().zip(self.corners()) {
            // Its length is twice the area.
            let n = (b - a).cross(c - a);
            triangle.iter().for_each(|i| sums[*i as usize] += n);
        }
        sums.into_iter().map(DVec3::normalize).collect()
    }
}

/// The vertices so far, by the weights of the icosahedron's corners in them.
struct Vertices<F> {
    known: HashMap<[(usize, u32); 3], u32>,
    positions: Vec<DVec3>,
    displaced: F,
}

impl<F: Fn(DVec3) -> DVec3> Vertices<F> {
    /// The vertex with these weights of corners, the same to the bit from every face.
    fn at(&mut self, corners: &[DVec3; 12], weights: [(usize, u32); 3]) -> u32 {
        let mut key = weights.map(|(i, w)| if w == 0 { (corners.len(), 0) } else { (i, w) });
        key.sort_unstable();
        *self.known.entry(key).or_insert_with(|| {
            let used = key.iter().filter(|(_, weight)| *weight > 0);
            let p: DVec3 = used.map(|(i, w)| corners[*i] * f64::from(*w)).sum();
            self.positions.push((self.displaced)(p.normalize()));
            (self.positions.len() - 1) as u32
        })
    }
}

/// The corners of an icosahedron: (0, ±1, ±φ) and their rotations, φ = (1 + √5)/2.
fn corners() -> [DVec3; 12] {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let mut corners = [DVec3::ZERO; 12];
    for (i, [y, z]) in [[1.0, phi], [1.0, -phi], [-1.0, phi], [-1.0, -phi]]
        .into_iter()
        .enumerate()
    {
        corners[3 * i] = DVec3::new(0.0, y, z);
        corners[3 * i + 1] = DVec3::new(z, 0.0, y);
        corners[3 * i + 2] = DVec3::new(y, z, 0.0);
    }
    corners
}

/// Its twenty faces, seen from outside counter-clockwise.
fn faces(corners: &[DVec3; 12]) -> Vec<[usize; 3]> {
    // Neighbouring corners are 2 apart; no other two are nearer than 2φ.
    let near = |a: usize, b: usize| corners[a].distance(corners[b]) < 2.5;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in (a + 1..12).filter(|b| near(a, *b)) {
            for c in (b + 1..12).filter(|c| near(a, *c) && near(b, *c)) {
                let outward = corners[a].cross(corners[b]).dot(corners[c]) > 0.0;
                faces.push(if outward { [a, b, c] } else { [a, c, b] });
            }
        }
    }
    faces
}
