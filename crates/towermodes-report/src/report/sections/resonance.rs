//! The distances of the rotor excitations from the natural frequencies.

use towermodes::Family;
use towermodes_analysis::resonance::{Campbell, FrequencyLine, Margin, StiffnessClass};

use super::super::content::ReportContent;
use super::super::document::{Block, Statement};
use super::super::mark::Mark;
use super::super::table::{Cell, Table};
use super::{RIGID, paragraph, picture, table};
use crate::figures;
use crate::number::{four_digits, margin_percent, typeset};
use crate::svg::Figure;
use crate::wording::{conclusion_text, operation, operation_of, verdict_counts};

/// The lines of a tower file that this section needs.
const ROTOR: &str = "[rotor]\nblades = 3\nrpm = [6.9, 12.1]   # lowest and highest operating speed";

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let campbell = match &content.campbell {
        None => return without_rotor(content),
        Some(Err(error)) => {
            let text = format!(
                "The rotor excitations were not compared with the natural frequencies: {error}."
            );
            return vec![paragraph(text)];
        }
        Some(Ok(campbell)) => campbell,
    };
    let has_turbine = matches!(content.turbine, Some(Ok(_)));
    let model = if has_turbine { RIGID } else { "" };
    let figure = figures::campbell_beside_conclusion(campbell);
    let figure = Figure {
        title: figure
            .title
            .replacen("diagram", &format!("diagram{model}"), 1),
        ..figure
    };
    let mut blocks = vec![
        paragraph(question(campbell)),
        Block::Statements(vec![conclusion(campbell, "Conclusion")]),
        picture(figure, "campbell"),
    ];
    if !campbell.classes.is_empty() {
        blocks.push(paragraph(classes(campbell)));
    }
    let caption = format!("Distance of every excitation from every natural frequency{model}");
    blocks.push(table(margins(campbell, &caption)));
    blocks.extend(meaning(campbell));
    if !has_blade(campbell) {
        blocks.push(paragraph("Blade modes were not checked."));
    }
    if !campbell.not_checked.is_empty() {
        return blocks;
    }
    blocks.push(paragraph(
        "The verdicts include the numerical error of the frequency: f is shifted by its error towards the excitation. The table gives the \
         distance without this shift.",
    ));
    blocks
}

/// The conclusion of a diagram with its verdict.
pub(super) fn conclusion(campbell: &Campbell, lead: &'static str) -> Statement {
    let is_checked = campbell.not_checked.is_empty();
    Statement {
        lead,
        text: conclusion_text(&campbell.conclusion()),
        verdict: is_checked.then(|| Mark::of(campbell.verdict())),
    }
}

/// Whether the diagram has blade modes.
pub(super) fn has_blade(campbell: &Campbell) -> bool {
    campbell.lines.iter().any(FrequencyLine::is_of_blade)
}

fn without_rotor(content: &ReportContent) -> Vec<Block> {
    let how = if content.circumstances.is_own_format {
        "The input has no [rotor], so resonance is not checked. With these lines in the tower file, or with --rpm LOWEST,HIGHEST for one \
         report, this section contains the Campbell diagram and the distance of each excitation:"
    } else {
        "The input gives no rotor speed, so resonance is not checked. Give --rpm LOWEST,HIGHEST (and --blades), or convert the tower to \
         TOML and add these lines; then this section contains the Campbell diagram and the distance of each excitation:"
    };
    vec![paragraph(how), Block::Code(ROTOR.to_owned())]
}

fn question(campbell: &Campbell) -> String {
    let multiples: Vec<String> = campbell.multiples.iter().map(|n| format!("{n}P")).collect();
    if !campbell.speeds_are_known() {
        return format!(
            "The rotor has {}. Its excitations are the multiples {} of the rotor speed. The table gives the rotor speed at which each excitation crosses a natural frequency.",
            operation_of(campbell),
            multiples.join(", ")
        );
    }
    format!(
        "The rotor has {} in operation. Its excitations are the multiples {} of the rotor speed. The distance of an excitation from a natural \
         frequency f is (excitation frequency)/f − 1, at the operating speed where it is smallest. The margin, the required distance, is {} %.",
        operation(&campbell.rotor),
        multiples.join(", "),
        margin_percent(campbell.margin)
    )
}

