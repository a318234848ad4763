//! The pages of `vkpt converge --html` and, in `check`, of `vkpt check --html` in a real browser: they show the data of
//! the records, in every view.
//!
//! Needs Chromium in PATH. Pictures of the page are in `target/screenshots/` afterwards.

pub mod browser;
mod check;

use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::root;

use browser::Browser;

/// A finished experiment.
struct Report {
    folder: TempDir,
    record: Value,
}

impl Report {
    fn page(&self) -> PathBuf {
        self.folder.path().join("r.html")
    }

    fn step(&self, variant: usize, step: usize) -> &Value {
        &self.record["variants"][variant]["steps"][step]
    }

    /// Steps of the first variant; all have as many.
    fn last(&self) -> usize {
        let steps = self.record["variants"][0]["steps"].as_array();
        steps.expect("steps").len() - 1
    }
}

/// A small room by two estimators, without Vulkan; made once for all tests.
fn report() -> &'static Report {
    static REPORT: OnceLock<Report> = OnceLock::new();
    REPORT.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::copy(root().join("scenes/room.txt"), folder.path().join("room.txt")).expect("a scene");
        let arguments = "converge room.txt --device cpu-f32 --size 60x60 --time 3 --spp 16 --replicates 4 --quiet \
             --vary connect=mis,bsdf --html r.html --json r.json";
        let done = Command::new(env!("CARGO_BIN_EXE_vkpt"))
            .args(arguments.split_whitespace())
            .current_dir(folder.path())
            .env("VKPT_CACHE", "")
            .output()
            .expect("the program runs");
        assert!(done.status.success(), "{done:?}");
        let text = std::fs::read_to_string(folder.path().join("r.json")).expect("a record");
        let record = serde_json::from_str(&text).expect("JSON");
        Report { folder, record }
    })
}

/// The page in a window of a desktop.
fn opened() -> Option<(Browser, &'static Report)> {
    let mut browser = Browser::start()?;
    let report = report();
    browser.window(1280, 900);
    browser.media("screen", "light");
    browser.open(&report.page());
    Some((browser, report))
}

/// No errors and no requests.
fn quiet(browser: &Browser) {
    assert_eq!(browser.complaints(), Vec::<String>::new());
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// The first number after `word` in a text.
fn after(text: &str, word: &str) -> f64 {
    let rest = text
        .split_once(word)
        .unwrap_or_else(|| panic!("no {word}: {text}"))
        .1;
    let end = rest.find(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c)));
    rest[..end.unwrap_or(rest.len())].parse().expect("a number")
}

fn target(variant: usize, step: usize) -> String {
    format!(
        "document.querySelector('.wide .target[data-variant=\"{variant}\"][data-step=\"{step}\"]')"
    )
}

const TIP: &str =
    "(() => { const t = document.querySelector('.tip'); return t.hidden ? '' : t.innerText; })()";

#[test]
fn a_point_shows_its_figures() {
    let Some((mut browser, report)) = opened() else {
        return;
    };
    assert_eq!(browser.text(TIP), "");
    for (variant, name) in [(0, "connect=mis"), (1, "connect=bsdf")] {
        for step in [0, report.last()] {
            browser.point(&target(variant, step), false);
            let message = browser.text(TIP);
            let record = report.step(variant, step);
            let mean = &record["errors"]["rel_mse"]["mean"];
            assert!(message.contains(name), "{message}");
            assert!(
                message.contains(&format!("{} spp", record["spp"])),
                "{message}"
            );
            // Three digits are shown.
            let agrees = |found: f64, expected: f64| (found / expected - 1.0).abs() < 6e-3;
            assert!(
                agrees(after(&message, "\nrelMSE "), number(&mean["value"])),
                "{message}"
            );
            assert!(
                agrees(after(&message, " ("), number(&mean["low"])),
                "{message}"
            );
            // Planted: another step's error is not taken for this one's.
            let other = report.step(variant, report.last() - step);
            assert!(!agrees(
                after(&message, "\nrelMSE "),
                number(&other["errors"]["rel_mse"]["mean"]["value"])
            ));
        }
    }
    browser.screenshot("point");
    // The same by keyboard: focus shows them, Escape ends it.
    browser.value(&format!("{}.focus()", target(0, 0)));
    assert!(browser.text(TIP).contains("connect=mis\n1 spp"));
    browser.key("Escape", 27);
    assert_eq!(browser.text(TIP), "");
    quiet(&browser);
}

