//! The rows of PLY elements that are kept.

use glam::DVec3;

use super::declared::{Element, Kind, Property};
use super::source::{Fault, Source};

/// Names of the corner list of a face.
pub(super) const CORNERS: [&str; 2] = ["vertex_index", "vertex_indices"];

/// The numbers of a vertex that are kept: its position, then its normal.
const NUMBERS: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// The rows read so far; everything else is skipped.
#[derive(Default)]
pub(super) struct Rows {
    pub(super) positions: Vec<DVec3>,
    pub(super) normals: Vec<DVec3>,
    pub(super) faces: Lists,
    /// Triangle strips, separated by −1 within a row.
    pub(super) strips: Lists,
    /// Number of rows read of the current element.
    pub(super) read: usize,
}

/// Lists of corners.
#[derive(Default)]
pub(super) struct Lists {
    pub(super) corners: Vec<i64>,
    pub(super) rows: Vec<Row>,
}

/// A list; its corners begin at the end of the previous one's.
pub(super) struct Row {
    pub(super) end: usize,
    /// Counted from 1; 0 in binary.
    pub(super) line: usize,
}

impl Rows {
    /// Reads all rows of an element.
    pub(super) fn read(
        &mut self,
        source: &mut impl Source,
        element: &Element,
    ) -> Result<(), Fault> {
        let place = |p: &Property| NUMBERS.iter().position(|name| *name == p.name);
        let places: Vec<_> = element.properties.iter().map(place).collect();
        for row in 0..element.count {
            self.read = row;
            match &*element.name {
                "vertex" => {
                    let [x, y, z, nx, ny, nz] = vertex(source, element, &places)?;
                    self.positions.push(DVec3::new(x, y, z));
                    self.normals.push(DVec3::new(nx, ny, nz));
                }
                "face" => self.faces.read(source, element)?,
                "tristrips" => self.strips.read(source, element)?,
                _ => element
                    .properties
                    .iter()
                    .try_for_each(|property| skip(source, property))?,
            }
        }
        Ok(())
    }
}

impl Lists {
    fn read(&mut self, source: &mut impl Source, element: &Element) -> Result<(), Fault> {
        let mut line = 0;
        let own = element
            .properties
            .iter()
            .position(|p| CORNERS.contains(&&*p.name));
        for (i, property) in element.properties.iter().enumerate() {
            match property.kind {
                Kind::List { count, of } if own == Some(i) => {
                    let corners = length(source.whole(count)?, source)?;
                    line = source.line();
                    for _ in 0..corners {
                        self.corners.push(source.whole(of)?);
                    }
                }
                _ => skip(source, property)?,
            }
        }
        let end = self.corners.len();
        self.rows.push(Row { end, line });
        Ok(())
    }
}

/// The numbers of a row of vertices; 0 for missing properties.
fn vertex(
    source: &mut impl Source,
    element: &Element,
    places: &[Option<usize>],
) -> Result<[f64; 6], Fault> {
    let mut numbers = [0.0; 6];
    for (property, &place) in element.properties.iter().zip(places) {
        match (property.kind, place) {
            (Kind::Scalar(of), Some(place)) => numbers[place] = source.real(of)?,
            _ => skip(source, property)?,
        }
    }
    Ok(numbers)
}

fn skip(source: &mut impl Source, property: &Property) -> Result<(), Fault> {
    match property.kind {
        Kind::Scalar(of) => source.skip(of),
        Kind::List { count, of } => {
            let length = length(source.whole(count)?, source)?;
            (0..length).try_for_each(|_| source.skip(of))
        }
    }
}

/// The length of a list.
fn length(count: i64, source: &impl Source) -> Result<u64, Fault> {
    u64::try_from(count).map_err(|_| Fault::Line(source.line()))
}
