//! A Chromium without a window, driven through a pipe: the Chrome DevTools Protocol in JSON.
//!
//! Commands go to its file descriptor 3, replies and events come from 4, each message ends with a
//! zero byte.

use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// The longest time that an answer may take.
pub const PATIENCE: Duration = Duration::from_secs(30);

/// Connects the two descriptors with standard input and output.
const LAUNCH: &str = r#"exec "$0" "$@" 3<&0 4>&1 0</dev/null 1>/dev/null 2>/dev/null"#;

/// Whether the browser draws in three dimensions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Graphics {
    /// It does not.
    Flat,
    /// WebGL, drawn by the processor.
    Space,
}

impl Graphics {
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Flat => &["--disable-3d-apis"],
            Self::Space => &[
                "--use-gl=angle",
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
            ],
        }
    }
}

/// A running browser with one page.
pub struct Browser {
    process: Child,
    commands: ChildStdin,
    messages: Receiver<Value>,
    /// Events that came while an answer was waited for.
    events: Vec<Value>,
    profile: PathBuf,
    session: Option<String>,
    last: u64,
}

impl Browser {
    /// Starts a browser with an empty page in a window of a width and height.
    pub fn start(program: &std::ffi::OsStr, size: (u32, u32), graphics: Graphics) -> Self {
        let (width, height) = size;
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("browser-{}-{number}", std::process::id());
        let profile = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
        let mut process = Command::new("sh")
            .args(["-c", LAUNCH])
            .arg(program)
            .args(["--headless", "--remote-debugging-pipe", "--disable-gpu"])
            // Chromium's own sandbox does not run as root, as in containers.
            .args(["--no-sandbox", "--disable-dev-shm-usage", "--no-first-run"])
            .args(["--disable-background-networking", "--disable-extensions"])
            .args(["--force-color-profile=srgb", "--hide-scrollbars"])
            .args(graphics.arguments())
            .arg(format!("--window-size={width},{height}"))
            .arg(format!("--user-data-dir={}", profile.display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("a shell");
        let commands = process.stdin.take().expect("a pipe");
        let mut replies = BufReader::new(process.stdout.take().expect("a pipe"));
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            let mut message = Vec::new();
            while replies
                .read_until(0, &mut message)
                .is_ok_and(|read| read > 0)
            {
                let text = message.strip_suffix(&[0]).unwrap_or(&message);
                let Ok(value) = serde_json::from_slice(text) else {
                    break;
                };
                if sender.send(value).is_err() {
                    break;
                }
                message.clear();
            }
        });
        let mut browser = Self {
            process,
            commands,
            messages,
            events: Vec::new(),
            profile,
            session: None,
            last: 0,
        };
        let target = browser.call("Target.createTarget", &json!({ "url": "about:blank" }));
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let session = browser.call("Target.attachToTarget", &attach);
        browser.session = session["sessionId"].as_str().map(str::to_owned);
        browser
    }

    /// Sends a command and waits for its result; fails if the browser refuses it.
    pub fn call(&mut self, method: &str, parameters: &Value) -> Value {
        self.last += 1;
        let mut message = json!({ "id": self.last, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            message["sessionId"] = json!(session);
        }
        let mut bytes = message.to_string().into_bytes();
        bytes.push(0);
        self.commands
            .write_all(&bytes)
            .expect("the browser listens");
        let started = Instant::now();
        loop {
            let mut reply = self.next(started, method);
            if reply["id"] == self.last {
                assert!(reply["error"].is_null(), "{method}: {}", reply["error"]);
                return reply["result"].take();
            }
            self.events.push(reply);
        }
    }

    /// Waits for an event.
    pub fn wait_for_event(&mut self, method: &str) {
        let started = Instant::now();
        while !self.events.iter().any(|event| event["method"] == method) {
            let event = self.next(started, method);
            self.events.push(event);
        }
    }

    /// The parameters of the events so far of one of these kinds.
    pub fn events(&mut self, methods: &[&str]) -> Vec<Value> {
        self.events.extend(self.messages.try_iter());
        let events = self.events.iter();
        let these = events.filter(|event| methods.iter().any(|method| event["method"] == *method));
        these.map(|event| event["params"].clone()).collect()
    }

    fn next(&self, started: Instant, waiting_for: &str) -> Value {
        let left = PATIENCE.saturating_sub(started.elapsed());
        let message = self.messages.recv_timeout(left);
        message.unwrap_or_else(|error| panic!("waiting for {waiting_for}: {error}"))
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // A test has ended either way: what is left over is not its result.
        let _ = self.process.kill();
        let _ = self.process.wait();
        let _ = std::fs::remove_dir_all(&self.profile);
    }
}

/// The bytes of a text in base64 (RFC 4648).
pub fn bytes_of_base64(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => Some(c - b'A'),
        b'a'..=b'z' => Some(c - b'a' + 26),
        b'0'..=b'9' => Some(c - b'0' + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    };
    let (mut bytes, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for value in text.bytes().filter_map(digit) {
        bits = bits << 6 | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    bytes
}
