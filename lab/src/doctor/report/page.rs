//! The page that `vkpt doctor` prints.

use super::tables::{
    battery, costs, device, driver_functions, habits, operations, own_functions, self_tests,
};
use super::{Examination, Verdict};
use crate::table::hanging;

/// The whole page, at most 100 characters per line: the verdict first, sections that decide nothing last.
pub fn page(e: &Examination) -> String {
    let mut sections = vec![
        head(e),
        section("Device", &device(&e.device)),
        section("Watchdogs and loops", &paragraphs(&e.watchdog)),
        section(
            "Self-tests: small kernels with known results",
            &self_tests(&e.self_tests),
        ),
        section(
            "Arithmetic compared with the host, bit by bit; different results by kind of operand and result",
            &operations(&e.operations),
        ),
        section(
            "vkpt's own functions: bits compared with the reference, errors with f64",
            &own_functions(&e.own_functions),
        ),
        section(
            "Battery: pictures at the limits of f32, compared with cpu-f32 and cpu-f64; a margin above 1 fails",
            &battery(&e.battery),
        ),
    ];
    sections.extend(e.habits.as_deref().map(|found| {
        let title = "The driver's choices in unmarked arithmetic, on which vkpt never relies";
        section(title, &habits(found))
    }));
    sections.extend(e.driver_functions.as_deref().map(|found| {
        let title = "The driver's GLSL functions, compared with f64; vkpt calls none of them";
        section(title, &driver_functions(found))
    }));
    sections.extend(e.costs.as_deref().map(|found| {
        let title =
            "Nanoseconds per call on the whole device: vkpt's own functions, and the driver's equivalents";
        section(title, &costs(found))
    }));
    sections.join("\n")
}

/// The verdict with its reasons.
pub fn head(e: &Examination) -> String {
    let Verdict {
        healthy,
        equal_bits,
        failures,
        differences,
        interrupted,
    } = &e.verdict;
    let verdict = match (healthy, equal_bits) {
        (true, true) => "healthy: expect the same bits as the reference",
        (true, false) => {
            "healthy, but rounds differently: pictures differ from the reference's by rounding, as f32 does from f64"
        }
        (false, _) if *interrupted && failures.is_empty() => {
            "interrupted: nothing failed until then, which is no verdict"
        }
        (false, _) => "NOT HEALTHY: do not trust pictures of this device with this driver",
    };
    let lines = failures
        .iter()
        .chain(differences)
        .map(|text| hanging("  – ", text));
    hanging("", &format!("{}: {verdict}", e.device.name)) + &lines.collect::<String>()
}

fn section(title: &str, text: &str) -> String {
    format!("{title}\n{text}")
}

fn paragraphs(lines: &[String]) -> String {
    lines.iter().map(|line| hanging("  ", line)).collect()
}
