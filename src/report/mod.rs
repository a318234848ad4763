//! The record of a finished rendering: as JSON, as a picture's header, and as lines to read.
//! Pure functions of records: nothing here measures or prints.

mod difference;
mod digest;
mod error;
mod header;
pub mod human;
pub mod names;
mod record;
mod settings;
mod summary;

pub use difference::Difference;
pub use digest::digest;
pub use header::{
    denoised_notes, differences, is_noted, layer_note, light_note, noted_digest, noted_freedom,
    notes, stderr_notes,
};
pub use record::{
    Denoised, Dropped, ErrorAt, Job, Kernel, Largest, Machine, Memory, Record, Seconds, Work,
};
pub use settings::SettingsRecord;
pub use summary::{concerns, summary};

/// The program's name and version.
pub const SOFTWARE: &str = concat!("vkpt ", env!("CARGO_PKG_VERSION"));
