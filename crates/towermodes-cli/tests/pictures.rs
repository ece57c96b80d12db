//! The pictures of the book are those that the program draws; `TRYCMD=overwrite` draws them anew.

use crate::pages;

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

use pages::links::links;
use pages::{pages, root};

/// Each picture and what it is drawn by.
const PICTURES: [(&str, &str); 5] = [
    ("nrel-5mw-tower", "examples/nrel-5mw.toml --what tower"),
    ("nrel-5mw-shapes", "examples/nrel-5mw.toml --what shapes"),
    (
        "nrel-5mw-campbell",
        "examples/nrel-5mw.toml --what campbell",
    ),
    ("monopile-tower", "examples/monopile.toml --what tower"),
    (
        "monopile-campbell",
        "examples/monopile.toml --what campbell --multiples 1,3",
    ),
];

/// How far numbers of two pictures may be apart: a twentieth of a pixel, because other machines
/// round otherwise.
const TOLERANCE: f64 = 0.05;

fn drawn(arguments: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_towermodes"));
    command.current_dir(root()).arg("plot");
    let output = command.args(arguments.split(' ')).output();
    let output = output.expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments}: {said}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn pictures_are_those_that_the_program_draws() {
    let overwrite = std::env::var_os("TRYCMD").is_some_and(|what| what == "overwrite");
    for (name, arguments) in PICTURES {
        let file = root().join(format!("book/src/pictures/{name}.svg"));
        let new = drawn(arguments);
        if overwrite {
            fs::write(&file, &new).expect("written");
        }
        let old = fs::read_to_string(&file).expect("a picture");
        let place = format!("{name}.svg, drawn by: towermodes plot {arguments}");
        if let Some((old, new)) = difference(&old, &new) {
            panic!("{place}\n  in the book: {old}\n  drawn now:   {new}");
        }
    }
}

/// Pictures of studies, which need a file for their results.
const STUDIES: [(&str, &str); 1] = [("nrel-5mw-scatter", "examples/studies/uncertainty.toml")];

#[test]
fn pictures_of_studies_are_those_that_the_program_draws() {
    let overwrite = std::env::var_os("TRYCMD").is_some_and(|what| what == "overwrite");
    for (name, study) in STUDIES {
        let folder = std::env::temp_dir().join(format!("{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let [results, picture] = ["results.csv", "picture.svg"].map(|name| folder.join(name));
        let mut command = Command::new(env!("CARGO_BIN_EXE_towermodes"));
        command.current_dir(root()).args(["sweep", study]);
        command.arg("--output").arg(&results);
        command.arg("--plot").arg(&picture);
        let output = command.output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{study}: {said}");
        let new = fs::read_to_string(&picture).expect("a picture");
        fs::remove_dir_all(&folder).expect("removed");
        let file = root().join(format!("book/src/pictures/{name}.svg"));
        if overwrite {
            fs::write(&file, &new).expect("written");
        }
        let old = fs::read_to_string(&file).expect("a picture");
        if let Some((old, new)) = difference(&old, &new) {
            panic!(
                "{name}.svg, drawn by: towermodes sweep {study} --plot\n  in the book: {old}\n  drawn now:   {new}"
            );
        }
    }
}

#[test]
fn every_picture_is_shown_and_none_is_forgotten() {
    let folder = root().join("book/src/pictures");
    let entries = fs::read_dir(folder).expect("the pictures");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let there: BTreeSet<_> = names
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    let tested = PICTURES.iter().chain(&STUDIES);
    let tested = tested.map(|(name, _)| format!("{name}.svg"));
    // Taken in a browser, as `TOWERMODES_SCREENSHOTS` does.
    let taken = ["explore.png".to_owned()];
    let known: BTreeSet<String> = tested.chain(taken).collect();
    assert_eq!(there, known);
    let shown: Vec<String> = pages().iter().flat_map(|page| links(&page.text)).collect();
    for name in there {
        let is_shown = shown
            .iter()
            .any(|link| link.ends_with(&format!("pictures/{name}")));
        assert!(is_shown, "{name} is on no page");
    }
}

/// The first tags or texts that differ: numbers in a tag by more than the tolerance, all else at
/// all.
fn difference<'a>(old: &'a str, new: &'a str) -> Option<(&'a str, &'a str)> {
    let (mut olds, mut news) = (old.split('<'), new.split('<'));
    loop {
        match (olds.next(), news.next()) {
            (None, None) => return None,
            (Some(old), Some(new)) if is_same(old, new) => {}
            (old, new) => return Some((old.unwrap_or("(the end)"), new.unwrap_or("(the end)"))),
        }
    }
}

/// Whether a tag and the text behind it are the same.
fn is_same(old: &str, new: &str) -> bool {
    let parts = |part| str::split_once(part, '>').unwrap_or((part, ""));
    let ((old_tag, old_text), (new_tag, new_text)) = (parts(old), parts(new));
    old_text == new_text && is_near(old_tag, new_tag)
}

fn is_near(old: &str, new: &str) -> bool {
    let (old, new) = (words(old), words(new));
    let pairs = old.iter().zip(&new);
    let mut pairs = pairs.map(
        |(old, new)| match (old.parse::<f64>(), new.parse::<f64>()) {
            (Ok(old), Ok(new)) => (old - new).abs() <= TOLERANCE,
            _ => old == new,
        },
    );
    old.len() == new.len() && pairs.all(|is_near| is_near)
}

/// A tag cut into numbers and what is between them.
fn words(tag: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_number = false;
    for sign in tag.chars() {
        let is_number = sign.is_ascii_digit() || sign == '.' || sign == '-';
        if is_number != was_number {
            words.push(String::new());
        }
        was_number = is_number;
        words.last_mut().expect("a word").push(sign);
    }
    words
}

#[test]
fn differences_are_seen() {
    let picture = "<svg width=\"9\"><path d=\"M 1.00 2 L-3.5-4\"/><text>0.32 Hz</text></svg>";
    let other = |from, to| picture.replace(from, to);
    assert_eq!(difference(picture, picture), None);
    assert_eq!(difference(picture, &other("1.00", "1.04")), None);
    assert!(difference(picture, &other("1.00", "1.06")).is_some());
    assert!(difference(picture, &other("-4", "4")).is_some());
    assert!(difference(picture, &other("0.32", "0.33")).is_some());
    assert!(difference(picture, &other("</svg>", "")).is_some());
}
