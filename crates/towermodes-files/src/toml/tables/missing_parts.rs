//! `missing_parts`: parts that the source of the tower has and the file lacks.

use towermodes::MissingPart;

use super::super::text::choice::chosen;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, every_row, list};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The parts; empty without the key. Each may be named once, and only if the file does not contain
/// it.
pub(crate) fn missing_parts(root: &Table<'_>, reading: &mut Reading) -> Option<Vec<MissingPart>> {
    let Some(value) = root.get("missing_parts") else {
        return Some(Vec::new());
    };
    let choices = MissingPart::ALL.map(|part| (part.name(), part));
    let mut parts: Vec<MissingPart> = Vec::new();
    let names = list(value, "missing_parts", reading)?;
    every_row(names, |_, name| {
        let part = chosen(name, "missing part", &choices, reading)?;
        if part.is_of_rotor_nacelle_assembly() && root.get("turbine").is_some() {
            return has_part(name, part, reading);
        }
        if parts.contains(&part) {
            return repeated(name, part, reading);
        }
        parts.push(part);
        Some(())
    })?;
    Some(parts)
}

/// The mistake of a part that is listed as missing although the file has a turbine.
fn has_part<T>(name: &Value<'_>, part: MissingPart, reading: &mut Reading) -> Option<T> {
    let part = part.name();
    let message = format!("`{part}` is listed as missing, but [turbine] describes it");
    let kind = DiagnosticKind::Contradiction(message);
    let hint = format!("remove \"{part}\" from missing_parts");
    reading.refuse(Diagnostic::new(name.span(), kind).with_hint(hint))
}

/// The mistake of a part that is listed twice.
fn repeated<T>(name: &Value<'_>, part: MissingPart, reading: &mut Reading) -> Option<T> {
    let what = format!("the missing part `{}`", part.name());
    let kind = DiagnosticKind::Repeated { what, times: 2 };
    let hint = "list each part once";
    reading.refuse(Diagnostic::new(name.span(), kind).with_hint(hint))
}
