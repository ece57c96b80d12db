//! A tower from a single ElastoDyn tower file, which contains everything except the heights of its
//! ends.

use super::tower_input::description::{
    Ends, ONLY_BENDS, description, hanging_note, hangs, remember, tuner_note,
};
use super::tower_input::tower_reader::read_with_places;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{FileFormat, ReadOptions, TowerInput};
use crate::note::Note;
use crate::source::Source;

const HINT: &str =
    "give the main file that refers to it, or --tower-height (and --tower-base if that is not 0)";

/// A tower, clamped and without a rotor-nacelle assembly, from a single ElastoDyn tower file.
///
/// The heights of its ends are options, or are taken from a header line of the form
/// `TowerHt = 87.6 m, TowerBsHt = 0 m`.
///
/// # Errors
/// The first mistake in the file, or that the height of the tower is unknown.
pub fn read_elastodyn_tower(
    source: Source,
    options: &ReadOptions,
) -> Result<TowerInput, ReadError> {
    let reading = match read_with_places(&source) {
        Ok(reading) => reading,
        Err(mistake) => return Err(ReadError::mistake(&source, mistake)),
    };
    let (ends, hangs) = match ends(&reading.file.header, options) {
        Ok(found) => found,
        Err(mistake) => return Err(ReadError::mistake(&source, mistake)),
    };
    let title = without_heights(&reading.file.header[1]);
    let description = description(&reading.file, ends, title);
    let mut input = TowerInput::new(FileFormat::ElastoDynTower, description, vec![source]);
    remember(&mut input.places, 0, &reading.spans);
    input.modal_values = Some(reading.file.modal_values());
    input.notes = reading.notes;
    input.notes.extend(tuner_note(&reading.file));
    input.notes.push(Note::new(ONLY_BENDS));
    input.notes.extend(hangs.then(|| hanging_note(ends)));
    input.notes.push(Note::missing_part(format!(
        "the tower extends from {} m to {} m, clamped, without RNA and without gravity: a tower file contains neither",
        ends.base_m, ends.top_m
    )));
    Ok(input)
}

/// The heights of the ends, from the options if given, and whether the tower hangs.
fn ends(header: &[String; 2], options: &ReadOptions) -> Result<(Ends, bool), Diagnostic> {
    let given = |name| header.iter().rev().find_map(|line| value_after(line, name));
    let Some(top_m) = options.tower_height_m.or_else(|| given("TowerHt")) else {
        let kind = DiagnosticKind::Missing {
            what: "the height of the tower, which a tower file does not contain,".to_owned(),
        };
        return Err(Diagnostic::new(0..0, kind).with_hint(HINT));
    };
    let base_m = options.tower_base_m.or_else(|| given("TowerBsHt"));
    let base_m = base_m.unwrap_or(0.0);
    let ends = Ends::of(base_m, top_m);
    let length_m = ends.top_m - ends.base_m;
    if length_m > 0.0 && length_m.is_finite() {
        return Ok((ends, hangs(base_m, top_m)));
    }
    let rule = format!("above the base, {} m", ends.base_m);
    let kind = DiagnosticKind::out_of_range_in("the tower top", ends.top_m, "m", rule);
    Err(Diagnostic::new(0..0, kind))
}

/// The number after the last `name =` in a line. The title of the tower precedes it and may be
/// anything.
fn value_after(line: &str, name: &str) -> Option<f64> {
    let (_, rest) = line.rsplit_once(name)?;
    let number = rest.trim_start().strip_prefix('=')?.trim_start();
    let number = number
        .split(|c: char| c.is_whitespace() || c == ',')
        .next()?;
    number.parse().ok().filter(|value: &f64| value.is_finite())
}

/// A header line without the heights at its end, which are not part of the title.
fn without_heights(line: &str) -> &str {
    match line.rsplit_once("TowerHt =") {
        Some((what, heights)) if heights.contains("TowerBsHt =") => {
            what.trim_end().trim_end_matches(';')
        }
        _ => line,
    }
}

#[cfg(test)]
mod tests {
    use super::{value_after, without_heights};

    #[test]
    fn heights_are_read_from_a_header_line() {
        let line = "by towermodes, TowerHt = 87.6 m, TowerBsHt = -10 m";
        assert_eq!(value_after(line, "TowerHt"), Some(87.6));
        assert_eq!(value_after(line, "TowerBsHt"), Some(-10.0));
        for line in ["TowerHt", "TowerHt = ", "TowerHt 87.6", "TowerHt = inf"] {
            assert_eq!(value_after(line, "TowerHt"), None);
        }
    }

    #[test]
    fn the_last_height_counts_and_is_no_part_of_the_name() {
        let line = "once TowerHt = 50 m, TowerBsHt = 1 m; TowerHt = 87.6 m, TowerBsHt = 0 m";
        assert_eq!(value_after(line, "TowerHt"), Some(87.6));
        assert_eq!(value_after(line, "TowerBsHt"), Some(0.0));
        let name = without_heights(line);
        assert_eq!(name, "once TowerHt = 50 m, TowerBsHt = 1 m");
        assert_eq!(without_heights("TowerHt = 9 m, TowerBsHt = 0 m"), "");
        assert_eq!(without_heights("TowerHt = high"), "TowerHt = high");
    }
}
