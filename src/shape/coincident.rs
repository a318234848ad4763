//! Coincident faces, as where a lamp is flush with a ceiling or a line is repeated in the file.
//!
//! Rounding cannot decide which of two such faces a ray meets first; the order of shapes decides (model.md, "Coincident
//! faces"). For each face the table lists the faces that may come before it; a hit does not count where one of them
//! does.

use std::ops::Range;

use super::ShapeKind;

crate::layout::record! {
    /// A face that coincides with another, in the list of that one.
    pub struct Coincidence {
        shape: uint,
        /// Triangle (index among all), face of a box, part of a cylinder, 0 for a sphere.
        prim: uint,
        /// `prepared::ShapeKind`.
        kind: uint as ShapeKind,
        /// Index of its primitive in the array of that kind.
        index: uint,
        /// 0: it comes first, so the other face is covered where both are. 1: two transmissive solids touch there, and
        /// light that leaves one enters the other.
        touches: uint,
        (pad0: uint),
        (pad1: uint),
        (pad2: uint),
    }
}

/// For each face of a scene, the faces that may come before it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coincidences {
    /// For each shape s the position p of its faces, then for each face the start of its list, then the end of the
    /// last: the list of primitive k of shape s is `list[faces[faces[s] + k]..faces[faces[s] + k + 1]]`, in wrapping
    /// arithmetic.
    pub faces: Vec<u32>,
    pub list: Vec<Coincidence>,
}

impl Coincidences {
    /// The faces that may come before primitive `prim` of `shape`.
    pub fn of(&self, shape: u32, prim: u32) -> &[Coincidence] {
        if self.list.is_empty() {
            return &[];
        }
        let face = self.faces[shape as usize].wrapping_add(prim) as usize;
        &self.list[self.faces[face] as usize..self.faces[face + 1] as usize]
    }

    /// No faces coincide.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The table for shapes with these face numbers. `list` has (shape, prim, entry), in any order.
    pub fn new(shapes: &[Range<u32>], mut list: Vec<(u32, u32, Coincidence)>) -> Self {
        list.sort_by_key(|&(shape, prim, c)| (shape, prim, c.shape, c.prim));
        let mut faces: Vec<u32> = vec![0; shapes.len()];
        let mut entries = list.iter().peekable();
        let mut begin = 0;
        for (s, numbers) in shapes.iter().enumerate() {
            faces[s] = (faces.len() as u32).wrapping_sub(numbers.start);
            for prim in numbers.clone() {
                faces.push(begin);
                while entries
                    .next_if(|e| (e.0, e.1) == (s as u32, prim))
                    .is_some()
                {
                    begin += 1;
                }
            }
        }
        faces.push(begin);
        Self {
            faces,
            list: list.into_iter().map(|e| e.2).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(shape: u32, prim: u32) -> Coincidence {
        Coincidence {
            shape,
            prim,
            kind: ShapeKind::Box,
            index: 0,
            touches: 0,
        }
    }

    #[test]
    fn each_face_has_its_own_list_in_order() {
        let list = vec![
            (1, 42, entry(0, 5)),
            (0, 2, entry(2, 1)),
            (1, 40, entry(0, 4)),
            (1, 42, entry(0, 1)),
        ];
        let table = Coincidences::new(&[0..6, 40..43, 0..6], list);
        assert_eq!(table.of(0, 2), [entry(2, 1)]);
        assert_eq!(table.of(1, 40), [entry(0, 4)]);
        assert_eq!(table.of(1, 42), [entry(0, 1), entry(0, 5)]);
        let others = (0..6)
            .map(|k| (0, k))
            .chain([(1, 41)])
            .chain((0..6).map(|k| (2, k)));
        for (shape, prim) in others.filter(|f| *f != (0, 2)) {
            assert_eq!(table.of(shape, prim), []);
        }
    }

    #[test]
    fn no_table_has_no_lists() {
        assert_eq!(Coincidences::default().of(7, 3), []);
    }
}
