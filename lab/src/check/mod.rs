//! The battery of stiff and extreme cases: small pictures at the edges of what f32 holds, each rendered three times over
//! the same samples, by a device and by both references, and held against bounds that stand in the case with their reason.
//!
//! [`battery`] has the cases, a file a group below `cases`; [`measure`](measure::measure) runs one, [`judge`] holds it
//! against its bounds, [`run`](run::run) does so for many.

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
