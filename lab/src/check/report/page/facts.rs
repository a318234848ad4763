//! What the figures and colours mean, and where they were taken.

use maud::{Markup, html};

use super::super::Check;
use super::Sheet;
use super::colours::{BANDS, BEYOND};
use crate::page::command_line;
use vkpt::report::SOFTWARE;
use vkpt::report::human::{duration, plural};

/// `475 cases in 33.1 s, quick; Mesa 22.3.6`
pub fn in_short(check: &Check) -> String {
    let cases = plural(check.cases.len() as u64, "case");
    format!("{cases} in {}, {}", duration(check.seconds), check.driver)
}

/// The section that says what is what.
pub fn legend() -> Markup {
    html! {
        section #legend {
            h2 { "What the figures mean" }
            p {
                "Each case is a small picture at an edge of what single precision holds, rendered by the device, by cpu-f32 and by \
                 cpu-f64 over the same paths. Choose a name to see its pictures and its bounds with their reasons."
            }
            dl {
                dt { "margin" }
                dd {
                    "measured/bound, the largest of the case; " b { "by" } " says which. Above 1 the case fails. "
                    span.key {
                        @for (end, class) in BANDS { span.margin.(class) { "≤ " (end) } }
                        span.margin.(BEYOND) { "> 1" }
                    }
                }
                dt { "parted" } dd { "paths that the device decides otherwise than cpu-f64: another shape, light, lobe or end" }
                dt { "99 %, worst" } dd { "relative difference to cpu-f64 of the paths that stay together: what 99 % stay below, and the largest" }
                dt { "broken" } dd { "samples with a NaN or an infinity, on the device or in a reference: there may be none" }
                dt { "weight" } dd { "the most that one path brings" }
                dt { "mean, expected" } dd { "radiance over all samples, and what a closed form or quadrature has in its place" }
                dt { "pictures" }
                dd {
                    "the mean of each pixel, by device and cpu-f64 brightened alike, by whole stops, so that the mean is between ¼ and ½. "
                    b { "difference" } " is (device − cpu-f64)/(the larger of them) in the channel where that is largest: red where the \
                    device is brighter, blue where it is darker, nearly white where they are equal, black where a sample is NaN or \
                    infinite; logarithmic from 10" sup { "−8" } " to 1."
                }
            }
        }
    }
}

/// The section at the end.
pub fn facts(sheet: &Sheet) -> Markup {
    let check = sheet.record;
    html! {
        section #facts {
            h2 { "How it was made" }
            p.note { "Command line" }
            pre.wrap { (command_line(&sheet.command)) }
            dl {
                dt { "device" } dd { (check.device) }
                @if !check.driver.is_empty() { dt { "driver" } dd { (check.driver) } }
                dt { "rounding" } dd { (rounding(check)) }
                dt { "chance" } dd { (chance(check)) }
                dt { "time" } dd { (duration(check.seconds)) }
                dt { "version" } dd { (SOFTWARE) }
            }
        }
    }
}

fn rounding(check: &Check) -> &'static str {
    match check.correctly_rounded {
        true => "a CPU driver: it must equal cpu-f32 in every bit",
        false => "a GPU, which may round otherwise than cpu-f32: bits are not held against it",
    }
}

fn chance(check: &Check) -> String {
    format!(
        "a renderer without fault fails some statement of the whole battery with a probability of {:e}, each with {:.1e}",
        check.alpha, check.level
    )
}
