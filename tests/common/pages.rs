//! What HTML pages must not have.

/// Every address that a browser would ask for: what stands in src, href, url() and @import.
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
