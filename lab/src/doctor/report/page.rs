//! The page that `vkpt doctor` prints.

use super::tables::{
    costs, device, driver_functions, habits, operations, own_functions, self_tests,
};
use super::{Examination, Verdict};
use crate::table::hanging;

/// All of it, at most 100 characters a line; the verdict first.
pub fn page(e: &Examination) -> String {
    let sections = [
        head(e),
        section("Device", &device(&e.device)),
        section("Watchdogs and loops", &paragraphs(&e.watchdog)),
        section(
            "Self-tests: small kernels whose results are known",
            &self_tests(&e.self_tests),
        ),
        section(
            "Arithmetic against the host's, bit by bit; what differs, by what was in it or came out",
            &operations(&e.operations),
        ),
        section(
            "What the driver makes of arithmetic that vkpt never leaves to it",
            &habits(&e.habits),
        ),
        section(
            "vkpt's own functions: bits against the reference, errors against f64",
            &own_functions(&e.own_functions),
        ),
        section(
            "GLSL's functions as this driver has them, against f64; vkpt calls none of them",
            &driver_functions(&e.driver_functions),
        ),
        section(
            "Nanoseconds a call on the whole device: vkpt's own, and the driver's way to the same",
            &costs(&e.costs),
        ),
    ];
    sections.join("\n")
}

fn head(e: &Examination) -> String {
    let Verdict {
        healthy,
        equal_bits,
        failures,
        differences,
    } = &e.verdict;
    let verdict = match (healthy, equal_bits) {
        (true, true) => "healthy: equal bits with the reference are to be expected",
        (true, false) => {
            "healthy, with bits of its own: pictures differ from the reference's by rounding, as f32's do from f64's"
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
