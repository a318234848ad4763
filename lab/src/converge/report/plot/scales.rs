//! The scales of the curves: axes with ticks and titles, and the lines of slope −½.

use maud::{Markup, html};

use super::axes::Axes;
use super::draw::{line, text, upright};
use super::palette::{GRID, GUIDE, INK, MUTED};
use super::ticks::{Tick, decades, plain, seconds, ticks};

/// Lines across at each power of ten, ticks, labels and the names of the axes.
pub fn scales(axes: &Axes, narrow: bool) -> Markup {
    let [left, top, right, bottom] = axes.frame;
    let [across, up] = &axes.spans;
    // Labels side by side need more room than one above the other.
    let columns = ticks(across, if narrow { 1 } else { 2 });
    let rows = ticks(up, 2);
    let length = |tick: &Tick| if tick.labelled { 5.0 } else { 3.0 };
    let [middle, centre] = [0.5 * (left + right), 0.5 * (top + bottom)];
    let grid = html! {
        @for x in columns.iter().filter(|t| t.decade).map(|t| axes.x(t.value)) {
            (line(&[[x, bottom], [x, top]], 1.0))
        }
        @for y in rows.iter().filter(|t| t.decade).map(|t| axes.y(t.value)) {
            (line(&[[left, y], [right, y]], 1.0))
        }
    };
    let marks = html! {
        @for tick in &columns {
            @let x = axes.x(tick.value);
            (line(&[[x, bottom], [x, bottom - length(tick)]], 1.0))
            @if tick.labelled { (text(&seconds(tick.value), [x, bottom + 17.0], "middle")) }
        }
        @for tick in &rows {
            @let y = axes.y(tick.value);
            (line(&[[left, y], [left + length(tick), y]], 1.0))
            @if tick.labelled { (text(&plain(tick.value), [left - 8.0, y], "end")) }
        }
        (line(&[[left, top], [left, bottom], [right, bottom]], 1.0))
        @if !narrow { (squares(axes)) }
    };
    let titles = html! {
        (text("wall-clock seconds per replicate", [middle, bottom + 39.0], "middle"))
        (upright("relative error, √relMSE", [12.0, centre]))
        @if !narrow { (upright("relMSE", [right + 48.0, centre])) }
    };
    html! { (GRID.group(grid)) (MUTED.group(marks)) (INK.group(titles)) }
}

/// The powers of ten of relMSE, the square of the left axis.
fn squares(axes: &Axes) -> Markup {
    let right = axes.frame[2];
    let up = &axes.spans[1];
    html! {
        @for square in decades(up.start * up.start..up.end * up.end) {
            @let y = axes.y(square.sqrt());
            (line(&[[right, y], [right + 5.0, y]], 1.0))
            (text(&plain(square), [right + 9.0, y], "start"))
        }
    }
}

/// Lines of slope −½ through the plot, a power of ten of efficiency apart.
pub fn guides(axes: &Axes) -> Markup {
    let [across, up] = &axes.spans;
    let products = up.start * up.start * across.start..up.end * up.end * across.end;
    GUIDE.group(html! {
        @for ends in decades(products).filter_map(|c| axes.guide(c)) { (line(&ends, 1.0)) }
    })
}
