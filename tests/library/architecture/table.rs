//! The table of rooms in ARCHITECTURE.md: where a room is, and what it may know.

use super::source::{FOLDERS, Path};

/// A row of the table.
#[derive(Debug)]
pub struct Row {
    /// The room: a folder or a file of a crate, with all that is below it; those of vkpt-lab and vkpt-cli are below `lab` and `cli`.
    pub room: Path,
    pub may_know: Known,
}

/// The third column.
#[derive(Debug, PartialEq)]
pub enum Known {
    Everything,
    /// These modules and items, with all below them; none if the table says "nothing".
    These(Vec<Path>),
}

impl Known {
    pub fn allows(&self, path: &Path) -> bool {
        match self {
            Self::Everything => true,
            Self::These(all) => all.iter().any(|known| path.is_within(known)),
        }
    }
}

/// The rows of all rooms in the text of ARCHITECTURE.md, or the error in the first that cannot be read.
pub fn rows(markdown: &str) -> Result<Vec<Row>, String> {
    let is_room = |line: &&str| {
        FOLDERS
            .iter()
            .any(|folder| line.starts_with(&format!("| `{folder}/")))
    };
    let lines = markdown.lines().filter(is_room);
    let row = |line: &str| row(line).map_err(|why| format!("{why}: {line}"));
    lines.map(row).collect()
}

fn row(line: &str) -> Result<Row, String> {
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    let &["", room, _, may_know, ""] = &cells[..] else {
        return Err("three columns are expected".to_owned());
    };
    let place = quoted(room).map(|place| place.replacen("src/", "", 1));
    let place = place.ok_or("the first column must be one path")?;
    let place = place.trim_end_matches('/').trim_end_matches(".rs");
    Ok(Row {
        room: place.split('/').collect(),
        may_know: known(may_know)?,
    })
}

/// `nothing`, `everything`, or paths in backquotes between commas.
fn known(cell: &str) -> Result<Known, String> {
    match cell {
        "nothing" => Ok(Known::These(Vec::new())),
        "everything" => Ok(Known::Everything),
        _ => {
            let path = |item: &str| {
                let path = quoted(item.trim()).map(|path| path.split("::").collect());
                path.ok_or(format!(
                    "`{item}` in the third column is no path in backquotes"
                ))
            };
            let all: Result<_, String> = cell.split(',').map(path).collect();
            Ok(Known::These(all?))
        }
    }
}

/// The text between two backquotes, without another backquote.
fn quoted(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('`')?.strip_suffix('`')?;
    (!inner.is_empty() && !inner.contains('`')).then_some(inner)
}

#[test]
fn the_third_column_is_read_to_the_letter() {
    let may_know = |cell: &str| known(cell);
    let these = |all: &[&str]| Known::These(all.iter().map(|p| p.split("::").collect()).collect());
    assert_eq!(may_know("nothing"), Ok(these(&[])));
    assert_eq!(may_know("everything"), Ok(Known::Everything));
    assert_eq!(
        may_know("`scene`, `gpu::Device`"),
        Ok(these(&["scene", "gpu::Device"]))
    );
    for wrong in [
        "",
        "–",
        "scene",
        "`scene` and `gpu`",
        "`scene`; `gpu`",
        "all of `scene`",
    ] {
        assert!(may_know(wrong).is_err(), "{wrong}");
    }
    assert!(rows("| `src/scene/` | two columns |").is_err());
    assert!(rows("| `src/a/`, `src/b/` | two rooms | nothing |").is_err());
    let text = "| room | – | – |\n| `src/a/b.rs` | x | nothing |\n| `lab/src/c/` | y | `a` |\n| `shaders/` | z | – |";
    let rows = rows(text);
    let rooms: Vec<String> = rows
        .expect("a row")
        .iter()
        .map(|r| r.room.to_string())
        .collect();
    assert_eq!(rooms, ["a::b", "lab::c"]);
}
