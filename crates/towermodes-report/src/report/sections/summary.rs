//! What matters most, in a few lines.

use towermodes::{Family, Mode};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{Campbell, Margin, StiffnessClass};

use super::super::content::ReportContent;
use super::super::document::{Block, Mark, Statement};
use super::own_picture;
use crate::number::{digits, four_digits, margin_percent, typeset};
use crate::wording::{completeness, counted, verdict_counts};

use crate::figures;

/// More failures than these are counted only.
const MOST_FAILURES: usize = 10;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let missing: Vec<Statement> = content
        .model_notes
        .iter()
        .map(|note| missing_part(note))
        .collect();
    let diagram = content.campbell.as_ref().and_then(|of| of.as_ref().ok());
    let bar = diagram.and_then(figures::first_frequencies);
    let mut blocks = Vec::new();
    if !missing.is_empty() {
        blocks.push(Block::Statements(missing));
    }
    blocks.extend(bar.map(own_picture));
    let statements = vec![resonance(content), frequencies(content), certainty(content)];
    blocks.push(Block::Statements(statements));
    blocks
}

/// What the model lacks, before anything that follows from it.
fn missing_part(note: &str) -> Statement {
    Statement {
        lead: "Not in the model",
        text: note.to_owned(),
        verdict: None,
    }
}

/// Whether anything stands for the machine: a mass on the tower's top.
fn has_machine(content: &ReportContent) -> bool {
    let tower = &content.tower;
    let mut masses = tower.point_masses().iter();
    tower.rna().mass_kg > 0.0
        || masses.any(|mass| mass.height_m == tower.top_m() && mass.mass_kg > 0.0)
}

/// The first mode of each plane and of torsion, and the first of all.
fn frequencies(content: &ReportContent) -> Statement {
    let solution = &content.solution;
    let of = |family: Family| solution.mode(family, 1);
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
    let mut first: Vec<&Mode> = families.into_iter().filter_map(of).collect();
    if let Some(lowest) = solution.modes.first()
        && !first.iter().any(|mode| mode.number == lowest.number)
    {
        first.push(lowest);
    }
    first.sort_by_key(|mode| mode.number);
    let texts: Vec<String> = first.into_iter().map(with_period).collect();
    let bare = match has_machine(content) {
        true => "",
        false => "Of the tower without a rotor-nacelle assembly: ",
    };
    Statement {
        lead: "Frequencies",
        text: format!("{bare}{}.", texts.join("; ")),
        verdict: None,
    }
}

fn with_period(mode: &Mode) -> String {
    if mode.frequency_hz == 0.0 {
        return format!("{}: nothing resists it", mode.label());
    }
    format!(
        "{} {} Hz (period {} s)",
        mode.label(),
        four_digits(mode.frequency_hz),
        digits(mode.period_s(), 4)
    )
}

fn resonance(content: &ReportContent) -> Statement {
    let lead = "Resonance";
    let nothing = |why: &str| Statement {
        lead,
        text: format!("{why}, so nothing is said of resonance."),
        verdict: None,
    };
    let campbell = match &content.campbell {
        None => return nothing("No rotor is given"),
        Some(Err(_)) => return nothing("The rotor's blade could not be solved"),
        Some(Ok(campbell)) => campbell,
    };
    let classes: Vec<String> = campbell.classes.iter().map(class_of_family).collect();
    let class = match &classes[..] {
        [] => String::new(),
        _ if !has_machine(content) => {
            "The tower carries no rotor-nacelle assembly, so no class of stiffness is said of it. "
                .to_owned()
        }
        classes => format!(
            "First bending{}: {}. ",
            of_what(content),
            classes.join(", ")
        ),
    };
    Statement {
        lead,
        text: format!(
            "{class}{}.{}{}",
            counts(campbell),
            failures(campbell),
            not_judged(campbell)
        ),
        verdict: Some(Mark::of(campbell.verdict())),
    }
}

/// Where there may be modes that excitations come near to and that are not in the list.
fn not_judged(campbell: &Campbell) -> String {
    match campbell.unjudged_hz() {
        None => String::new(),
        Some([known_hz, reach_hz]) => format!(
            " Modes from {} to {} Hz, which excitations reach, are not in the list and not judged.",
            four_digits(known_hz),
            four_digits(reach_hz)
        ),
    }
}

/// "FAIL: yaw (0.1217 Hz) is met by 1P at 7.3 rpm; …".
fn failures(campbell: &Campbell) -> String {
    let margins = campbell.margins.iter();
    let failing: Vec<&Margin> = margins.filter(|m| m.verdict == Verdict::Fail).collect();
    let more = match failing.len().saturating_sub(MOST_FAILURES) {
        0 => String::new(),
        more => format!("; {more} more are in the section on resonance"),
    };
    let named = failing.iter().take(MOST_FAILURES);
    let named: Vec<String> = named.map(|margin| failure(campbell, margin)).collect();
    match named.len() {
        0 => String::new(),
        _ => format!(" FAIL: {}{more}.", named.join("; ")),
    }
}

fn failure(campbell: &Campbell, margin: &Margin) -> String {
    let line = campbell.lines.get(margin.line);
    let label = line.map_or("a mode", |line| line.label.as_str());
    let (hz, multiple) = (four_digits(margin.natural_hz), margin.multiple);
    let rpm = digits(margin.nearest_rpm, 4);
    if margin.distance == 0.0 {
        return format!("{label} ({hz} Hz) is met by {multiple}P at {rpm} rpm");
    }
    let percent = typeset(&campbell.distance_percent(margin));
    format!("{multiple}P at {rpm} rpm comes to {percent} % of {label} ({hz} Hz)")
}

/// Whose class it is, where parts are missing that would change it.
fn of_what(content: &ReportContent) -> &'static str {
    match content.model_notes.is_empty() {
        true => "",
        false => " of the model without what is missing",
    }
}

/// "fore-aft is soft-stiff".
fn class_of_family((family, class): &(Family, StiffnessClass)) -> String {
    format!("{} is {class}", family.name())
}

/// "Of 32 pairs of excitation and mode 30 pass, 1 is near the limit and 1 fails at a margin of 5
/// %".
fn counts(campbell: &Campbell) -> String {
    let [pass, warn, fail] = verdict_counts(campbell);
    format!(
        "Of {} of an excitation and a natural frequency {} PASS, {} WARN and {} FAIL at a margin of {} %",
        counted(campbell.margins.len(), "pair"),
        pass,
        warn,
        fail,
        margin_percent(campbell.margin)
    )
}

fn certainty(content: &ReportContent) -> Statement {
    let solution = &content.solution;
    let share = |mode: &Mode| mode.error_hz() / mode.frequency_hz;
    let worst = solution
        .modes
        .iter()
        .map(share)
        .filter(|share| share.is_finite());
    let worst = worst.fold(0.0, f64::max);
    let said = content.notes.len() + solution.warnings.len();
    let remarks = match said {
        0 => "There are no warnings.".to_owned(),
        1 => "There is 1 note or warning: see the section on these.".to_owned(),
        count => format!("There are {count} notes and warnings: see the section on these."),
    };
    Statement {
        lead: "Certainty",
        text: format!(
            "{}; the largest numerical error of these frequencies is {} %. {remarks}",
            completeness(&solution.certificate, solution.modes.len()),
            digits(100.0 * worst, 2),
        ),
        verdict: None,
    }
}
