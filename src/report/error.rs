//! The last line of a rendering: samples, time, rate and error.

use super::human::{count, duration};
use super::{ErrorAt, Record};

/// `256 spp · 12.3 s (600 ms compile) · 2.50 M samples/s · relMSE 3.1e-3 (95 %: 2.8–3.5e-3)`
pub fn bought(record: &Record) -> String {
    let seconds = &record.seconds;
    let mut parts = vec![
        format!("{} spp", record.job.spp),
        time(seconds.compile, seconds.render),
    ];
    if let Some(rate) = record.work.samples_per_s {
        parts.push(format!("{} samples/s", count(rate)));
    }
    parts.extend(record.error.last().map(rel_mse));
    let integrator = &record.job.settings.integrator;
    parts.extend(
        record
            .job
            .auto
            .as_ref()
            .map(|why| format!("{integrator} by auto: {why}")),
    );
    let device = &record.machine.device;
    parts.extend(
        record
            .machine
            .device_auto
            .as_ref()
            .map(|why| format!("on {device}, {why}")),
    );
    parts.join(" · ")
}

fn time(compile: f64, render: f64) -> String {
    let all = duration(compile + render);
    match compile >= 0.001 {
        true => format!("{all} ({} compile)", duration(compile)),
        false => all,
    }
}

fn rel_mse(error: &ErrorAt) -> String {
    let interval = error.low.zip(error.high);
    match (error.rel_mse, interval) {
        (None, _) => "relMSE unknown".to_owned(),
        (Some(0.0), _) => "relMSE 0".to_owned(),
        (Some(estimate), None) => format!("relMSE {estimate:.1e}?{}", culprits(error)),
        (Some(estimate), Some(ends)) => with_interval(estimate, ends.into()),
    }
}

/// ` (half of it in 3 pixels, the worst 12,40)`
fn culprits(error: &ErrorAt) -> String {
    match (error.half_in_pixels, error.worst_pixel) {
        (Some(1), Some([x, y])) => format!(" (half of it in pixel {x},{y})"),
        (Some(n), Some([x, y])) => format!(" (half of it in {n} pixels, the worst {x},{y})"),
        _ => String::new(),
    }
}

/// All three as multiples of one power of ten, with as many decimals as the interval is wide.
fn with_interval(estimate: f64, [low, high]: [f64; 2]) -> String {
    let exponent = estimate.log10().floor() as i32;
    let unit = 10f64.powi(exponent);
    let decimals = match (high - low) / unit {
        width if width >= 0.2 => 1,
        width if width >= 0.02 => 2,
        _ => 3,
    };
    let number = |x: f64| format!("{:.decimals$}", x / unit);
    let [estimate, low, high] = [estimate, low, high].map(number);
    format!("relMSE {estimate}e{exponent} (95 %: {low}–{high}e{exponent})")
}
