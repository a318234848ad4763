//! The details below a case's row: pictures, bounds with their reasons, warnings, scene.

use maud::{Markup, html};

use super::super::words::{margin, plain, relative};
use super::super::{CaseRecord, Held};
use super::Shown;
use super::colours::band;
use crate::page::image;
use vkpt::film::Film;
use vkpt::image::EncodeError;
use vkpt::report::human::{plural, thousands};
use vkpt::report::names::Named;
use vkpt::settings::Integrator;

/// The most lines of a scene to show; some scenes have ten thousand lights.
const LINES: usize = 40;

pub fn opened(case: &CaseRecord, shown: Option<&Shown>) -> Result<Markup, EncodeError> {
    Ok(html! {
        p.about { (case.about) }
        @if let Some(shown) = shown { (pictures(case, shown)?) }
        @for warning in &case.warnings { p.note { "Warning: " (warning) } }
        (bounds(&case.held))
        @if let Some(shown) = shown { (scene(shown)) }
        p.note { "To run only this case: " code { "vkpt check --case '" (case.name) "'" } }
    })
}

fn pictures(case: &CaseRecord, shown: &Shown) -> Result<Markup, EncodeError> {
    let Shown {
        device,
        reference,
        difference,
        ..
    } = shown;
    let stops = exposure(reference);
    let brightened = match stops {
        0.0 => String::new(),
        stops => {
            let s = if stops.abs() == 1.0 { "" } else { "s" };
            format!("{stops:+} stop{s}").replace('-', "−")
        }
    };
    Ok(html! {
        div.pictures.small {
            (picture(image(device, stops, "picture by the device")?, "device", &brightened))
            (picture(image(reference, stops, "picture by cpu-f64")?, "cpu-f64", &brightened))
            figure {
                div.picture { (image(difference, 0.0, "where the device is brighter or darker")?) }
                div.bar {}
                div.ends { span { "−1" } span.between { "10" sup { "−4" } } span { "0" } span.between { "10" sup { "−4" } } span { "1" } }
                figcaption { b { "difference" } ", relative" }
            }
            (places(case))
        }
    })
}

fn picture(image: Markup, name: &str, note: &str) -> Markup {
    html! {
        figure {
            div.picture { (image) }
            figcaption { b { (name) } @if !note.is_empty() { ", " (note) } }
        }
    }
}

/// Whole stops that bring the picture's mean between a quarter and a half; 0 for a black one.
fn exposure(film: &Film) -> f64 {
    let sum: f64 = film.rgb.iter().flatten().map(|&x| f64::from(x)).sum();
    let mean = sum / (3 * film.rgb.len()).max(1) as f64;
    match mean > 0.0 && mean.is_finite() {
        true => -2.0 - mean.log2().floor(),
        false => 0.0,
    }
}

/// The number of samples, and notable paths.
fn places(case: &CaseRecord) -> Markup {
    let at = |[x, y, i]: [u32; 3]| format!("pixel {x},{y}, sample {i}");
    html! {
        dl.places {
            dt { "samples" } dd { (thousands(case.samples)) }
            dt { "diverged" } dd { (thousands(case.diverged)) @if let Some(a) = case.diverged_at { ", the first " (at(a)) } }
            @if let Some(a) = case.worst_at { dt { "worst" } dd { (at(a)) } }
            dt { "mean" } dd { (plain(case.mean)) " ± " (relative(Some(case.standard_error))) }
            @if let Some(expected) = case.expected { dt { "expected" } dd { (plain(expected)) } }
        }
    }
}

fn bounds(held: &[Held]) -> Markup {
    html! {
        table.bounds {
            thead { tr { th.words { "bound" } th { "measured" } th { "at most" } th { "margin" } th.words { "why" } } }
            tbody {
                @for held in held {
                    tr {
                        th.words scope="row" { (held.what) }
                        td { (plain(held.measured)) }
                        td { (plain(held.bound)) }
                        td.margin.(band(held.margin)) { (margin(held.margin)) }
                        td.words.why { (held.why) }
                    }
                }
            }
        }
    }
}

fn scene(shown: &Shown) -> Markup {
    let [width, height] = [shown.device.width, shown.device.height];
    let lines: Vec<&str> = shown.scene.lines().collect();
    let text = lines[..lines.len().min(LINES)].join("\n");
    html! {
        details {
            summary { "Scene and settings" }
            pre.wrap { (text) }
            @if lines.len() > LINES { p.note { "the first " (LINES) " of " (thousands(lines.len() as u64)) " lines" } }
            @if let Some(n) = shown.triangles { p.note { "and a mesh of " (plural(n as u64, "triangle")) " in the last material" } }
            @if shown.settings.integrator != Integrator::Path.name() {
                p.note { "A pixel shows the total radiance of its samples, including splats that land on other pixels." }
            }
            p.note {
                (width) "×" (height) " pixels"
                @if let Some([x0, y0, x1, y1]) = shown.crop { ", crop " (x0) "," (y0) "," (x1) "," (y1) }
                ", " (plural(shown.spp.into(), "sample")) " each, seed " (shown.seed) ": " code { (shown.settings) }
            }
        }
    }
}
