//! The results of `vkpt check`: a record, and the record as a table and as a page.

#[cfg(test)]
pub mod fixture;
pub mod page;
mod record;
mod table;
mod words;

pub use page::{Sheet, Shown, page};
pub use record::{CaseRecord, Check, Held};
pub use table::{failures, table};
pub use words::{decisive, margin, plain};
