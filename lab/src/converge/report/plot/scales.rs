//! The scales of the curves: axes with ticks and titles, and the lines of slope −½.

use plotters::style::text_anchor::HPos;

use super::axes::{Axes, Tick, plain, seconds, ticks};
use super::canvas::{Canvas, Place, Type};
use super::palette::{GRID, GUIDE, INK, MUTED};
use super::{LABEL, PlotError};

/// A plot in progress.
pub struct Sheet<'a> {
    pub canvas: Canvas<'a>,
    pub axes: Axes<'a>,
}

impl Sheet<'_> {
    /// Grid lines, ticks, labels and titles of the axes.
    pub fn scales(&self, narrow: bool) -> Result<(), PlotError> {
        let [left, top, right, bottom] = self.axes.frame;
        let [across, up] = &self.axes.spans;
        // Labels side by side need more space than those above one another.
        for tick in ticks(across, if narrow { 1 } else { 2 }) {
            let x = self.axes.place(tick.value, up.start)[0];
            self.tick(&tick, [[x, bottom], [x, top]], [x, bottom + 17.0], seconds)?;
        }
        for tick in ticks(up, 2) {
            let y = self.axes.place(across.start, tick.value)[1];
            self.tick(&tick, [[left, y], [right, y]], [left - 8.0, y], plain)?;
        }
        let title = Type {
            colour: INK,
            ..LABEL
        };
        let upright = Type {
            upright: true,
            ..title
        };
        let middle = [0.5 * (left + right), 0.5 * (top + bottom)];
        let canvas = &self.canvas;
        canvas.text(
            "wall-clock seconds per replicate",
            [middle[0], bottom + 39.0],
            title,
        )?;
        canvas.text("relative error, √relMSE", [12.0, middle[1]], upright)?;
        if !narrow {
            self.right_scale()?;
            canvas.text("relMSE", [right + 48.0, middle[1]], upright)?;
        }
        canvas.line(&[[left, top], [left, bottom], [right, bottom]], MUTED, 1.0)
    }

    /// A line across the plot at each power of ten, a short one at other ticks.
    fn tick(
        &self,
        tick: &Tick,
        [from, to]: [Place; 2],
        label: Place,
        words: fn(f64) -> String,
    ) -> Result<(), PlotError> {
        if tick.decade {
            self.canvas.line(&[from, to], GRID, 1.0)?;
        }
        let length = if tick.labelled { 5.0 } else { 3.0 };
        let whole = (to[0] - from[0]).hypot(to[1] - from[1]);
        let inwards = [0, 1].map(|i| from[i] + (to[i] - from[i]) / whole * length);
        self.canvas.line(&[from, inwards], MUTED, 1.0)?;
        if !tick.labelled {
            return Ok(());
        }
        let upright = from[0] == to[0];
        let anchor = if upright { HPos::Center } else { HPos::Right };
        self.canvas
            .text(&words(tick.value), label, Type { anchor, ..LABEL })
    }

    /// The powers of ten of relMSE, the square of the left axis.
    fn right_scale(&self) -> Result<(), PlotError> {
        let [across, up] = &self.axes.spans;
        let right = self.axes.frame[2];
        let squares = up.start * up.start..up.end * up.end;
        for tick in ticks(&squares, 0).iter().filter(|tick| tick.decade) {
            let y = self.axes.place(across.start, tick.value.sqrt())[1];
            self.canvas
                .line(&[[right, y], [right + 5.0, y]], MUTED, 1.0)?;
            let left = Type {
                anchor: HPos::Left,
                ..LABEL
            };
            self.canvas
                .text(&plain(tick.value), [right + 9.0, y], left)?;
        }
        Ok(())
    }

    /// Lines of slope −½ through the plot, a power of ten of efficiency apart.
    pub fn guides(&self) -> Result<(), PlotError> {
        let [across, up] = &self.axes.spans;
        let least = up.start * up.start * across.start;
        let most = up.end * up.end * across.end;
        for tick in ticks(&(least..most), 0).iter().filter(|tick| tick.decade) {
            if let Some(line) = self.axes.guide(tick.value) {
                self.canvas.line(&line, GUIDE, 1.0)?;
            }
        }
        Ok(())
    }
}
