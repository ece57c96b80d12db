//! The most important results in a few lines.

use towermodes::{Family, Mode};
use towermodes_analysis::resonance::{Campbell, FrequencyLine};

use super::super::content::ReportContent;
use super::super::document::{Block, Statement};
use super::super::mark::Mark;
use super::{own_picture, turbine};
use crate::figures;
use crate::number::{digits, four_digits, margin_percent};
use crate::wording::{completeness, counted, verdict_counts};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let mut blocks = Vec::new();
    let missing = content
        .circumstances
        .model_notes
        .iter()
        .map(|note| missing_part(note));
    let missing: Vec<Statement> = missing.collect();
    if !missing.is_empty() {
        blocks.push(Block::Statements(missing));
    }
    let turbine = content.turbine.as_ref().and_then(|of| of.as_ref().ok());
    let mut statements: Vec<Statement> = turbine.map(turbine::resonance).into_iter().collect();
    let lead = match turbine {
        Some(_) => "Resonance with a rigid rotor",
        None => "Resonance",
    };
    statements.push(resonance(content, lead));
    let lead = match turbine {
        Some(_) => "Frequencies with a rigid rotor",
        None => "Frequencies",
    };
    statements.push(frequencies(content, lead));
    statements.push(verification(content));
    blocks.push(Block::Statements(statements));
    let diagram = content.campbell.as_ref().and_then(|of| of.as_ref().ok());
    let bar = diagram.and_then(figures::first_frequencies);
    blocks.extend(bar.map(own_picture));
    blocks
}

/// A part of the turbine that the model lacks; the summary begins with it.
fn missing_part(note: &str) -> Statement {
    Statement {
        lead: "Not in the model",
        text: note.to_owned(),
        verdict: None,
    }
}

/// Whether the model has a rotor-nacelle assembly, or a mass at the tower top in its place.
fn has_rna(content: &ReportContent) -> bool {
    let tower = &content.tower;
    let mut masses = tower.point_masses().iter();
    tower.rna().mass_kg > 0.0
        || masses.any(|mass| mass.height_m == tower.top_m() && mass.mass_kg > 0.0)
}

/// The conclusion of the resonance check, and the number of verdicts.
fn resonance(content: &ReportContent, lead: &'static str) -> Statement {
    let not_checked = |why: &str| Statement {
        lead,
        text: format!("Not checked: {why}."),
        verdict: None,
    };
    let campbell = match &content.campbell {
        None => return not_checked("the input gives no rotor speed"),
        Some(Err(_)) => return not_checked("the rotor blade could not be solved"),
        Some(Ok(campbell)) => campbell,
    };
    if !campbell.not_checked.is_empty() {
        return Statement {
            lead,
            text: campbell.conclusion().join(" "),
            verdict: None,
        };
    }
    Statement {
        lead,
        text: format!(
            "{} {}{}",
            campbell.conclusion().join(" "),
            caveat(content),
            verdicts(campbell)
        ),
        verdict: Some(Mark::of(campbell.verdict())),
    }
}

/// How many pairs were checked, and how many of them pass, warn and fail.
fn verdicts(campbell: &Campbell) -> String {
    let [pass, warn, fail] = verdict_counts(campbell);
    let (modes, unchecked) = match campbell.lines.iter().any(FrequencyLine::is_of_blade) {
        true => ("mode", ""),
        false => ("tower mode", " Blade modes were not checked."),
    };
    format!(
        "{} of {modes} and excitation: {pass} PASS, {warn} WARN, {fail} FAIL at a required margin of {} %.{unchecked}",
        counted(campbell.margins.len(), "pair"),
        margin_percent(campbell.margin)
    )
}

/// A limit of the conclusion: parts that would change it are missing.
fn caveat(content: &ReportContent) -> &'static str {
    match (
        has_rna(content),
        content.circumstances.model_notes.is_empty(),
    ) {
        (false, _) => {
            "The model has no rotor-nacelle assembly: the class and the distances do not apply to the turbine. "
        }
        (true, false) => {
            "The class and the distances apply to the model without the missing parts. "
        }
        (true, true) => "",
    }
}

/// The first mode of each family, and the first of all.
fn frequencies(content: &ReportContent, lead: &'static str) -> Statement {
    let solution = &content.solution;
    let families = [
        Family::Surge,
        Family::Sway,
        Family::Heave,
        Family::Roll,
        Family::Pitch,
        Family::Yaw,
        Family::ForeAft,
        Family::SideSide,
        Family::Torsion,
    ];
    let first = families
        .into_iter()
        .filter_map(|family| solution.mode(family, 1));
    let mut first: Vec<&Mode> = first.collect();
    if let Some(lowest) = solution.modes.first()
        && !first.iter().any(|mode| mode.number == lowest.number)
    {
        first.push(lowest);
    }
    first.sort_by_key(|mode| mode.number);
    let texts: Vec<String> = first.into_iter().map(with_period).collect();
    let bare = match has_rna(content) {
        true => "",
        false => "Tower without rotor-nacelle assembly: ",
    };
    Statement {
        lead,
        text: format!("{bare}{}.", texts.join("; ")),
        verdict: None,
    }
}

fn with_period(mode: &Mode) -> String {
    if mode.frequency_hz == 0.0 {
        return format!("{} 0 Hz (free motion)", mode.label());
    }
    format!(
        "{} {} Hz (period {} s)",
        mode.label(),
        four_digits(mode.frequency_hz),
        four_digits(mode.period_s())
    )
}

/// The certificate, the largest numerical error, and the number of messages.
fn verification(content: &ReportContent) -> Statement {
    let solution = &content.solution;
    let relative = solution
        .modes
        .iter()
        .map(|mode| mode.error_hz() / mode.frequency_hz);
    let largest = relative
        .filter(|error| error.is_finite())
        .fold(0.0, f64::max);
    let messages = match content.circumstances.notes.len() + solution.warnings.len() {
        0 => "There are no notes or warnings on the input or the computation.".to_owned(),
        count => format!(
            "{} on the input or the computation: see the section Notes and warnings.",
            counted(count, "note or warning").replace("note or warnings", "notes and warnings")
        ),
    };
    Statement {
        lead: "Numerical verification",
        text: format!(
            "Mode list {}. The largest numerical error of a frequency is {} %. The uncertainty of the input is not included. {messages}",
            completeness(&solution.certificate, solution.modes.len()),
            digits(100.0 * largest, 2),
        ),
        verdict: None,
    }
}
