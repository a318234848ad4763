//! References of leaves to primitives.

use crate::prepared::{Prepared, ShapeKind};

/// Bits of a reference that hold the index; the two above hold the kind.
pub const INDEX_BITS: u32 = 30;
pub const INDEX_MASK: u32 = (1 << INDEX_BITS) - 1;

/// Every primitive of a kind in `kinds`, in the order of `kinds`.
pub fn references(prepared: &Prepared, kinds: &[ShapeKind]) -> Vec<u32> {
    kinds
        .iter()
        .flat_map(|&kind| (0..count(prepared, kind)).map(move |i| encode(kind, i)))
        .collect()
}

/// Primitives of a kind.
fn count(prepared: &Prepared, kind: ShapeKind) -> u32 {
    let count = match kind {
        ShapeKind::Sphere => prepared.spheres.len(),
        ShapeKind::Box => prepared.boxes.len(),
        ShapeKind::Cylinder => prepared.cylinders.len(),
        ShapeKind::Mesh => prepared.triangles.len(),
    };
    count as u32
}

/// kind·2³⁰ + index; index < 2³⁰.
pub fn encode(kind: ShapeKind, index: u32) -> u32 {
    (kind as u32) << INDEX_BITS | index
}

/// The inverse of [`encode`].
pub fn decode(reference: u32) -> (ShapeKind, usize) {
    let kind = match reference >> INDEX_BITS {
        0 => ShapeKind::Sphere,
        1 => ShapeKind::Box,
        2 => ShapeKind::Cylinder,
        _ => ShapeKind::Mesh,
    };
    (kind, (reference & INDEX_MASK) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_decode_to_what_was_encoded() {
        for kind in ShapeKind::EVERY {
            for index in [0, 1, INDEX_MASK] {
                assert_eq!(decode(encode(kind, index)), (kind, index as usize));
            }
        }
    }
}
