//! A page whose server goes, and comes again.

use super::page::{opened, text};
use super::{ENDLESS, Rendering};

#[test]
fn a_page_finds_the_next_rendering_at_its_port() {
    let first = Rendering::start(ENDLESS);
    let port = first.port;
    let Some(mut browser) = opened(&first) else {
        return;
    };
    // Killed: the page gets no message.
    drop(first);
    browser.wait("document.querySelector('#phase').textContent.includes('is unreachable')");
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
    browser.wait_anew(
        "document.querySelector('#phase').textContent === 'Rendering'
            && document.querySelector('#zoom').textContent !== '100 %'
            && !document.querySelector('#stop').disabled",
    );
    drop(second);
}
