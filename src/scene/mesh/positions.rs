//! Positions that are no finite numbers.

use glam::DVec3;

/// `positions`, if all that triangles have are finite in single precision; otherwise the first of those that are not.
///
/// Scanners write NaN where they saw nothing. Where no triangle is, any position will do: such a vertex is moved onto one
/// that is used.
pub(super) fn finite(
    mut positions: Vec<DVec3>,
    triangles: &[[u32; 3]],
) -> Result<Vec<DVec3>, usize> {
    let is_finite = |p: &DVec3| p.as_vec3().is_finite();
    if positions.iter().all(is_finite) {
        return Ok(positions);
    }
    let mut used = triangles.as_flattened().iter().map(|i| *i as usize);
    if let Some(bad) = used.clone().find(|i| !is_finite(&positions[*i])) {
        return Err(bad);
    }
    let somewhere = used.next().map_or(DVec3::ZERO, |i| positions[i]);
    let bad = positions.iter_mut().filter(|p| !is_finite(p));
    bad.for_each(|p| *p = somewhere);
    Ok(positions)
}
