//! The picture at each step next to the reference, and the map of its errors.
//!
//! Without scripts all steps are listed; with them, one is shown at a time, by a slider.

use maud::{Markup, html};

use super::super::words::number;
use super::super::{StepRecord, VariantRecord};
use super::{PageError, Sheet, Shown, name};
use crate::page::{data_uri, image};
use vkpt::film::Film;
use vkpt::metrics::{HEATMAP_RANGE, Pair, heatmap, heatmap_scale};
use vkpt::report::human::duration;

/// Pictures up to this width are enlarged on most screens, with square pixels.
const SMALL: u32 = 400;

/// The section with all pictures.
pub fn pictures(sheet: &Sheet) -> Result<Markup, PageError> {
    let mut steps = Vec::new();
    for (i, variant) in sheet.record.variants.iter().enumerate() {
        let Some(shown) = sheet.shown.get(i) else {
            break;
        };
        for (k, step) in variant.steps.iter().enumerate() {
            steps.push(of_step(sheet, (i, variant, shown), (k, step))?);
        }
    }
    let groups = references(sheet);
    let mut references = Vec::new();
    for &i in &groups {
        references.push(reference(sheet, i)?);
    }
    Ok(html! {
        section #pictures {
            h2 { "Pictures" }
            (controls(sheet, &groups))
            div.panes.small[sheet.shown.iter().all(|s| s.reference.film().width <= SMALL)] {
                @for reference in references { (reference) }
                @for step in steps { (step) }
            }
            (scale()?)
        }
    })
}

/// For each distinct reference, the first variant that it judges.
fn references(sheet: &Sheet) -> Vec<usize> {
    let film = |i: usize| sheet.shown[i].reference.film();
    let mut firsts: Vec<usize> = Vec::new();
    for i in 0..sheet.shown.len() {
        if firsts.iter().all(|&j| film(j) != film(i)) {
            firsts.push(i);
        }
    }
    firsts
}

/// The controls that scripts show: the choice of a variant and the slider. A variant names the one with its reference.
fn controls(sheet: &Sheet, groups: &[usize]) -> Markup {
    let film = |i: usize| sheet.shown.get(i).map(|s| s.reference.film());
    let group = |i: usize| groups.iter().find(|&&j| film(j) == film(i)).copied();
    let variants = &sheet.record.variants;
    let steps = variants.first().map_or(0, |v| v.steps.len());
    let last = steps.saturating_sub(1);
    let spp = |step: &StepRecord| step.spp.to_string();
    let all = variants
        .first()
        .map_or(Vec::new(), |v| v.steps.iter().map(spp).collect());
    html! {
        form.controls hidden autocomplete="off" {
            fieldset.variants hidden[variants.len() < 2] {
                legend { "variant" }
                @for (i, variant) in variants.iter().enumerate() {
                    label {
                        input type="radio" name="variant" value=(i) checked[i == 0] data-reference=(group(i).unwrap_or(0));
                        " " (name(variant))
                    }
                }
            }
            label.step-label {
                span { "samples per pixel" }
                input #step type="range" min="0" max=(last) step="1" value=(last) data-spp=(all.join(" "));
                output for="step" { (all.last().map_or("", |s| s)) }
            }
        }
    }
}

fn reference(sheet: &Sheet, i: usize) -> Result<Markup, PageError> {
    let name = &sheet.record.variants[i].reference.name;
    let film = sheet.shown[i].reference.film();
    Ok(html! {
        figure.reference data-reference=(i) {
            (picture(film, sheet.exposure, &format!("reference, {name}"))?)
            figcaption { b { "reference" } br; (name) }
        }
    })
}

fn of_step(
    sheet: &Sheet,
    (i, variant, shown): (usize, &VariantRecord, &Shown),
    (k, step): (usize, &StepRecord),
) -> Result<Markup, PageError> {
    let Some(measured) = shown.curve.steps.get(k) else {
        return Ok(html! {});
    };
    let film = &measured.picture;
    let map = heatmap(&Pair::new(film, shown.reference.film())?);
    let of = match variant.name.as_str() {
        "" => String::new(),
        name => format!("{name}, "),
    };
    let alt = format!("{of}{} samples per pixel", step.spp);
    let own = step.errors.rel_mse.replicates.first();
    let own = own.map_or(String::new(), |&e| format!(", relMSE {}", number(e)));
    Ok(html! {
        div.step data-variant=(i) data-step=(k) {
            figure {
                (picture(film, sheet.exposure, &alt)?)
                figcaption {
                    b { (step.spp) " spp" } span.of { (of.trim_end_matches(", ")) } br;
                    (duration(step.wall_s.value)) (own)
                }
            }
            figure.map {
                (picture(&map, 0.0, &format!("relMSE of each pixel, {alt}"))?)
                figcaption { b { "relMSE of each pixel" } br; "compared with the reference" }
            }
        }
    })
}

/// A picture, and the mark of one of its pixels.
fn picture(film: &Film, exposure: f64, alt: &str) -> Result<Markup, PageError> {
    Ok(html! {
        div.picture {
            (image(film, exposure, alt)?)
            span.mark hidden {}
        }
    })
}

/// The colours of the maps, with their figures.
fn scale() -> Result<Markup, PageError> {
    let source = data_uri(&heatmap_scale(128), 0.0)?;
    let [low, high] = HEATMAP_RANGE;
    let middle = (low * high).sqrt();
    Ok(html! {
        figure.scale {
            img src=(source) alt="from black through purple and orange to pale yellow";
            div.ends { span { "≤ " (format!("{low:e}")) } span { (format!("{middle:e}")) } span { "≥ " (high) } }
            figcaption {
                "(x − r)²/(r² + 0.01) of each pixel x, averaged over its channels; logarithmic, with the same scale in all maps. The \
                 pictures are those of the first replicate."
            }
        }
    })
}
