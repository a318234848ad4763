//! The picture of one moment.

use std::sync::Arc;

use vkpt::film::Film;
use vkpt::render::ErrorAt;

/// A picture in progress, shared by all viewers.
#[derive(Debug)]
pub struct Snapshot {
    /// 1 is the first.
    pub number: u64,
    pub film: Film,
    /// Its first pixel's column and row in the full picture.
    pub origin: [u32; 2],
    /// Samples in every pixel.
    pub samples: u32,
    /// The error estimates so far.
    pub errors: Vec<ErrorAt>,
}

/// The pixels of a snapshot as a browser gets them: f32, R G B, row by row from the top. The browser runs on this machine, so
/// their bytes are in this machine's order.
#[derive(Clone, Debug)]
pub struct Pixels(pub Arc<Snapshot>);

impl AsRef<[u8]> for Pixels {
    fn as_ref(&self) -> &[u8] {
        bytemuck::cast_slice(&self.0.film.rgb)
    }
}
