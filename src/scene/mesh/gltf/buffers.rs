//! Buffers of meshes and skins: the chunk of a GLB, external files, embedded data.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use super::address::bytes_at;
use super::document::{Accessor, Buffer, Document};
use super::requirements::or_compressed;

/// The bytes of a document's buffers.
pub(super) struct Buffers<'a> {
    /// At least the declared length of each buffer; empty for a buffer that is not needed.
    bytes: Vec<Cow<'a, [u8]>>,
    /// The external files read.
    files: Vec<PathBuf>,
}

impl<'a> Buffers<'a> {
    /// Reads the buffers that are needed; others, such as those of pictures, may be missing. Errors are messages.
    pub(super) fn load(
        document: &Document,
        bin: Option<&'a [u8]>,
        folder: &Path,
    ) -> Result<Self, String> {
        let mut buffers = Self {
            bytes: vec![Cow::default(); document.buffers.len()],
            files: Vec::new(),
        };
        for (number, needed) in needed(document).into_iter().enumerate() {
            if needed {
                let buffer = &document.buffers[number];
                // Only the first buffer may be a GLB's chunk (glTF 2.0, section 4.4.3.3).
                let bin = bin.filter(|_| number == 0);
                let bytes = buffers
                    .of(buffer, bin, folder)
                    .map_err(|what| format!("its buffer {number} {what}"))?;
                buffers.bytes[number] = bytes;
            }
        }
        Ok(buffers)
    }

    fn of(
        &mut self,
        buffer: &Buffer,
        bin: Option<&'a [u8]>,
        folder: &Path,
    ) -> Result<Cow<'a, [u8]>, String> {
        let claimed = buffer.byte_length;
        let bytes: Cow<[u8]> = match (&buffer.uri, bin) {
            (Some(uri), _) => {
                let (bytes, file) = bytes_at(uri, claimed, folder)
                    .map_err(|reason| format!("cannot be read: {reason}"))?;
                self.files.extend(file);
                bytes.into()
            }
            (None, Some(bin)) => bin.into(),
            (None, None) => {
                let what = "has no data: no `uri`, and no binary chunk as in GLB";
                return Err(or_compressed(what.into(), &buffer.extensions));
            }
        };
        match bytes.len() {
            has if (has as u64) < claimed => Err(format!(
                "is truncated: it declares {claimed} bytes, but has {has}"
            )),
            _ => Ok(bytes),
        }
    }

    /// The bytes of a buffer that is needed. Errors are messages.
    pub(super) fn get(&self, number: usize) -> Result<&[u8], String> {
        let bytes = self.bytes.get(number);
        bytes
            .map(AsRef::as_ref)
            .ok_or_else(|| format!("buffer {number} does not exist"))
    }

    /// Total number of bytes.
    pub(super) fn total(&self) -> usize {
        self.bytes.iter().map(|bytes| bytes.len()).sum()
    }

    /// The external files that were read.
    pub(super) fn into_files(self) -> Vec<PathBuf> {
        self.files
    }
}

/// Whether each buffer is needed.
fn needed(document: &Document) -> Vec<bool> {
    let primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let of_meshes = primitives.flat_map(|p| p.attributes.values().chain(&p.indices));
    let of_skins = document
        .skins
        .iter()
        .filter_map(|skin| skin.inverse_bind_matrices.as_ref());
    let mut needed = vec![false; document.buffers.len()];
    let accessors = of_meshes
        .chain(of_skins)
        .filter_map(|i| document.accessors.get(*i));
    for view in accessors.flat_map(views) {
        let buffer = document.buffer_views.get(view).map(|view| view.buffer);
        if let Some(needed) = buffer.and_then(|buffer| needed.get_mut(buffer)) {
            *needed = true;
        }
    }
    needed
}

/// The buffer views of an accessor.
fn views(accessor: &Accessor) -> impl Iterator<Item = usize> {
    let sparse = accessor.sparse.as_ref();
    let sparse = sparse.map(|sparse| [sparse.indices.buffer_view, sparse.values.buffer_view]);
    accessor
        .buffer_view
        .into_iter()
        .chain(sparse.into_iter().flatten())
}
