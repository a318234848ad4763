//! The meaning of the figures and colours, and how they were obtained.

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

/// The section that explains the figures.
pub fn legend() -> Markup {
    html! {
        section #legend {
            h2 { "What the figures mean" }
            p {
                "Each case is a small picture at a limit of single precision, rendered by the device, by cpu-f32 and by cpu-f64 with \
                 the same random numbers. Select a name to see its pictures and its bounds with their reasons."
            }
            dl {
                dt { "margin" }
                dd {
                    "measured/bound, the largest of the case; " b { "by" } " names the bound. Above 1 the case fails. "
                    span.key {
                        @for (end, class) in BANDS { span.margin.(class) { "≤ " (end) } }
                        span.margin.(BEYOND) { "> 1" }
                    }
                }
                dt { "diverged" } dd { "paths on which device and cpu-f64 decide differently: another shape, light, lobe or end" }
                dt { "99 %, worst" } dd { "relative difference to cpu-f64 of the paths that do not diverge: the 99th percentile, and the largest" }
                dt { "broken" } dd { "samples with a NaN or an infinity, on the device or in a reference: none are allowed" }
                dt { "weight" } dd { "the largest contribution of one path" }
                dt { "mean, expected" } dd { "mean radiance of all samples, and its value by a closed form or quadrature" }
                dt { "pictures" }
                dd {
                    "the mean of each pixel, by device and cpu-f64, both brightened by the same whole number of stops to a mean between ¼ and ½. "
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
        false => "a GPU, which may round differently from cpu-f32: bits are not compared",
    }
}

fn chance(check: &Check) -> String {
    format!(
        "a correct renderer fails the whole battery with probability {:e}, and each statistical test with {:.1e}",
        check.alpha, check.level
    )
}
