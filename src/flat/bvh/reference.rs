//! References of leaves to primitives.

use crate::prepared::{Prepared, ShapeKind};

/// Bits of a reference for the index; the two bits above are the kind.
pub const INDEX_BITS: u32 = 30;
pub const INDEX_MASK: u32 = (1 << INDEX_BITS) - 1;

const _: () = assert!(
    ShapeKind::EVERY.len() <= 1 << (32 - INDEX_BITS),
    "more kinds of shapes than a reference distinguishes: give the kind another bit"
);

/// Every primitive of a kind in `kinds`, in the order of `kinds`.
pub fn references(prepared: &Prepared, kinds: &[ShapeKind]) -> Vec<u32> {
    kinds
        .iter()
        .flat_map(|&kind| (0..prepared.primitives.count(kind)).map(move |i| encode(kind, i as u32)))
        .collect()
}

/// kind·2³⁰ + index; index < 2³⁰.
pub fn encode(kind: ShapeKind, index: u32) -> u32 {
    (kind as u32) << INDEX_BITS | index
}

/// The inverse of [`encode`].
pub fn decode(reference: u32) -> (ShapeKind, usize) {
    let kind = ShapeKind::EVERY[(reference >> INDEX_BITS) as usize];
    (kind, (reference & INDEX_MASK) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_decode_to_the_encoded_values() {
        for kind in ShapeKind::EVERY {
            for index in [0, 1, INDEX_MASK] {
                assert_eq!(decode(encode(kind, index)), (kind, index as usize));
            }
        }
    }
}
