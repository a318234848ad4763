//! Parts on disk: checkpoints of a rendering, and the part that it resumes from.

mod checkpoint;
mod digest;
mod resume;

pub use checkpoint::Checkpoint;
pub use digest::digest;
pub use resume::{hint, resumed};
