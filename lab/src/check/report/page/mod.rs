//! The battery as an HTML page: failures, a table for each group of cases, coloured by margin, and behind each row its
//! bounds and pictures.

mod case;
mod colours;
mod facts;
mod findings;
mod group;
mod opened;

use maud::html;

use super::{CaseRecord, Check};
use crate::page::Page;
use vkpt::film::Film;
use vkpt::image::EncodeError;
use vkpt::report::SettingsRecord;

/// The contents of the page.
#[derive(Clone, Debug)]
pub struct Sheet<'a> {
    pub record: &'a Check,
    /// The command line as it was typed.
    pub command: String,
    /// For each case of the record.
    pub shown: &'a [Shown],
}

/// The contents of a case in addition to its figures.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The text of its scene file.
    pub scene: String,
    /// The number of triangles of a mesh that follows the scene's text, in its last material.
    pub triangles: Option<usize>,
    pub settings: SettingsRecord,
    pub spp: u32,
    pub seed: u32,
    /// Left, top, right, bottom of the rendered part, if not the whole.
    pub crop: Option<[u32; 4]>,
    /// The mean of each pixel by the device, and by cpu-f64 over the same paths.
    pub device: Film,
    pub reference: Film,
    /// Where they differ, in the colours of [`vkpt::metrics::difference_map`].
    pub difference: Film,
}

/// The whole file. Equal sheets make equal pages: it contains no date.
///
/// # Errors
/// Pictures with more or fewer pixels than their size.
pub fn page(sheet: &Sheet) -> Result<String, EncodeError> {
    let check = sheet.record;
    let title = format!("Stiff cases on {}", check.device);
    let mut groups = Vec::new();
    for cases in by_group(sheet) {
        groups.push(group::group(&cases, opens(check))?);
    }
    let body = html! {
        header {
            h1 { (title) }
            p.muted { (facts::in_short(check)) }
        }
        main {
            (findings::findings(check))
            @for group in groups { (group) }
            (facts::legend())
            (facts::facts(sheet))
        }
    };
    Ok(crate::page::page(&Page {
        title: &title,
        styles: &[&colours::scale(), include_str!("page.css")],
        script: "",
        body,
    }))
}

/// A case with its details.
type Row<'a> = (&'a CaseRecord, Option<&'a Shown>);

/// The cases of each group, in the order of the record.
fn by_group<'a>(sheet: &Sheet<'a>) -> Vec<Vec<Row<'a>>> {
    let mut groups: Vec<Vec<Row>> = Vec::new();
    for (i, case) in sheet.record.cases.iter().enumerate() {
        let row = (case, sheet.shown.get(i));
        match groups.last_mut() {
            Some(rows) if rows[0].0.group() == case.group() => rows.push(row),
            _ => groups.push(vec![row]),
        }
    }
    groups
}

/// Whether failing rows are open initially: not if they would bury the others.
fn opens(check: &Check) -> bool {
    const FEW: usize = 10;
    check.cases.iter().filter(|c| !c.passed).count() <= FEW
}
