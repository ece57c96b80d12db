//! What can happen to a file: lost, doubled and swapped lines, other numbers, other characters, an
//! early end.

use proptest::prelude::*;
use proptest::sample::Index;
use towermodes_files::{FileError, FileResolver, Source};

/// Numbers that no tower has, or that no reader may believe.
const NUMBERS: [&str; 22] = [
    "nan",
    "NaN",
    ".nan",
    "inf",
    "-inf",
    "Infinity",
    ".inf",
    "-1",
    "0",
    "-0.0",
    "1e308",
    "-1e308",
    "1e999",
    "1e-308",
    "1d400",
    "1000000000000",
    "1e12",
    "9223372036854775808",
    "18446744073709551616",
    "999999*0.0",
    "",
    "é",
];

/// One thing that happens to a text.
#[derive(Debug, Clone)]
pub enum Damage {
    LoseLine(Index),
    DoubleLine(Index, usize),
    SwapLines(Index, Index),
    Number(Index, usize),
    Character(Index, char),
    End(Index),
}

/// Some of it.
pub fn any_damages() -> impl Strategy<Value = Vec<Damage>> {
    let character = prop_oneof![
        prop::sample::select(
            "\n\r\t ,:-/'\"[]{}*&#!$.0\u{feff}\0"
                .chars()
                .collect::<Vec<_>>()
        ),
        any::<char>(),
    ];
    let index = any::<Index>;
    let damage = prop_oneof![
        1 => index().prop_map(Damage::LoseLine),
        1 => (index(), 1..4_usize).prop_map(|(at, times)| Damage::DoubleLine(at, times)),
        1 => (index(), index()).prop_map(|(a, b)| Damage::SwapLines(a, b)),
        4 => (index(), 0..NUMBERS.len()).prop_map(|(at, by)| Damage::Number(at, by)),
        2 => (index(), character).prop_map(|(at, by)| Damage::Character(at, by)),
        1 => index().prop_map(Damage::End),
    ];
    prop::collection::vec(damage, 1..4)
}

/// A text after all of it.
pub fn all(text: &str, damages: &[Damage]) -> String {
    let damaged = |text: String, damage: &Damage| one(&text, damage);
    damages.iter().fold(text.to_owned(), damaged)
}

fn one(text: &str, damage: &Damage) -> String {
    match damage {
        Damage::LoseLine(at) => with_lines(text, |lines| {
            lines.remove(at.index(lines.len()));
        }),
        Damage::DoubleLine(at, times) => with_lines(text, |lines| {
            let at = at.index(lines.len());
            lines.splice(at..at, vec![lines[at]; *times]);
        }),
        Damage::SwapLines(a, b) => with_lines(text, |lines| {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }),
        Damage::Number(at, by) => with_number(text, at, NUMBERS[*by]),
        Damage::Character(at, by) => {
            let at = boundary(text, at);
            let rest = text[at..].chars().next().map_or(0, char::len_utf8);
            format!("{}{by}{}", &text[..at], &text[at + rest..])
        }
        Damage::End(at) => text[..boundary(text, at)].to_owned(),
    }
}

/// A text whose lines, ends included, are changed; an empty one stays as it is.
fn with_lines(text: &str, change: impl FnOnce(&mut Vec<&str>)) -> String {
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    if !lines.is_empty() {
        change(&mut lines);
    }
    lines.concat()
}

/// A text with one of its numbers replaced, if it has any.
fn with_number(text: &str, at: &Index, by: &str) -> String {
    let is_gap = |c: char| c.is_whitespace() || ",[]{}:".contains(c);
    let is_number = |word: &&str| {
        word.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
            && word.contains(|c: char| c.is_ascii_digit())
    };
    let numbers: Vec<&str> = text.split(is_gap).filter(is_number).collect();
    if numbers.is_empty() {
        return text.to_owned();
    }
    let number = at.get(&numbers);
    let start = number.as_ptr() as usize - text.as_ptr() as usize;
    format!("{}{by}{}", &text[..start], &text[start + number.len()..])
}

/// A place between two characters of a text.
fn boundary(text: &str, at: &Index) -> usize {
    let at = at.index(text.len() + 1);
    let is_boundary = |at: &usize| text.is_char_boundary(*at);
    (0..=at).rev().find(is_boundary).unwrap_or(0)
}

/// The files beside a main file, all of them damaged in the same way.
pub struct Damaged<'a> {
    pub companions: &'a dyn FileResolver,
    pub damages: &'a [Damage],
}

impl FileResolver for Damaged<'_> {
    fn read(&self, path: &str) -> Result<Source, FileError> {
        let mut source = self.companions.read(path)?;
        source.text = all(&source.text, self.damages);
        Ok(source)
    }
}
