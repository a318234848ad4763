//! Common parts of the HTML reports: each is one self-contained file that is readable on a screen, a phone and paper, in
//! light and dark, with and without scripts.

mod picture;

pub use picture::{data_uri, image};

use maud::{DOCTYPE, Markup, PreEscaped, html};

use vkpt::report::SOFTWARE;

/// A report's own parts.
#[derive(Debug)]
pub struct Page<'a> {
    pub title: &'a str,
    /// CSS in addition to that of all reports.
    pub styles: &'a [&'a str],
    /// JavaScript, if any. The page must be complete without.
    pub script: &'a str,
    pub body: Markup,
}

/// The colours of a page, by name, in light and dark.
pub const COLOURS: &str = include_str!("colours.css");

/// What the page may load: nothing from the network. The browser enforces it (Content Security Policy Level 3, W3C).
const POLICY: &str = include_str!("policy.txt");

/// The whole file.
pub fn page(page: &Page) -> String {
    let document = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy" content=(POLICY.trim_end());
                meta name="color-scheme" content="light dark";
                title { (page.title) }
                style { (PreEscaped(COLOURS)) }
                style { (PreEscaped(include_str!("style.css"))) }
                @for style in page.styles {
                    style { (PreEscaped(style)) }
                }
            }
            body {
                (page.body)
                footer { "Written by " (SOFTWARE) ". Self-contained: loads nothing from the network." }
                @if !page.script.is_empty() { script { (PreEscaped(page.script)) } }
            }
        }
    };
    document.into_string()
}

/// A command line that wraps only between words.
pub fn command_line(text: &str) -> Markup {
    let words = text.split(' ').enumerate();
    html! {
        @for (i, word) in words {
            @if i > 0 { " " }
            span.word { (word) }
        }
    }
}
