//! Non-finite positions.

use glam::DVec3;

/// `positions`, if all positions that triangles use are finite in single precision; otherwise the index of the first
/// that is not.
///
/// Scanners write NaN where they measured nothing. The position of an unused vertex does not matter: a non-finite one
/// is moved onto a used vertex.
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
