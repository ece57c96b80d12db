//! How far what the rotor excites stays from the natural frequencies.

use towermodes::Family;
use towermodes_analysis::resonance::{Campbell, StiffnessClass};

use super::super::content::ReportContent;
use super::super::document::Block;
use super::super::table::{Cell, Table};
use super::{paragraph, picture, table};
use crate::figures;
use crate::number::{digits, four_digits, margin_percent, typeset};
use crate::wording::{counted, speed_range, verdict_counts};

/// What a user adds to a file for this section.
const ROTOR: &str =
    "[rotor]\nblades = 3\nrpm = [6.9, 12.1]   # lowest and highest speed in operation";

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
        paragraph(asked(campbell)),
        picture(figures::campbell(campbell), "campbell"),
    ];
    if !campbell.classes.is_empty() {
        blocks.push(paragraph(classes(campbell)));
    }
    blocks.push(table(margins(campbell)));
    blocks.push(paragraph(verdicts(campbell)));
    blocks
}

fn without_rotor(content: &ReportContent) -> Vec<Block> {
    let how = if content.is_own_format {
        "The input has no [rotor], so nothing can be said of resonance. With the number of blades and the range of speeds this section has \
         the Campbell diagram and a margin for each excitation; --rpm LOWEST,HIGHEST does the same for a single report:"
    } else {
        "The input says no speed of the rotor, so nothing can be said of resonance. Give --rpm LOWEST,HIGHEST (and --blades), or convert the \
         tower to TOML and add these lines, to have the Campbell diagram and a margin for each excitation here:"
    };
    vec![paragraph(how), Block::Code(ROTOR.to_owned())]
}

fn asked(campbell: &Campbell) -> String {
    let rotor = &campbell.rotor;
    let multiples: Vec<String> = campbell.multiples.iter().map(|n| format!("{n}P")).collect();
    format!(
        "The rotor has {} and runs at {} rpm. Its speed and multiples of it ({}) excite the tower; n Ω/f − 1 says how far an excitation n Ω stays \
         from a natural frequency f where they are nearest in operation. The margin asked for is {} %.",
        counted(rotor.blades, "blade"),
        speed_range(rotor),
        multiples.join(", "),
        margin_percent(campbell.margin)
    )
}

/// "1st fore-aft bending is soft-stiff", and what that means.
fn classes(campbell: &Campbell) -> String {
    let class = |(family, class): &(Family, StiffnessClass)| {
        format!("1st {} bending is {class}", family.name())
    };
    let classes: Vec<String> = campbell.classes.iter().map(class).collect();
    format!(
        "{}. In operation soft-soft is below the rotor's speed (1P), soft-stiff between it and the passing of the blades ({}P), stiff-stiff \
         above both.",
        classes.join("; "),
        campbell.rotor.blades
    )
}

fn margins(campbell: &Campbell) -> Table {
    let mut table = Table::new(
        "Margins of every natural frequency to every excitation",
        [
            "natural frequency",
            "#f there (Hz)",
            "#excitation",
            "#n Ω there (Hz)",
            "#nearest at (rpm)",
            "#n Ω/f − 1 (%)",
            "verdict",
        ],
    );
    for margin in &campbell.margins {
        let label = campbell.lines.get(margin.line).map(|line| &line.label);
        let texts = [
            label.cloned().unwrap_or_default(),
            four_digits(margin.natural_hz),
            format!("{}P", margin.multiple),
            four_digits(margin.excitation_hz),
            digits(margin.nearest_rpm, 4),
            typeset(&campbell.distance_percent(margin)),
        ];
        let mut row: Vec<Cell> = texts.into_iter().map(Cell::from).collect();
        row.push(margin.verdict.into());
        table.push(row);
    }
    let which = "pairs nearer than a factor 2";
    table.with_only(which, |row| campbell.margins[row].is_near())
}

fn verdicts(campbell: &Campbell) -> String {
    let [pass, warn, fail] = verdict_counts(campbell);
    format!(
        "FAIL ({}): the rotor's speed or the passing of its blades comes nearer to a tower's mode than the margin. WARN ({}): it comes nearer \
         than twice the margin, or another multiple or a blade's mode nearer than the margin. PASS ({}): all others. What decides is the \
         distance after f is moved by its error towards the excitation; the table has it without.",
        fail, warn, pass
    )
}
