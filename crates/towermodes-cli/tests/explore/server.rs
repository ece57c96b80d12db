//! A running explorer, asked as a page asks it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

use crate::pages::root;
use crate::sandbox::PROGRAM;

/// The longest time that an answer may take.
const PATIENCE: Duration = Duration::from_secs(60);

/// A running program; it is ended with the test.
pub struct Explorer {
    pub process: Child,
    /// `http://127.0.0.1:PORT/TOKEN/`, with a fragment if numbers are set.
    pub address: String,
}

/// An answer of the server.
pub struct Reply {
    pub status: u16,
    /// Names in lower case.
    pub headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

impl Explorer {
    /// Starts the program in the folder of the repository and waits for its address.
    pub fn start(arguments: &[&str]) -> Self {
        // Whoever runs the tests may ignore Ctrl-C, as a background job does, and hand that down.
        let mut command = match cfg!(target_os = "linux") {
            true => {
                let mut command = Command::new("env");
                command.args(["--default-signal=INT", PROGRAM]);
                command
            }
            false => Command::new(PROGRAM),
        };
        let mut process = command
            .current_dir(root())
            .args(["explore", "--no-open"])
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        let mut address = String::new();
        let output = process.stdout.take().expect("its output");
        BufReader::new(output)
            .read_line(&mut address)
            .expect("an address");
        let holds = address.starts_with("http://127.0.0.1:");
        assert!(holds, "{arguments:?}: {address:?}");
        Self {
            process,
            address: address.trim().to_owned(),
        }
    }

    pub fn port(&self) -> u16 {
        let host = self.host();
        let (_, port) = host.split_once(':').expect("a port");
        port.parse().expect("a number")
    }

    /// `127.0.0.1:PORT`.
    pub fn host(&self) -> String {
        let rest = self.address.trim_start_matches("http://");
        rest.split('/').next().expect("a host").to_owned()
    }

    /// `/TOKEN/`.
    pub fn root(&self) -> String {
        let rest = self.address.trim_start_matches("http://");
        let token = rest.split('/').nth(1).expect("a token");
        format!("/{token}/")
    }

    /// Asks as a page does, below the token.
    pub fn ask(&self, method: &str, what: &str, body: &[u8]) -> Reply {
        let path = self.root() + what;
        self.send(&request(method, &path, &[("Host", &self.host())], body))
    }

    /// Sends bytes over a connection of their own, and reads until the server closes it.
    pub fn send(&self, bytes: &[u8]) -> Reply {
        let answer = self.sent(bytes);
        Reply::parse(&answer).unwrap_or_else(|| panic!("no answer: {answer:?}"))
    }

    /// The same without an answer that is understood.
    pub fn sent(&self, bytes: &[u8]) -> Vec<u8> {
        let mut stream = self.connected();
        // The server may close the connection before it has read everything.
        let _ = stream.write_all(bytes);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        answer
    }

    pub fn connected(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port())).expect("it listens");
        stream.set_read_timeout(Some(PATIENCE)).expect("a time");
        stream.set_write_timeout(Some(PATIENCE)).expect("a time");
        stream
    }

    /// The JSON that a question is answered with.
    #[track_caller]
    pub fn answer(&self, what: &str, question: &Value) -> Value {
        let reply = self.ask("POST", what, question.to_string().as_bytes());
        assert_eq!(reply.status, 200, "{what}: {}", reply.text());
        serde_json::from_slice(&reply.body).expect("JSON")
    }

    /// Fails if the page is not served any more.
    #[track_caller]
    pub fn is_well(&self) {
        assert_eq!(self.ask("GET", "", b"").status, 200);
        let answer = self.answer("solve", &serde_json::json!({ "numbers": {} }));
        assert!(answer["refused"].is_null(), "{answer}");
    }
}

impl Drop for Explorer {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Reply {
    fn parse(bytes: &[u8]) -> Option<Self> {
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n")?;
        let head = std::str::from_utf8(&bytes[..end]).ok()?;
        let mut lines = head.split("\r\n");
        let status = lines.next()?.split(' ').nth(1)?.parse().ok()?;
        let headers = lines.filter_map(|line| {
            let (name, value) = line.split_once(':')?;
            Some((name.to_ascii_lowercase(), value.trim().to_owned()))
        });
        Some(Self {
            status,
            headers: headers.collect(),
            body: bytes[end + 4..].to_vec(),
        })
    }

    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub fn header(&self, name: &str) -> &str {
        let mut headers = self.headers.iter();
        let found = headers.find(|(own, _)| own == name);
        found.map_or("", |(_, value)| value.as_str())
    }
}

/// A request that asks the server to close the connection.
pub fn request(method: &str, path: &str, headers: &[(&str, &str)], body: &[u8]) -> Vec<u8> {
    let mut text = format!("{method} {path} HTTP/1.1\r\nConnection: close\r\n");
    for (name, value) in headers {
        text.push_str(&format!("{name}: {value}\r\n"));
    }
    if method != "GET" || !body.is_empty() {
        text.push_str(&format!("Content-Length: {}\r\n", body.len()));
    }
    text.push_str("\r\n");
    [text.as_bytes(), body].concat()
}
