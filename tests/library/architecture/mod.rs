//! The table of rooms in ARCHITECTURE.md, compared with the sources: it is the only place that says what a room may know.

mod circles;
mod planted;
mod source;
mod table;

use std::path::Path;

use source::{FOLDERS, Source};
use table::{Known, Row, rows};

/// Words, and the room that alone may use each.
const WORDS: [(&str, &str); 8] = [
    ("unsafe", "gpu"),
    ("ash::", "gpu"),
    ("naga::", "kernel"),
    ("unaudited::", "lab::doctor"),
    ("println!", "lab::cli"),
    ("print!", "lab::cli"),
    ("dbg!", "lab::cli"),
    ("std::process::exit", "lab::cli"),
];

/// Everything in a source file that the table does not allow.
fn violations(source: &Source, table: &[Row]) -> Vec<String> {
    let module = source.module();
    if matches!(
        module.to_string().as_str(),
        "lib" | "lab::lib" | "cli::lib" | "cli::main"
    ) {
        return Vec::new();
    }
    let violation = |line: usize, what: &str| format!("{}:{line}: {what}", source.path);
    let Some(row) = room_of(&module, table) else {
        return vec![violation(
            1,
            "this room is not in the table of ARCHITECTURE.md",
        )];
    };
    let mut all = Vec::new();
    for (line, path) in source.names() {
        let other = room_of(&path, table);
        if other.is_some_and(|other| other.room != row.room) && !row.may_know.allows(&path) {
            let room = &row.room;
            all.push(violation(
                line,
                &format!("by the table of ARCHITECTURE.md, {room} may not know {path}"),
            ));
        }
    }
    for (word, home) in WORDS {
        for (line, code) in source.lines() {
            if !module.is_within(&home.split("::").collect()) && is_word_in(word, code) {
                all.push(violation(line, &format!("`{word}` outside {home}")));
            }
        }
    }
    all
}

/// The row of the room that contains a module or an item; the innermost of nested rooms.
fn room_of<'t>(path: &source::Path, table: &'t [Row]) -> Option<&'t Row> {
    let around = table.iter().filter(|row| path.is_within(&row.room));
    around.max_by_key(|row| row.room.len())
}

/// `println!` is also in `eprintln!`, but `naga::` is not in `our_naga::`.
fn is_word_in(word: &str, code: &str) -> bool {
    let code = code.replace("eprint", "print");
    code.match_indices(word).any(|(i, _)| {
        let before = code[..i].chars().next_back();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
    })
}

/// Entries of the table without a source: rooms that do not exist, and permissions that no room uses.
fn idle(table: &[Row], sources: &[Source]) -> Vec<String> {
    let mut all = Vec::new();
    for Row { room, may_know } in table {
        let own =
            |source: &&Source| room_of(&source.module(), table).is_some_and(|r| r.room == *room);
        let own: Vec<&Source> = sources.iter().filter(own).collect();
        if own.is_empty() {
            all.push(format!("there is no room {room}"));
        }
        let Known::These(known) = may_know else {
            continue;
        };
        let named: Vec<_> = own.iter().flat_map(|source| source.names()).collect();
        let idle = known
            .iter()
            .filter(|known| !named.iter().any(|(_, path)| path.is_within(known)));
        all.extend(idle.map(|known| format!("{room} does not use {known}")));
    }
    all
}

#[test]
fn every_file_keeps_to_its_room() {
    let markdown = std::fs::read_to_string("ARCHITECTURE.md").expect("ARCHITECTURE.md");
    let table = rows(&markdown).unwrap_or_else(|why| panic!("ARCHITECTURE.md: {why}"));
    let sources: Vec<_> = FOLDERS
        .iter()
        .flat_map(|folder| Source::all(Path::new(folder)))
        .collect();
    assert!(table.len() > 15 && sources.len() > 100);
    let mut all: Vec<String> = sources
        .iter()
        .flat_map(|source| violations(source, &table))
        .collect();
    all.extend(
        idle(&table, &sources)
            .iter()
            .map(|what| format!("ARCHITECTURE.md: {what}")),
    );
    assert!(all.is_empty(), "{}", all.join("\n"));
}
