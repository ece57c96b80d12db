//! Reads a design file: the table `[design]` of a TOML file.

mod choices;
mod frequency;
mod schema;
mod variable;

use ::toml::de::DeTable;

use super::study::{method, segments};
use super::study_file::read_study;
use super::text::reading::Reading;
use super::text::table::Table;
use super::text::values::{Value, number, truth};
use crate::design_study::DesignStudy;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::source::Source;
use schema::{DESIGN, LIMITS, STUDY};

pub use schema::design_study_schema;

/// The minimum content of a design file.
const LEAST: &str = "a design file needs [design.variables] with the design variables, for example \"stations[*].wall\" = { between = [0.012, 0.060] }, and [design.frequencies], as \"fore-aft 1\" = { min = 0.3 }";

/// Reads a design file in TOML.
///
/// # Errors
/// [`ReadError::Mistakes`] with all mistakes that were found.
///
/// # Example
/// ```
/// use towermodes_files::{DesignBand, Source, read_design_study};
///
/// let text = r#"
///     [design.variables]
///     "scale(stations[*].wall)" = { between = [0.7, 1.5] }
///     [design.frequencies]
///     "fore-aft 1" = { between = "1P-3P", margin = 0.1 }
/// "#;
/// let source = Source { name: "design.toml".to_owned(), text: text.to_owned() };
/// let study = read_design_study(&source)?;
/// assert_eq!(study.variables[0].between, [0.7, 1.5]);
/// assert_eq!(study.frequencies[0].band, DesignBand::Multiples([1, 3], Some(0.1)));
/// # Ok::<(), towermodes_files::ReadError>(())
/// ```
pub fn read_design_study(source: &Source) -> Result<DesignStudy, ReadError> {
    let read = |root: &Table<'_>, reading: &mut Reading| study(root, source, reading);
    read_study(source, (LEAST, &STUDY), other_file, read)
}

/// The mistake that the file describes a tower or is a sweep study.
fn other_file(entries: &DeTable<'_>) -> Option<Diagnostic> {
    if entries.contains_key("design") {
        return None;
    }
    let others = [
        ("tower", "a tower file, not a design file"),
        ("sweep", "a sweep study, not a design file"),
    ];
    let (_, found) = others.iter().find(|(key, _)| entries.contains_key(*key))?;
    let found = (*found).to_owned();
    let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found });
    Some(mistake.with_hint(LEAST))
}

fn study(root: &Table<'_>, source: &Source, reading: &mut Reading) -> Option<DesignStudy> {
    let value = root.require("design", LEAST, reading)?;
    let design = Table::of(value, "[design]", &DESIGN, reading)?;
    let variables = design.require("variables", LEAST, reading);
    let variables = variables.and_then(|value| variable::variables(value, reading));
    let frequencies = design.require("frequencies", LEAST, reading);
    let frequencies = frequencies.and_then(|value| frequency::frequencies(value, reading));
    let limits = limits(&design, reading);
    let number_of = design.get("segments").map(|value| segments(value, reading));
    let method = design.get("method").map(|value| method(value, reading));
    let inertia = design.get("rotary_inertia");
    let inertia = inertia.map(|value| truth(value, "rotary_inertia", reading));
    let (diameter_to_wall, cone_angle_deg) = limits?;
    Some(DesignStudy {
        variables: variables?,
        frequencies: frequencies?,
        diameter_to_wall,
        cone_angle_deg,
        segments: number_of.map_or(Some(None), |found| found.map(Some))?,
        method: method.map_or(Some(None), |found| found.map(Some))?,
        rotary_inertia: inertia.unwrap_or(Some(true))?,
        source: source.clone(),
    })
}

type Limits = (Option<[f64; 2]>, Option<f64>);

/// `[design.limits]`.
fn limits(design: &Table<'_>, reading: &mut Reading) -> Option<Limits> {
    let Some(value) = design.get("limits") else {
        return Some((None, None));
    };
    let table = Table::of(value, LIMITS.name, &LIMITS, reading)?;
    let ratio = table.get("diameter_to_wall");
    let ratio = ratio.map(|value| ratios(value, reading));
    let angle = table.get("cone_angle");
    let angle = angle.map(|value| angle_deg(value, reading));
    Some((
        ratio.map_or(Some(None), |found| found.map(Some))?,
        angle.map_or(Some(None), |found| found.map(Some))?,
    ))
}

/// The highest ratio, or the lowest and the highest ratio.
fn ratios(value: &Value<'_>, reading: &mut Reading) -> Option<[f64; 2]> {
    let what = "diameter_to_wall";
    if value.get_ref().is_array() {
        let hint = "diameter_to_wall = [lowest, highest], or the highest alone";
        return variable::range(value, what, hint, reading)
            .and_then(|[low, high]| positive(value, what, low, reading).map(|low| [low, high]));
    }
    let high = number(value, what, reading)?;
    positive(value, what, high, reading).map(|high| [0.0, high])
}

fn angle_deg(value: &Value<'_>, reading: &mut Reading) -> Option<f64> {
    let angle = number(value, "cone_angle", reading)?;
    match 0.0 < angle && angle < 90.0 {
        true => Some(angle),
        false => {
            let rule = "between 0 and 90 degrees";
            let kind = DiagnosticKind::out_of_range("cone_angle", angle, rule);
            reading.refuse(Diagnostic::new(value.span(), kind))
        }
    }
}

/// A positive number.
fn positive(value: &Value<'_>, what: &str, found: f64, reading: &mut Reading) -> Option<f64> {
    match found > 0.0 {
        true => Some(found),
        false => {
            let kind = DiagnosticKind::out_of_range(what, found, "positive");
            reading.refuse(Diagnostic::new(value.span(), kind))
        }
    }
}
