//! Requests that are accepted: only those of the page itself, under its own address.

use hyper::StatusCode;
use hyper::header::{HOST, HeaderMap, ORIGIN};

/// The address of the page and its token.
pub(super) struct Gate {
    port: u16,
    token: String,
}

/// A request that is not answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Refused {
    pub(super) status: StatusCode,
    pub(super) message: &'static str,
}

impl Gate {
    pub(super) fn new(port: u16, token: String) -> Self {
        Self { port, token }
    }

    pub(super) fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.token)
    }

    /// The part of the path after the token.
    ///
    /// # Errors
    /// [`Refused`]: the headers or the path are not those of the page.
    pub(super) fn inside<'p>(
        &self,
        headers: &HeaderMap,
        path: &'p str,
    ) -> Result<&'p str, Refused> {
        let forbidden = |message| Refused {
            status: StatusCode::FORBIDDEN,
            message,
        };
        let hosts = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{}", self.port));
        let is_own = |host: &str| hosts.iter().any(|own| own == host);
        if !single(headers, HOST.as_str()).is_some_and(is_own) {
            return Err(forbidden("this program answers only under its own address"));
        }
        let origin = single(headers, ORIGIN.as_str());
        let has_origin = headers.contains_key(ORIGIN);
        let is_own_origin = |origin: &str| origin.strip_prefix("http://").is_some_and(is_own);
        if has_origin && !origin.is_some_and(is_own_origin) {
            return Err(forbidden(
                "the request comes from another page; only the page of this program may send requests",
            ));
        }
        // A link on another page may not open it either: `none` is an address that was typed.
        let from = single(headers, "sec-fetch-site");
        if from.is_some_and(|from| !matches!(from, "same-origin" | "none")) {
            return Err(forbidden(
                "the request comes from another page; only the page of this program may send requests",
            ));
        }
        let rest = path.strip_prefix('/').unwrap_or(path);
        let (token, inside) = rest.split_once('/').unwrap_or((rest, ""));
        match is_same(token.as_bytes(), self.token.as_bytes()) {
            true if rest.contains('/') => Ok(inside),
            _ => Err(forbidden(
                "the address lacks the token or its last slash; use the whole address that the program printed",
            )),
        }
    }
}

/// The value of a header that occurs exactly once.
fn single<'h>(headers: &'h HeaderMap, name: &str) -> Option<&'h str> {
    let mut all = headers.get_all(name).iter();
    match (all.next(), all.next()) {
        (Some(one), None) => one.to_str().ok(),
        _ => None,
    }
}

/// Equality in a time that does not depend on the position of the first difference.
fn is_same(a: &[u8], b: &[u8]) -> bool {
    let differences = a.iter().zip(b).fold(0, |all, (a, b)| all | (a ^ b));
    a.len() == b.len() && differences == 0
}

#[cfg(test)]
mod tests {
    use hyper::header::{HeaderMap, HeaderValue};

    use super::Gate;

    fn headers(pairs: &[(&'static str, &'static str)]) -> HeaderMap {
        let mut headers = HeaderMap::new();
        for (name, value) in pairs {
            headers.append(*name, HeaderValue::from_static(value));
        }
        headers
    }

    #[test]
    fn only_the_page_itself_comes_in() {
        let gate = Gate::new(4000, "abc".to_owned());
        let own = ("host", "127.0.0.1:4000");
        let inside = |pairs: &[(&'static str, &'static str)], path: &'static str| {
            gate.inside(&headers(pairs), path).ok()
        };
        assert_eq!(inside(&[own], "/abc/"), Some(""));
        assert_eq!(inside(&[own], "/abc/solve"), Some("solve"));
        assert_eq!(
            inside(&[own], "/abc/../../etc/passwd"),
            Some("../../etc/passwd")
        );
        assert_eq!(inside(&[("host", "localhost:4000")], "/abc/"), Some(""));
        let fine = [own, ("origin", "http://127.0.0.1:4000")];
        assert_eq!(inside(&fine, "/abc/solve"), Some("solve"));
        for wrong in [
            "/", "/abc", "/abd/", "/abcd/", "/ab/", "//abc/", "/solve", "/?abc/",
        ] {
            assert_eq!(inside(&[own], wrong), None, "{wrong}");
        }
        for host in [
            "evil.example:4000",
            "127.0.0.1",
            "127.0.0.1:4001",
            "0.0.0.0:4000",
            "",
        ] {
            assert_eq!(inside(&[("host", host)], "/abc/"), None, "{host}");
        }
        assert_eq!(inside(&[], "/abc/"), None);
        assert_eq!(inside(&[own, own], "/abc/"), None);
        for origin in [
            "http://evil.example",
            "null",
            "https://127.0.0.1:4000",
            "http://127.0.0.1",
        ] {
            assert_eq!(
                inside(&[own, ("origin", origin)], "/abc/"),
                None,
                "{origin}"
            );
        }
        assert_eq!(
            inside(&[own, ("sec-fetch-site", "cross-site")], "/abc/"),
            None
        );
        assert_eq!(
            inside(&[own, ("sec-fetch-site", "none")], "/abc/"),
            Some("")
        );
    }
}
