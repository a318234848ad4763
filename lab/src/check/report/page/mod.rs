//! The battery as an HTML page: what fails, groups of cases in a table each, coloured by how near they are to their
//! bounds, and behind each row its bounds and its pictures.

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

/// All that the page shows.
#[derive(Clone, Debug)]
pub struct Sheet<'a> {
    pub record: &'a Check,
    /// The command line as it was typed.
    pub command: String,
    /// For each case of the record.
    pub shown: &'a [Shown],
}

/// What a case has beside its figures.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The text of its scene file.
    pub scene: String,
    /// Of a mesh that comes after the scene's text, in its last material.
    pub triangles: Option<usize>,
    pub settings: SettingsRecord,
    pub spp: u32,
    pub seed: u32,
    /// Left, top, right, bottom of what was rendered, if not all of it.
    pub crop: Option<[u32; 4]>,
    /// The mean of each pixel by the device, and by cpu-f64 over the same paths.
    pub device: Film,
    pub reference: Film,
    /// Where they differ, in the colours of [`vkpt::metrics::difference_map`].
    pub difference: Film,
}

/// The whole file. Equal sheets make equal pages: it holds no date.
///
/// # Errors
/// Pictures that hold more or fewer pixels than they say.
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

/// A case with what is shown of it.
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

/// Whether rows that fail stand open: not where they would bury the others.
fn opens(check: &Check) -> bool {
    const FEW: usize = 10;
    check.cases.iter().filter(|c| !c.passed).count() <= FEW
}
