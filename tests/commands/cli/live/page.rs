//! The page in a browser: opened, read, and inspected in light, dark and on a phone.

use serde_json::{Value, json};

use super::{ENDLESS, Rendering};
use crate::report_page::browser::Browser;

/// Reasons why text cannot be read.
const CONTRAST: &str = include_str!("../../report_page/contrast.js");

/// The page of a rendering in a desktop window, with a first picture; `None` if the run skips browsers.
pub fn opened(rendering: &Rendering) -> Option<Browser> {
    let mut browser = Browser::start()?;
    browser.window(1280, 900);
    browser.media("screen", "light");
    visit(&mut browser, rendering);
    Some(browser)
}

/// Opens the page and waits for a picture.
pub fn visit(browser: &mut Browser, rendering: &Rendering) {
    browser.visit(&rendering.address());
    browser.wait("document.querySelector('#zoom').textContent !== '100 %'");
}

/// The text of an element.
pub fn text(browser: &mut Browser, id: &str) -> String {
    browser.text(&format!("document.querySelector('#{id}').textContent"))
}

/// The frame of the canvas in the window: left, top, width and height.
pub fn canvas(browser: &mut Browser) -> [f64; 4] {
    let frame = "(() => { const c = document.querySelector('#picture'); c.scrollIntoView({ block: 'center' });
        const r = c.getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()";
    let frame = browser.value(frame);
    [0, 1, 2, 3].map(|i| frame[i].as_f64().expect("a number"))
}

/// No errors, and no requests except to the page's own server.
pub fn quiet(browser: &Browser, rendering: &Rendering) {
    let own = rendering.address();
    assert_eq!(browser.complaints_beside(&own), Vec::<String>::new());
}

#[test]
fn light_and_dark_can_be_read() {
    let rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    browser.wait("document.querySelectorAll('#plot .dot').length > 2");
    for scheme in ["light", "dark"] {
        browser.media("screen", scheme);
        assert_eq!(browser.value(CONTRAST), json!([]), "{scheme}");
        browser.screenshot(&format!("live-{scheme}"));
    }
    // Planted: grey words.
    browser.value("document.querySelector('h1').style.color = '#777'");
    assert_eq!(browser.value(CONTRAST).as_array().map(Vec::len), Some(1));
    quiet(&browser, &rendering);
}

#[test]
fn a_phone_scrolls_one_way() {
    let rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    for width in [768, 360] {
        browser.window(width, 740);
        let fits = format!("document.documentElement.scrollWidth <= {width}");
        assert_eq!(browser.value(&fits), true, "{width}");
    }
    browser.screenshot("live-phone");
    quiet(&browser, &rendering);
}

#[test]
fn everything_has_a_name() {
    let rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    let tree = browser.call("Accessibility.getFullAXTree", json!({}));
    let nodes = tree["nodes"].as_array().expect("nodes");
    let of_role = |role: &str| -> Vec<&str> {
        let own = nodes.iter().filter(|n| n["role"]["value"] == role);
        own.map(|n| n["name"]["value"].as_str().unwrap_or_default())
            .collect()
    };
    assert_eq!(
        of_role("button"),
        ["Stop and save", "Smaller", "Larger", "Fit"]
    );
    assert_eq!(of_role("slider"), ["Exposure"]);
    for role in ["progressbar", "image"] {
        let names = of_role(role);
        assert!(
            !names.is_empty() && names.iter().all(|n| !n.is_empty()),
            "{role}: {names:?}"
        );
    }
}

#[test]
fn the_page_shows_the_servers_words() {
    let rendering = Rendering::start("--time 100 -o a.exr");
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    browser.wait("/^[0-9,]+ samples per pixel, .*, about 1 min [0-9]+ s left$/.test(document.querySelector('#numbers').textContent)");
    assert_eq!(text(&mut browser, "phase"), "Rendering");
    browser.wait("/^[0-9]+ % – scene.scn – vkpt$/.test(document.title)");
    browser.wait("document.querySelectorAll('#plot .dot').length > 2");
    let latest = text(&mut browser, "latest");
    assert!(latest.starts_with("relMSE "), "{latest}");
    // As many points as the server knows errors, or one fewer by now.
    let state = super::get(rendering.port, "/state")
        .expect("an answer")
        .json();
    let known = state["errors"].as_array().map_or(0, Vec::len);
    let dots = browser.value("document.querySelectorAll('#plot .dot').length");
    let dots = dots.as_u64().unwrap_or(0) as usize;
    assert!(dots <= known && known <= dots + 2, "{dots} of {known}");
    // Less error, further down and to the right.
    let places = browser.value(
        "[...document.querySelectorAll('#plot .dot')].map((d) => [d.cx.baseVal.value, d.cy.baseVal.value])",
    );
    let places = places.as_array().expect("places");
    let at = |i: usize, k: usize| places[i][k].as_f64().expect("a number");
    let last = places.len() - 1;
    assert!(
        at(last, 0) > at(0, 0) && at(last, 1) > at(0, 1),
        "{places:?}"
    );
    quiet(&browser, &rendering);
}

/// Planted: a script of another's in the page, which the policy forbids.
#[test]
fn a_foreign_script_does_not_run() {
    let rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    browser.value("(() => { const s = document.createElement('script'); s.textContent = 'window.planted = 1'; document.body.append(s); })()");
    assert_eq!(browser.value("window.planted ?? 0"), 0);
    let reached = "fetch('http://127.0.0.1:9/').then(() => true, () => false)";
    assert_eq!(browser.value(reached), Value::Bool(false));
    assert!(!browser.complaints_beside(&rendering.address()).is_empty());
}
