//! The properties of a device, as a record, and the record as a page to read.

mod page;
mod tables;
mod verdict;

use serde::Serialize;

use crate::check::report::Check;

pub use page::{head, page};
pub use verdict::{Verdict, verdict};

/// All findings.
#[derive(Clone, Debug, Serialize)]
pub struct Examination {
    pub verdict: Verdict,
    pub device: DeviceFacts,
    pub watchdog: Vec<String>,
    pub self_tests: Vec<SelfTest>,
    pub operations: Vec<Operation>,
    pub own_functions: Vec<OwnFunction>,
    pub battery: Battery,
    /// How the driver compiles arithmetic that it may rewrite; vkpt's own it may not. This and the next two are `None` if not
    /// examined.
    pub habits: Option<Vec<Habit>>,
    pub driver_functions: Option<Vec<DriverFunction>>,
    pub costs: Option<Vec<Cost>>,
}

/// Cases of `vkpt check`.
#[derive(Clone, Debug, Serialize)]
pub struct Battery {
    #[serde(flatten)]
    pub check: Check,
    /// The error that ended the battery.
    pub error: Option<String>,
}

/// The outcome of a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// Equal to the reference, to the bit.
    Passes,
    /// Different from the reference, as Vulkan allows.
    Differs,
    /// Wrong, and pictures depend on it.
    Fails,
    /// Wrong, and no kernel of vkpt uses it.
    Avoided,
}

/// The device's own description.
#[derive(Clone, Debug, Serialize)]
pub struct DeviceFacts {
    pub name: String,
    pub driver: String,
    pub kind: String,
    pub vulkan: [u32; 3],
    /// Lanes that run together.
    pub subgroup: u32,
    pub group_size: [u32; 3],
    pub group_invocations: u32,
    pub group_count: [u32; 3],
    /// Bytes, as all sizes here.
    pub storage_buffer: u64,
    pub uniform_buffer: u64,
    pub allocation: u64,
    pub push_constants: u32,
    pub shared_memory: u32,
    pub storage_buffers: u32,
    pub uniform_buffers: u32,
    pub heaps: Vec<Heap>,
    /// Nanoseconds per tick.
    pub timestamp_period: f32,
    pub float64: bool,
    pub int64: bool,
    pub float_controls: Option<FloatControls>,
    /// Steps after which the driver silently ends all loops of a subgroup.
    pub loop_limit: Option<u32>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub struct Heap {
    pub bytes: u64,
    pub device_local: bool,
}

/// The behaviour of 32-bit floats that shaders may request.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct FloatControls {
    pub denormals_kept: bool,
    pub denormals_flushed: bool,
    pub signed_zero_inf_nan_kept: bool,
    pub rounding_to_nearest: bool,
    pub rounding_to_zero: bool,
}

/// A small kernel with known results.
#[derive(Clone, Debug, Serialize)]
pub struct SelfTest {
    pub name: &'static str,
    pub outcome: Outcome,
    /// Invocations, and those of them whose result was wrong.
    pub invocations: u32,
    pub wrong: u32,
    /// What it represents.
    pub stands_for: &'static str,
}

/// An operation compared with the host's, bit by bit; a NaN equals any other.
#[derive(Clone, Debug, Serialize)]
pub struct Operation {
    pub name: &'static str,
    pub outcome: Outcome,
    pub compared: usize,
    /// Unequal results: of normal numbers, of or to a denormal, of or to NaN, an infinity or a zero of the other sign.
    pub unequal: usize,
    pub unequal_denormal: usize,
    pub unequal_special: usize,
    /// Largest error over normal numbers, in units of the last place, and the error that Vulkan allows; integers have neither.
    pub worst_ulps: Option<f64>,
    pub allowed_ulps: Option<f64>,
    /// The first that differs.
    pub example: Option<String>,
}

/// Something that is the driver's choice, and the choice.
#[derive(Clone, Debug, Serialize)]
pub struct Habit {
    pub name: &'static str,
    pub choice: String,
}

/// A function of vkpt's own.
#[derive(Clone, Debug, Serialize)]
pub struct OwnFunction {
    pub name: &'static str,
    pub outcome: Outcome,
    pub range: &'static str,
    pub compared: u64,
    /// Results whose bits differ from the reference in f32.
    pub unequal: u64,
    /// Largest error compared with f64 where argument and result are normal numbers, its place, and the bound.
    pub worst_ulps: f64,
    pub worst_at: f32,
    pub bound_ulps: f64,
}

/// A GLSL function, as implemented by the driver.
#[derive(Clone, Debug, Serialize)]
pub struct DriverFunction {
    pub name: &'static str,
    pub range: &'static str,
    /// Largest errors compared with f64, and their places: units of the last place, absolute, relative.
    pub ulps: Worst,
    pub absolute: Worst,
    pub relative: Worst,
    /// The error that Vulkan allows, in words, and whether the driver complies; `None`: anything is allowed.
    pub allowed: &'static str,
    pub within: Option<bool>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    pub error: f64,
    pub at: f32,
}

/// The time of a call, over the whole device.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Cost {
    pub name: &'static str,
    /// The name of the driver's equivalent.
    pub drivers_name: &'static str,
    /// Nanoseconds per call, the quickest of several rounds.
    pub own: f64,
    pub drivers: f64,
}
