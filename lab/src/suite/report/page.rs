//! A page with all scenes, and the pictures of those that went wrong.

use maud::{Markup, html};

use super::{Case, Shown, Suite, Verdict, sum};
use crate::page::{self, Page, image};
use vkpt::film::Film;
use vkpt::image::EncodeError;
use vkpt::metrics::HEATMAP_RANGE;
use vkpt::report::human::duration;

/// One file that needs no network: a table, what went wrong first. `folder` is what was tested.
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
        Verdict::Same => "the same to the bit".to_owned(),
        Verdict::Close { rel_mse } => format!("close, relMSE {rel_mse:.1e}"),
        Verdict::Kept { .. } => "kept now".to_owned(),
        Verdict::Differs(_) => "differs".to_owned(),
        Verdict::Failed(_) => "failed".to_owned(),
    }
}

/// What went wrong, with the pictures beside each other where there are any.
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
        "relMSE of each pixel, from black ({low:e} and less) to pale yellow ({high} and more)"
    );
    let heat = shown.heat.as_ref().map(|film| (film, scale.as_str()));
    let all = [
        (&shown.expected, "the picture that is kept"),
        (&shown.actual, "the picture now"),
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
