//! A page whose server goes, and comes again.

use std::thread::sleep;
use std::time::{Duration, Instant};

use super::page::{opened, text};
use super::{ENDLESS, PATIENCE, Rendering, get};

/// How many snapshots there were so far.
fn pictures(port: u16) -> Option<u64> {
    get(port, "/state")?.json()["picture"]["number"].as_u64()
}

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
    let second = Rendering::on("cpu-f32", port, ENDLESS);
    // A page that comes anew asks for a second picture once it has the first; until then it cannot be spoken to.
    let start = Instant::now();
    while pictures(port) < Some(2) {
        assert!(start.elapsed() < PATIENCE, "nobody asks");
        sleep(Duration::from_millis(50));
    }
    assert_eq!(text(&mut browser, "phase"), "Rendering");
    assert_eq!(
        browser.value("document.querySelector('#stop').disabled"),
        false
    );
    drop(second);
}