/// The definition of the design classes, and the class of each first bending mode.
fn classes(campbell: &Campbell) -> String {
    let class = |(family, class): &(Family, StiffnessClass)| {
        let class = match class {
            StiffnessClass::Coincident { multiple } => {
                format!("no class, because {multiple}P crosses its frequency in operation")
            }
            class => class.name().to_owned(),
        };
        format!("1st {} bending: {class}", family.name())
    };
    let classes: Vec<String> = campbell.classes.iter().map(class).collect();
    format!(
        "Design classes by the first bending frequencies: soft-soft below 1P, soft-stiff between 1P and the blade passing frequency ({}P), \
         stiff-stiff above both, in the whole operating range. This tower: {}.",
        campbell.rotor.blades,
        classes.join("; ")
    )
}

/// The table of all pairs of an excitation and a line of a diagram.
pub(super) fn margins(campbell: &Campbell, caption: &str) -> Table {
    let mut table = Table::new(
        caption,
        [
            "mode",
            "#excitation",
            "verdict",
            "#distance (%)",
            "#rotor speed (rpm)",
            "#f (Hz)",
            "#excitation (Hz)",
        ],
    );
    for margin in &campbell.margins {
        let label = campbell.lines.get(margin.line).map(|line| &line.label);
        let row: [Cell; 7] = [
            label.cloned().unwrap_or_default().into(),
            format!("{}P", margin.multiple).into(),
            margin.verdict.into(),
            distance(campbell, margin).into(),
            four_digits(margin.nearest_rpm).into(),
            four_digits(margin.natural_hz).into(),
            four_digits(margin.excitation_hz).into(),
        ];
        table.push(row);
    }
    let which = "pairs whose frequencies differ by at most a factor of 2";
    table.with_only(which, |row| campbell.margins[row].is_near())
}

/// The distance in percent; 0 if the excitation crosses the natural frequency. If a pair warns
/// because its mode is missing at higher speeds, the text states this.
pub(super) fn distance(campbell: &Campbell, margin: &Margin) -> String {
    if let Some(rpm) = campbell.missing_from_rpm(margin) {
        return format!("no mode from {} rpm", four_digits(rpm));
    }
    match margin.distance {
        0.0 => "0".to_owned(),
        _ => typeset(&campbell.distance_percent(margin)),
    }
}

/// The meaning of the verdicts, or the data that they need.
pub(super) fn meaning(campbell: &Campbell) -> Vec<Block> {
    if campbell.not_checked.is_empty() {
        return vec![Block::List(verdicts(campbell))];
    }
    if campbell.speeds_are_known() {
        return Vec::new();
    }
    let how =
        "With --rpm LOWEST,HIGHEST, or with these lines in a tower file, each pair has a verdict:";
    vec![paragraph(how), Block::Code(ROTOR.to_owned())]
}

/// The meaning of each verdict, with the number of pairs. Blade modes are named only if they were
/// checked.
fn verdicts(campbell: &Campbell) -> Vec<String> {
    let [pass, warn, fail] = verdict_counts(campbell);
    let strong = match campbell.rotor.blades {
        1 => "1P".to_owned(),
        blades => format!("1P or {blades}P"),
    };
    let blades = match has_blade(campbell) {
        true => {
            "; or any multiple is closer to a blade mode than the margin; or a blade mode could not be followed over all operating speeds"
        }
        false => "",
    };
    vec![
        format!("FAIL ({fail}): {strong} is closer to a tower mode than the margin."),
        format!(
            "WARN ({warn}): {strong} is closer to a tower mode than twice the margin; or another multiple is closer to a tower mode than \
             the margin{blades}."
        ),
        format!("PASS ({pass}): all other pairs."),
    ]
}
