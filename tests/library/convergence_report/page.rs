//! The page as a text: self-contained, and nothing in it is mistaken for markup. Its look and behaviour are
//! tested in `tests/commands/report_page`.

use vkpt::metrics::convergence::{Curve, Reference};
use vkpt_lab::converge::report::plot::palette::Colour;
use vkpt_lab::converge::report::{Convergence, Sheet, Shown, page};

use super::records::{curve, experiment, film, reference};
use crate::common::pages::{MARKUP, no_markup, outside};

const STEPS: [(f64, f64); 4] = [(0.1, 0.4), (0.2, 0.21), (0.4, 0.1), (0.8, 0.05)];

fn written(record: &Convergence, curves: &[&Curve], reference: &Reference, scene: &str) -> String {
    let sheet = Sheet {
        record,
        scene,
        command: "vkpt converge 'a b.scn' --html r.html".to_owned(),
        exposure: 0.0,
        shown: curves
            .iter()
            .map(|&curve| Shown {
                curve,
                reference,
                command: "vkpt 'a b.scn'".to_owned(),
            })
            .collect(),
    };
    page(&sheet).expect("a page")
}

fn one(scene_name: &str, text: &str) -> String {
    let curve = curve(&STEPS);
    let record = experiment(scene_name, &[("", &curve)]);
    written(&record, &[&curve], &reference(), text)
}

#[test]
fn it_is_whole_by_itself() {
    let page = one("a.scn", "screen 4 3\n");
    assert_eq!(outside(&page), Vec::<&str>::new());
    // A picture and a map a step, the reference, and the scale of the maps.
    assert_eq!(
        page.matches("src=\"data:image/png;base64,").count(),
        4 * 2 + 1 + 1
    );
    assert!(page.contains("default-src &#39;none&#39;") || page.contains("default-src 'none'"));
    for planted in [
        "<img src=\"x.png\">",
        "<a href=\"https://a.b\">",
        "<p style=\"background: url(//a.b/c)\">",
    ] {
        assert!(!outside(&(page.clone() + planted)).is_empty(), "{planted}");
    }
}

#[test]
fn equal_experiments_make_equal_pages() {
    assert_eq!(one("a.scn", "text"), one("a.scn", "text"));
}

#[test]
fn words_are_no_markup() {
    let page = one(MARKUP, MARKUP);
    let plain = one("a.scn", "text");
    no_markup(&page, &plain);
}

#[test]
fn the_page_shows_all_of_the_record() {
    let (a, b) = (curve(&STEPS), curve(&STEPS.map(|(s, e)| (s, 3.0 * e))));
    let mut record = experiment("a b.scn", &[("connect=mis", &a), ("connect=bsdf", &b)]);
    record.models_differ = true;
    record.interrupted = true;
    let page = written(&record, &[&a, &b], &reference(), "# a comment\n");
    for words in [
        "Convergence of a b.scn",
        "connect=bsdf",
        "a device",
        "a driver",
        "<span class=\"word\">b.scn'</span> <span class=\"word\">--html</span>",
        "# a comment",
        "seeds 0 to 1",
        "two halves",
        "Interrupted",
        "converge to different limits",
        "sampler=sobol",
        "×0.333",
        "250 ms of set-up before the first sample",
        "--trace",
    ] {
        assert!(page.contains(words), "{words}");
    }
    // Both variants have one reference: it is on the page once.
    assert_eq!(page.matches("<figure class=\"reference\"").count(), 1);
}

/// As where a setting of the model varies.
#[test]
fn a_reference_of_its_own_stands_beside_each_variant() {
    let curves = [curve(&STEPS), curve(&STEPS), curve(&STEPS)];
    let [a, b, c] = &curves;
    let record = experiment("a.scn", &[("x=1", a), ("x=2", b), ("x=3", c)]);
    let first = reference();
    let second = Reference::picture(film(1.5), None).expect("a picture");
    let shown = [(a, &first), (b, &second), (c, &first)];
    let sheet = Sheet {
        record: &record,
        scene: "",
        command: String::new(),
        exposure: 0.0,
        shown: shown
            .map(|(curve, reference)| Shown {
                curve,
                reference,
                command: String::new(),
            })
            .into(),
    };
    let page = page(&sheet).expect("a page");
    let named = |before: &str| -> Vec<String> {
        let all = page.match_indices(before);
        all.map(|(at, _)| page[at + before.len()..].chars().take(1).collect())
            .collect()
    };
    assert_eq!(
        named("<figure class=\"reference\" data-reference=\""),
        ["0", "1"]
    );
    let radios = named("name=\"variant\" value=\"");
    assert_eq!(radios, ["0", "1", "2"]);
    let inputs = page.split("name=\"variant\"").skip(1);
    let judged: Vec<_> = inputs
        .filter_map(|input| input.split_once("data-reference=\""))
        .map(|(_, rest)| &rest[..1])
        .collect();
    assert_eq!(judged, ["0", "1", "0"]);
}

/// Each colour of the plot has its counterpart, and every colour of the SVG has one.
#[test]
fn the_dark_theme_knows_every_colour_of_the_plot() {
    let page = one("a.scn", "");
    let svg = &page[page.find("<svg").expect("a plot")..page.rfind("</svg>").expect("its end")];
    for group in svg.match_indices(" color=\"#").map(|(at, _)| &svg[..at]) {
        let name = group.rsplit('"').nth(1).expect("a class");
        let colour = Colour::all().find(|c| c.name == name);
        let colour = colour.unwrap_or_else(|| panic!("{name}"));
        assert!(page.contains(&format!(" --{name}: {};", colour.dark)));
        assert!(page.contains(&format!(".plot .{name} {{ color: var(--{name}); }}")));
    }
}