/// The visible contents: variant and step of each picture, the captions, and where the pictures' data differ.
const SHOWN: &str = "(() => {
    const visible = [...document.querySelectorAll('.step')].filter((e) => e.checkVisibility() || e.querySelector('figure').checkVisibility());
    return { which: visible.map((e) => e.dataset.variant + ',' + e.dataset.step),
             caption: visible[0].querySelector('figcaption').innerText,
             source: visible[0].querySelector('img').src,
             width: visible[0].querySelector('img').naturalWidth,
             references: [...document.querySelectorAll('.reference')].filter((e) => e.checkVisibility()).length,
             output: document.querySelector('output').innerText };
})()";

#[test]
fn the_slider_shows_the_picture_of_its_step() {
    let Some((mut browser, report)) = opened() else {
        return;
    };
    let last = report.last();
    let check = |browser: &mut Browser, variant: usize, step: usize| -> String {
        let shown = browser.value(SHOWN);
        assert_eq!(
            shown["which"],
            serde_json::json!([format!("{variant},{step}")])
        );
        let caption = shown["caption"].as_str().expect("a caption");
        let record = report.step(variant, step);
        let spp = format!("{} spp", record["spp"]);
        assert!(caption.starts_with(&spp), "{caption}");
        assert_eq!(shown["output"].as_str(), Some(spp.as_str()));
        let own = number(&record["errors"]["rel_mse"]["replicates"][0]);
        assert!(
            (after(caption, "relMSE ") / own - 1.0).abs() < 6e-3,
            "{caption}"
        );
        assert_eq!(
            (&shown["width"], &shown["references"]),
            (&60.into(), &1.into())
        );
        shown["source"].as_str().expect("a picture").to_owned()
    };
    let mut sources = vec![check(&mut browser, 0, last)];
    // By keyboard, one step back, then to the first.
    browser.value("document.querySelector('#step').focus()");
    browser.key("ArrowLeft", 37);
    sources.push(check(&mut browser, 0, last - 1));
    browser.key("Home", 36);
    sources.push(check(&mut browser, 0, 0));
    // By its value, as a finger leaves it.
    browser.value("(() => { const s = document.querySelector('#step'); s.value = 1; s.dispatchEvent(new Event('input')); })()");
    sources.push(check(&mut browser, 0, 1));
    // The other variant at the same step; then by a point of the plot.
    browser.point(
        "document.querySelector('input[name=variant][value=\"1\"]')",
        true,
    );
    sources.push(check(&mut browser, 1, 1));
    browser.point(&target(0, 2), true);
    sources.push(check(&mut browser, 0, 2));
    sources.sort();
    sources.dedup();
    assert_eq!(sources.len(), 6, "each has a picture of its own");
    quiet(&browser);
}

#[test]
fn a_worst_pixel_is_marked_where_it_is() {
    let Some((mut browser, _)) = opened() else {
        return;
    };
    let marks = "[...document.querySelectorAll('.mark')].filter((e) => e.checkVisibility()).length";
    assert_eq!(browser.value(marks), 0);
    browser.point("document.querySelectorAll('.worst .pick')[2]", true);
    // Picture, reference and map.
    assert_eq!(browser.value(marks), 3);
    // The middle of the ring, in pixels of the film, lies in the middle of the pixel that the button names.
    let off = browser.value(
        "(() => { const [x, y] = document.querySelectorAll('.worst .pick')[2].innerText.split(',').map(Number);
          const m = [...document.querySelectorAll('.mark')].find((e) => e.checkVisibility());
          const [a, b] = [m, m.parentElement].map((e) => e.getBoundingClientRect());
          const at = [(a.x + a.width / 2 - b.x) / b.width * 60, (a.y + a.height / 2 - b.y) / b.height * 60];
          return Math.hypot(at[0] - x - .5, at[1] - y - .5); })()",
    );
    assert!(number(&off) < 0.1, "{off}");
    let named =
        browser.text("document.querySelectorAll('.worst .pick')[2].innerText.replace(' ', '')");
    let command = browser.text("document.querySelector('.worst pre').innerText");
    assert!(command.contains(&format!("--trace {named},0")), "{command}");
    assert!(
        command.starts_with("vkpt room.txt --size 60x60"),
        "{command}"
    );
    browser.screenshot("pixel");
    browser.point("document.querySelectorAll('.worst .pick')[2]", true);
    assert_eq!(browser.value(marks), 0);
    quiet(&browser);
}

