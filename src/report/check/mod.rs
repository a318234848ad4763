//! What `vkpt check` found: a record, and the record as a table.

mod record;
mod table;

pub use record::{CaseRecord, Check, Held};
pub use table::{failures, table};
