//! Access control: only this server's own pages, and only its own resources.
//!
//! Any site in a browser can send requests to this machine. They reveal their origin: by `Origin` and `Sec-Fetch-Site`, or,
//! if the site's name was made to resolve here (DNS rebinding), by that name in `Host`.

use hyper::header::{HOST, HeaderMap, HeaderName, ORIGIN};
use hyper::{Method, StatusCode, Uri};

/// The requested resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    Page,
    State(Asked),
    Picture,
    Stop,
}

/// The state of a tab that asks for news.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// Its own random number.
    pub tab: Option<u64>,
    /// The number of the snapshot that it has, 0 before the first.
    pub has: u64,
    /// Whether it knows that nothing more will come.
    pub knows_end: bool,
}

const SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// The route of a request to the server at `port`, or why it is refused.
///
/// # Errors
/// The status of the answer.
pub fn admit(
    method: &Method,
    uri: &Uri,
    headers: &HeaderMap,
    port: u16,
) -> Result<Route, StatusCode> {
    if uri.authority().is_some() || !is_to_us(headers, port) || !is_from_us(headers, port) {
        return Err(StatusCode::FORBIDDEN);
    }
    let (route, right) = match uri.path() {
        "/" => (Route::Page, Method::GET),
        "/state" => (Route::State(asked(uri)), Method::GET),
        "/picture" => (Route::Picture, Method::GET),
        "/stop" => (Route::Stop, Method::POST),
        _ => return Err(StatusCode::NOT_FOUND),
    };
    if *method != right {
        return Err(StatusCode::METHOD_NOT_ALLOWED);
    }
    // Any site may link to the page; only the page itself may make the other requests.
    let follows_link = route == Route::Page;
    let anonymous = route == Route::Stop && !headers.contains_key(ORIGIN);
    match anonymous || !(follows_link || is_same_site(headers)) {
        true => Err(StatusCode::FORBIDDEN),
        false => Ok(route),
    }
}

/// Whether a name and port, as in `localhost:8080`, are this server's.
fn is_own(authority: &str, port: u16) -> bool {
    let (name, given) = match authority.split_once(':') {
        Some((name, given)) => (name, given.parse().ok()),
        None => (authority, Some(80)),
    };
    given == Some(port) && (name == "127.0.0.1" || name.eq_ignore_ascii_case("localhost"))
}

/// Whether the request names this server, once.
fn is_to_us(headers: &HeaderMap, port: u16) -> bool {
    let mut hosts = headers.get_all(HOST).iter();
    let host = hosts.next().and_then(|host| host.to_str().ok());
    host.is_some_and(|host| is_own(host, port)) && hosts.next().is_none()
}

/// Whether no other site is named as the origin.
fn is_from_us(headers: &HeaderMap, port: u16) -> bool {
    headers.get_all(ORIGIN).iter().all(|origin| {
        let own = origin.to_str().ok().and_then(|o| o.strip_prefix("http://"));
        own.is_some_and(|authority| is_own(authority, port))
    })
}

/// Whether the browser, if it reports it, saw no other site involved.
fn is_same_site(headers: &HeaderMap) -> bool {
    let mut sites = headers.get_all(SITE).iter();
    sites.all(|site| site == "same-origin" || site == "none")
}

/// `tab=7&has=3&end=1`; anything else is ignored.
fn asked(uri: &Uri) -> Asked {
    let mut asked = Asked::default();
    for pair in uri.query().unwrap_or_default().split('&') {
        match pair.split_once('=') {
            Some(("tab", number)) => asked.tab = number.parse().ok(),
            Some(("has", number)) => asked.has = number.parse().unwrap_or(0),
            Some(("end", number)) => asked.knows_end = number == "1",
            _ => {}
        }
    }
    asked
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What becomes of a line such as `GET /state`, with headers.
    fn at(line: &str, headers: &[(&'static str, &str)]) -> Result<Route, u16> {
        let (method, uri) = line.split_once(' ').expect("two words");
        let method = method.parse().expect("a method");
        let mut all = HeaderMap::new();
        for (name, value) in headers {
            let value = value.parse().expect("a value");
            all.append(HeaderName::from_static(name), value);
        }
        admit(&method, &uri.parse().expect("an address"), &all, 8080).map_err(|s| s.as_u16())
    }

    const HOST: (&str, &str) = ("host", "127.0.0.1:8080");

    #[test]
    fn its_own_pages_get_in() {
        assert_eq!(at("GET /", &[HOST]), Ok(Route::Page));
        assert_eq!(at("GET /picture", &[HOST]), Ok(Route::Picture));
        let asked = Asked {
            tab: Some(7),
            has: 3,
            knows_end: true,
        };
        let state = Ok(Route::State(asked));
        assert_eq!(at("GET /state?tab=7&has=3&x=%41&end=1", &[HOST]), state);
        let own = ("origin", "http://localhost:8080");
        let same = ("sec-fetch-site", "same-origin");
        let named = ("host", "LocalHost:8080");
        assert_eq!(at("POST /stop", &[named, own, same]), Ok(Route::Stop));
        // A link on another page leads here; the page has nothing in it.
        let cross = ("sec-fetch-site", "cross-site");
        assert_eq!(at("GET /", &[HOST, cross]), Ok(Route::Page));
    }

    #[test]
    fn other_names_and_sites_do_not() {
        for host in [
            "evil.example:8080",
            "evil.example",
            "127.0.0.1",
            "127.0.0.1:80",
            "127.0.0.1:8080.evil.example",
            "localhost.evil.example:8080",
            "127.0.0.1:8080:8080",
            "user@127.0.0.1:8080",
            "0.0.0.0:8080",
            "127.0.0.2:8080",
            "",
        ] {
            assert_eq!(at("GET /", &[("host", host)]), Err(403), "{host}");
        }
        assert_eq!(at("GET /", &[]), Err(403), "no Host");
        assert_eq!(at("GET /", &[HOST, HOST]), Err(403), "two");
        assert_eq!(at("GET http://evil.example:8080/", &[HOST]), Err(403));
        for origin in [
            "null",
            "",
            "https://127.0.0.1:8080",
            "http://127.0.0.1",
            "http://127.0.0.1:8081",
            "http://evil.example",
            "http://evil.example:8080",
        ] {
            for line in ["GET /state", "POST /stop"] {
                let found = at(line, &[HOST, ("origin", origin)]);
                assert_eq!(found, Err(403), "{line} {origin}");
            }
        }
        let cross = ("sec-fetch-site", "cross-site");
        assert_eq!(at("GET /picture", &[HOST, cross]), Err(403), "an <img>");
        assert_eq!(at("POST /stop", &[HOST]), Err(403), "no Origin");
    }

    #[test]
    fn nothing_else_is_there() {
        for path in ["/favicon.ico", "//", "/state/", "/../etc/passwd", "/STOP"] {
            assert_eq!(at(&format!("GET {path}"), &[HOST]), Err(404), "{path}");
        }
        for line in ["POST /", "HEAD /", "PUT /state", "GET /stop", "OPTIONS /"] {
            assert_eq!(at(line, &[HOST]), Err(405), "{line}");
        }
    }

    #[test]
    fn browsers_leave_the_usual_port_out() {
        let get = |host: &str| {
            let mut headers = HeaderMap::new();
            headers.insert(hyper::header::HOST, host.parse().expect("a value"));
            admit(&Method::GET, &Uri::from_static("/"), &headers, 80)
        };
        assert_eq!(get("localhost"), Ok(Route::Page));
        assert_eq!(get("localhost:80"), Ok(Route::Page));
        assert!(get("localhost:8080").is_err());
    }
}
