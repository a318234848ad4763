//! The page: one file, which only contacts this server.

use std::hash::{BuildHasher, RandomState};
use std::io;

use hyper::body::Bytes;
use hyper::header::HeaderValue;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use vkpt_lab::page::COLOURS;

/// Parts of the script, in the order of their dependencies.
const SCRIPTS: [&str; 4] = [
    include_str!("picture.js"),
    include_str!("view.js"),
    include_str!("plot.js"),
    include_str!("page.js"),
];

/// The page as served, and its permissions.
#[derive(Debug)]
pub struct Page {
    pub html: Bytes,
    /// Content Security Policy Level 3, W3C: only the page's own script and style, and only this server.
    pub policy: HeaderValue,
}

impl Page {
    /// The page of a rendering.
    ///
    /// # Errors
    /// None: the policy contains only characters that headers allow.
    pub fn new(title: &str) -> io::Result<Self> {
        // Content injected by others cannot know it.
        let own = format!("{:016x}", RandomState::new().hash_one(title));
        let policy = format!(
            "default-src 'none'; script-src 'nonce-{own}'; style-src 'nonce-{own}'; img-src data:; \
             connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
        );
        Ok(Self {
            html: document(title, &own).into_string().into(),
            policy: policy.parse().map_err(io::Error::other)?,
        })
    }
}

fn document(title: &str, own: &str) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                // Or browsers ask for /favicon.ico.
                link rel="icon" href="data:,";
                title { (title) " – vkpt" }
                style nonce=(own) { (PreEscaped(COLOURS)) (PreEscaped(include_str!("page.css"))) }
            }
            body {
                (head(title))
                main {
                    (picture())
                    (curve())
                }
                (dialog())
                script nonce=(own) {
                    (PreEscaped("\"use strict\";\n(() => {\n"))
                    @for part in SCRIPTS { (PreEscaped(part)) }
                    (PreEscaped("})();\n"))
                }
            }
        }
    }
}

/// The name and progress of the rendering, and the button that stops it.
fn head(title: &str) -> Markup {
    html! {
        header {
            h1 { (title) }
            p #phase role="status" { "Waiting for the first samples" }
            p #numbers {}
            progress #fraction max="1" value="0" aria-label="Fraction of the work done" {}
            p #trouble .bad hidden {}
            button #stop type="button" aria-keyshortcuts="s" { "Stop and save" }
        }
    }
}

/// The picture with its controls.
fn picture() -> Markup {
    html! {
        section aria-label="Picture" {
            div.controls {
                label for="exposure" { "Exposure" }
                input #exposure type="range" min="-10" max="10" step="0.25" value="0" aria-keyshortcuts="e Shift+E 0";
                output #stops for="exposure" { "0 EV" }
                span.group role="group" aria-label="Zoom" {
                    button #out type="button" aria-label="Smaller" aria-keyshortcuts="-" { "−" }
                    output #zoom { "100 %" }
                    button #in type="button" aria-label="Larger" aria-keyshortcuts="+" { "+" }
                    button #fit type="button" aria-keyshortcuts="f" { "Fit" }
                }
            }
            canvas #picture tabindex="0" role="img" aria-label="The picture so far. Arrow keys move the selected pixel." {}
            p.readout { output #pixel aria-live="off" { "Point at a pixel, or select one with the arrow keys" } }
            p.note { (keys()) }
        }
    }
}

fn keys() -> Markup {
    let all = [
        ("E", "brighter"),
        ("Shift E", "darker"),
        ("0", "reset exposure"),
        ("+ −", "or mouse wheel: zoom"),
        ("F", "fit"),
        ("← ↑ → ↓", "move by one pixel, with Shift by ten"),
        ("S", "stop and save"),
    ];
    html! {
        @for (key, what) in all { span.key { kbd { (key) } " " (what) } " " }
    }
}

/// Error over time.
fn curve() -> Markup {
    html! {
        section aria-label="Error over time" {
            figure {
                svg #plot viewBox="0 0 480 300" role="img" aria-labelledby="latest" {}
                figcaption { span #latest { "The error estimate needs two samples per pixel" } }
            }
            p.note {
                "relMSE of the picture over seconds of rendering, both logarithmic; the band is the 95 % interval. \
                 A point without a band is an estimate dominated by a few pixels."
            }
        }
    }
}

fn dialog() -> Markup {
    html! {
        dialog #sure aria-labelledby="question" {
            p #question { "Stop rendering now and save the picture with the samples done so far?" }
            form method="dialog" {
                button #yes value="stop" autofocus { "Stop and save" }
                button value="" { "Continue rendering" }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_s_name_is_a_name() {
        let page = Page::new("<script>a</script>").expect("a page");
        let html = String::from_utf8_lossy(&page.html);
        assert!(html.contains("<h1>&lt;script&gt;a&lt;/script&gt;</h1>"));
        assert_eq!(html.matches("<script").count(), 1, "its own");
    }

    #[test]
    fn the_policy_lets_the_page_s_own_parts_run() {
        let [page, other] = ["a", "a"].map(|title| Page::new(title).expect("a page"));
        let policy = page.policy.to_str().expect("a text");
        let own = policy
            .split("script-src 'nonce-")
            .nth(1)
            .and_then(|rest| rest.split('\'').next())
            .expect("a nonce");
        let html = String::from_utf8_lossy(&page.html);
        assert_eq!(html.matches(&format!("nonce=\"{own}\"")).count(), 2);
        assert!(!policy.contains("-inline") && !policy.contains("-eval"));
        assert_ne!(page.policy, other.policy, "nobody can know it before");
    }
}
