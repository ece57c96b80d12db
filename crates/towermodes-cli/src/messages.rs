//! Messages on standard error: errors with the lines of their files, notes, warnings.

use std::io::Write as _;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use towermodes::{Place, Warning};
use towermodes_files::{Diagnostic, Note, Source, TowerInput};
use towermodes_report::wording::printable;

use crate::terminal::NOT_SHOWN;

/// Prints an error and its hint.
pub(crate) fn fail(text: &str, hint: Option<&str>) {
    say(&message(Level::ERROR, text, hint));
}

/// Prints the mistakes in a file, each with its line; `prefix` begins each.
pub(crate) fn mistaken(source: &Source, mistakes: &[Diagnostic], prefix: &str) {
    say(&mistakes_text(source, mistakes, prefix));
}

/// Prints text that accompanies a result.
pub(crate) fn report(text: &str) {
    say(&printable(text, NOT_SHOWN));
}

/// Prints the notes of a reader; notes on something that the user should check are warnings.
pub(crate) fn note(notes: &[Note]) {
    for note in notes {
        let level = match note.is_warning() {
            true => Level::WARNING,
            false => Level::NOTE,
        };
        say(&message(level, &note.to_string(), None));
    }
}

/// Prints warnings that do not come from a reader.
pub(crate) fn warn_texts(warnings: &[String]) {
    for warning in warnings {
        say(&message(Level::WARNING, warning, None));
    }
}

/// Prints warnings, with file and line of the input if they are known.
pub(crate) fn warn(warnings: &[Warning], input: &TowerInput) {
    for warning in warnings {
        let text = warning_text(warning, input).unwrap_or_else(|| warning.to_string());
        say(&message(Level::WARNING, &text, None));
    }
}

/// A warning with file and line of the input, or with the setting of the command line; none if
/// they are not known.
pub(crate) fn warning_text(warning: &Warning, input: &TowerInput) -> Option<String> {
    let place = warning.place()?;
    let (file, line) = input.line_of(place)?;
    let warning = with_name(warning, place, input);
    Some(match input.setting_of(place) {
        Some(setting) => format!("with {file} {setting}: {warning}"),
        None => format!("{file}:{line}: {warning}"),
    })
}

/// A warning with the name of its part in parentheses: "point mass 1 (platform): ...".
fn with_name(warning: &Warning, place: Place, input: &TowerInput) -> String {
    let (text, part) = (warning.to_string(), place.to_string());
    match (
        input.description.part_names.of(place),
        text.strip_prefix(&part),
    ) {
        (Some(name), Some(rest)) => format!("{part} ({name}){rest}"),
        _ => text,
    }
}

/// A message of a program that goes on.
pub(crate) fn hear(text: &str) {
    say(&message(Level::INFO, text, None));
}

/// Writes to standard error. If it is closed, the message is lost.
fn say(text: &str) {
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}

fn message(level: Level<'_>, text: &str, hint: Option<&str>) -> String {
    let text = printable(text, NOT_SHOWN);
    let title = rendered(&[Group::with_title(level.primary_title(&*text))]);
    let hint = hint.map(|hint| rendered(&[Group::with_title(Level::HELP.primary_title(hint))]));
    title + &hint.unwrap_or_default()
}

/// All errors with their source lines, separated by blank lines; `prefix` begins each.
fn mistakes_text(source: &Source, mistakes: &[Diagnostic], prefix: &str) -> String {
    let mut text = String::new();
    let name = printable(&source.name, NOT_SHOWN);
    for mistake in mistakes {
        if !text.is_empty() {
            text.push('\n');
        }
        let message = format!("{prefix}{}", mistake.message());
        let said = printable(&message, NOT_SHOWN);
        let hint = mistake.hint.as_deref();
        let hint = hint.map(|hint| printable(hint, NOT_SHOWN));
        let snippet = Snippet::source(&source.text)
            .path(&*name)
            .annotation(AnnotationKind::Primary.span(visible(&source.text, mistake)));
        let group = Group::with_title(Level::ERROR.primary_title(&*said)).element(snippet);
        let group = match &hint {
            Some(hint) => group.element(Level::HELP.message(&**hint)),
            None => group,
        };
        text.push_str(&rendered(&[group]));
    }
    text
}

/// The first line of the span of an error, so that a long table is not printed completely.
fn visible(text: &str, mistake: &Diagnostic) -> std::ops::Range<usize> {
    let start = mistake.span.start.min(text.len());
    let end = mistake.span.end.clamp(start, text.len());
    let first_line = text.get(start..end).unwrap_or_default().lines().next();
    start..start + first_line.map_or(0, str::len)
}

fn rendered(report: &[Group<'_>]) -> String {
    let mut text = Renderer::styled().render(report);
    text.push('\n');
    text
}
