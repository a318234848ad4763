//! A page with all scenes, and the pictures of those that failed.

use maud::{Markup, html};

use super::{Case, Shown, Suite, Verdict, sum};
use crate::page::{self, Page, image};
use vkpt::film::Film;
use vkpt::image::EncodeError;
use vkpt::metrics::HEATMAP_RANGE;
use vkpt::report::human::duration;

/// One self-contained file: failures, then a table. `folder` is the tested folder.
///
/// # Errors
/// A picture that cannot be encoded.
pub fn page(suite: &Suite, folder: &str) -> Result<String, EncodeError> {
    let title = format!("vkpt test {folder}");
    let wrong = suite.cases.iter().filter(|c| c.verdict.wrong().is_some());
    let wrong: Vec<Markup> = wrong.map(details).collect::<Result<_, _>>()?;
    Ok(page::page(&Page {
        title: &title,
        styles: &[include_str!("page.css")],
        script: "",
        body: html! {
            h1 { (title) }
            p { (sum(suite)) }
            @for details in &wrong { (details) }
            h2 { "All scenes" }
            table {
                thead { tr { th { "scene" } th { "picture" } th.number { "time" } } }
                tbody { @for case in &suite.cases { (row(case)) } }
            }
        },
    }))
}

fn row(case: &Case) -> Markup {
    let is_wrong = case.verdict.wrong().is_some();
    html! {
        tr {
            td { @if is_wrong { a href=(format!("#{}", case.name)) { (case.name) } } @else { (case.name) } }
            td.bad[is_wrong] { (word(&case.verdict)) }
            td.number { (duration(case.seconds)) }
        }
    }
}

fn word(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Same => "same to the bit".to_owned(),
        Verdict::Close { rel_mse } => format!("close, relMSE {rel_mse:.1e}"),
        Verdict::Kept { .. } => "kept as expected".to_owned(),
        Verdict::Differs(_) => "differs".to_owned(),
        Verdict::Failed(_) => "failed".to_owned(),
    }
}

/// A failure, with the pictures side by side, if any.
fn details(case: &Case) -> Result<Markup, EncodeError> {
    Ok(html! {
        h2 id=(case.name) { (case.name) }
        pre.wrap { (case.verdict.wrong().unwrap_or_default()) }
        @if let Some(shown) = &case.shown { (pictures(shown)?) }
    })
}

fn pictures(shown: &Shown) -> Result<Markup, EncodeError> {
    let [low, high] = HEATMAP_RANGE;
    let scale = format!(
        "relMSE of each pixel, from black ({low:e} or less) to pale yellow ({high} or more)"
    );
    let heat = shown.heat.as_ref().map(|film| (film, scale.as_str()));
    let all = [
        (&shown.expected, "expected picture"),
        (&shown.actual, "actual picture"),
    ];
    let figures = all
        .into_iter()
        .chain(heat)
        .map(|(film, words)| figure(film, words));
    let figures: Vec<Markup> = figures.collect::<Result<_, _>>()?;
    Ok(html! { div.pictures { @for figure in &figures { (figure) } } })
}

fn figure(film: &Film, words: &str) -> Result<Markup, EncodeError> {
    let image = image(film, 0.0, words)?;
    Ok(html! {
        figure {
            div.picture.small[film.width < 200] { (image) }
            figcaption { (words) }
        }
    })
}
