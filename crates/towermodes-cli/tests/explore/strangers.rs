//! The server against whoever is not the page.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::json;
use towermodes_testing::{Says, assert_matches};

use super::server::{Explorer, request};

const TOWER: &str = "examples/reference-tower.toml";

fn started() -> Explorer {
    Explorer::start(&[TOWER])
}

#[test]
fn it_listens_on_loopback_only() {
    let explorer = started();
    let Ok(sockets) = std::fs::read_to_string("/proc/net/tcp") else {
        return;
    };
    let port = format!(":{:04X}", explorer.port());
    let own = sockets
        .lines()
        .filter_map(|line| line.split_whitespace().nth(1));
    let own: Vec<&str> = own.filter(|local| local.ends_with(&port)).collect();
    assert!(!own.is_empty());
    // 127.0.0.1 in the byte order of the machine.
    let holds = own.iter().all(|local| local.starts_with("0100007F"));
    assert!(holds, "{own:?}");
    let six = std::fs::read_to_string("/proc/net/tcp6").unwrap_or_default();
    let mut six = six
        .lines()
        .filter_map(|line| line.split_whitespace().nth(1));
    assert!(!six.any(|local| local.ends_with(&port)));
}

#[test]
fn every_answer_has_the_strict_policy() {
    let explorer = started();
    let replies = [
        explorer.ask("GET", "", b""),
        explorer.ask("GET", "sheet", b""),
        explorer.ask("POST", "solve", br#"{"numbers":{}}"#),
        explorer.ask("GET", "nothing", b""),
        explorer.send(&request("GET", "/", &[("Host", &explorer.host())], b"")),
    ];
    for reply in replies {
        let policy = reply.header("content-security-policy");
        policy.begins("default-src 'none'; script-src 'self'; style-src 'self'");
        assert!(!policy.contains("unsafe"));
        assert_eq!(reply.header("x-content-type-options"), "nosniff");
        assert_eq!(reply.header("cross-origin-resource-policy"), "same-origin");
        assert_eq!(reply.header("cache-control"), "no-store");
        assert_eq!(reply.header("access-control-allow-origin"), "");
    }
}

#[test]
fn other_pages_names_and_tokens_are_refused() {
    let explorer = started();
    let (host, root) = (explorer.host(), explorer.root());
    let origin = format!("http://{host}");
    let question = br#"{"numbers":{}}"#;
    let status = |path: &str, headers: &[(&str, &str)]| {
        let reply = explorer.send(&request("POST", path, headers, question));
        assert!(!reply.text().contains("frequency_hz") || reply.status == 200);
        reply.status
    };
    let solve = format!("{root}solve");
    assert_eq!(status(&solve, &[("Host", &host), ("Origin", &origin)]), 200);
    let strange: [(&str, &[(&str, &str)]); 9] = [
        ("/solve", &[("Host", &host)]),
        (
            "/0123456789abcdef0123456789abcdef/solve",
            &[("Host", &host)],
        ),
        (&solve, &[("Host", "evil.example")]),
        (&solve, &[("Host", "127.0.0.1:1")]),
        (&solve, &[]),
        (&solve, &[("Host", &host), ("Host", "evil.example")]),
        (
            &solve,
            &[("Host", &host), ("Origin", "http://evil.example")],
        ),
        (&solve, &[("Host", &host), ("Origin", "null")]),
        (&solve, &[("Host", &host), ("Sec-Fetch-Site", "cross-site")]),
    ];
    for (path, headers) in strange {
        assert_eq!(status(path, headers), 403, "{path} {headers:?}");
    }
    explorer.is_well();
}

#[test]
fn no_other_file_can_be_had() {
    let explorer = started();
    let paths = [
        "../../etc/passwd",
        "..%2f..%2fetc%2fpasswd",
        "%2e%2e/%2e%2e/etc/passwd",
        "....//etc/passwd",
        "/etc/passwd",
        "explore.js/../../Cargo.toml",
        "page.html",
        "sheet/",
        "\\..\\..\\etc\\passwd",
    ];
    for path in paths {
        let reply = explorer.ask("GET", path, b"");
        // A request line that is none is refused before it is understood.
        assert_matches!(reply.status, 400 | 404);
        assert!(!reply.text().contains("root:"), "{path}");
    }
    let absolute = format!("http://{}/etc/passwd", explorer.host());
    let reply = explorer.send(&request(
        "GET",
        &absolute,
        &[("Host", &explorer.host())],
        b"",
    ));
    assert_eq!(reply.status, 403);
    explorer.is_well();
}

#[test]
fn broken_and_huge_bodies_are_refused() {
    let explorer = started();
    let huge = vec![b' '; (1 << 20) + 1];
    let bodies: [(&[u8], u16); 10] = [
        (b"", 400),
        (b"{", 400),
        (b"null", 400),
        (b"[]", 400),
        (b"{}", 400),
        (br#"{"numbers":{"rna.mass":"heavy"}}"#, 400),
        (br#"{"numbers":{"rna.mass":NaN}}"#, 400),
        (br#"{"numbers":{"rna.mass":1e999}}"#, 400),
        (b"\xff\xfe\x00", 400),
        (&huge, 413),
    ];
    for what in ["solve", "elasticities", "reproduce", "take"] {
        for (body, status) in bodies {
            let reply = explorer.ask("POST", what, body);
            let start = String::from_utf8_lossy(&body[..body.len().min(40)]).into_owned();
            assert_eq!(reply.status, status, "{what}: {start}: {}", reply.text());
        }
    }
    // Deep nesting does not exhaust the stack.
    let deep = format!("{{\"numbers\":{}", "[".repeat(500_000));
    assert_eq!(explorer.ask("POST", "solve", deep.as_bytes()).status, 400);
    explorer.is_well();
}

#[test]
fn other_methods_are_refused() {
    let explorer = started();
    for (method, what, allowed) in [
        ("GET", "solve", "POST"),
        ("PUT", "solve", "POST"),
        ("DELETE", "", "GET"),
        ("POST", "sheet", "GET"),
        ("OPTIONS", "solve", "POST"),
    ] {
        let reply = explorer.ask(method, what, b"");
        assert_eq!(reply.status, 405, "{method} {what}");
        let message = format!("this address answers {allowed} only\n");
        assert_eq!(reply.text(), message, "{method} {what}");
    }
    explorer.is_well();
}

#[test]
fn broken_requests_are_survived() {
    let explorer = started();
    let (host, root) = (explorer.host(), explorer.root());
    let many: String = (0..2000).map(|k| format!("X-{k}: 1\r\n")).collect();
    let requests = [
        "\r\n\r\n".to_owned(),
        "nonsense\r\n\r\n".to_owned(),
        "GET\r\n\r\n".to_owned(),
        format!("GET {root} HTTP/9.9\r\nHost: {host}\r\n\r\n"),
        format!("GET {root} HTTP/1.1\r\nHost: {host}\r\n{many}\r\n"),
        format!(
            "GET {root}{} HTTP/1.1\r\nHost: {host}\r\n\r\n",
            "a".repeat(1_000_000)
        ),
        format!("POST {root}solve HTTP/1.1\r\nHost: {host}\r\nContent-Length: -5\r\n\r\n"),
        format!(
            "POST {root}solve HTTP/1.1\r\nHost: {host}\r\nContent-Length: 5\r\nContent-Length: 9\r\n\r\nabcde"
        ),
        format!(
            "POST {root}solve HTTP/1.1\r\nHost: {host}\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n"
        ),
        "\u{0}\u{1}\u{2}".repeat(1000),
    ];
    for text in requests {
        let mut stream = explorer.connected();
        let _ = stream.write_all(text.as_bytes());
        let _ = stream.shutdown(std::net::Shutdown::Write);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let holds = !String::from_utf8_lossy(&answer).starts_with("HTTP/1.1 200");
        assert!(holds, "{text:.60}");
    }
    // A body that is announced and never comes.
    let mut stream = explorer.connected();
    let half =
        format!("POST {root}solve HTTP/1.1\r\nHost: {host}\r\nContent-Length: 1000\r\n\r\n{{");
    stream.write_all(half.as_bytes()).expect("sent");
    explorer.is_well();
    drop(stream);
    explorer.is_well();
}

/// New connections are served as soon as the idle ones are closed, which takes some seconds.
#[test]
fn a_thousand_connections_are_survived() {
    let explorer = started();
    let (host, root) = (explorer.host(), explorer.root());
    let flood: Vec<TcpStream> = (0..1000)
        .filter_map(|_| TcpStream::connect(("127.0.0.1", explorer.port())).ok())
        .collect();
    assert!(flood.len() > 900, "{}", flood.len());
    let started = Instant::now();
    let question = json!({ "numbers": {} }).to_string();
    let path = format!("{root}solve");
    let request = request("POST", &path, &[("Host", &host)], question.as_bytes());
    loop {
        let answer = explorer.sent(&request);
        if answer.starts_with(b"HTTP/1.1 200") {
            break;
        }
        let holds = started.elapsed() < Duration::from_secs(30);
        assert!(holds, "no connection is served any more");
        std::thread::sleep(Duration::from_millis(100));
    }
    drop(flood);
    explorer.is_well();
}

/// Many solves at once: each has its answer.
#[test]
fn questions_at_once_are_answered() {
    let explorer = started();
    let first = explorer.ask("POST", "solve", br#"{"numbers":{"rna.mass":1000}}"#);
    let of = |text: &[u8]| {
        let answer: serde_json::Value = serde_json::from_slice(text).expect("JSON");
        answer["modes"][0]["frequency_hz"]
            .as_f64()
            .expect("a number")
    };
    std::thread::scope(|scope| {
        for _ in 0..50 {
            scope.spawn(|| {
                let answer = explorer.ask("POST", "solve", br#"{"numbers":{"rna.mass":1000}}"#);
                assert_eq!(of(&answer.body), of(&first.body));
            });
        }
    });
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_leaves_nothing_behind() {
    let mut explorer = started();
    explorer.is_well();
    let (id, port) = (explorer.process.id(), explorer.port());
    let children = format!("/proc/{id}/task/{id}/children");
    let children = std::fs::read_to_string(children).unwrap_or_default();
    assert_eq!(children.trim(), "", "it has started other programs");
    let begun = Instant::now();
    let sent = Command::new("kill")
        .args(["-INT", &id.to_string()])
        .status();
    assert!(sent.is_ok_and(|status| status.success()));
    let ended = explorer.process.wait().expect("a process");
    assert!(begun.elapsed() < Duration::from_secs(2));
    use std::os::unix::process::ExitStatusExt;
    // As a shell expects of a program that Ctrl-C ends.
    assert_eq!(ended.signal(), Some(2));
    let holds = TcpStream::connect(("127.0.0.1", port)).is_err();
    assert!(holds, "it still listens");
}

#[test]
fn a_port_that_is_taken_is_named() {
    let explorer = started();
    let port = explorer.port().to_string();
    let mut command = Command::new(crate::sandbox::PROGRAM);
    let arguments = ["explore", "--no-open", TOWER, "--port", &port];
    let second = command
        .current_dir(crate::pages::root())
        .args(arguments)
        .output();
    let second = second.expect("the program runs");
    assert_eq!(second.status.code(), Some(1));
    let said = String::from_utf8_lossy(&second.stderr);
    said.says(&format!("port {port} cannot be used"));
    said.says("without --port");
}
