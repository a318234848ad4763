//! A browser without a window: Chromium, by the DevTools protocol over a WebSocket.
//!
//! <https://chromedevtools.github.io/devtools-protocol/>

use std::fs;
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use tempfile::TempDir;
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

use crate::common::needs::Need;

/// No answer takes longer.
const PATIENCE: Duration = Duration::from_secs(60);

/// A browser with one page. It ends when it is dropped.
pub struct Browser {
    child: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: Option<String>,
    calls: u64,
    /// Unsolicited messages of the browser.
    events: Vec<Value>,
    _profile: TempDir,
}

/// The program, by the names that distributions give it.
fn program() -> Result<PathBuf, &'static str> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let names = ["chromium", "chromium-browser", "google-chrome", "chrome"];
    let all = std::env::split_paths(&path);
    all.flat_map(|folder| names.map(|name| folder.join(name)))
        .find(|file| file.is_file())
        .ok_or("there is no Chromium in PATH")
}

impl Browser {
    /// `None` if the run skips Chromium.
    pub fn start() -> Option<Self> {
        let program = Need::Chromium.find(program)?;
        let profile = tempfile::tempdir().expect("a folder");
        // The page is our own: nothing needs the sandbox, which root and containers do not have.
        let mut child = Command::new(program)
            .args([
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-dev-shm-usage",
            ])
            .args([
                "--no-first-run",
                "--disable-background-networking",
                "--disable-extensions",
            ])
            .args([
                "--hide-scrollbars",
                "--force-color-profile=srgb",
                "--remote-debugging-port=0",
            ])
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("chromium starts");
        let address = address(&mut child);
        let (socket, _) = tungstenite::connect(address).expect("a connection");
        if let MaybeTlsStream::Plain(stream) = socket.get_ref() {
            stream.set_read_timeout(Some(PATIENCE)).expect("a timeout");
        }
        let mut browser = Self {
            child,
            socket,
            session: None,
            calls: 0,
            events: Vec::new(),
            _profile: profile,
        };
        let page = browser.call("Target.createTarget", json!({"url": "about:blank"}));
        let attach = json!({"targetId": page["targetId"], "flatten": true});
        let session = browser.call("Target.attachToTarget", attach);
        browser.session = session["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Network", "Log"] {
            browser.call(&format!("{domain}.enable"), json!({}));
        }
        Some(browser)
    }

    /// A method's answer; the browser's messages in between are kept.
    pub fn call(&mut self, method: &str, params: Value) -> Value {
        self.answer(method, params)
            .unwrap_or_else(|error| panic!("{method}: {error}"))
    }

    /// The same, or the browser's error.
    fn answer(&mut self, method: &str, params: Value) -> Result<Value, Value> {
        self.calls += 1;
        let id = self.calls;
        let mut request = json!({"id": id, "method": method, "params": params});
        if let Some(session) = &self.session {
            request["sessionId"] = json!(session);
        }
        self.socket
            .send(Message::text(request.to_string()))
            .expect("sent");
        loop {
            let message = self.receive();
            if message["id"] == json!(id) {
                return match &message["error"] {
                    Value::Null => Ok(message["result"].clone()),
                    error => Err(error.clone()),
                };
            }
        }
    }

    fn receive(&mut self) -> Value {
        loop {
            let message = self.socket.read().expect("an answer in time");
            if let Message::Text(text) = message {
                let message: Value = serde_json::from_str(&text).expect("JSON");
                if message["id"].is_null() {
                    self.events.push(message.clone());
                }
                return message;
            }
        }
    }

    /// Opens a file and waits until it is loaded.
    pub fn open(&mut self, file: &Path) {
        self.visit(&format!("file://{}", file.display()));
    }

    /// Opens an address and waits until it is loaded.
    pub fn visit(&mut self, url: &str) {
        self.call("Page.navigate", json!({"url": url}));
        // The answer comes when the new document has taken the old one's place.
        while self.value("document.readyState") != "complete" {
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// The parameters of all events of a kind so far.
    pub fn events(&self, method: &str) -> Vec<&Value> {
        let of_kind = self.events.iter().filter(|e| e["method"] == method);
        of_kind.map(|e| &e["params"]).collect()
    }

    /// The errors of the page, and its requests to the network.
    pub fn complaints(&self) -> Vec<String> {
        self.complaints_beside("file:")
    }

    /// The errors of the page, and its requests to the network except those with this beginning.
    pub fn complaints_beside(&self, own: &str) -> Vec<String> {
        let errors = self.events("Runtime.exceptionThrown").into_iter();
        let logged = self.events("Log.entryAdded").into_iter();
        let printed = self.events("Runtime.consoleAPICalled").into_iter();
        let wrong = errors.chain(logged).chain(printed).map(Value::to_string);
        let requests = self.events("Network.requestWillBeSent").into_iter();
        let asked = requests.filter_map(|r| r["request"]["url"].as_str());
        let outside = asked.filter(|url| !url.starts_with(own) && !url.starts_with("data:"));
        wrong.chain(outside.map(str::to_owned)).collect()
    }

    /// The value of an expression of JavaScript.
    pub fn value(&mut self, expression: &str) -> Value {
        let params = json!({"expression": expression, "returnByValue": true, "awaitPromise": true});
        let answer = self.call("Runtime.evaluate", params);
        assert!(
            answer["exceptionDetails"].is_null(),
            "{expression}: {}",
            answer["exceptionDetails"]
        );
        answer["result"]["value"].clone()
    }

    pub fn text(&mut self, expression: &str) -> String {
        self.value(expression).as_str().expect("a text").to_owned()
    }

    /// A window of so many CSS pixels.
    pub fn window(&mut self, width: u32, height: u32) {
        let size = json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500});
        self.call("Emulation.setDeviceMetricsOverride", size);
    }

