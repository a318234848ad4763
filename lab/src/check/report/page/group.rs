//! A group of cases: a table with two rows for each case: its figures, and the details that open below them.

use maud::{Markup, html};

use super::{Row, case, findings, opened};
use vkpt::image::EncodeError;

/// The section of a non-empty group.
pub fn group(cases: &[Row], opens: bool) -> Result<Markup, EncodeError> {
    let name = cases[0].0.group();
    let mut rows = Vec::new();
    for (case, shown) in cases {
        rows.push(html! {
            (case::figures(case, opens))
            tr.more {
                td colspan=(case::COLUMNS) { div.opened { (opened::opened(case, *shown)?) } }
            }
        });
    }
    Ok(html! {
        section id=(format!("group-{name}")) {
            h2 { (name) " " span.note { (findings::in_short(cases)) } }
            div.scroll.wide {
                table.cases {
                    (case::heads())
                    tbody { @for row in rows { (row) } }
                }
            }
        }
    })
}
