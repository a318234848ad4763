//! The pixels that make most of the error at the last step.

use maud::{Markup, html};

use super::super::words::number;
use super::{PageError, Sheet, Shown, name};
use crate::page::command_line;
use vkpt::metrics::{Pair, WorstPixel, worst_pixels};

/// Pixels to list for each variant.
const COUNT: usize = 10;

/// A table for each variant.
pub fn worst(sheet: &Sheet) -> Result<Markup, PageError> {
    let mut tables = Vec::new();
    for (i, shown) in sheet.shown.iter().enumerate() {
        tables.push(of_variant(sheet, i, shown)?);
    }
    Ok(html! {
        section #worst {
            h2 { "Worst pixels" }
            p.note {
                "The pixels with the largest relMSE in the picture of the last step, counted from the top left of the full picture. \
                 Select one to mark it in the pictures."
            }
            @for table in tables { (table) }
        }
    })
}

fn of_variant(sheet: &Sheet, i: usize, shown: &Shown) -> Result<Markup, PageError> {
    let Some(last) = shown.curve.steps.last() else {
        return Ok(html! {});
    };
    let pair = Pair::new(&last.picture, shown.reference.film())?;
    let worst = worst_pixels(&pair, COUNT);
    let size = [last.picture.width, last.picture.height];
    let origin = sheet.record.crop.map_or([0, 0], |[x, y, ..]| [x, y]);
    let heading = sheet.record.variants.get(i).map_or("", name);
    Ok(html! {
        div.worst data-variant=(i) {
            @if sheet.shown.len() > 1 { h3 { (heading) ", " (last.spp) " spp" } }
            div.scroll {
                table {
                    thead { tr {
                        th { "x, y" }
                        th { "picture R" } th { "G" } th { "B" }
                        th { "reference R" } th { "G" } th { "B" }
                        th { "relMSE" } th { "share of all" }
                    } }
                    tbody { @for pixel in &worst { (row(pixel, size, origin)) } }
                }
            }
            @if let Some(pixel) = worst.first() {
                @let [x, y] = in_full(pixel, origin);
                p.note { "To print the path of its first sample, vertex by vertex:" }
                pre.wrap { (command_line(&shown.command)) " " span.word { "--trace" } " " span.word { span.pixel { (x) "," (y) } ",0" } }
            }
        }
    })
}

fn in_full(pixel: &WorstPixel, origin: [u32; 2]) -> [u32; 2] {
    [0, 1].map(|i| pixel.at[i] + origin[i])
}

fn row(pixel: &WorstPixel, size: [u32; 2], origin: [u32; 2]) -> Markup {
    let [x, y] = in_full(pixel, origin);
    // The centre of the pixel, in percent of the picture.
    let [left, top] = [0, 1].map(|i| 100.0 * (f64::from(pixel.at[i]) + 0.5) / f64::from(size[i]));
    html! {
        tr {
            td { button.pick type="button" aria-pressed="false" data-left=(left) data-top=(top) data-pixel=(format!("{x},{y}")) {
                (x) ", " (y)
            } }
            @for value in pixel.test { td { (number(value.into())) } }
            @for value in pixel.reference { td { (number(value.into())) } }
            td { (number(pixel.error)) }
            td { (format!("{:.1} %", 100.0 * pixel.share)) }
        }
    }
}
