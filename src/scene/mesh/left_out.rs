//! Counts the parts of a file that a reader omits, for its warnings.

use glam::DVec3;

use crate::scene::text::quote;

/// Counts of omitted parts.
#[derive(Clone, Debug, Default)]
pub(super) struct LeftOut {
    /// Faces with fewer than three corners.
    pub(super) faces: usize,
    /// Normals without a direction.
    pub(super) normals: usize,
    /// Corners that name a missing normal.
    pub(super) references: usize,
    /// Free-form curves and surfaces.
    pub(super) surfaces: usize,
    /// Number of lines that begin with an unknown word, and the first of them with its word.
    unknown: usize,
    first_unknown: Option<(usize, String)>,
}

impl LeftOut {
    /// Counts line `number`, which begins with `word`.
    pub(super) fn unknown(&mut self, number: usize, word: &str) {
        self.unknown += 1;
        self.first_unknown
            .get_or_insert_with(|| (number, quote(word)));
    }

    /// The normals of vertices, by [`unit_or_zero`]; counts those without a direction that triangles use.
    pub(super) fn directions(
        &mut self,
        normals: impl Iterator<Item = DVec3>,
        triangles: &[[u32; 3]],
    ) -> Vec<DVec3> {
        let units: Vec<DVec3> = normals.map(unit_or_zero).collect();
        if units.contains(&DVec3::ZERO) {
            let mut used = vec![false; units.len()];
            for corner in triangles.as_flattened() {
                used[*corner as usize] = true;
            }
            let without = units
                .iter()
                .zip(used)
                .filter(|(n, used)| *used && **n == DVec3::ZERO);
            self.normals += without.count();
        }
        units
    }

    /// One sentence for each kind.
    pub(super) fn warnings(&self) -> Vec<String> {
        let count = |n: usize, one: &str, more: &str| match n {
            0 => None,
            1 => Some(format!("1 {one}")),
            n => Some(format!("{n} {more}")),
        };
        let faces = count(
            self.faces,
            "face with fewer than three corners is skipped",
            "faces with fewer than three corners are skipped",
        );
        let normals = count(
            self.normals,
            "normal is zero or not finite: the faces' own normals are used there",
            "normals are zero or not finite: the faces' own normals are used there",
        );
        let references = count(
            self.references,
            "corner names a normal that the file lacks: the face's own normal is used there",
            "corners name normals that the file lacks: the faces' own normals are used there",
        );
        let surfaces = count(
            self.surfaces,
            "free-form curve or surface is skipped",
            "free-form curves and surfaces are skipped",
        );
        let unknown = (self.first_unknown.as_ref()).map(|(line, word)| match self.unknown {
            1 => format!("line {line} begins with the unknown word `{word}` and is skipped"),
            n => format!("{n} lines begin with unknown words and are skipped; the first is line {line}, `{word}`"),
        });
        let all = [faces, normals, references, surfaces, unknown];
        all.into_iter().flatten().collect()
    }
}

/// A normal in the scene's form: of unit length, or zero if the file's normal has no direction. Exporters write NaN or
/// zero for vertices of faces without area.
pub(super) fn unit_or_zero(normal: DVec3) -> DVec3 {
    match normal.is_finite() {
        true => normal.normalize_or_zero(),
        false => DVec3::ZERO,
    }
}
