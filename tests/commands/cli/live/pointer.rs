//! The page by pointer: exposure, zoom, pixel values, stop and save; two tabs at once.

use super::page::{canvas, opened, quiet, text, visit};
use super::{ENDLESS, Rendering};
use crate::report_page::browser::Browser;

/// The colour on the screen at a place of the canvas, from 0 to 255.
fn colour(browser: &mut Browser, x: f64, y: f64) -> [u8; 3] {
    // Of a copy: a canvas that is read more than once slows down, and Chromium says so.
    let pixel = browser.value(&format!(
        "(() => {{ const copy = document.createElement('canvas').getContext('2d');
            copy.drawImage(document.querySelector('#picture'), -{x}, -{y});
            return [...copy.getImageData(0, 0, 1, 1).data]; }})()"
    ));
    [0, 1, 2].map(|i| pixel[i].as_u64().expect("a code") as u8)
}

/// The page's text about the pixel that is read: its place and its values.
pub fn readout(browser: &mut Browser) -> ([u32; 2], [f64; 3]) {
    let shown = text(browser, "pixel");
    let numbers: Vec<&str> = shown
        .split(|c: char| !(c.is_ascii_alphanumeric() || "+-.".contains(c)))
        .collect();
    let after = |name: &str| {
        let at = numbers.iter().position(|word| *word == name);
        at.map(|i| numbers[i + 1])
            .unwrap_or_else(|| panic!("no {name}: {shown}"))
    };
    let place = ["x", "y"].map(|name| after(name).parse().expect("a place"));
    (
        place,
        ["R", "G", "B"].map(|name| after(name).parse().expect("a value")),
    )
}

/// Ends the rendering by the page and waits for the last picture there.
fn stop_and_save(browser: &mut Browser) {
    browser.point("document.querySelector('#stop')", true);
    browser.wait("document.querySelector('#sure').open");
    browser.point("document.querySelector('#yes')", true);
    browser.wait("document.querySelector('#phase').textContent === 'Done: the files are written'");
}

#[test]
fn pixels_are_those_of_the_file() {
    let mut rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    stop_and_save(&mut browser);
    quiet(&browser, &rendering);
    let (code, message) = rendering.end();
    assert_eq!(code, Some(130), "{message}");
    let film = rendering.picture("a.exr");
    let [left, top, width, height] = canvas(&mut browser);
    // Enlarged by a whole number, in the middle.
    let zoom = (width / 16.0).min(height / 12.0).floor();
    let place = |x: u32, y: u32| {
        [
            (width - 16.0 * zoom) / 2.0 + (f64::from(x) + 0.3) * zoom,
            (height - 12.0 * zoom) / 2.0 + (f64::from(y) + 0.6) * zoom,
        ]
    };
    for [x, y] in [[0, 0], [15, 11], [7, 5], [3, 8], [12, 2]] {
        let [at, down] = place(x, y);
        browser.mouse("mouseMoved", left + at, top + down);
        browser.wait(&format!(
            "document.querySelector('#pixel').textContent.startsWith('x {x}, y {y}:')"
        ));
        let (_, values) = readout(&mut browser);
        let own = film.row(y as usize)[x as usize];
        for (shown, value) in values.iter().zip(own) {
            assert!(
                (shown - f64::from(value)).abs() <= 5e-5 * f64::from(value),
                "{x},{y}: {shown} {value}"
            );
        }
        let codes = own.map(|value| vkpt::image::srgb::quantise(f64::from(value)));
        let shown = colour(&mut browser, at.floor(), down.floor());
        let off = codes.iter().zip(shown).map(|(a, b)| a.abs_diff(b)).max();
        assert!(off <= Some(1), "{x},{y}: {shown:?} for {codes:?}");
    }
}

