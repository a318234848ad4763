//! Lines, markers and text in SVG, through plotters.

use plotters::coord::Shift;
use plotters::element::Drawable;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::PlotError;
use super::palette::{Colour, GUIDE, OWN, PAPER};

/// A place in CSS pixels from the top left.
pub type Place = [f64; 2];

/// plotters counts in whole units: a tenth of a pixel each, so that rounding moves nothing visibly.
pub const UNITS: f64 = 10.0;

/// plotters divides the size of a font by this before writing it.
const FONT: f64 = 1.24;

/// The drawing surface.
pub struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

/// Text style: size in pixels, colour, and the anchor of placement.
#[derive(Clone, Copy)]
pub struct Type {
    pub size: f64,
    pub colour: Colour,
    pub anchor: HPos,
    pub bold: bool,
    /// Reads from bottom to top.
    pub upright: bool,
}

/// The marker of a measured point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    Wedge,
}

impl Marker {
    /// The marker of variant `i`. The numbers of markers and colours are coprime: 35 variants differ in one or both.
    pub fn of_variant(i: usize) -> Self {
        [
            Self::Circle,
            Self::Square,
            Self::Triangle,
            Self::Diamond,
            Self::Wedge,
        ][i % 5]
    }

    /// Its corners around 0,0; all shapes have about the same area, and a circle has no corners.
    fn corners(self) -> &'static [Place] {
        match self {
            Self::Circle => &[],
            Self::Square => &[[-3.6, -3.6], [3.6, -3.6], [3.6, 3.6], [-3.6, 3.6]],
            Self::Triangle => &[[0.0, -5.2], [4.9, 3.4], [-4.9, 3.4]],
            Self::Diamond => &[[0.0, -5.3], [5.3, 0.0], [0.0, 5.3], [-5.3, 0.0]],
            Self::Wedge => &[[0.0, 5.2], [4.9, -3.4], [-4.9, -3.4]],
        }
    }
}

impl<'a> Canvas<'a> {
    /// An empty sheet of `size` pixels, drawn to `svg`.
    pub fn new(svg: &'a mut String, size: Place) -> Result<Self, PlotError> {
        let [width, height] = size.map(|side| units(side).max(0) as u32);
        let area = SVGBackend::with_string(svg, (width, height)).into_drawing_area();
        area.fill(&rgb(PAPER))?;
        Ok(Self { area })
    }

    /// For elements that plotters lays out itself.
    pub fn area(&self) -> &DrawingArea<SVGBackend<'a>, Shift> {
        &self.area
    }

    pub fn line(&self, points: &[Place], colour: Colour, width: f64) -> Result<(), PlotError> {
        let points: Vec<_> = points.iter().map(|&p| backend(p)).collect();
        self.draw(&PathElement::new(points, stroke(colour, width)))
    }

    /// Hollow: the paper shows through, for an inconclusive point.
    pub fn marker(
        &self,
        at: Place,
        (marker, colour): (Marker, Colour),
        hollow: bool,
    ) -> Result<(), PlotError> {
        let filled = rgb(if hollow { PAPER } else { colour }).filled();
        let outline = stroke(if hollow { colour } else { PAPER }, 1.2);
        if marker == Marker::Circle {
            let radius = units(4.0);
            self.draw(&Circle::new(backend(at), radius, filled))?;
            return self.draw(&Circle::new(backend(at), radius, outline));
        }
        let corner = |[x, y]: &Place| backend([at[0] + x, at[1] + y]);
        let mut corners: Vec<_> = marker.corners().iter().map(corner).collect();
        self.draw(&Polygon::new(corners.clone(), filled))?;
        corners.extend(corners.first().copied());
        self.draw(&PathElement::new(corners, outline))
    }

    /// Text, vertically centred on `at`.
    pub fn text(&self, text: &str, at: Place, form: Type) -> Result<(), PlotError> {
        let mut font = FontDesc::new(
            FontFamily::SansSerif,
            form.size * UNITS * FONT,
            if form.bold {
                FontStyle::Bold
            } else {
                FontStyle::Normal
            },
        );
        if form.upright {
            font = font.transform(FontTransform::Rotate270);
        }
        let colour = rgb(form.colour);
        let style = TextStyle::from(font)
            .color(&colour)
            .pos(Pos::new(form.anchor, VPos::Center));
        Ok(self.area.draw_text(text, &style, backend(at))?)
    }

    fn draw<E>(&self, element: &E) -> Result<(), PlotError>
    where
        for<'b> &'b E: plotters::element::PointCollection<'b, (i32, i32)>,
        E: Drawable<SVGBackend<'a>>,
    {
        Ok(self.area.draw(element)?)
    }
}

/// A whole document from plotters' output: with the intended size, a name for screen readers, and dashed lines where
/// their role needs it.
pub fn document(drawn: &str, [width, height]: Place, name: &str) -> String {
    let content = drawn.split_once('>').map_or("", |(_, content)| content);
    let (w, h) = (width * UNITS, height * UNITS);
    let head = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" aria-label=\"{}\" \
         width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {w} {h}\" stroke-linejoin=\"round\">",
        escaped(name)
    );
    let dashed = |text: String, colour: Colour, dashes: &str| {
        let stroke = format!("stroke=\"{}\"", colour.hex());
        text.replace(&stroke, &format!("{stroke} stroke-dasharray=\"{dashes}\""))
    };
    let content = dashed(content.to_owned(), GUIDE, "60 40");
    head + &dashed(content, OWN, "12 28")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn backend([x, y]: Place) -> (i32, i32) {
    (units(x), units(y))
}

/// Plotters' units in pixels.
pub fn pixels((x, y): (i32, i32)) -> Place {
    [x, y].map(|unit| f64::from(unit) / UNITS)
}

/// Pixels in plotters' units.
pub fn units(pixels: f64) -> i32 {
    (pixels * UNITS).round() as i32
}

fn stroke(colour: Colour, width: f64) -> ShapeStyle {
    rgb(colour).stroke_width(units(width).max(0) as u32)
}

fn rgb(colour: Colour) -> RGBColor {
    let [r, g, b] = colour.light;
    RGBColor(r, g, b)
}
