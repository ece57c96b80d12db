//! The functions that a page calls, and those that it provides.
//!
//! Bytes are passed through the memory of the module: the page calls [`room`], writes to this
//! address and calls a function; then it reads the bytes at [`answer`]. No function takes a
//! pointer.
//!
//! | call | text in the room | returns |
//! |---|---|---|
//! | `begin()` | | |
//! | `put(n)` | the name of a file in `n` bytes, its content | a [`Kind`] |
//! | `open()` | | a [`Kind`] |
//! | `ask(n)` | the name of a question in `n` bytes, its body | a [`Kind`] |
//! | `colours()` | | a [`Kind`] |

// An exported name must be unique, and an imported function must be what it is declared as: the
// compiler can see neither. There is no other unsafe code.
#![allow(unsafe_code)]

use std::cell::RefCell;

use towermodes_explore::{Exploration, Explorer, Question, Reply};
use towermodes_report::report::{page_colours, quoted};

use crate::chosen::ChosenFiles;

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Milliseconds since an arbitrary moment.
    safe fn now_ms() -> f64;
    /// Receives the message of a panic, a text in UTF-8 at this address; then the module traps.
    safe fn failed(message: *const u8, length: usize);
}

/// The kind of an answer.
#[derive(Clone, Copy)]
#[repr(u32)]
enum Kind {
    /// A document in JSON; empty if there is no content.
    Json = 0,
    /// A file: one line with its name, one with its media type, then its content.
    File = 1,
    /// No file, but the reason why the tower is refused, in JSON.
    Refused = 2,
    /// A message: the reason why there is no answer.
    Message = 3,
}

/// The state of the module: chosen files, explorer, and the buffers of calls and answers.
struct Desk {
    room: Vec<u8>,
    answer: Vec<u8>,
    files: ChosenFiles,
    explorer: Option<Explorer>,
}

thread_local! {
    static DESK: RefCell<Desk> = RefCell::new(Desk {
        room: Vec::new(),
        answer: Vec::new(),
        files: ChosenFiles::default(),
        explorer: None,
    });
}

/// Initializes the module; must be the first call.
#[unsafe(no_mangle)]
pub extern "C" fn begin() {
    std::panic::set_hook(Box::new(|panic| {
        let message = panic.to_string();
        failed(message.as_ptr(), message.len());
    }));
}

/// The address of a buffer of this length for the page to write to, valid until the next call.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    with(|desk| {
        desk.room.clear();
        desk.room.resize(length, 0);
        desk.room.as_mut_ptr()
    })
}

/// The address of the answer to the last call.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    with(|desk| desk.answer.as_ptr())
}

/// The number of bytes of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    with(|desk| desk.answer.len())
}

/// Adds a file.
#[unsafe(no_mangle)]
pub extern "C" fn put(name_length: usize) -> u32 {
    answered(|desk| {
        let (name, content) = desk.taken(name_length);
        match desk.files.add(name, content) {
            Ok(()) => (Kind::Json, Vec::new()),
            Err(error) => message(&error.to_string()),
        }
    })
}

/// Opens the tower of the files, so that questions can be asked.
#[unsafe(no_mangle)]
pub extern "C" fn open() -> u32 {
    answered(|desk| match desk.files.tower() {
        Err(error) => message(&error),
        Ok(input) => {
            let name = input.files().next().unwrap_or_default().to_owned();
            let report = Box::new(|_, words: &[String]| Err(no_report(words)));
            let exploration = Exploration::of_file(input, name, report, now);
            desk.explorer = Some(Explorer::new(exploration));
            (Kind::Json, Vec::new())
        }
    })
}

/// Answers a question about the tower.
#[unsafe(no_mangle)]
pub extern "C" fn ask(name_length: usize) -> u32 {
    answered(|desk| {
        let (name, body) = desk.taken(name_length);
        let mut all = Question::ALL.into_iter();
        let question = all.find(|question| question.name() == name);
        match (&desk.explorer, question) {
            (None, _) => message("no tower is open"),
            (_, None) => message(&format!("`{name}` is not a question of the page")),
            (Some(explorer), Some(question)) => told(explorer.reply(question, &body, &|| true)),
        }
    })
}

/// The style sheet with the colours of the page, with which the page is built.
#[unsafe(no_mangle)]
pub extern "C" fn colours() -> u32 {
    answered(|_| (Kind::Json, page_colours().into_bytes()))
}

fn now() -> f64 {
    now_ms()
}

fn with<T>(action: impl FnOnce(&mut Desk) -> T) -> T {
    DESK.with(|desk| action(&mut desk.borrow_mut()))
}

/// Stores the answer of an action and returns its kind.
fn answered(action: impl FnOnce(&mut Desk) -> (Kind, Vec<u8>)) -> u32 {
    with(|desk| {
        let (kind, answer) = action(desk);
        desk.answer = answer;
        kind as u32
    })
}

impl Desk {
    /// What the page has written: a name of this number of bytes, and the bytes after it.
    fn taken(&mut self, name_length: usize) -> (String, Vec<u8>) {
        let mut name = std::mem::take(&mut self.room);
        let rest = name.split_off(name_length.min(name.len()));
        (String::from_utf8_lossy(&name).into_owned(), rest)
    }
}

fn told(reply: Reply) -> (Kind, Vec<u8>) {
    match reply {
        Reply::Json(text) => (Kind::Json, text),
        Reply::Refused(text) => (Kind::Refused, text),
        Reply::NoFile(text) | Reply::Wrong(text) => message(&text),
        Reply::File(file) => {
            let head = format!("{}\n{}\n", file.name, file.media_type);
            (Kind::File, [head.into_bytes(), file.content].concat())
        }
    }
}

fn message(text: &str) -> (Kind, Vec<u8>) {
    (Kind::Message, text.as_bytes().to_vec())
}

/// The message that only the program writes reports.
fn no_report(words: &[String]) -> String {
    let quoted = words.iter().map(|word| quoted(word));
    let quoted: Vec<String> = quoted.collect();
    format!(
        "This page writes no report. The program towermodes does: {}",
        quoted.join(" ")
    )
}
