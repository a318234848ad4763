//! Things that HTML pages must not have.

/// Every address that a browser would request: those in src, href, url() and @import.
pub fn outside(page: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for (before, harmless) in [
        ("src=\"", &["data:"][..]),
        ("href=\"", &["data:", "#"]),
        ("url(", &["data:", "#"]),
        ("@import", &[]),
        ("http:", &["//www.w3.org/2000/svg\""]),
        ("https:", &[]),
        ("src='", &[]),
        ("href='", &[]),
    ] {
        for (at, _) in page.match_indices(before) {
            let rest = &page[at + before.len()..];
            if !harmless.iter().any(|h| rest.starts_with(h)) {
                found.push(&page[at..page.len().min(at + 40)]);
            }
        }
    }
    found
}

/// Words that would be markup, were they not escaped.
pub const MARKUP: &str = "</pre><script>alert(1)</script>&\"'<img src=x onerror=y>";

/// A page about [`MARKUP`] has only the tags of a plain one, and shows the words as words.
pub fn no_markup(page: &str, plain: &str) {
    for tag in ["<script", "<img", "</pre", "<style"] {
        assert_eq!(
            page.matches(tag).count(),
            plain.matches(tag).count(),
            "{tag}"
        );
    }
    assert!(page.contains("&lt;script&gt;alert(1)&lt;/script&gt;"));
    assert_eq!(outside(page), Vec::<&str>::new());
}
