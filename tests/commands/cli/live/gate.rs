//! Nothing from outside gets in, and only the page's own resources are served.

use std::net::{IpAddr, TcpStream, UdpSocket};
use std::time::Duration;

use super::{ENDLESS, Rendering, get, send, stop};
use crate::cli::program::{folder, words};

/// The status of a request to this port, with other headers if `lines` has some.
fn status(port: u16, line: &str, lines: &str) -> Option<u16> {
    let request = format!("{line} HTTP/1.1\r\n{lines}Connection: close\r\n\r\n");
    send(port, &request).map(|answer| answer.status)
}

#[test]
fn others_are_refused() {
    let rendering = Rendering::start(ENDLESS);
    let port = rendering.port;
    let own = format!("Host: 127.0.0.1:{port}\r\n");
    let evil = format!("Origin: http://evil.example:{port}\r\n");
    let rebound = format!("Host: evil.example:{port}\r\n");
    let local = format!("Host: localhost:{port}\r\n");
    let rows = [
        ("GET /", own.clone(), 200),
        ("GET /", local.clone(), 200),
        ("GET /state", own.clone(), 200),
        ("GET /", rebound.clone(), 403),
        ("GET /state", rebound.clone(), 403),
        ("GET /", String::new(), 403),
        ("GET /", format!("{own}{rebound}"), 403),
        ("GET /state", format!("{own}{evil}"), 403),
        (
            "GET /picture",
            format!("{own}Sec-Fetch-Site: cross-site\r\n"),
            403,
        ),
        ("POST /stop", format!("{own}{evil}"), 403),
        ("POST /stop", format!("{own}Origin: null\r\n"), 403),
        ("POST /stop", own.clone(), 403),
        (
            "POST /stop",
            format!("{rebound}Origin: http://127.0.0.1:{port}\r\n"),
            403,
        ),
        ("GET /favicon.ico", own.clone(), 404),
        ("GET /../Cargo.toml", own.clone(), 404),
        ("GET /a.exr", own.clone(), 404),
        ("GET /stop", own.clone(), 405),
        ("POST /", own.clone(), 405),
        ("DELETE /picture", own.clone(), 405),
        ("nonsense", String::new(), 400),
    ];
    for (line, lines, expected) in rows {
        assert_eq!(
            status(port, line, &lines),
            Some(expected),
            "{line}\n{lines}"
        );
    }
    // After all of that it still renders: no refused request has stopped it.
    let state = get(port, "/state").expect("an answer").json();
    assert_eq!(state["stopping"], false);
    // Planted: an accepted request would be noticed.
    assert_eq!(stop(port).map(|answer| answer.status), Some(204));
    let state = get(port, "/state").map(|answer| answer.json());
    assert!(state.is_none_or(|state| state["stopping"] == true));
}

#[test]
fn answers_guard_themselves() {
    let rendering = Rendering::start(ENDLESS);
    for path in ["/", "/state", "/nothing"] {
        let head = get(rendering.port, path).expect("an answer").head;
        for line in [
            "x-content-type-options: nosniff",
            "x-frame-options: deny",
            "cache-control: no-store",
            "cross-origin-resource-policy: same-origin",
            "content-security-policy: default-src 'none'; script-src 'nonce-",
        ] {
            assert!(head.contains(line), "{path}: {line}: {head}");
        }
        assert!(!head.contains("access-control"), "{path}: {head}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn no_other_address_of_this_machine_leads_there() {
    let rendering = Rendering::start(ENDLESS);
    let reaches = |address: IpAddr| {
        let place = (address, rendering.port).into();
        TcpStream::connect_timeout(&place, Duration::from_secs(2)).is_ok()
    };
    assert!(reaches([127, 0, 0, 1].into()));
    assert!(!reaches([127, 0, 0, 2].into()));
    // Nothing is sent: it is only asked which address would be.
    let socket = UdpSocket::bind("0.0.0.0:0").expect("a socket");
    if socket.connect("192.0.2.1:9").is_ok() {
        let own = socket.local_addr().expect("an address").ip();
        assert!(own.is_loopback() || !reaches(own), "{own}");
    }
}

#[test]
fn a_port_in_use_is_an_error_before_anything_is_rendered() {
    let rendering = Rendering::start(ENDLESS);
    let folder = folder("this is no scene");
    let run = words(
        folder.path(),
        &format!("scene.scn --view={}", rendering.port),
    );
    assert_eq!(run.code, Some(2), "{}", run.err);
    let port = rendering.port;
    assert!(
        run.err
            .contains(&format!("--view: cannot listen on port {port}")),
        "{}",
        run.err
    );
    let wrong = words(folder.path(), "scene.scn --view=65536");
    assert_eq!(wrong.code, Some(2));
    assert!(wrong.err.contains("must be a port"), "{}", wrong.err);
}
