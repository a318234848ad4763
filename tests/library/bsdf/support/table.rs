//! The reference tables, `../shared/spec/tables`.

use std::collections::HashMap;
use std::path::Path;

use vkpt::settings::Distribution;

/// A table: names of the columns, and the cells of each row.
pub struct Table {
    columns: HashMap<String, usize>,
    rows: Vec<Vec<String>>,
}

/// A row of a [`Table`].
pub struct Row<'a> {
    table: &'a Table,
    cells: &'a [String],
}

impl Table {
    /// Reads a table; `None`, with a line that says so, where the tables are not at hand.
    pub fn open(name: &str) -> Option<Self> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/spec/tables");
        let path = folder.join(name);
        let Ok(text) = std::fs::read_to_string(&path) else {
            println!("skipped: the reference table {} is absent", path.display());
            return None;
        };
        let mut lines = text
            .lines()
            .map(|l| l.split(',').map(str::to_owned).collect::<Vec<_>>());
        let header = lines.next().expect("a header");
        let columns = header
            .into_iter()
            .enumerate()
            .map(|(i, n)| (n, i))
            .collect();
        let rows: Vec<_> = lines.collect();
        assert!(!rows.is_empty(), "{name} has no rows");
        Some(Self { columns, rows })
    }

    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|cells| Row { table: self, cells })
    }
}

impl Row<'_> {
    pub fn text(&self, column: &str) -> &str {
        &self.cells[self.table.columns[column]]
    }
    pub fn number(&self, column: &str) -> f64 {
        self.text(column).parse().expect("a number")
    }
    pub fn outside(&self) -> bool {
        self.text("side") == "outside"
    }
    pub fn distribution(&self) -> Distribution {
        match self.text("D") {
            "phong" => Distribution::Phong,
            "beckmann" => Distribution::Beckmann,
            "ggx" => Distribution::Ggx,
            other => panic!("no distribution is called {other}"),
        }
    }
}