    /// `screen` or `print`; `light` or `dark`.
    pub fn media(&mut self, media: &str, scheme: &str) {
        let features = json!([{"name": "prefers-color-scheme", "value": scheme}]);
        self.call(
            "Emulation.setEmulatedMedia",
            json!({"media": media, "features": features}),
        );
    }

    /// Moves the pointer over the middle of the element that the expression names, scrolled into view; presses there too.
    pub fn point(&mut self, element: &str, press: bool) {
        let middle = self.value(&format!(
            "(() => {{ const e = {element}; e.scrollIntoView({{block: 'center'}}); \
             const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; }})()"
        ));
        let [x, y] = [0, 1].map(|i| middle[i].as_f64().expect("a place"));
        self.mouse("mouseMoved", x, y);
        if press {
            self.mouse("mousePressed", x, y);
            self.mouse("mouseReleased", x, y);
        }
    }

    /// Moves the pointer to a place of the window, or presses or releases its left button there.
    pub fn mouse(&mut self, kind: &str, x: f64, y: f64) {
        let button = if kind == "mouseMoved" { "none" } else { "left" };
        let event = json!({"type": kind, "x": x, "y": y, "button": button, "clickCount": 1});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Moves the pointer with its left button down.
    pub fn drag(&mut self, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) {
        self.mouse("mousePressed", x0, y0);
        let event = json!({"type": "mouseMoved", "x": x1, "y": y1, "button": "left", "buttons": 1});
        self.call("Input.dispatchMouseEvent", event);
        self.mouse("mouseReleased", x1, y1);
    }

    /// Turns the wheel at a place of the window; `down` is negative where it is turned up.
    pub fn wheel(&mut self, x: f64, y: f64, down: f64) {
        let event = json!({"type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": down});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Waits until an expression is true on a page that is being reloaded: until then there may be no page to evaluate it.
    pub fn wait_anew(&mut self, expression: &str) {
        let start = Instant::now();
        let params = json!({"expression": expression, "returnByValue": true});
        let is_true = |answer: Value| answer["result"]["value"] == true;
        while !self
            .answer("Runtime.evaluate", params.clone())
            .is_ok_and(is_true)
        {
            assert!(start.elapsed() < PATIENCE, "never true: {expression}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Waits until an expression of JavaScript is true.
    pub fn wait(&mut self, expression: &str) {
        let start = Instant::now();
        while self.value(expression) != true {
            assert!(start.elapsed() < PATIENCE, "never true: {expression}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Presses a key of this name and code, such as `ArrowLeft` and 37.
    pub fn key(&mut self, name: &str, code: u32) {
        for kind in ["rawKeyDown", "keyUp"] {
            let event =
                json!({"type": kind, "key": name, "code": name, "windowsVirtualKeyCode": code});
            self.call("Input.dispatchKeyEvent", event);
        }
    }

    /// The whole page as `target/screenshots/NAME.png`.
    pub fn screenshot(&mut self, name: &str) {
        let all = json!({"format": "png", "captureBeyondViewport": true, "clip": self.whole()});
        let shot = self.call("Page.captureScreenshot", all);
        let png = STANDARD.decode(shot["data"].as_str().expect("a picture"));
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("../screenshots");
        fs::create_dir_all(&folder).expect("a folder");
        let file = folder.join(name).with_extension("png");
        fs::write(&file, png.expect("base64")).expect("a file");
    }

    fn whole(&mut self) -> Value {
        let size = self.call("Page.getLayoutMetrics", json!({}))["cssContentSize"].clone();
        json!({"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1})
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Where the browser listens; it says so itself.
fn address(child: &mut Child) -> String {
    let stderr = child.stderr.take().expect("a pipe");
    let mut lines = BufReader::new(stderr).lines().map_while(Result::ok);
    let line = lines
        .find(|line| line.contains("ws://"))
        .expect("an address");
    // Read to the end, or it would wait for us.
    std::thread::spawn(move || lines.for_each(drop));
    line[line.find("ws://").unwrap_or(0)..].trim().to_owned()
}
