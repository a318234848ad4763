//! Parts on disk: the one that a rendering leaves now and then, and the one that it goes on from.

mod checkpoint;
mod digest;
mod resume;

pub use checkpoint::Checkpoint;
pub use digest::digest;
pub use resume::{hint, resumed};
