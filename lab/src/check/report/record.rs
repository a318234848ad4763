//! The battery as a record; its JSON is `--json`'s file, field by field. Infinite values are `null` there.

use serde::Serialize;

/// The cases, the device, and the results.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    pub version: &'static str,
    pub device: String,
    pub driver: String,
    /// It must equal cpu-f32 in every bit, as CPU drivers must.
    pub correctly_rounded: bool,
    pub quick: bool,
    /// Level of each statistical statement, so that all of them together have the level `alpha`.
    pub level: f64,
    pub alpha: f64,
    pub seconds: f64,
    /// By ctrl-c, or by a case that could not run.
    pub interrupted: bool,
    pub passed: bool,
    pub cases: Vec<CaseRecord>,
}

/// One case.
#[derive(Clone, Debug, Serialize)]
pub struct CaseRecord {
    pub name: String,
    /// A description: what is stiff about it.
    pub about: String,
    pub samples: u64,
    /// Samples whose path the device and cpu-f64 decided differently.
    pub diverged: u64,
    /// Quantiles of the relative difference to cpu-f64 of the others; none if no path carries light.
    pub median: Option<f64>,
    pub p99: Option<f64>,
    pub worst: Option<f64>,
    /// Pixel and sample of the worst.
    pub worst_at: Option<[u32; 3]>,
    /// The first pixel and sample that diverged.
    pub diverged_at: Option<[u32; 3]>,
    pub nan: u64,
    pub infinite: u64,
    /// The largest contribution of one path.
    pub largest: f64,
    pub mean: f64,
    pub standard_error: f64,
    /// By a closed form, if one is known.
    pub expected: Option<f64>,
    pub seconds: f64,
    /// Warnings about the scene.
    pub warnings: Vec<String>,
    pub held: Vec<Held>,
    /// The largest margin of its bounds.
    pub margin: f64,
    pub passed: bool,
}

impl CaseRecord {
    /// The part of the name before the first slash.
    pub fn group(&self) -> &str {
        self.name.split('/').next().unwrap_or_default()
    }

    /// Samples that are NaN or infinite.
    pub fn broken(&self) -> u64 {
        self.nan + self.infinite
    }
}

/// A measured value and its bound.
#[derive(Clone, Debug, Serialize)]
pub struct Held {
    pub what: &'static str,
    pub measured: f64,
    pub bound: f64,
    /// measured/bound: above 1 it fails.
    pub margin: f64,
    /// The meaning of the value, and the reason for the bound.
    pub why: String,
}

impl Held {
    pub fn new(what: &'static str, measured: f64, bound: f64, why: impl Into<String>) -> Self {
        // A NaN exceeds every bound.
        let margin = match measured {
            0.0 => 0.0,
            m if m.is_nan() => f64::INFINITY,
            m => m / bound,
        };
        Self {
            what,
            measured,
            bound,
            margin,
            why: why.into(),
        }
    }

    pub fn passed(&self) -> bool {
        self.margin <= 1.0
    }
}
