//! Vectors and indices out of buffers (glTF 2.0, section 3.6.2, *Accessors*): each stretch of bytes is checked before it is
//! read.

use std::borrow::Cow;

use glam::DVec3;
use gltf::json::accessor::{Accessor, ComponentType, Type};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root, buffer};

/// A document's accessors and the bytes that they read.
pub(super) struct Accessors<'a> {
    root: &'a Root,
    buffers: &'a [Cow<'a, [u8]>],
}

impl<'a> Accessors<'a> {
    pub(super) fn new(root: &'a Root, buffers: &'a [Cow<'a, [u8]>]) -> Self {
        Self { root, buffers }
    }

    /// Vectors of three; whole numbers too, as KHR_mesh_quantization allows.
    pub(super) fn vectors(&self, index: Index<Accessor>) -> Result<Vec<DVec3>, String> {
        let (accessor, kind) = self.get(index, Type::Vec3)?;
        let size = kind.size();
        let decode = |row: &[u8]| {
            let component = |i: usize| number(kind, accessor.normalized, &row[i * size..]);
            DVec3::new(component(0), component(1), component(2))
        };
        self.values(accessor, 3 * size, decode)
            .map_err(|what| within(index, &what))
    }

    /// Indices of vertices.
    pub(super) fn indices(&self, index: Index<Accessor>) -> Result<Vec<u32>, String> {
        let (accessor, kind) = self.get(index, Type::Scalar)?;
        if !is_index(kind) {
            return Err(within(index, "its numbers are no indices"));
        }
        self.values(accessor, kind.size(), |row| whole(kind, row))
            .map_err(|what| within(index, &what))
    }

    /// A number of elements, if there are as many bytes.
    fn limited(&self, count: u64) -> Result<usize, String> {
        let bytes: usize = self.buffers.iter().map(|bytes| bytes.len()).sum();
        match usize::try_from(count) {
            Ok(count) if count <= bytes => Ok(count),
            _ => Err(format!(
                "it claims {count} elements, and there are {bytes} bytes"
            )),
        }
    }

    fn get(
        &self,
        index: Index<Accessor>,
        asked: Type,
    ) -> Result<(&'a Accessor, ComponentType), String> {
        let accessor = self.root.get(index);
        let accessor = accessor.ok_or_else(|| within(index, "there is none"))?;
        match (&accessor.component_type, &accessor.type_) {
            (Checked::Valid(kind), Checked::Valid(found)) if *found == asked => {
                Ok((accessor, kind.0))
            }
            _ => Err(within(index, &format!("its elements are no {asked:?}"))),
        }
    }

    /// All elements, of `size` bytes each, with the sparse ones in place.
    fn values<T: Clone + Default>(
        &self,
        accessor: &Accessor,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<T>, String> {
        let count = self.limited(accessor.count.0)?;
        let offset = accessor.byte_offset.unwrap_or_default().0;
        let mut values: Vec<T> = match accessor.buffer_view {
            Some(view) => self.rows(view, offset, count, size)?.map(&decode).collect(),
            None if accessor.sparse.is_some() => vec![T::default(); count],
            None => return Err("it has no data".into()),
        };
        if let Some(sparse) = &accessor.sparse {
            let few = self.limited(sparse.count.0)?;
            let Checked::Valid(kind) = sparse.indices.component_type else {
                return Err("its sparse indices are of no known type".into());
            };
            let at = &sparse.indices;
            let places = self.rows(at.buffer_view, at.byte_offset.0, few, kind.0.size())?;
            let with = &sparse.values;
            let new = self.rows(with.buffer_view, with.byte_offset.0, few, size)?;
            for (place, new) in places.zip(new) {
                let place = whole(kind.0, place) as usize;
                let value = values.get_mut(place);
                *value.ok_or_else(|| format!("its sparse index {place} is out of range"))? =
                    decode(new);
            }
        }
        Ok(values)
    }

    /// `count` stretches of `size` bytes, from byte `offset` of a buffer view on.
    fn rows(
        &self,
        view: Index<buffer::View>,
        offset: u64,
        count: usize,
        size: usize,
    ) -> Result<impl Iterator<Item = &'a [u8]>, String> {
        let missing = || format!("there is no buffer view {}", view.value());
        let view = self.root.get(view).ok_or_else(missing)?;
        let stride = view.byte_stride.map_or(size, |stride| stride.0);
        let start = view.byte_offset.unwrap_or_default().0;
        let all = slice(
            self.buffers.get(view.buffer.value()),
            start,
            view.byte_length.0,
        )
        .and_then(|bytes| bytes.get(usize::try_from(offset).ok()?..));
        // The last element may be shorter than the stride.
        let needed = match count.checked_sub(1) {
            Some(last) => stride.checked_mul(last).and_then(|n| n.checked_add(size)),
            None => Some(0),
        };
        match (all, needed) {
            (Some(all), Some(needed)) if needed <= all.len() && stride >= size => {
                Ok((0..count).map(move |row| &all[row * stride..][..size]))
            }
            _ => Err(format!(
                "its {count} elements of {size} bytes reach beyond their buffer"
            )),
        }
    }
}

/// `length` bytes of a buffer from byte `start` on.
fn slice<'a>(buffer: Option<&'a Cow<'a, [u8]>>, start: u64, length: u64) -> Option<&'a [u8]> {
    let start = usize::try_from(start).ok()?;
    let end = start.checked_add(usize::try_from(length).ok()?)?;
    buffer?.get(start..end)
}

fn within(index: Index<Accessor>, what: &str) -> String {
    format!("accessor {}: {what}", index.value())
}

fn is_index(kind: ComponentType) -> bool {
    matches!(
        kind,
        ComponentType::U8 | ComponentType::U16 | ComponentType::U32
    )
}

/// The unsigned number at the start of `bytes`, which hold one; little endian.
fn whole(kind: ComponentType, bytes: &[u8]) -> u32 {
    let bytes = &bytes[..kind.size()];
    bytes
        .iter()
        .rev()
        .fold(0, |n, byte| n << 8 | u32::from(*byte))
}

/// The number at the start of `bytes`, which hold one; a normalised one lies in [0, 1] or [−1, 1]
/// (glTF 2.0, section 3.11, *Animations*, table of normalised integers).
fn number(kind: ComponentType, normalized: bool, bytes: &[u8]) -> f64 {
    let bits = whole(kind, bytes);
    let (value, most) = match kind {
        ComponentType::F32 => return f64::from(f32::from_bits(bits)),
        ComponentType::I8 => (f64::from(bits as u8 as i8), f64::from(i8::MAX)),
        ComponentType::U8 => (f64::from(bits), f64::from(u8::MAX)),
        ComponentType::I16 => (f64::from(bits as u16 as i16), f64::from(i16::MAX)),
        ComponentType::U16 => (f64::from(bits), f64::from(u16::MAX)),
        ComponentType::U32 => (f64::from(bits), f64::from(u32::MAX)),
    };
    match normalized {
        true => (value / most).max(-1.0),
        false => value,
    }
}
