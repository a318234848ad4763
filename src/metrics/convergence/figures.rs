//! One value per metric.

use serde::Serialize;

use crate::metrics::Trimmed;

/// A metric for the error of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    Mse,
    Rmse,
    RelMse,
    Smape,
    Flip,
}

impl Metric {
    /// All metrics with their names.
    pub const ALL: [(Self, &'static str); 5] = [
        (Self::Mse, "MSE"),
        (Self::Rmse, "RMSE"),
        (Self::RelMse, "relMSE"),
        (Self::Smape, "SMAPE"),
        (Self::Flip, "FLIP"),
    ];
}

/// A value for each metric.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Figures<T = Trimmed> {
    pub mse: T,
    pub rmse: T,
    pub rel_mse: T,
    pub smape: T,
    pub flip: T,
}

impl<T> Figures<T> {
    /// Computes the value of each metric by `f`; `None` if it is `None` for one of them.
    pub fn try_from_fn(f: impl Fn(Metric) -> Option<T>) -> Option<Self> {
        Some(Self {
            mse: f(Metric::Mse)?,
            rmse: f(Metric::Rmse)?,
            rel_mse: f(Metric::RelMse)?,
            smape: f(Metric::Smape)?,
            flip: f(Metric::Flip)?,
        })
    }

    pub fn of(&self, metric: Metric) -> &T {
        match metric {
            Metric::Mse => &self.mse,
            Metric::Rmse => &self.rmse,
            Metric::RelMse => &self.rel_mse,
            Metric::Smape => &self.smape,
            Metric::Flip => &self.flip,
        }
    }
}
