//! The reference tables, `tests/data/tables`.

use std::collections::HashMap;
use std::fmt::{self, Debug, Formatter};

use vkpt::settings::Distribution;

use super::data::data;

/// A table: names of the columns, and the cells of each row.
pub struct Table {
    columns: HashMap<String, usize>,
    rows: Vec<Vec<String>>,
}

/// A row of a [`Table`]; shown as its cells.
pub struct Row<'a> {
    table: &'a Table,
    cells: &'a [String],
}

impl Table {
    /// Reads `tests/data/tables/NAME`.
    pub fn open(name: &str) -> Self {
        let path = data("tables").join(name);
        let text =
            std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
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
        Self { columns, rows }
    }

    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|cells| Row { table: self, cells })
    }
}

impl Debug for Row<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&self.cells.join(","))
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
