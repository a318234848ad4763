//! The facts needed to repeat the experiment.

use maud::{Markup, html};

use super::{Sheet, name};
use crate::converge::report::Convergence;
use crate::page::command_line;
use vkpt::report::SOFTWARE;
use vkpt::report::human::{duration, plural};

/// `400×300, 8 replicates, 59.1 s of sampling on …`
pub fn in_short(e: &Convergence) -> String {
    format!(
        "{}, {}, {} of sampling on {}",
        size(e),
        plural(e.replicates as u64, "replicate"),
        duration(e.spent_s),
        e.device
    )
}

/// The section at the end.
pub fn facts(sheet: &Sheet) -> Markup {
    let e = sheet.record;
    let last = u64::from(e.seed) + e.replicates as u64 - 1;
    html! {
        section #facts {
            h2 { "How it was made" }
            p.note { "Command line" }
            pre.wrap { (command_line(&sheet.command)) }
            dl {
                dt { "scene" } dd { (e.scene) }
                dt { "size" } dd { (size(e)) }
                dt { "replicates" } dd { (e.replicates) ", seeds " (e.seed) " to " (last) }
                dt { "sampling" } dd { (duration(e.spent_s)) " of at most " (duration(e.seconds)) " in all, variants interleaved" }
                dt { "device" } dd { (e.device) }
                @if !e.driver.is_empty() { dt { "driver" } dd { (e.driver) } }
                dt { "version" } dd { (SOFTWARE) }
                @if sheet.exposure != 0.0 { dt { "exposure" } dd { (sheet.exposure) " stops, for pictures and FLIP" } }
                @for variant in &e.variants {
                    dt { "settings" @if !variant.name.is_empty() { ", " (name(variant)) } }
                    dd { code { (variant.settings) } }
                }
            }
            details {
                summary { "Scene file" }
                pre.wrap { (sheet.scene) }
            }
        }
    }
}

fn size(e: &Convergence) -> String {
    let [width, height] = e.size;
    let crop = e.crop.map_or(String::new(), |[x0, y0, x1, y1]| {
        format!(", crop {x0},{y0},{x1},{y1}")
    });
    format!("{width}×{height}{crop}")
}
