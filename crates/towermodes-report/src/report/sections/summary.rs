//! The most important results in a few lines.

use towermodes_analysis::resonance::{Campbell, Excited, FrequencyLine, WeightLeftOut};

use super::super::content::{ReportContent, TurbineResults};
use super::super::document::{Block, Statement};
use super::super::mark::Mark;
use super::super::table::Table;
use super::resonance::has_blade;
use super::{own_picture, table, verdicts};
use crate::figures;
use crate::number::{digits, four_digits, margin_percent};
use crate::wording::{completeness, counted, sentence, verdict_counts, verdict_word};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let missing = content.circumstances.model_notes.iter();
    let missing: Vec<Statement> = missing.map(|note| missing_part(note)).collect();
    let turbine = content.turbine.as_ref().and_then(|of| of.as_ref().ok());
    let governing = turbine.map(|of| &of.coupled.campbell);
    let rigid = content.campbell.as_ref().and_then(|of| of.as_ref().ok());
    let mut statements = vec![resonance(content, governing.or(rigid))];
    statements.extend(turbine.map(|_| models(rigid)));
    statements.push(verification(content));
    let mut blocks = vec![Block::Statements(statements)];
    if !missing.is_empty() {
        blocks.insert(0, Block::Statements(missing));
    }
    blocks.push(table(verdict_table(content, turbine, rigid)));
    let bar = governing.or(rigid).and_then(figures::first_frequencies);
    blocks.extend(bar.map(own_picture));
    blocks
}

/// The table of the governing model.
fn verdict_table(
    content: &ReportContent,
    turbine: Option<&TurbineResults>,
    rigid: Option<&Campbell>,
) -> Table {
    let first = verdicts::first(&content.solution);
    let is_checked = |campbell: &&Campbell| campbell.not_checked.is_empty();
    if let Some(of) = turbine {
        let (coupled, is_first) = (&of.coupled, verdicts::is_first_of_turbine);
        let caption = "Verdicts on the turbine with rotating rotor; frequencies at the rotor speed of the nearest excitation";
        return match is_checked(&&coupled.campbell) {
            true => verdicts::of_diagram(&coupled.campbell, caption, is_first),
            false => verdicts::of_unjudged_turbine(coupled),
        };
    }
    if let Some(campbell) = rigid.filter(is_checked) {
        let is_first = |line: &FrequencyLine| match line.of {
            Excited::Tower { number, .. } => first.iter().any(|mode| mode.number == number),
            Excited::Blade { .. } | Excited::Turbine { .. } => false,
        };
        return verdicts::of_diagram(campbell, "Verdicts", is_first);
    }
    let caption = match has_rna(content) {
        true => "First modes",
        false => "First modes of the tower without rotor-nacelle assembly",
    };
    verdicts::without_verdicts(&first, caption)
}

/// A part of the turbine that the model lacks; the summary begins with it.
fn missing_part(note: &str) -> Statement {
    Statement {
        lead: "Not in the model",
        text: sentence(note),
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

/// The result of the resonance check by the governing model: class, verdict and number of pairs.
fn resonance(content: &ReportContent, campbell: Option<&Campbell>) -> Statement {
    let lead = "Resonance";
    let Some(campbell) = campbell else {
        let why = match &content.campbell {
            None => "the input gives no rotor speed",
            Some(_) => "the rotor blade could not be solved",
        };
        return Statement {
            lead,
            text: format!("Not checked: {why}."),
            verdict: None,
        };
    };
    if !campbell.not_checked.is_empty() {
        return Statement {
            lead,
            text: campbell.conclusion().join(" "),
            verdict: None,
        };
    }
    let sentences = campbell.placement().into_iter();
    let weight = WeightLeftOut::of(&content.tower);
    let weight = weight.map(|weight| sentence(&weight.to_string()));
    let sentences = sentences.chain(campbell.omissions()).chain(weight);
    let sentences: Vec<String> = sentences.collect();
    Statement {
        lead,
        text: format!(
            "{} {}{}",
            sentences.join(" "),
            caveat(content),
            counts(campbell)
        ),
        verdict: Some(Mark::of(campbell.verdict())),
    }
}

/// Which of two models governs, and the verdict of the other.
fn models(rigid: Option<&Campbell>) -> Statement {
    let other = rigid.filter(|campbell| campbell.not_checked.is_empty());
    let other = other.map(|campbell| {
        let verdict = verdict_word(campbell.verdict());
        let hz = campbell.first_bending.iter().filter_map(|line| {
            let point = campbell.lines[*line].points.first();
            point.map(|[_, hz]| format!("{} Hz", four_digits(*hz)))
        });
        let hz: Vec<String> = hz.collect();
        let first = match hz.is_empty() {
            true => String::new(),
            false => format!(", first bending frequencies {}", hz.join(" and ")),
        };
        format!(" With a rigid rotor: {verdict}{first}.")
    });
    Statement {
        lead: "Governing model",
        text: format!(
            "The coupled turbine with its flexible, rotating rotor. Sections with the remark \"rigid rotor\" model the rotor-nacelle assembly as a rigid body; their verdicts are for comparison.{}",
            other.unwrap_or_default()
        ),
        verdict: None,
    }
}

/// How many pairs were checked, and how many of them pass, warn and fail.
fn counts(campbell: &Campbell) -> String {
    let [pass, warn, fail] = verdict_counts(campbell);
    let (modes, unchecked) = match has_blade(campbell) {
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
        lead: match content.turbine {
            Some(Ok(_)) => "Numerical verification (rigid rotor)",
            Some(Err(_)) | None => "Numerical verification",
        },
        text: format!(
            "Mode list {}. The largest estimated numerical error of a frequency is {} %. The uncertainty of the input is not included. {messages}",
            completeness(solution),
            digits(100.0 * largest, 2),
        ),
        verdict: None,
    }
}
