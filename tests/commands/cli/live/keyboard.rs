//! The page by keyboard alone.

use super::page::{opened, quiet, text};
use super::pointer::readout;
use super::{ENDLESS, Rendering};

#[test]
fn keys_do_the_same_as_the_pointer() {
    let mut rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    for (key, code, shown) in [
        ("e", 69, "+0.5 EV"),
        ("e", 69, "+1 EV"),
        ("0", 48, "0 EV"),
        ("E", 69, "-0.5 EV"),
    ] {
        browser.key(key, code);
        assert_eq!(text(&mut browser, "stops"), shown);
        let slider = browser.value("document.querySelector('#exposure').valueAsNumber");
        let stops: f64 = shown.trim_end_matches(" EV").parse().expect("stops");
        assert_eq!(slider.as_f64(), Some(stops));
    }
    let fitted = text(&mut browser, "zoom");
    for (key, code, same) in [
        ("+", 187, false),
        ("-", 189, true),
        ("-", 189, false),
        ("f", 70, true),
    ] {
        browser.key(key, code);
        let sign = if same { "===" } else { "!==" };
        browser.wait(&format!(
            "document.querySelector('#zoom').textContent {sign} '{fitted}'"
        ));
    }
    // Arrows begin in the middle, once the picture has the focus.
    browser.value("document.querySelector('#picture').focus()");
    for (key, code, place) in [
        ("ArrowLeft", 37, [8, 6]),
        ("ArrowLeft", 37, [7, 6]),
        ("ArrowUp", 38, [7, 5]),
        ("ArrowRight", 39, [8, 5]),
        ("ArrowDown", 40, [8, 6]),
    ] {
        browser.key(key, code);
        let [x, y] = place;
        browser.wait(&format!(
            "document.querySelector('#pixel').textContent.startsWith('x {x}, y {y}:')"
        ));
    }
    // To the edge, and no further.
    (0..20).for_each(|_| browser.key("ArrowUp", 38));
    browser.wait("document.querySelector('#pixel').textContent.startsWith('x 8, y 0:')");
    browser.screenshot("live-keys");
    browser.key("s", 83);
    browser.wait("document.querySelector('#sure').open");
    browser.key("Escape", 27);
    browser.wait("!document.querySelector('#sure').open");
    browser.key("s", 83);
    browser.wait("document.activeElement === document.querySelector('#yes')");
    browser.screenshot("live-sure");
    browser.key(" ", 32);
    browser.wait("document.querySelector('#phase').textContent === 'Done: the files are written'");
    quiet(&browser, &rendering);
    let (code, message) = rendering.end();
    assert_eq!(code, Some(130), "{message}");
    assert!(
        message.contains("note: continue with --resume, which reads a.vkpt"),
        "{message}"
    );
    // The last picture stays, and its pixels can be read.
    let (place, values) = readout(&mut browser);
    let own = rendering.picture("a.exr").row(place[1] as usize)[place[0] as usize];
    for (shown, value) in values.iter().zip(own) {
        assert!(
            (shown - f64::from(value)).abs() <= 5e-5 * f64::from(value),
            "{shown} {value}"
        );
    }
    browser.screenshot("live-ended");
}
