//! What each address answers.

use std::borrow::Cow;
use std::sync::Arc;

use http_body_util::{BodyExt, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::header::{ALLOW, HeaderValue};
use hyper::http::request::Parts;
use hyper::{Method, Response, StatusCode};
use serde::de::DeserializeOwned;

use super::SLOW_BODY;
use super::gate::Gate;
use super::reply::{self, Body, json, plain, refused, reply};
use crate::explorer::Explorer;
use crate::page::{PageFile, page_files};
use crate::refusal::Refusal;
use crate::take::TakeError;

/// The largest body, bytes: the numbers of ten thousand stations.
const MOST_BYTES: usize = 1 << 20;

/// The explorer behind its gate, with the files of the page.
pub(super) struct Routes {
    explorer: Explorer,
    gate: Gate,
    files: Vec<PageFile>,
}

/// Questions that are answered by computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Question {
    Sheet,
    Solve,
    Elasticities,
    Reproduce,
    Take,
}

/// Where a request leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Route {
    /// To a file of the page, by its index.
    File(usize),
    /// To a question.
    Question(Question),
}

impl Routes {
    pub(super) fn new(explorer: Explorer, gate: Gate) -> Self {
        Self {
            explorer,
            gate,
            files: page_files(),
        }
    }

    /// Where a request leads, or why it is refused.
    pub(super) fn find(&self, head: &Parts) -> Result<Route, Response<Body>> {
        let path = self.gate.inside(&head.headers, head.uri.path());
        let path = path.map_err(refused)?;
        let file = self.files.iter().position(|file| file.name == path);
        let (route, method) = match (file, path) {
            (Some(index), _) => (Route::File(index), Method::GET),
            (None, "sheet") => (Route::Question(Question::Sheet), Method::GET),
            (None, "solve") => (Route::Question(Question::Solve), Method::POST),
            (None, "elasticities") => (Route::Question(Question::Elasticities), Method::POST),
            (None, "reproduce") => (Route::Question(Question::Reproduce), Method::POST),
            (None, "take") => (Route::Question(Question::Take), Method::POST),
            _ => {
                return Err(plain(
                    StatusCode::NOT_FOUND,
                    "there is nothing at this address",
                ));
            }
        };
        match head.method == method {
            true => Ok(route),
            false => Err(other_method(&method)),
        }
    }
}

fn other_method(method: &Method) -> Response<Body> {
    let message = format!("this address is asked by {method}");
    let mut response = plain(StatusCode::METHOD_NOT_ALLOWED, &message);
    if let Ok(value) = HeaderValue::from_str(method.as_str()) {
        response.headers_mut().insert(ALLOW, value);
    }
    response
}

/// Answers a request; what computes runs on a thread of its own.
pub(super) async fn answer(routes: Arc<Routes>, route: Route, body: Incoming) -> Response<Body> {
    let question = match route {
        Route::File(index) => {
            let file = &routes.files[index];
            let content = match &file.content {
                Cow::Borrowed(text) => Bytes::from_static(text.as_bytes()),
                Cow::Owned(text) => Bytes::from(text.clone()),
            };
            return reply(StatusCode::OK, file.media_type, content);
        }
        Route::Question(question) => question,
    };
    let body = match whole(body).await {
        Ok(body) => body,
        Err(response) => return response,
    };
    let computed = move || computed(&routes.explorer, question, &body);
    let done = tokio::task::spawn_blocking(computed).await;
    done.unwrap_or_else(|_| {
        plain(
            StatusCode::INTERNAL_SERVER_ERROR,
            "the program failed on these numbers; this is a defect of the program: its terminal has the message",
        )
    })
}

/// The whole body of a request, if it is small and comes in time.
async fn whole(body: Incoming) -> Result<Bytes, Response<Body>> {
    let collected = tokio::time::timeout(SLOW_BODY, Limited::new(body, MOST_BYTES).collect());
    match collected.await {
        Ok(Ok(body)) => Ok(body.to_bytes()),
        Ok(Err(error)) if error.is::<http_body_util::LengthLimitError>() => Err(plain(
            StatusCode::PAYLOAD_TOO_LARGE,
            &format!("the body has more than {MOST_BYTES} bytes"),
        )),
        Ok(Err(_)) => Err(plain(StatusCode::BAD_REQUEST, "the body is broken off")),
        Err(_) => Err(plain(
            StatusCode::REQUEST_TIMEOUT,
            &format!("the body did not come within {} s", SLOW_BODY.as_secs()),
        )),
    }
}

fn computed(explorer: &Explorer, question: Question, body: &[u8]) -> Response<Body> {
    match question {
        Question::Sheet => json(&explorer.sheet()),
        Question::Solve => asked(body, |state| either(explorer.solve(state))),
        Question::Elasticities => asked(body, |of| either(explorer.elasticities(of))),
        Question::Reproduce => asked(body, |state| json(&explorer.reproduce(state))),
        Question::Take => asked(body, |take| match explorer.take(take) {
            Ok(taken) => reply::file(taken),
            Err(TakeError::Refused(refusal)) => {
                let mut response = json(&refusal);
                *response.status_mut() = StatusCode::CONFLICT;
                response
            }
            Err(error) => plain(StatusCode::CONFLICT, &error.to_string()),
        }),
    }
}

/// The answer to a question in JSON, if it is one.
fn asked<Q: DeserializeOwned>(
    body: &[u8],
    answer: impl FnOnce(&Q) -> Response<Body>,
) -> Response<Body> {
    match serde_json::from_slice(body) {
        Ok(question) => answer(&question),
        Err(error) => plain(
            StatusCode::BAD_REQUEST,
            &format!("the body is not a question of the page: {error}"),
        ),
    }
}

/// A refused tower is an answer too.
fn either(result: Result<impl serde::Serialize, Refusal>) -> Response<Body> {
    match result {
        Ok(answer) => json(&answer),
        Err(refusal) => json(&refusal),
    }
}
