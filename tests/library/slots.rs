//! The table of slots in `shaders/README.md` is that of the shaders: no slot is missing, none is superfluous, and the files
//! that may fill it exist.

use std::collections::BTreeSet;

use vkpt::kernel::{file, files};

/// Name, folder (none where the text is generated) and the files that may fill it.
#[derive(Debug, PartialEq, Eq)]
struct Row {
    slot: String,
    folder: Option<String>,
    files: Vec<String>,
}

/// The words in backquotes of a cell.
fn quoted(cell: &str) -> Vec<String> {
    cell.split('`')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

fn rows(readme: &str) -> Vec<Row> {
    let row = |line: &str| {
        let cells: Vec<&str> = line.strip_prefix("| `<")?.split('|').collect();
        let folder = quoted(cells[1]).pop();
        let files = match &folder {
            Some(folder) => quoted(cells[2])
                .iter()
                .map(|f| format!("{folder}{f}"))
                .collect(),
            None => Vec::new(),
        };
        Some(Row {
            slot: cells[0].trim().trim_end_matches(">`").to_owned(),
            folder,
            files,
        })
    };
    readme.lines().filter_map(row).collect()
}

/// The slots that files of kernels ask for; the self-tests of devices have their own.
fn asked() -> BTreeSet<String> {
    let text = files().filter(|f| !f.starts_with("doctor/"));
    let text = text.filter_map(file);
    let uses = text.flat_map(|t| t.lines().filter_map(|l| l.strip_prefix("// uses:")));
    let names = uses.flat_map(|l| l.split(','));
    let slot = |name: &str| Some(name.trim().strip_prefix('<')?.strip_suffix('>')?.to_owned());
    names.filter_map(slot).collect()
}

/// The errors of the table.
fn complaints(readme: &str) -> Vec<String> {
    let rows = rows(readme);
    let listed: BTreeSet<String> = rows.iter().map(|r| r.slot.clone()).collect();
    let mut bad: Vec<String> = asked()
        .symmetric_difference(&listed)
        .map(|slot| format!("<{slot}> stands in the table or in the shaders alone"))
        .collect();
    for row in &rows {
        let missing = row.files.iter().filter(|f| file(f).is_none());
        bad.extend(missing.map(|f| format!("<{}>: no such file, {f}", row.slot)));
        if row.folder.is_some() && row.files.len() < 2 {
            bad.push(format!("<{}> has no alternative", row.slot));
        }
    }
    bad
}

const README: &str = include_str!("../../shaders/README.md");

#[test]
fn the_table_of_slots_is_that_of_the_shaders() {
    let bad = complaints(README);
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn a_missing_a_surplus_and_a_misspelt_row_are_noticed() {
    assert_eq!(
        complaints(&README.replace("| `<depth>`", "| `<deep>`")).len(),
        2
    );
    assert_eq!(complaints(&README.replace("`capped`", "`caped`")).len(), 1);
    assert_eq!(complaints(&README.replace("`unlimited`, ", "")).len(), 1);
}
