//! How fast pictures converge: statistics of the errors of several independent replicates of a rendering after 1, 2, 4,
//! … samples per pixel.
//!
//! Replicates are independent, so means over them have intervals (Student's t); comparisons within a replicate (two
//! steps of one rendering, two variants with the same seed) are paired.

mod curve;
mod figures;
mod floor;
mod interval;
mod ratio;
mod reach;
mod reference;
mod summary;

pub use curve::{Curve, Step};
pub use figures::{Figures, Metric};
pub use floor::{Floor, floor};
pub use interval::{Interval, LEVEL};
pub use ratio::{efficiency, ratio_of_efficiencies, slope};
pub use reach::{Reach, reach};
pub use reference::{Reference, STANDARD_ERRORS};
pub use summary::{Summary, median};
