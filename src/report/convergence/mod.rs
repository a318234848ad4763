//! What `vkpt converge` found: a record, and the record as a table, as CSV and as a plot.

mod concerns;
mod csv;
pub mod plot;
mod record;
mod table;
mod variant;
mod words;

pub use concerns::concerns;
pub use csv::csv;
pub use plot::svg;
pub use record::{Convergence, ReferenceRecord};
pub use table::table;
pub use variant::{ErrorRecord, ReachRecord, StepRecord, Subject, VariantRecord};
