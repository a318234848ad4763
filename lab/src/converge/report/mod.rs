//! The results of `vkpt converge`: a record, and the record as a table, as CSV, as a plot and as a page.

mod concerns;
mod csv;
pub mod page;
pub mod plot;
mod record;
mod table;
mod variant;
mod words;

pub use concerns::concerns;
pub use csv::csv;
pub use page::{Sheet, Shown, page};
pub use plot::svg;
pub use record::{Convergence, ReferenceRecord};
pub use table::table;
pub use variant::{ErrorRecord, ReachRecord, StepRecord, Subject, VariantRecord};
