//! What a device is like, as a record, and the record as a page to read.

mod page;
mod tables;
mod verdict;

use serde::Serialize;

pub use page::page;
pub use verdict::{Verdict, verdict};

/// All that was found.
#[derive(Clone, Debug, Serialize)]
pub struct Examination {
    pub verdict: Verdict,
    pub device: DeviceFacts,
    pub watchdog: Vec<String>,
    pub self_tests: Vec<SelfTest>,
    pub operations: Vec<Operation>,
    /// What the driver makes of arithmetic that may be rewritten; vkpt's never may.
    pub habits: Vec<Habit>,
    pub own_functions: Vec<OwnFunction>,
    pub driver_functions: Vec<DriverFunction>,
    pub costs: Vec<Cost>,
}

/// How something that was tried came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// As the reference does it, to the bit.
    Passes,
    /// Not as the reference does it, but as Vulkan allows.
    Differs,
    /// Wrong, and pictures depend on it.
    Fails,
    /// Wrong, and no kernel of vkpt's does it.
    Avoided,
}

/// What a device tells of itself.
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
    /// Nanoseconds a tick.
    pub timestamp_period: f32,
    pub float64: bool,
    pub int64: bool,
    pub float_controls: Option<FloatControls>,
    /// Steps after which the driver ends all loops of a subgroup, in silence.
    pub loop_limit: Option<u32>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub struct Heap {
    pub bytes: u64,
    pub device_local: bool,
}

/// What shaders may demand of 32-bit floats.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct FloatControls {
    pub denormals_kept: bool,
    pub denormals_flushed: bool,
    pub signed_zero_inf_nan_kept: bool,
    pub rounding_to_nearest: bool,
    pub rounding_to_zero: bool,
}

/// A small kernel whose results are known.
#[derive(Clone, Debug, Serialize)]
pub struct SelfTest {
    pub name: &'static str,
    pub outcome: Outcome,
    /// Invocations, and those of them whose result was wrong.
    pub invocations: u32,
    pub wrong: u32,
    /// What it stands for.
    pub stands_for: &'static str,
}

/// An operation held against the host's, bit by bit; a NaN equals any other.
#[derive(Clone, Debug, Serialize)]
pub struct Operation {
    pub name: &'static str,
    pub outcome: Outcome,
    pub compared: usize,
    /// Unequal results: of normal numbers, of or to a denormal, of or to NaN, an infinity or a zero of the other sign.
    pub unequal: usize,
    pub unequal_denormal: usize,
    pub unequal_special: usize,
    /// Largest error over normal numbers, in units of the last place, and what Vulkan allows; integers have none.
    pub worst_ulps: Option<f64>,
    pub allowed_ulps: Option<f64>,
    /// The first that differs.
    pub example: Option<String>,
}

/// Something that a driver may choose, and its choice.
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
    /// Results whose bits are not those of the reference in f32.
    pub unequal: u64,
    /// Largest error against f64 where argument and result are normal numbers, where, and the bound.
    pub worst_ulps: f64,
    pub worst_at: f32,
    pub bound_ulps: f64,
}

/// A function of GLSL's own, as the driver does it.
#[derive(Clone, Debug, Serialize)]
pub struct DriverFunction {
    pub name: &'static str,
    pub range: &'static str,
    /// Largest errors against f64, and where: units of the last place, absolute, relative.
    pub ulps: Worst,
    pub absolute: Worst,
    pub relative: Worst,
    /// What Vulkan allows, in words, and whether the driver keeps to it; `None`: it allows anything.
    pub allowed: &'static str,
    pub within: Option<bool>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    pub error: f64,
    pub at: f32,
}

/// What a call takes, over the whole device.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Cost {
    pub name: &'static str,
    /// What the driver's way is called.
    pub drivers_name: &'static str,
    /// Nanoseconds a call, the quickest of several rounds.
    pub own: f64,
    pub drivers: f64,
}
