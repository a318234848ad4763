//! Triangulates arbitrary polygons.

use glam::{DVec2, DVec3};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// The numbers of text files have six digits: a polygon that is no wider than this has no area.
const SIX_DIGITS: f64 = 1e-6;

/// Maximum number of corners of a fan.
const MOST_IN_A_FAN: usize = 32;

/// The message about a line with such a face.
pub(super) const CROSSES: &str = "is a face that crosses itself, cut it into triangles";

/// A polygon that crosses itself or is not planar.
#[derive(Debug)]
pub(super) struct Crossing;

/// Appends the triangles of a polygon with three or more corners, in its winding order.
///
/// A fan around the first corner, if that stays within the polygon, as it does where all corners are convex, and has
/// few triangles: those of a large fan all lie in each other's boxes. Otherwise the constrained Delaunay triangulation
/// of the polygon in its best-fitting plane. A boundary that touches itself, such as a bridge to a hole, is not a
/// crossing.
pub(super) fn cut(
    corners: &[u32],
    position: impl Fn(u32) -> DVec3,
    triangles: &mut Vec<[u32; 3]>,
) -> Result<(), Crossing> {
    if let &[a, b, c] = corners {
        triangles.push([a, b, c]);
        return Ok(());
    }
    let first = position(corners[0]);
    let from_first: Vec<DVec3> = corners.iter().map(|&i| position(i) - first).collect();
    let normal = normal(&from_first);
    let few = corners.len() <= MOST_IN_A_FAN;
    if has_no_area(&from_first) || few && normal.is_some_and(|n| fan_fits(&from_first, n)) {
        let pairs = corners[1..].windows(2);
        triangles.extend(pairs.map(|pair| [corners[0], pair[0], pair[1]]));
        return Ok(());
    }
    let (right, up) = normal.ok_or(Crossing)?.any_orthonormal_pair();
    let flat = from_first
        .iter()
        .map(|p| DVec2::new(p.dot(right), p.dot(up)));
    triangles.extend(delaunay(corners, flat)?);
    Ok(())
}

/// Twice the vector areas of the triangles of a fan around the first corner.
fn fan_areas(from_first: &[DVec3]) -> impl Iterator<Item = DVec3> {
    from_first[1..]
        .windows(2)
        .map(|pair| pair[0].cross(pair[1]))
}

/// The unit normal of the best-fitting plane of a polygon: n ∝ Σ pᵢ × pᵢ₊₁ (Newell; Sutherland, Sproull and Schumacker,
/// *A Characterization of Ten Hidden-Surface Algorithms*, 1974). `None` if the terms cancel.
fn normal(from_first: &[DVec3]) -> Option<DVec3> {
    let sum: DVec3 = fan_areas(from_first).sum();
    let parts: f64 = fan_areas(from_first).map(DVec3::length).sum();
    (sum.length() > SIX_DIGITS * parts).then(|| sum.normalize())
}

/// All corners are collinear.
fn has_no_area(from_first: &[DVec3]) -> bool {
    let extent = from_first.iter().map(|p| p.length_squared());
    let parts: f64 = fan_areas(from_first).map(DVec3::length).sum();
    parts <= SIX_DIGITS * extent.fold(0.0, f64::max)
}

/// Whether the fan around the first corner covers exactly the polygon: seen from that corner, the others are in order
/// and within half a turn.
fn fan_fits(from_first: &[DVec3], normal: DVec3) -> bool {
    let left_of =
        |a: DVec3, b: DVec3| a.cross(b).dot(normal) >= -SIX_DIGITS * a.length() * b.length();
    let start = from_first[1];
    let in_order = from_first[1..]
        .windows(2)
        .all(|pair| left_of(pair[0], pair[1]));
    in_order && from_first[2..].iter().all(|&p| left_of(start, p))
}

/// A corner of a polygon, projected into its plane.
struct Corner {
    vertex: u32,
    at: Point2<f64>,
}

impl HasPosition for Corner {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.at
    }
}

type Delaunay = ConstrainedDelaunayTriangulation<Corner>;

/// The triangles of the constrained Delaunay triangulation inside the polygon; spade's predicates are exact.
fn delaunay(corners: &[u32], flat: impl Iterator<Item = DVec2>) -> Result<Vec<[u32; 3]>, Crossing> {
    let mut delaunay = Delaunay::new();
    let mut handles = Vec::with_capacity(corners.len());
    for (&vertex, at) in corners.iter().zip(flat) {
        let at = spade::mitigate_underflow(Point2::new(at.x, at.y));
        let handle = delaunay.insert(Corner { vertex, at });
        handles.push(handle.map_err(|_| Crossing)?);
    }
    let passes = boundary(&mut delaunay, &handles)?;
    let turns = winding(&delaunay, &passes);
    if turns.iter().any(|turns| !(0..=1).contains(turns)) {
        return Err(Crossing);
    }
    let inside = delaunay
        .inner_faces()
        .filter(|face| turns[face.fix().index()] == 1);
    let triangles = inside.map(|face| face.vertices().map(|corner| corner.data().vertex));
    Ok(triangles.collect())
}

/// Inserts the polygon's sides as constraint edges; returns how often it passes along each directed edge.
fn boundary(delaunay: &mut Delaunay, handles: &[FixedVertexHandle]) -> Result<Vec<i32>, Crossing> {
    let mut passes = vec![0; delaunay.num_directed_edges()];
    let next = handles.iter().cycle().skip(1);
    for (&from, &to) in handles.iter().zip(next).filter(|(from, to)| from != to) {
        let edges = delaunay.try_add_constraint(from, to);
        if edges.is_empty() {
            return Err(Crossing);
        }
        edges.iter().for_each(|edge| passes[edge.index()] += 1);
    }
    Ok(passes)
}

/// The winding number of each face: crossing a side from right to left adds one.
fn winding(delaunay: &Delaunay, passes: &[i32]) -> Vec<i32> {
    let mut turns = vec![None; delaunay.num_all_faces()];
    let outer = delaunay.outer_face().fix();
    turns[outer.index()] = Some(0);
    let mut edges: Vec<_> = delaunay
        .directed_edges()
        .filter(|edge| edge.face().is_outer())
        .collect();
    while let Some(edge) = edges.pop() {
        let [left, right] = [edge, edge.rev()].map(|edge| edge.face());
        let known = turns[left.fix().index()].unwrap_or_default();
        let of_right = &mut turns[right.fix().index()];
        if of_right.is_none() {
            *of_right = Some(known - passes[edge.fix().index()] + passes[edge.rev().fix().index()]);
            edges.extend(
                right
                    .as_inner()
                    .iter()
                    .flat_map(|face| face.adjacent_edges()),
            );
        }
    }
    turns.into_iter().map(Option::unwrap_or_default).collect()
}
