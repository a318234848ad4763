//! A page whose server goes, and comes again.

use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::json;

use super::page::{opened, text};
use super::{ENDLESS, PATIENCE, Rendering};

#[test]
fn a_page_finds_the_next_rendering_at_its_port() {
    let first = Rendering::start(ENDLESS);
    let port = first.port;
    let Some(mut browser) = opened(&first) else {
        return;
    };
    // Killed: nobody tells the page.
    drop(first);
    browser.wait("document.querySelector('#phase').textContent.includes('cannot be reached')");
    assert_eq!(
        browser.value("document.querySelector('#stop').disabled"),
        true
    );
    assert_ne!(
        text(&mut browser, "zoom"),
        "100 %",
        "the last picture stays"
    );
    let loaded = browser.told("Page.loadEventFired").len();
    let second = Rendering::on("cpu-f32", port, ENDLESS);
    // While it is loaded anew nothing can be asked of it.
    let start = Instant::now();
    while browser.told("Page.loadEventFired").len() <= loaded {
        assert!(start.elapsed() < PATIENCE, "it stays as it is");
        sleep(Duration::from_millis(50));
        browser.call("Page.getNavigationHistory", json!({}));
    }
    browser.wait("document.querySelector('#zoom').textContent !== '100 %'");
    assert_eq!(text(&mut browser, "phase"), "Rendering");
    assert_eq!(
        browser.value("document.querySelector('#stop').disabled"),
        false
    );
    drop(second);
}
