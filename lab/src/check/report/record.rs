//! The battery as a record; its JSON is `--json`'s file, field by field. What is infinite is `null` there.

use serde::Serialize;

/// What ran, where, what came out.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    pub version: &'static str,
    pub device: String,
    pub driver: String,
    /// A CPU driver: it must equal cpu-f32 in every bit.
    pub correctly_rounded: bool,
    pub quick: bool,
    /// Level of each statistical statement, so that all of them together have that of `alpha`.
    pub level: f64,
    pub alpha: f64,
    pub seconds: f64,
    /// By ctrl-c, or by a case that could not be run.
    pub interrupted: bool,
    pub passed: bool,
    pub cases: Vec<CaseRecord>,
}

/// One case.
#[derive(Clone, Debug, Serialize)]
pub struct CaseRecord {
    pub name: String,
    /// What is stiff about it.
    pub about: String,
    pub samples: u64,
    /// Samples whose path the device and cpu-f64 decided differently.
    pub parted: u64,
    /// Quantiles of the relative difference to cpu-f64 of the others; none where no path brings light.
    pub median: Option<f64>,
    pub p99: Option<f64>,
    pub worst: Option<f64>,
    /// Pixel and sample of the worst.
    pub worst_at: Option<[u32; 3]>,
    /// The first pixel and sample that parted.
    pub parted_at: Option<[u32; 3]>,
    pub nan: u64,
    pub infinite: u64,
    /// The most that one path brings.
    pub largest: f64,
    pub mean: f64,
    pub standard_error: f64,
    /// By a closed form, where there is one.
    pub expected: Option<f64>,
    pub seconds: f64,
    /// What is warned of at load.
    pub warnings: Vec<String>,
    pub held: Vec<Held>,
    /// The largest of what it is held against.
    pub margin: f64,
    pub passed: bool,
}

impl CaseRecord {
    /// The part of the name before the first slash.
    pub fn group(&self) -> &str {
        self.name.split('/').next().unwrap_or_default()
    }

    /// Samples that are no number, or an infinite one.
    pub fn broken(&self) -> u64 {
        self.nan + self.infinite
    }
}

/// Something measured, held against its bound.
#[derive(Clone, Debug, Serialize)]
pub struct Held {
    pub what: &'static str,
    pub measured: f64,
    pub bound: f64,
    /// measured/bound: above 1 it fails.
    pub margin: f64,
    /// What it is and where the bound comes from.
    pub why: String,
}

impl Held {
    pub fn new(what: &'static str, measured: f64, bound: f64, why: impl Into<String>) -> Self {
        // A NaN is below no bound.
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
