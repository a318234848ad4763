//! The experiment as an HTML page: the results, the plot, the pictures next to the reference, the worst pixels, every
//! figure, and the facts needed to repeat it.

mod facts;
mod figures;
mod findings;
mod graph;
mod pictures;
mod worst;

use maud::html;

use super::{Convergence, VariantRecord};
use crate::page::Page;
use vkpt::image::EncodeError;
use vkpt::metrics::MetricsError;
use vkpt::metrics::convergence::{Curve, Reference};

/// The contents of the page.
#[derive(Clone, Debug)]
pub struct Sheet<'a> {
    pub record: &'a Convergence,
    /// The text of the scene file.
    pub scene: &'a str,
    /// The command line as it was typed.
    pub command: String,
    /// Stops by which the pictures are brightened.
    pub exposure: f64,
    /// For each variant of the record, with as many steps.
    pub shown: Vec<Shown<'a>>,
}

/// The contents of a variant in addition to its figures.
#[derive(Clone, Debug)]
pub struct Shown<'a> {
    pub curve: &'a Curve,
    pub reference: &'a Reference,
    /// `vkpt SCENE …` with the variant's settings; the page appends `--trace X,Y,I`.
    pub command: String,
}

/// Why no page could be made.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    #[error(transparent)]
    Picture(#[from] EncodeError),
    #[error(transparent)]
    Metrics(#[from] MetricsError),
}

/// The whole file. Equal sheets make equal pages: it contains no date.
///
/// It takes about 8 bytes for each pixel of each step and variant, less if there is little noise.
///
/// # Errors
/// Pictures that have no pixels, or of another size than their reference.
pub fn page(sheet: &Sheet) -> Result<String, PageError> {
    let title = format!("Convergence of {}", sheet.record.scene);
    let body = html! {
        header {
            h1 { (title) }
            p.muted { (facts::in_short(sheet.record)) }
        }
        main {
            (findings::findings(sheet.record))
            (graph::graph(sheet.record))
            (pictures::pictures(sheet)?)
            (worst::worst(sheet)?)
            (figures::figures(sheet.record))
            (facts::facts(sheet))
        }
    };
    Ok(crate::page::page(&Page {
        title: &title,
        styles: &[&graph::colours(), include_str!("page.css")],
        script: include_str!("page.js"),
        body,
    }))
}

/// The name of a variant if nothing varies.
fn name(variant: &VariantRecord) -> &str {
    match variant.name.as_str() {
        "" => "all samples",
        name => name,
    }
}
