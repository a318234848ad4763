//! What `vkpt converge` found: a record, and the record as a table and as CSV.

mod csv;
mod record;
mod table;
mod variant;

pub use csv::csv;
pub use record::{Convergence, ReferenceRecord};
pub use table::table;
pub use variant::{ErrorRecord, ReachRecord, StepRecord, Subject, VariantRecord};
