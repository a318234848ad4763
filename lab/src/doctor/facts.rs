//! The device's own description, and known watchdogs.

use crate::doctor::report::{DeviceFacts, FloatControls, Heap};
use vkpt::gpu::{Device, DeviceKind, GpuError, Options};
use vkpt::render::DISPATCH_TIME;
use vkpt::report::human::{duration, thousands};

/// As the device reports them, except the loop limit, which is probed.
pub fn facts(device: &Device) -> Result<DeviceFacts, GpuError> {
    let (info, limits, facts) = (device.info(), device.limits(), device.facts());
    let heap = |h: &vkpt::gpu::Heap| Heap {
        bytes: h.bytes,
        device_local: h.device_local,
    };
    Ok(DeviceFacts {
        name: info.name.clone(),
        driver: info.driver.clone(),
        kind: info.kind.to_string(),
        vulkan: info.vulkan,
        subgroup: limits.subgroup,
        group_size: limits.group_size,
        group_invocations: limits.group_invocations,
        group_count: limits.group_count,
        storage_buffer: limits.storage_buffer,
        uniform_buffer: limits.uniform_buffer,
        allocation: limits.allocation,
        push_constants: limits.push_constants,
        shared_memory: facts.shared_memory,
        storage_buffers: limits.storage_buffers,
        uniform_buffers: limits.uniform_buffers,
        heaps: facts.heaps.iter().map(heap).collect(),
        timestamp_period: limits.timestamp_period,
        float64: facts.float64,
        int64: facts.int64,
        float_controls: facts.float_controls.map(|c| FloatControls {
            denormals_kept: c.denormals_kept,
            denormals_flushed: c.denormals_flushed,
            signed_zero_inf_nan_kept: c.signed_zero_inf_nan_kept,
            rounding_to_nearest: c.rounding_to_nearest,
            rounding_to_zero: c.rounding_to_zero,
        }),
        loop_limit: device.loop_limit()?,
    })
}

/// Limits that end long work, as documented or observed.
pub fn watchdog(device: &Device) -> Result<Vec<String>, GpuError> {
    let loops = match device.loop_limit()? {
        None => "The driver ended no loop early.".to_owned(),
        Some(limit) => format!(
            "The driver silently ends all loops of a subgroup after {} steps. vkpt's kernels count their steps and \
             pass unfinished paths to the next dispatch before that.",
            thousands(limit.into())
        ),
    };
    let kind = match device.info().kind {
        DeviceKind::Cpu => {
            "No watchdog is known for CPU drivers: dispatches of 40 s have completed."
        }
        _ => {
            "Documented watchdogs: Windows resets a GPU after 2 s (TdrDelay), Linux' amdgpu after 10 s, in older \
             versions later for compute (amdgpu.lockup_timeout)."
        }
    };
    let ours = format!(
        "vkpt sizes its dispatches to take {}, and treats a device as hung after {}.",
        duration(DISPATCH_TIME.as_secs_f64()),
        duration(Options::default().patience.as_secs_f64())
    );
    Ok(vec![loops, kind.to_owned(), ours])
}
