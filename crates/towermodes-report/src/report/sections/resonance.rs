//! The separation of the rotor's excitations from the natural frequencies.

use towermodes::Family;
use towermodes_analysis::resonance::{Campbell, Margin, StiffnessClass};

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::{Cell, Table};
use super::{paragraph, picture, table};
use crate::figures;
use crate::number::{four_digits, margin_percent, typeset};
use crate::wording::{operation, verdict_counts};

/// The lines of a tower file that this section needs.
const ROTOR: &str = "[rotor]\nblades = 3\nrpm = [6.9, 12.1]   # lowest and highest operating speed";

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let campbell = match &content.campbell {
        None => return without_rotor(content),
        Some(Err(error)) => {
            let text = format!(
                "The rotor's excitations were not compared with the natural frequencies: {error}."
            );
            return vec![paragraph(text)];
        }
        Some(Ok(campbell)) => campbell,
    };
    let mut blocks = vec![
        paragraph(question(campbell)),
        picture(figures::campbell(campbell), "campbell"),
    ];
    if !campbell.classes.is_empty() {
        blocks.push(paragraph(classes(campbell)));
    }
    blocks.push(table(margins(campbell)));
    blocks.push(Block::List(verdicts(campbell)));
    blocks.push(paragraph(
        "The verdicts include the numerical error of the frequency: f is shifted by its error towards the excitation. The table gives the \
         separation without this shift.",
    ));
    blocks
}

fn without_rotor(content: &ReportContent) -> Vec<Block> {
    let how = if content.circumstances.is_own_format {
        "The input has no [rotor], so resonance is not checked. With these lines in the tower file, or with --rpm LOWEST,HIGHEST for one \
         report, this section contains the Campbell diagram and the margin of each excitation:"
    } else {
        "The input gives no rotor speed, so resonance is not checked. Give --rpm LOWEST,HIGHEST (and --blades), or convert the tower to \
         TOML and add these lines; then this section contains the Campbell diagram and the margin of each excitation:"
    };
    vec![paragraph(how), Block::Code(ROTOR.to_owned())]
}

fn question(campbell: &Campbell) -> String {
    let multiples: Vec<String> = campbell.multiples.iter().map(|n| format!("{n}P")).collect();
    format!(
        "The rotor has {} in operation. Its excitations n Ω are the multiples {} of the rotor speed. The separation of an excitation from a \
         natural frequency f is n Ω/f − 1, at the operating speed where it is smallest. The required margin is {} %.",
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
                format!("none, {multiple}P crosses it in operation")
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

fn margins(campbell: &Campbell) -> Table {
    let mut table = Table::new(
        "Separation of every natural frequency from every excitation",
        [
            "natural frequency",
            "#excitation",
            "#rotor speed (rpm)",
            "#f (Hz)",
            "#n Ω (Hz)",
            "#n Ω/f − 1 (%)",
            "verdict",
        ],
    );
    for margin in &campbell.margins {
        let label = campbell.lines.get(margin.line).map(|line| &line.label);
        let texts = [
            label.cloned().unwrap_or_default(),
            format!("{}P", margin.multiple),
            four_digits(margin.nearest_rpm),
            four_digits(margin.natural_hz),
            four_digits(margin.excitation_hz),
            separation(campbell, margin),
        ];
        let mut row: Vec<Cell> = texts.into_iter().map(Cell::from).collect();
        row.push(margin.verdict.into());
        table.push(row);
    }
    let which = "pairs within a factor of 2";
    table.with_only(which, |row| campbell.margins[row].is_near())
}

/// In percent; 0 where the excitation crosses the frequency.
fn separation(campbell: &Campbell, margin: &Margin) -> String {
    match margin.distance {
        0.0 => "0".to_owned(),
        _ => typeset(&campbell.distance_percent(margin)),
    }
}

/// What each verdict means, with the number of pairs.
fn verdicts(campbell: &Campbell) -> Vec<String> {
    let [pass, warn, fail] = verdict_counts(campbell);
    let strong = match campbell.rotor.blades {
        1 => "1P".to_owned(),
        blades => format!("1P or {blades}P"),
    };
    vec![
        format!("FAIL ({fail}): {strong} is within the margin of a tower mode."),
        format!(
            "WARN ({warn}): {strong} is within twice the margin of a tower mode; or another multiple is within the margin of a tower mode; or \
             any multiple is within the margin of a blade mode; or the mode is not known in the whole operating range."
        ),
        format!("PASS ({pass}): all other pairs."),
    ]
}
