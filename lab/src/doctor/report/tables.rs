//! The sections of the page.

use super::{
    Battery, Cost, DeviceFacts, DriverFunction, Habit, Operation, Outcome, OwnFunction, SelfTest,
};
use crate::check::report::{CaseRecord, decisive, margin};
use crate::table::{columns, hanging};
use vkpt::report::human::{bytes, duration, thousands};

pub fn device(d: &DeviceFacts) -> String {
    let [major, minor, patch] = d.vulkan;
    let heap = |h: &super::Heap| {
        let whose = if h.device_local { "device" } else { "host" };
        format!("{} ({whose})", bytes(h.bytes))
    };
    let heaps: Vec<String> = d.heaps.iter().map(heap).collect();
    let rows = [
        (
            "driver",
            format!("{}, Vulkan {major}.{minor}.{patch}, {}", d.driver, d.kind),
        ),
        ("subgroup", format!("{} lanes", d.subgroup)),
        (
            "workgroup",
            format!(
                "{} invocations, at most {} in x, y, z",
                d.group_invocations,
                by(d.group_size)
            ),
        ),
        ("dispatch", format!("{} workgroups", by(d.group_count))),
        (
            "storage buffers",
            format!(
                "{} per kernel, {} each",
                thousands(d.storage_buffers.into()),
                bytes(d.storage_buffer)
            ),
        ),
        (
            "uniform buffers",
            format!(
                "{} per kernel, {} each",
                thousands(d.uniform_buffers.into()),
                bytes(d.uniform_buffer)
            ),
        ),
        ("push constants", bytes(d.push_constants.into())),
        ("shared memory", bytes(d.shared_memory.into())),
        (
            "memory",
            format!(
                "{}; one allocation: {}",
                heaps.join(", "),
                bytes(d.allocation)
            ),
        ),
        ("clock", format!("{} ns per tick", d.timestamp_period)),
        (
            "double, int64_t",
            format!("{}, {}", yes(d.float64), yes(d.int64)),
        ),
        ("float controls", float_controls(d)),
    ];
    rows.iter()
        .map(|(name, value)| hanging(&format!("  {name:<16}  "), value))
        .collect()
}

fn by(n: [u32; 3]) -> String {
    n.map(|n| thousands(n.into())).join(" × ")
}

fn yes(is: bool) -> &'static str {
    if is { "yes" } else { "no" }
}

fn float_controls(d: &DeviceFacts) -> String {
    let Some(c) = d.float_controls else {
        return "not reported by Vulkan 1.1".to_owned();
    };
    let all = [
        (c.denormals_kept, "denormals kept"),
        (c.denormals_flushed, "denormals flushed"),
        (c.signed_zero_inf_nan_kept, "−0, ∞ and NaN kept"),
        (c.rounding_to_nearest, "rounding to nearest"),
        (c.rounding_to_zero, "rounding to zero"),
    ];
    let named: Vec<&str> = all
        .iter()
        .filter(|(is, _)| *is)
        .map(|(_, name)| *name)
        .collect();
    if named.is_empty() {
        "none".to_owned()
    } else {
        named.join(", ")
    }
}

fn word(outcome: Outcome) -> String {
    match outcome {
        Outcome::Passes => "passes",
        Outcome::Differs => "differs",
        Outcome::Fails => "FAILS",
        Outcome::Avoided => "fails, avoided",
    }
    .to_owned()
}

pub fn self_tests(tests: &[SelfTest]) -> String {
    let row = |t: &SelfTest| {
        let (wrong, of) = (thousands(t.wrong.into()), thousands(t.invocations.into()));
        let finding = match t.wrong {
            0 => t.stands_for.to_owned(),
            _ => format!("{wrong} of {of} results are wrong"),
        };
        [t.name.to_owned(), word(t.outcome), finding]
    };
    let rows: Vec<[String; 3]> = tests.iter().map(row).collect();
    columns(&rows, [false; 3])
}

