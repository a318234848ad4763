//! The page of `vkpt check --html`, made from planted records, which need no device.

use serde_json::json;
use tempfile::TempDir;
use vkpt_lab::check::report::{Check, Held, Sheet, page};

use super::browser::Browser;
use super::{number, quiet};
use crate::common::checks::{case, check, run, shown};

/// Two cases of which one fails, and nine of each colour.
fn record() -> Check {
    let mut cases = run().cases;
    let margins = [0.0, 0.2, 0.3, 0.5, 0.6, 0.75, 0.8, 0.999, 1.0];
    cases.extend(margins.into_iter().enumerate().map(|(i, margin)| {
        let held = vec![
            Held::new("99 %", margin, 1.0, "what is stiff about it ".repeat(12)),
            Held::new("NaN", 0.0, 0.0, "none"),
        ];
        let mut case = case(&format!("medium/one-channel-black/{i}e-6"), held);
        case.about = "glass that absorbs one channel wholly, and the others not at all".to_owned();
        case.expected = Some(0.8345);
        case
    }));
    check(cases)
}

/// The page in a window of a desktop; the folder is where it lies.
fn opened() -> Option<(Browser, TempDir)> {
    let mut browser = Browser::start()?;
    let record = record();
    let shown = vec![shown(); record.cases.len()];
    let sheet = Sheet {
        record: &record,
        command: "vkpt check --html r.html".to_owned(),
        shown: &shown,
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("r.html");
    std::fs::write(&file, page(&sheet).expect("a page")).expect("a file");
    browser.window(1280, 900);
    browser.media("screen", "light");
    browser.open(&file);
    Some((browser, folder))
}

/// Natural and shown widths of the visible pictures, once they are loaded.
const SEEN: &str = "(async () => {
    const all = [...document.querySelectorAll('.pictures img')].filter((e) => e.checkVisibility());
    await Promise.all(all.map((e) => e.decode()));
    return all.map((e) => [e.naturalWidth, e.getBoundingClientRect().width]);
})()";

const FIRST: &str = "document.getElementById('alpha/ggx/1e-3').querySelector('summary')";

#[test]
fn a_row_opens_by_its_name() {
    let Some((mut browser, _folder)) = opened() else {
        return;
    };
    // Failed cases are open: device, reference, difference, ten times as large as they are.
    let three = json!([[16, 160], [16, 160], [16, 160]]);
    assert_eq!(browser.value(SEEN), three);
    browser.point(FIRST, true);
    assert_eq!(browser.value(SEEN).as_array().map(Vec::len), Some(6));
    let more = browser.text("document.getElementById('alpha/ggx/1e-3').nextSibling.innerText");
    for words in ["energy", "chance", "1,048,576", "cpu-f64", "0.50"] {
        assert!(more.contains(words), "{words}: {more}");
    }
    browser.screenshot("check");
    browser.point(FIRST, true);
    assert_eq!(browser.value(SEEN), three);
    // By keyboard the same.
    browser.value(&format!("{FIRST}.focus()"));
    browser.key(" ", 32);
    assert_eq!(browser.value(SEEN).as_array().map(Vec::len), Some(6));
    quiet(&browser);
}

#[test]
fn failures_are_one_link_away() {
    let Some((mut browser, _folder)) = opened() else {
        return;
    };
    let row = "document.getElementById('furnace/rough-cylinder/2^-17').getBoundingClientRect().top";
    assert!(number(&browser.value(row)) > 450.0);
    browser.point("document.querySelector('.failures a')", true);
    let top = number(&browser.value(row));
    assert!((0.0..450.0).contains(&top), "{top}");
    quiet(&browser);
}

#[test]
fn light_and_dark_can_be_read() {
    let Some((mut browser, _folder)) = opened() else {
        return;
    };
    let contrast = include_str!("contrast.js");
    let ground = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)";
    // Luminance of the colours in the order of the margins: monotonous, so that they can be distinguished without hue.
    let bands = "['q1', 'q2', 'q3', 'q4', 'beyond'].map((c) => {
        const [r, g, b] = getComputedStyle(document.querySelector('.' + c)).backgroundColor.match(/\\d+/g).map(Number);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b; })";
    for (scheme, sign) in [("light", -1.0), ("dark", 1.0)] {
        browser.media("screen", scheme);
        let bright = number(&browser.value(ground)[0]) > 128.0;
        assert_eq!(bright, scheme == "light");
        assert_eq!(browser.value(contrast), json!([]), "{scheme}");
        let levels = browser.value(bands);
        let levels: Vec<f64> = levels
            .as_array()
            .expect("levels")
            .iter()
            .map(number)
            .collect();
        let steps = levels.windows(2).map(|pair| sign * (pair[1] - pair[0]));
        assert!(steps.clone().all(|step| step > 8.0), "{scheme}: {levels:?}");
        browser.screenshot(&format!("check-{scheme}"));
    }
    quiet(&browser);
}

#[test]
fn a_phone_scrolls_one_way() {
    let Some((mut browser, _folder)) = opened() else {
        return;
    };
    browser.point(FIRST, true);
    for width in [412, 768, 360] {
        browser.window(width, 740);
        let fits = format!("document.documentElement.scrollWidth <= {width}");
        assert_eq!(browser.value(&fits), true, "{width}");
        // The opened content is as wide as the screen, not as the table that scrolls.
        let right = "Math.max(...[...document.querySelectorAll('.opened, .pictures img, .bounds')].filter((e) => e.checkVisibility())
            .map((e) => e.getBoundingClientRect().right))";
        assert!(number(&browser.value(right)) <= f64::from(width), "{width}");
    }
    browser.screenshot("check-phone");
    browser.media("screen", "dark");
    browser.screenshot("check-phone-dark");
    quiet(&browser);
}

#[test]
fn paper_has_the_open_details() {
    let Some((mut browser, _folder)) = opened() else {
        return;
    };
    browser.media("print", "light");
    // The width of A4 at 96 dots an inch, without its margins.
    browser.window(688, 1000);
    assert_eq!(browser.value(SEEN).as_array().map(Vec::len), Some(3));
    browser.screenshot("check-print");
    let wide = "Math.max(...[...document.querySelectorAll('table')].filter((e) => e.checkVisibility()).map((e) => e.getBoundingClientRect().right))";
    assert!(number(&browser.value(wide)) <= 688.0, "no table is cut off");
    quiet(&browser);
}
