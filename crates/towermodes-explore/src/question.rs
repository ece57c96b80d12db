//! Questions of a page as text, and their answers as bytes.

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::explorer::{Explorer, Wanted};
use super::refusal::Refusal;
use super::take::{TakeError, Taken};
use super::turbine::WhirlQuestion;

/// The requests of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Question {
    /// The input values of the tower.
    Sheet,
    /// The modes for changed input values.
    Solve,
    /// The coupled diagram of a turbine.
    Coupled,
    /// The modes of a turbine at a rotor speed.
    Whirl,
    /// The frequencies in softer and stiffer soil.
    Band,
    /// A tower with a frequency in a band.
    Target,
    /// The elasticities of a mode.
    Elasticities,
    /// The lines that reproduce a state.
    Reproduce,
    /// A file.
    Take,
}

/// An answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Reply {
    /// A document in JSON; in the answer for a solved tower the key `refused` is null.
    Json(Vec<u8>),
    /// A file.
    File(Taken),
    /// There is no such file; the refusal of the tower in JSON.
    Refused(Vec<u8>),
    /// There is no such file; the reason.
    NoFile(String),
    /// The text is not a question.
    Wrong(String),
}

impl Question {
    /// All questions.
    pub const ALL: [Self; 9] = [
        Self::Sheet,
        Self::Solve,
        Self::Coupled,
        Self::Whirl,
        Self::Band,
        Self::Target,
        Self::Elasticities,
        Self::Reproduce,
        Self::Take,
    ];

    /// Its name in the address of a request.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sheet => "sheet",
            Self::Solve => "solve",
            Self::Coupled => "coupled",
            Self::Whirl => "whirl",
            Self::Band => "band",
            Self::Target => "target",
            Self::Elasticities => "elasticities",
            Self::Reproduce => "reproduce",
            Self::Take => "take",
        }
    }
}

impl Explorer {
    /// Answers a question, whose text is JSON; the text of the question for the sheet is not read.
    /// A long computation is cancelled when `wanted` returns false.
    pub fn reply(&self, question: Question, text: &[u8], wanted: Wanted<'_>) -> Reply {
        match question {
            Question::Sheet => json(&self.sheet()),
            Question::Solve => asked(text, |state| either(self.of(state).solve(state))),
            Question::Coupled => asked(text, |state| either(self.of(state).coupled(state, wanted))),
            Question::Whirl => asked(text, |of: &WhirlQuestion| {
                either(self.of(&of.state).whirl(of))
            }),
            Question::Band => asked(text, |state| either(self.of(state).band(state))),
            Question::Target => asked(text, |of| either(self.target(of, wanted))),
            Question::Elasticities => asked(text, |of| either(self.elasticities(of, wanted))),
            Question::Reproduce => asked(text, |state| json(&self.reproduce(state))),
            Question::Take => asked(text, |take| match self.take(take) {
                Ok(taken) => Reply::File(taken),
                Err(TakeError::Refused(refusal)) => match json(&refusal) {
                    Reply::Json(text) => Reply::Refused(text),
                    other => other,
                },
                Err(error) => Reply::NoFile(error.to_string()),
            }),
        }
    }
}

/// The answer to a question in JSON, if the text is one.
fn asked<Q: DeserializeOwned>(text: &[u8], answer: impl FnOnce(&Q) -> Reply) -> Reply {
    match serde_json::from_slice(text) {
        Ok(question) => answer(&question),
        Err(error) => Reply::Wrong(format!("the body is not a question of the page: {error}")),
    }
}

/// An answer for a tower that is not refused.
#[derive(Serialize)]
struct Given<T> {
    refused: (),
    #[serde(flatten)]
    answer: T,
}

/// The answer, or the refusal of the tower, as JSON.
fn either(result: Result<impl Serialize, Refusal>) -> Reply {
    match result {
        Ok(answer) => json(&Given {
            refused: (),
            answer,
        }),
        Err(refusal) => json(&refusal),
    }
}

fn json(value: &impl Serialize) -> Reply {
    match serde_json::to_vec(value) {
        Ok(text) => Reply::Json(text),
        Err(error) => Reply::NoFile(error.to_string()),
    }
}