pub fn operations(operations: &[Operation]) -> String {
    let head = [
        "",
        "",
        "results",
        "normal",
        "denormal",
        "NaN, ∞, −0",
        "ulp",
        "allowed",
    ]
    .map(str::to_owned);
    let count = |n: usize| {
        if n == 0 {
            "–".to_owned()
        } else {
            thousands(n as u64)
        }
    };
    let row = |o: &Operation| {
        [
            o.name.to_owned(),
            word(o.outcome),
            thousands(o.compared as u64),
            count(o.unequal),
            count(o.unequal_denormal),
            count(o.unequal_special),
            o.worst_ulps.map_or(String::new(), units),
            o.allowed_ulps.map_or(String::new(), |u| format!("{u}")),
        ]
    };
    let rows: Vec<[String; 8]> = std::iter::once(head)
        .chain(operations.iter().map(row))
        .collect();
    let examples = operations.iter().filter_map(|o| {
        Some(hanging(
            "  ",
            &format!("{}: {}", o.name, o.example.as_ref()?),
        ))
    });
    columns(&rows, [false, false, true, true, true, true, true, true])
        + &examples.collect::<String>()
}

pub fn habits(habits: &[Habit]) -> String {
    let rows: Vec<[String; 2]> = habits
        .iter()
        .map(|h| [h.name.to_owned(), h.choice.clone()])
        .collect();
    columns(&rows, [false; 2])
}

pub fn own_functions(functions: &[OwnFunction]) -> String {
    let head = [
        "",
        "",
        "range",
        "results",
        "different bits",
        "worst ulp",
        "at",
        "bound",
    ]
    .map(str::to_owned);
    let row = |f: &OwnFunction| {
        [
            f.name.to_owned(),
            word(f.outcome),
            f.range.to_owned(),
            thousands(f.compared),
            thousands(f.unequal),
            format!("{:.3}", f.worst_ulps),
            format!("{:.4e}", f.worst_at),
            format!("{}", f.bound_ulps),
        ]
    };
    let rows: Vec<[String; 8]> = std::iter::once(head)
        .chain(functions.iter().map(row))
        .collect();
    columns(&rows, [false, false, false, true, true, true, true, true])
}

pub fn battery(battery: &Battery) -> String {
    let head = ["", "", "margin", "by", "time"].map(str::to_owned);
    let row = |c: &CaseRecord| {
        let outcome = match c.passed {
            true => Outcome::Passes,
            false => Outcome::Fails,
        };
        [
            c.name.clone(),
            word(outcome),
            margin(c.margin),
            decisive(c).map_or("–", |held| held.what).to_owned(),
            duration(c.seconds),
        ]
    };
    let cases = battery.check.cases.iter().map(row);
    let rows: Vec<[String; 5]> = std::iter::once(head).chain(cases).collect();
    columns(&rows, [false, false, true, false, true])
}

pub fn driver_functions(functions: &[DriverFunction]) -> String {
    let head = [
        "",
        "range",
        "worst ulp",
        "absolute",
        "relative",
        "Vulkan allows",
        "complies",
    ]
    .map(str::to_owned);
    let row = |f: &DriverFunction| {
        [
            f.name.to_owned(),
            f.range.to_owned(),
            units(f.ulps.error),
            absolute(f),
            format!("{:.1e}", f.relative.error),
            f.allowed.to_owned(),
            f.within
                .map_or("", |within| if within { "yes" } else { "NO" })
                .to_owned(),
        ]
    };
    let rows: Vec<[String; 7]> = std::iter::once(head)
        .chain(functions.iter().map(row))
        .collect();
    columns(&rows, [false, false, true, true, true, false, false])
}

/// Empty where results far exceed 1: there it would only reflect their size.
fn absolute(f: &DriverFunction) -> String {
    match f.absolute.error {
        error if error < 1.0 => format!("{error:.1e}"),
        _ => String::new(),
    }
}

/// Units of the last place: `0.50`, `62`, `3,100`.
fn units(error: f64) -> String {
    match error {
        e if e < 10.0 => format!("{e:.2}"),
        e if e < 1e7 => thousands(e.round() as u64),
        e => format!("{e:.1e}"),
    }
}

pub fn costs(costs: &[Cost]) -> String {
    // – for no more than the loop around it takes.
    let nanoseconds = |n: f64| {
        if n > 0.0 {
            format!("{n:.3}")
        } else {
            "–".to_owned()
        }
    };
    let row = |c: &Cost| {
        let ratio = if c.drivers > 0.0 {
            format!("× {:.2}", c.own / c.drivers)
        } else {
            String::new()
        };
        [
            c.name.to_owned(),
            nanoseconds(c.own),
            c.drivers_name.to_owned(),
            nanoseconds(c.drivers),
            ratio,
        ]
    };
    let rows: Vec<[String; 5]> = costs.iter().map(row).collect();
    columns(&rows, [false, true, false, true, true])
}
