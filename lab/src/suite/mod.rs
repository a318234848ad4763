//! The scenes of a folder, rendered and compared with the pictures that are kept of them: `vkpt test`.

pub mod command;
pub mod report;
