//! The battery of stiff and extreme cases: small pictures at the limits of f32, each rendered three times with the same
//! samples, by a device and by both references, and compared with the case's bounds, which have reasons.
//!
//! [`battery`] has the cases, a file a group below `cases`; [`measure`](measure::measure) runs one, [`judge`] compares
//! it with its bounds, [`run`](run::run) does so for many.

pub mod both;
pub mod bound;
pub mod case;
mod cases;
pub mod closed;
pub mod command;
pub mod judge;
pub mod measure;
pub mod picture;
pub mod report;
pub mod run;
pub mod select;

pub use case::{Case, Expectation, Stiffness};
pub use cases::battery;
