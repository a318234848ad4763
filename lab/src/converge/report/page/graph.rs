//! The plot in the page: it follows the reader's theme, and each point shows its figures.

use maud::{Markup, html};

use super::super::Convergence;
use super::super::plot::palette::Colour;
use super::super::plot::{self, Form, Plot, Point};
use super::super::words::{between, number, with_half_width};
use vkpt::report::human::duration;

/// Two layouts, of which a page shows the one that fits: labels of a wide plot scaled to a phone would be unreadable.
const FORMS: [(&str, f64); 2] = [("wide", 960.0), ("narrow", 340.0)];

/// The section with the plot.
pub fn graph(e: &Convergence) -> Markup {
    html! {
        section #plot {
            h2 { "Error over seconds" }
            figure.graph {
                @for (class, width) in FORMS {
                    div class=(class) { (with_targets(e, &plot::plot(e, Form { width, title: false }))) }
                }
                div.tip role="status" hidden {}
                figcaption {
                    "Mean of the replicates with its 95 % interval (Student’s t) over the seconds of sampling of one \
                     replicate, without compiling. Efficiency is constant along each dashed line, of slope −½: curves of \
                     independent samples run parallel to it, that of a biased estimator flattens."
                }
            }
        }
    }
}

/// The plot with a target over each point, large enough for a finger, with a description of the point. It is a group,
/// because screen readers skip the parts of an image.
fn with_targets(e: &Convergence, plot: &Plot) -> Markup {
    html! {
        svg.plot role="group" aria-label=(plot::name(e)) viewBox=(plot.view()) {
            (plot.drawn)
            @for point in &plot.points {
                @let label = label(e, point);
                @let [x, y] = point.at;
                g.target tabindex="0" role="img" aria-label=(label)
                    data-variant=(point.variant) data-step=(point.step) {
                    circle cx=(x) cy=(y) r="11" {}
                    title { (label) }
                }
            }
        }
    }
}

/// A line for each figure of a step.
fn label(e: &Convergence, point: &Point) -> String {
    let variant = &e.variants[point.variant];
    let step = &variant.steps[point.step];
    let error = &step.errors.rel_mse;
    let mean = error.summary.mean;
    let mut lines = Vec::new();
    if !variant.name.is_empty() {
        lines.push(variant.name.clone());
    }
    lines.push(format!(
        "{} spp · {}",
        step.spp,
        duration(step.wall_s.value)
    ));
    lines.push(format!(
        "relMSE {} ({})",
        number(mean.value),
        between(&mean)
    ));
    lines.push(format!("√relMSE {}", number(mean.value.max(0.0).sqrt())));
    lines.extend(step.slope.map(|s| format!("slope {}", with_half_width(&s))));
    if error.below_reference {
        lines.push("not above the reference’s own error".to_owned());
    }
    lines.join("\n")
}

/// CSS that gives the plot the colours of the reader's theme: a rule overrides an SVG attribute.
pub fn colours() -> String {
    let each = |line: fn(Colour) -> String| Colour::all().map(line).collect::<String>();
    let light = each(|c| format!(" --{}: {};", c.name, c.light));
    let dark = each(|c| format!(" --{}: {};", c.name, c.dark));
    let rules = each(|c| format!(".plot .{0} {{ color: var(--{0}); }}\n", c.name));
    format!(
        ".plot {{{light} }}\n@media screen and (prefers-color-scheme: dark) {{\n.plot {{{dark} }}\n}}\n{rules}"
    )
}
