//! The live view of a growing picture: the answers of the page's server, the page in a browser, and the messages to tev.

mod ends;
mod gate;
mod keyboard;
mod page;
mod pointer;
mod reconnect;
mod tev;
mod viewer;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::{Arc, Mutex};
use std::thread::{JoinHandle, sleep};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;
use vkpt::film::Film;

use super::program::{command, folder};

/// A ball, half of its picture black, whose samples take almost no time.
const SCENE: &str = "screen 16 12\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nsphere 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

/// A rendering that would take days.
const ENDLESS: &str = "--spp 4000000000 -o a.exr";

/// Nothing here takes longer.
const PATIENCE: Duration = Duration::from_secs(60);

/// A rendering under way, with its page. It ends when it is dropped.
struct Rendering {
    folder: TempDir,
    child: Child,
    port: u16,
    /// Its output on stderr.
    stderr: Arc<Mutex<String>>,
    reader: Option<JoinHandle<()>>,
}

impl Rendering {
    /// Begins, at a free port, and is reached.
    fn start(flags: &str) -> Self {
        Self::on("cpu-f32", 0, flags)
    }

    fn on(device: &str, port: u16, flags: &str) -> Self {
        let folder = folder(SCENE);
        let line = format!("scene.scn --device {device} --view={port} {flags}");
        let words: Vec<_> = line.split_whitespace().collect();
        let child = command(folder.path(), &words)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn();
        let mut child = child.expect("it runs");
        let mut lines = BufReader::new(child.stderr.take().expect("a pipe"));
        let mut first = String::new();
        lines.read_line(&mut first).expect("a line");
        let address = "note: live view: http://127.0.0.1:";
        let port = first
            .strip_prefix(address)
            .and_then(|p| p.strip_suffix("/\n"));
        let port = port.unwrap_or_else(|| panic!("no address: {first}"));
        let stderr = Arc::new(Mutex::new(String::new()));
        let own = stderr.clone();
        let reader = std::thread::spawn(move || {
            let mut rest = String::new();
            let _ = lines.read_to_string(&mut rest);
            *own.lock().expect("a lock") = rest;
        });
        Self {
            folder,
            child,
            port: port.parse().expect("a port"),
            stderr,
            reader: Some(reader),
        }
    }

    fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Waits for its end: the exit code, and its output.
    fn end(&mut self) -> (Option<i32>, String) {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if let Some(status) = self.child.try_wait().expect("a child") {
                let reader = self.reader.take().expect("it ends once");
                reader.join().expect("a text");
                let stderr = self.stderr.lock().expect("a lock").clone();
                return (status.code(), stderr);
            }
            sleep(Duration::from_millis(10));
        }
        panic!("it goes on");
    }

    fn picture(&self, name: &str) -> Film {
        picture(&self.folder.path().join(name))
    }
}

impl Drop for Rendering {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn picture(path: &Path) -> Film {
    vkpt::image::read(path).expect("a picture").film
}

/// An answer.
struct Answer {
    status: u16,
    /// In lower case.
    head: String,
    body: Vec<u8>,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body).expect("JSON")
    }

    /// Which snapshot a picture is.
    fn number(&self) -> u64 {
        let number = self.head.split("vkpt-number: ").nth(1).expect("a number");
        let digits = number.split("\r\n").next().unwrap_or_default();
        digits.parse().expect("digits")
    }
}

/// Sends a request unchanged, with its end; `None` if there is no answer.
fn send(port: u16, request: &str) -> Option<Answer> {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).ok()?;
    stream.set_read_timeout(Some(PATIENCE)).expect("a timeout");
    stream.write_all(request.as_bytes()).ok()?;
    let mut all = Vec::new();
    // An answer cut off by a server that ends is no answer.
    stream.read_to_end(&mut all).ok()?;
    let gap = all.windows(4).position(|w| w == b"\r\n\r\n")?;
    let head = String::from_utf8_lossy(&all[..gap]).to_lowercase();
    let status = head.split(' ').nth(1)?.parse().ok()?;
    Some(Answer {
        status,
        head,
        body: all.split_off(gap + 4),
    })
}

/// Asks as a tab of the server's own page does.
fn get(port: u16, path: &str) -> Option<Answer> {
    let host = format!("127.0.0.1:{port}");
    send(
        port,
        &format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"),
    )
}

fn stop(port: u16) -> Option<Answer> {
    let host = format!("127.0.0.1:{port}");
    let request = format!(
        "POST /stop HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
    );
    send(port, &request)
}

/// A tab like that of the page: it fetches every picture that is announced.
struct Tab {
    port: u16,
    number: u32,
    has: u64,
    picture: Option<Answer>,
    knows_end: bool,
}

impl Tab {
    fn new(port: u16, number: u32) -> Self {
        Self {
            port,
            number,
            has: 0,
            picture: None,
            knows_end: false,
        }
    }

    /// The server's message; `None` once there is no answer.
    fn ask(&mut self) -> Option<Value> {
        let Self { number, has, .. } = self;
        let end = u8::from(self.knows_end);
        let path = format!("/state?tab={number}&has={has}&end={end}");
        let state = get(self.port, &path)?.json();
        let newest = state["picture"]["number"].as_u64().unwrap_or(0);
        if newest != self.has {
            let picture = get(self.port, "/picture")?;
            self.has = picture.number();
            self.picture = Some(picture);
        }
        self.knows_end = state["phase"] == "ended";
        Some(state)
    }

    /// Waits until enough is announced.
    fn state(&mut self, enough: impl Fn(&Value) -> bool) -> Value {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            let state = self.ask().expect("an answer");
            if enough(&state) {
                return state;
            }
            sleep(Duration::from_millis(20));
        }
        panic!("not announced");
    }
}

/// The pixels of `/picture`.
fn pixels(answer: &Answer) -> Vec<[f32; 3]> {
    let float = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
    let pixel = |p: &[u8]| [float(p), float(&p[4..]), float(&p[8..])];
    answer.body.chunks_exact(12).map(pixel).collect()
}
