//! Reads vectors and indices from buffers (glTF 2.0, section 3.6.2, *Accessors*); every byte range is checked first.

use std::array;

use super::buffers::Buffers;
use super::component::Component;
use super::document::{Accessor, Document, Sparse};
use super::requirements::or_compressed;

/// A document's accessors and the bytes behind them.
pub(super) struct Accessors<'a> {
    pub(super) document: &'a Document,
    pub(super) buffers: &'a Buffers<'a>,
}

impl Accessors<'_> {
    /// Vectors of N numbers; integers too, as KHR_mesh_quantization allows.
    pub(super) fn vectors<const N: usize>(&self, index: usize) -> Result<Vec<[f64; N]>, String> {
        let (accessor, kind) = self.get::<N>(index)?;
        let decode = |bytes: &[u8]| kind.number(accessor.normalized, bytes);
        self.elements(accessor, kind, decode)
            .map_err(|what| within(index, &what))
    }

    /// Vectors of N indices of vertices or joints.
    pub(super) fn indices<const N: usize>(&self, index: usize) -> Result<Vec<[u32; N]>, String> {
        let (accessor, kind) = self.get::<N>(index)?;
        if !kind.is_index() {
            return Err(within(index, "its numbers are not indices"));
        }
        self.elements(accessor, kind, |bytes| kind.whole(bytes))
            .map_err(|what| within(index, &what))
    }

    /// The index that no vertex may have: the maximum of its type (glTF 2.0, section 3.7.2.1, *Overview*).
    pub(super) fn no_index(&self, index: usize) -> Option<u32> {
        let kind = Component::of(self.document.accessors.get(index)?.component_type);
        Some(kind.ok()?.all_ones())
    }

    /// An accessor of vectors of N, and the type of their components.
    fn get<const N: usize>(&self, index: usize) -> Result<(&Accessor, Component), String> {
        let accessor = self.document.accessors.get(index);
        let accessor = accessor.ok_or_else(|| within(index, "it does not exist"))?;
        let asked = match N {
            1 => "SCALAR",
            3 => "VEC3",
            4 => "VEC4",
            _ => "MAT4",
        };
        if accessor.kind != asked {
            return Err(within(index, &format!("its elements are not {asked}")));
        }
        let kind = Component::of(accessor.component_type).map_err(|what| within(index, &what))?;
        Ok((accessor, kind))
    }

    /// All elements, with sparse substitutions applied.
    fn elements<T: Copy + Default, const N: usize>(
        &self,
        accessor: &Accessor,
        kind: Component,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<[T; N]>, String> {
        let size = kind.size();
        let decode = |row: &[u8]| array::from_fn(|i| decode(&row[i * size..]));
        let count = self.limited(accessor.count)?;
        let mut elements: Vec<[T; N]> = match accessor.buffer_view {
            Some(view) => self
                .rows(view, accessor.byte_offset, count, N * size)?
                .map(decode)
                .collect(),
            None if accessor.sparse.is_some() => vec![[T::default(); N]; count],
            None => return Err("it has no data".into()),
        };
        if let Some(sparse) = &accessor.sparse {
            for (place, row) in self.sparse(sparse, N * size)? {
                let element = elements.get_mut(place);
                *element.ok_or_else(|| format!("its sparse index {place} is out of range"))? =
                    decode(row);
            }
        }
        Ok(elements)
    }

    /// The indices of sparse elements and their bytes, `size` each.
    fn sparse(
        &self,
        sparse: &Sparse,
        size: usize,
    ) -> Result<impl Iterator<Item = (usize, &[u8])>, String> {
        let count = self.limited(sparse.count)?;
        let (at, with) = (&sparse.indices, &sparse.values);
        let kind = Component::of(at.component_type)
            .ok()
            .filter(|kind| kind.is_index());
        let kind = kind.ok_or("its sparse indices are not of an index type")?;
        let places = self.rows(at.buffer_view, at.byte_offset, count, kind.size())?;
        let rows = self.rows(with.buffer_view, with.byte_offset, count, size)?;
        Ok(places
            .map(move |place| kind.whole(place) as usize)
            .zip(rows))
    }

    /// `count` rows of `size` bytes, from byte `offset` of a buffer view.
    fn rows(
        &self,
        index: usize,
        offset: Option<u64>,
        count: usize,
        size: usize,
    ) -> Result<impl Iterator<Item = &[u8]> + use<'_>, String> {
        let view = self.document.buffer_views.get(index);
        let view = view.ok_or_else(|| format!("buffer view {index} does not exist"))?;
        let buffer = self.buffers.get(view.buffer)?;
        // Some exporters write a stride of 0 for packed elements.
        let stride = view
            .byte_stride
            .filter(|stride| *stride != 0)
            .unwrap_or(size);
        if stride < size {
            return Err(format!(
                "its elements of {size} bytes are only {stride} bytes apart"
            ));
        }
        let bytes = slice(
            buffer,
            view.byte_offset.unwrap_or(0),
            Some(view.byte_length),
        )
        .and_then(|view| slice(view, offset.unwrap_or(0), None));
        // The last element may be shorter than the stride.
        let needed = match count.checked_sub(1) {
            Some(last) => stride.checked_mul(last).and_then(|n| n.checked_add(size)),
            None => Some(0),
        };
        match (bytes, needed) {
            (Some(bytes), Some(needed)) if needed <= bytes.len() => {
                Ok((0..count).map(move |row| &bytes[row * stride..][..size]))
            }
            _ => {
                let what =
                    format!("its {count} elements of {size} bytes reach beyond their buffer");
                Err(or_compressed(what, &view.extensions))
            }
        }
    }

    /// A number of elements, if there are enough bytes.
    fn limited(&self, count: u64) -> Result<usize, String> {
        let bytes = self.buffers.total();
        match usize::try_from(count) {
            Ok(count) if count <= bytes => Ok(count),
            _ => Err(format!(
                "it declares {count} elements, but there are only {bytes} bytes"
            )),
        }
    }
}

/// `length` bytes from byte `start`, by default all that follow.
fn slice(bytes: &[u8], start: u64, length: Option<u64>) -> Option<&[u8]> {
    let rest = bytes.get(usize::try_from(start).ok()?..)?;
    match length {
        Some(length) => rest.get(..usize::try_from(length).ok()?),
        None => Some(rest),
    }
}

fn within(index: usize, what: &str) -> String {
    format!("accessor {index}: {what}")
}
