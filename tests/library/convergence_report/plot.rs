//! Points lie where logarithms between the labels of the ticks say.

use roxmltree::{Document, Node};
use vkpt_lab::converge::report::plot::palette::{Colour, GUIDE, INK, MUTED, OWN, PAPER, SERIES};
use vkpt_lab::converge::report::plot::{Form, plot};
use vkpt_lab::converge::report::svg;

use super::records::{curve, experiment};

type Place = [f64; 2];

/// Places are rounded to a tenth of a pixel, each end of a difference once.
const ROUNDING: f64 = 0.2;

/// Seconds and relMSE of 1, 2, 4 … samples that are independent and cost a tenth of a second each.
fn independent() -> Vec<(f64, f64)> {
    (0..8)
        .map(|i| 2f64.powi(i))
        .map(|n| (0.1 * n, 2.0 / n))
        .collect()
}

/// Whether an element is in a group of a colour.
fn is_of(node: &Node, colour: Colour) -> bool {
    let mut groups = node.ancestors();
    groups.any(|g| {
        g.attribute("class") == Some(colour.name) && g.attribute("color") == Some(colour.light)
    })
}

/// The points of all lines of a colour.
fn lines(svg: &str, colour: Colour) -> Vec<Vec<Place>> {
    let document = Document::parse(svg).expect("XML");
    let of_colour =
        |n: &Node| n.has_tag_name(("http://www.w3.org/2000/svg", "polyline")) && is_of(n, colour);
    let points = |n: Node| {
        let pairs = n.attribute("points").expect("points").split_whitespace();
        let number = |word: &str| word.parse::<f64>().expect("a number");
        pairs
            .map(|p| p.split_once(',').expect("x,y"))
            .map(|(x, y)| [number(x), number(y)])
            .collect()
    };
    document
        .descendants()
        .filter(of_colour)
        .map(points)
        .collect()
}

/// The place of a tick's label.
fn label(svg: &str, text: &str) -> Place {
    let document = Document::parse(svg).expect("XML");
    let found = document
        .descendants()
        .find(|n| {
            n.has_tag_name(("http://www.w3.org/2000/svg", "text"))
                && n.text().is_some_and(|t| t.trim() == text)
        })
        .unwrap_or_else(|| panic!("no label {text}"));
    ["x", "y"].map(|a| {
        found
            .attribute(a)
            .expect("a place")
            .parse()
            .expect("a number")
    })
}

/// Where seconds and √relMSE are by the labels of two ticks of each axis.
fn expected(svg: &str, (seconds, rel_mse): (f64, f64)) -> Place {
    let along = |i: usize, [a, b]: [&str; 2], decades: f64, from: f64, value: f64| {
        let (a, b) = (label(svg, a)[i], label(svg, b)[i]);
        a + (b - a) * (value / from).log10() / decades
    };
    [
        along(0, ["100 ms", "10 s"], 2.0, 0.1, seconds),
        along(1, ["0.1", "1"], 1.0, 0.1, rel_mse.sqrt()),
    ]
}

fn near(a: Place, b: Place) -> bool {
    (0..2).all(|i| (a[i] - b[i]).abs() <= ROUNDING)
}

/// The curve of the first variant: its only line of more than two points.
fn drawn(svg: &str) -> Vec<Place> {
    let mut all = lines(svg, SERIES[0]);
    all.retain(|line| line.len() > 5);
    assert_eq!(all.len(), 1);
    all.remove(0)
}

fn slope(line: &[Place]) -> f64 {
    let (a, b) = (line[0], line[line.len() - 1]);
    (b[1] - a[1]) / (b[0] - a[0])
}

#[test]
fn points_lie_where_the_ticks_say() {
    let steps = independent();
    let svg = svg(&experiment("a.scn", &[("", &curve(&steps))]));
    let line = drawn(&svg);
    assert_eq!(line.len(), steps.len());
    for (&at, &step) in line.iter().zip(&steps) {
        assert!(near(at, expected(&svg, step)), "{step:?}: {at:?}");
        // Planted: 3 % more time, or 3 % more error.
        assert!(!near(at, expected(&svg, (1.03 * step.0, step.1))));
        assert!(!near(at, expected(&svg, (step.0, 1.06 * step.1))));
    }
}

#[test]
fn errors_that_fall_by_the_root_of_time_are_parallel_to_the_guides() {
    let of = |power: f64| {
        let steps: Vec<_> = independent()
            .iter()
            .map(|&(s, _)| (s, 0.04 * s.powf(power)))
            .collect();
        svg(&experiment("a.scn", &[("", &curve(&steps))]))
    };
    let agree = |svg: &str| {
        let curve = slope(&drawn(svg));
        let guides = lines(svg, GUIDE);
        // The legend's sample is level.
        let guides: Vec<_> = guides.iter().filter(|g| slope(g) != 0.0).collect();
        assert!(guides.len() >= 3, "{}", guides.len());
        guides.iter().all(|g| {
            let length = (g[1][0] - g[0][0]).abs().min(1000.0);
            (slope(g) - curve).abs() <= 2.0 * ROUNDING / length
        })
    };
    assert!(agree(&of(-1.0)));
    // Planted: 5 % too flat.
    assert!(!agree(&of(-0.95)));
}

