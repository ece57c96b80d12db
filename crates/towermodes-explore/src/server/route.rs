//! The answers of each address.

use std::borrow::Cow;
use std::sync::Arc;

use http_body_util::{BodyExt, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::http::request::Parts;
use hyper::{Method, Response, StatusCode};

use super::SLOW_BODY;
use super::gate::{Gate, Refused};
use super::reply::{Body, file, plain, reply};
use crate::explorer::{Explorer, Wanted};
use crate::page::{PageFile, page_files};
use crate::question::{Question, Reply};

const JSON: &str = "application/json";

/// The largest body, bytes: the input values of ten thousand stations.
const MOST_BYTES: usize = 1 << 20;

/// The explorer, its access check, and the files of the page.
pub(super) struct Routes {
    explorer: Explorer,
    gate: Gate,
    files: Vec<PageFile>,
}

/// The target of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Route {
    /// A file of the page, by its index.
    File(usize),
    /// A question.
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

    /// The target of a request, or the reason why it is refused.
    pub(super) fn find(&self, head: &Parts) -> Result<Route, Refused> {
        let path = self.gate.inside(&head.headers, head.uri.path())?;
        let file = self.files.iter().position(|file| file.name == path);
        let mut questions = Question::ALL.into_iter();
        let question = questions.find(|question| question.name() == path);
        let (route, method) = match (file, question) {
            (Some(index), _) => (Route::File(index), Method::GET),
            (None, Some(Question::Sheet)) => (Route::Question(Question::Sheet), Method::GET),
            (None, Some(question)) => (Route::Question(question), Method::POST),
            (None, None) => {
                return Err(Refused {
                    status: StatusCode::NOT_FOUND,
                    message: "there is nothing at this address",
                });
            }
        };
        match head.method == method {
            true => Ok(route),
            false => Err(Refused {
                status: StatusCode::METHOD_NOT_ALLOWED,
                message: match method {
                    Method::GET => "this address answers GET only",
                    _ => "this address answers POST only",
                },
            }),
        }
    }
}

/// Answers a request; computations run on a separate thread.
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
    // If the page closes the connection, this answer is dropped, and the computation is cancelled.
    let token = Arc::new(());
    let held = Arc::downgrade(&token);
    let computed = move || {
        let wanted = || held.strong_count() > 0;
        computed(&routes.explorer, question, &body, &wanted)
    };
    let done = tokio::task::spawn_blocking(computed).await;
    drop(token);
    done.unwrap_or_else(|_| {
        plain(
            StatusCode::INTERNAL_SERVER_ERROR,
            "the program failed with these values; this is a bug of the program, and its message is in the terminal",
        )
    })
}

/// The whole body of a request, if it is small and arrives in time.
async fn whole(body: Incoming) -> Result<Bytes, Response<Body>> {
    let collected = tokio::time::timeout(SLOW_BODY, Limited::new(body, MOST_BYTES).collect());
    match collected.await {
        Ok(Ok(body)) => Ok(body.to_bytes()),
        Ok(Err(error)) if error.is::<http_body_util::LengthLimitError>() => Err(plain(
            StatusCode::PAYLOAD_TOO_LARGE,
            &format!("the body has more than {MOST_BYTES} bytes"),
        )),
        Ok(Err(_)) => Err(plain(
            StatusCode::BAD_REQUEST,
            "the body of the request is incomplete",
        )),
        Err(_) => Err(plain(
            StatusCode::REQUEST_TIMEOUT,
            &format!(
                "the body of the request was not received within {} s",
                SLOW_BODY.as_secs()
            ),
        )),
    }
}

fn computed(
    explorer: &Explorer,
    question: Question,
    body: &[u8],
    wanted: Wanted<'_>,
) -> Response<Body> {
    match explorer.reply(question, body, wanted) {
        Reply::Json(text) => reply(StatusCode::OK, JSON, text),
        Reply::File(taken) => file(taken),
        // An answer like any other: a browser prints every error status on its console.
        Reply::Refused(text) => reply(StatusCode::OK, JSON, text),
        Reply::NoFile(message) => plain(StatusCode::CONFLICT, &message),
        Reply::Wrong(message) => plain(StatusCode::BAD_REQUEST, &message),
    }
}