#[test]
fn light_and_dark_can_be_read() {
    let Some((mut browser, _)) = opened() else {
        return;
    };
    let contrast = include_str!("contrast.js");
    let ground = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)";
    let paper =
        "getComputedStyle(document.querySelector('.wide rect')).fill.match(/\\d+/g).map(Number)";
    for (scheme, dark) in [("light", false), ("dark", true)] {
        browser.media("screen", scheme);
        let channels = browser.value(ground);
        let bright = channels
            .as_array()
            .expect("a colour")
            .iter()
            .all(|c| number(c) > 128.0);
        assert_eq!(bright, !dark, "{scheme}: {channels}");
        assert_eq!(
            browser.value(paper),
            channels,
            "the plot stands on the page's own ground"
        );
        assert_eq!(browser.value(contrast), serde_json::json!([]), "{scheme}");
        browser.screenshot(scheme);
    }
    // Planted: grey words.
    browser.value("document.querySelector('h2').style.color = '#777'");
    assert_eq!(browser.value(contrast).as_array().map(Vec::len), Some(1));
    quiet(&browser);
}

#[test]
fn a_phone_scrolls_one_way() {
    let Some((mut browser, _)) = opened() else {
        return;
    };
    // Not innerWidth: a phone makes that larger where a page is wider than its screen.
    let fits = |browser: &mut Browser, width: u32| {
        browser.value(&format!("document.documentElement.scrollWidth <= {width}"))
    };
    for width in [412, 768, 360] {
        browser.window(width, 740);
        assert_eq!(fits(&mut browser, width), true, "{width}");
    }
    let plot = "[...document.querySelectorAll('.plot')].filter((e) => e.checkVisibility()).map((e) => e.getBoundingClientRect().width / e.viewBox.baseVal.width)";
    let scale = browser.value(plot);
    // One of the two, and hardly scaled: its labels can be read.
    assert_eq!(scale.as_array().map(Vec::len), Some(1));
    assert!(number(&scale[0]) > 0.9, "{scale}");
    browser.screenshot("phone");
    browser.media("screen", "dark");
    browser.screenshot("phone-dark");
    // Planted: something wide.
    browser.value("document.querySelector('h1').style.width = '500px'");
    assert_eq!(fits(&mut browser, 360), false);
    quiet(&browser);
}

#[test]
fn paper_has_all_of_it() {
    let Some((mut browser, report)) = opened() else {
        return;
    };
    let seen = |browser: &mut Browser, what: &str| {
        let count = format!(
            "[...document.querySelectorAll('{what}')].filter((e) => e.checkVisibility({{contentVisibilityAuto: true}})).length"
        );
        browser.value(&count)
    };
    let steps = 2 * (report.last() + 1);
    assert_eq!(seen(&mut browser, ".step img"), 2);
    browser.media("print", "light");
    // The width of A4 at 96 dots an inch, without its margins.
    browser.window(688, 1000);
    assert_eq!(seen(&mut browser, ".step img"), 2 * steps);
    assert_eq!(seen(&mut browser, ".worst tbody tr"), 20);
    assert_eq!(seen(&mut browser, "details pre"), 1);
    assert_eq!(seen(&mut browser, ".controls"), 0);
    browser.screenshot("print");
    let wide = "Math.max(...[...document.querySelectorAll('table')].map((e) => e.getBoundingClientRect().right))";
    assert!(number(&browser.value(wide)) <= 688.0, "no table is cut off");
    quiet(&browser);
}

#[test]
fn without_scripts_all_pictures_are_there() {
    let Some((mut browser, report)) = opened() else {
        return;
    };
    let off = serde_json::json!({"value": true});
    browser.call("Emulation.setScriptExecutionDisabled", off);
    browser.open(&report.page());
    // The document's own nodes, asked without a script of the page.
    let shown = browser.value("[...document.querySelectorAll('.step img, .reference img')].filter((e) => e.checkVisibility()).length");
    assert_eq!(shown, 4 * (report.last() + 1) + 1);
    assert_eq!(
        browser.value("document.querySelector('.controls').checkVisibility()"),
        false
    );
    browser.screenshot("no-scripts");
}

/// Planted: a page that asks for something outside, and one that fails.
#[test]
fn a_complaint_is_heard() {
    let Some((mut browser, _)) = opened() else {
        return;
    };
    quiet(&browser);
    browser.value("new Promise((done) => { const i = new Image(); i.onerror = done; i.src = 'http://127.0.0.1:9/x.png'; }).then(() => 0)");
    assert!(!browser.complaints().is_empty(), "the network");
    let Some((mut browser, _)) = opened() else {
        return;
    };
    browser.value("new Promise((done) => setTimeout(() => { setTimeout(done, 50); throw new Error('planted'); }, 0)).then(() => 0)");
    assert!(!browser.complaints().is_empty(), "an error");
}