/// relMSE ± t₁·s/√2, Student's t of one degree of freedom 12.706: below 0 it ends at the axis.
#[test]
fn bars_end_where_the_intervals_do() {
    let mut wide = curve(&independent());
    for step in &mut wide.steps {
        // Replicates of 0.99 and 1.01: s/√2 = 0.01, the interval ± 12.7 %.
        let errors: Vec<f64> = step.means(vkpt::metrics::convergence::Metric::RelMse);
        let middle = 0.5 * (errors[0] + errors[1]);
        for (figures, factor) in step.figures.iter_mut().zip([0.99, 1.01]) {
            figures.rel_mse.all = factor * middle;
        }
    }
    let svg = svg(&experiment("a.scn", &[("", &wide)]));
    let bars: Vec<_> = lines(&svg, SERIES[0])
        .into_iter()
        .filter(|l| l.len() == 2 && l[0][0] == l[1][0])
        .collect();
    assert_eq!(bars.len(), 8);
    for (bar, (s, e)) in bars.iter().zip(independent()) {
        for (end, factor) in bar.iter().zip([1.0 - 0.127_06, 1.127_06]) {
            assert!(near(*end, expected(&svg, (s, factor * e))), "{end:?} {s}");
        }
    }
}

#[test]
fn inconclusive_points_are_hollow_and_those_without_a_logarithm_left_out() {
    let filled = |steps: &[(f64, f64)]| {
        let record = experiment("a.scn", &[("", &curve(steps))]);
        let text = svg(&record);
        let document = Document::parse(&text).expect("XML");
        let markers = |class: &str, fill: &str, colour: Colour| {
            let all = document.descendants();
            all.filter(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "path")))
                .filter(|n| {
                    n.attribute("class") == Some(class) && n.attribute("fill") == Some(fill)
                })
                .filter(|n| is_of(n, colour))
                .count()
        };
        let hollow = |colour| markers("hollow", PAPER.light, colour);
        // One in the legend; hollow ones have another there.
        (
            plot(&record, Form::FILE).points.len(),
            markers("filled", "currentColor", SERIES[0]) - 1,
            hollow(SERIES[0]) + hollow(MUTED),
        )
    };
    assert_eq!(filled(&[(1.0, 0.1), (2.0, 0.05)]), (2, 2, 0));
    // The reference itself is off by about 1e-6.
    assert_eq!(filled(&[(1.0, 1e-5), (2.0, 1e-7)]), (2, 1, 1 + 1));
    // Below 0 by chance, as an unbiased estimate may be: it is also below the reference's own.
    assert_eq!(filled(&[(1.0, 1e-5), (2.0, -1e-7)]).0, 1);
    let svg = svg(&experiment("a.scn", &[("", &curve(&[(1.0, 1e-5)]))]));
    assert!(!lines(&svg, OWN).is_empty(), "the reference's own error");
}

#[test]
fn variants_differ_in_colour_and_marker_and_names_are_text() {
    let c = curve(&independent());
    let name = "connect=<b>&\"mis\"";
    let names: Vec<String> = (0..40).map(|i| format!("{name} {i}")).collect();
    let variants: Vec<_> = names.iter().map(|n| (n.as_str(), &c)).collect();
    let svg = svg(&experiment("<script>&\".scn", &variants));
    assert!(!svg.contains("<script") && !svg.contains("<b>"));
    let document = Document::parse(&svg).expect("XML");
    let texts: Vec<_> = document
        .descendants()
        .filter_map(|n| n.text())
        .map(str::trim)
        .collect();
    assert!(texts.contains(&"<script>&\".scn") && texts.contains(&names[39].as_str()));
    let size = document.root_element();
    let height: f64 = size
        .attribute("height")
        .expect("a height")
        .parse()
        .expect("a number");
    for text in document
        .descendants()
        .filter(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "text")))
    {
        let y: f64 = text.attribute("y").expect("y").parse().expect("a number");
        assert!(y < height, "{:?} is cut off", text.text());
    }
}

/// Programs that know no CSS draw it as well: fonts and colours are attributes. What is seen has a name.
#[test]
fn a_file_needs_no_styles() {
    let svg = svg(&experiment("a\u{1}b.scn", &[("", &curve(&independent()))]));
    assert!(!svg.contains("<style") && !svg.contains("var("));
    let document = Document::parse(&svg).expect("XML");
    let root = document.root_element();
    assert_eq!(root.attribute("role"), Some("img"));
    let title = root
        .first_element_child()
        .filter(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "title")));
    assert_eq!(
        title.and_then(|n| n.text()),
        Some("Error of a\u{FFFD}b.scn over seconds")
    );
    let mut drawn = 0;
    for node in document.descendants() {
        for attribute in ["fill", "stroke"] {
            if node.attribute(attribute) == Some("currentColor") {
                drawn += 1;
                assert!(Colour::all().any(|colour| is_of(&node, colour)), "{node:?}");
            }
        }
    }
    assert!(drawn > 50, "{drawn}");
    let texts = document
        .descendants()
        .filter(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    for text in texts {
        for attribute in ["font-family", "font-size"] {
            assert!(
                text.ancestors().any(|n| n.has_attribute(attribute)),
                "{text:?}"
            );
        }
        assert!(is_of(&text, INK) || is_of(&text, MUTED), "{text:?}");
    }
}