#[test]
fn the_slider_brightens_and_the_wheel_enlarges() {
    let rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    let [left, top, width, height] = canvas(&mut browser);
    let zoom = |browser: &mut Browser| -> f64 {
        let shown = text(browser, "zoom");
        shown.trim_end_matches(" %").parse().expect("a zoom")
    };
    let middle = [left + width / 2.0 + 3.0, top + height / 2.0 + 5.0];
    browser.mouse("mouseMoved", middle[0], middle[1]);
    browser.wait("document.querySelector('#pixel').textContent.startsWith('x ')");
    let (before, fitted) = (readout(&mut browser).0, zoom(&mut browser));
    for (down, factor) in [(-120.0, 2f64.sqrt()), (120.0, 1.0), (120.0, 0.5f64.sqrt())] {
        browser.wheel(middle[0], middle[1], down);
        let wanted = format!("{:.0} %", fitted * factor);
        browser.wait(&format!(
            "document.querySelector('#zoom').textContent === '{wanted}'"
        ));
        // The pixel under the pointer stays there.
        browser.mouse("mouseMoved", middle[0], middle[1]);
        assert_eq!(readout(&mut browser).0, before);
    }
    // Dragged by three of its pixels, another is under the pointer.
    let side = zoom(&mut browser) / 100.0;
    let to = [middle[0] + 3.0 * side, middle[1]];
    browser.drag(middle, to);
    browser.mouse("mouseMoved", middle[0], middle[1]);
    browser.wait(&format!(
        "document.querySelector('#pixel').textContent.startsWith('x {}, y {}:')",
        before[0] - 3,
        before[1]
    ));
    browser.point("document.querySelector('#fit')", true);
    browser.wait(&format!(
        "document.querySelector('#zoom').textContent === '{fitted:.0} %'"
    ));
    let at = [(width / 2.0).floor(), (height / 2.0).floor()];
    let plain = colour(&mut browser, at[0], at[1]);
    // The middle of the slider is 0; right of it is brighter.
    let slider = "(() => { const r = document.querySelector('#exposure').getBoundingClientRect(); return [r.x + r.width * .7, r.y + r.height / 2]; })()";
    let place = browser.value(slider);
    let [x, y] = [0, 1].map(|i| place[i].as_f64().expect("a place"));
    browser.mouse("mousePressed", x, y);
    browser.mouse("mouseReleased", x, y);
    let shown = text(&mut browser, "stops");
    assert!(shown.starts_with('+') && shown.ends_with(" EV"), "{shown}");
    browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))).then(() => 0)");
    let bright = colour(&mut browser, at[0], at[1]);
    assert!((0..3).all(|c| bright[c] > plain[c]), "{plain:?} {bright:?}");
    quiet(&browser, &rendering);
}

#[test]
fn two_tabs_both_get_the_last_picture() {
    let mut rendering = Rendering::start(ENDLESS);
    let Some(mut first) = opened(&rendering) else {
        return;
    };
    let Some(mut second) = Browser::start() else {
        return;
    };
    visit(&mut second, &rendering);
    let asked = |browser: &Browser| {
        let requests = browser.events("Network.requestWillBeSent").into_iter();
        let urls = requests.filter_map(|r| r["request"]["url"].as_str());
        urls.filter(|url| url.ends_with("/picture")).count()
    };
    for browser in [&mut first, &mut second] {
        let numbers = text(browser, "numbers");
        browser.wait(&format!(
            "document.querySelector('#numbers').textContent !== '{numbers}'"
        ));
    }
    stop_and_save(&mut second);
    first.wait("document.querySelector('#phase').textContent === 'Done: the files are written'");
    assert!(asked(&first) > 0 && asked(&second) > 0);
    let (code, message) = rendering.end();
    assert_eq!(code, Some(130), "{message}");
    let own = rendering.picture("a.exr").row(6)[8];
    for browser in [&mut first, &mut second] {
        browser.value("document.querySelector('#picture').focus()");
        browser.key("ArrowRight", 39);
        browser.wait("document.querySelector('#pixel').textContent.startsWith('x 8, y 6:')");
        let (_, values) = readout(browser);
        assert!((values[0] - f64::from(own[0])).abs() <= 5e-5 * f64::from(own[0]));
    }
}

#[test]
fn going_on_is_an_answer_too() {
    let rendering = Rendering::start(ENDLESS);
    let Some(mut browser) = opened(&rendering) else {
        return;
    };
    browser.point("document.querySelector('#stop')", true);
    browser.wait("document.querySelector('#sure').open");
    browser.point("document.querySelector('#sure button:not(#yes)')", true);
    browser.wait("!document.querySelector('#sure').open");
    let state = super::get(rendering.port, "/state")
        .expect("an answer")
        .json();
    assert_eq!(state["stopping"], false);
    quiet(&browser, &rendering);
}
