//! What a rendering did, as a record, and the record as JSON, as a picture's header, as lines to
//! read and as pages.
//! Pure functions of records: nothing here measures or prints.

pub mod check;
mod comparison;
pub mod convergence;
mod digest;
pub mod doctor;
mod error;
pub mod explanation;
mod header;
pub mod human;
pub mod names;
mod page;
mod record;
mod settings;
pub mod suite;
mod summary;
mod table;

pub use comparison::{Comparison, Tested, comparison};
pub use digest::digest;
pub use header::{
    denoised_notes, differences, is_noted, layer_note, light_note, noted_digest, noted_freedom,
    notes, stderr_notes,
};
pub use page::COLOURS;
pub use record::{
    Denoised, Dropped, ErrorAt, Job, Kernel, Largest, Machine, Memory, Record, Seconds, Work,
};
pub use settings::SettingsRecord;
pub use summary::{concerns, summary};

/// The program's name and version.
pub const SOFTWARE: &str = concat!("vkpt ", env!("CARGO_PKG_VERSION"));
