//! The Campbell diagram: natural frequencies and excitations against the rotor speed.

mod above;
mod extent;
mod field;
mod key;
mod kind;
mod layout;
mod lines;
mod marks;
mod rays;
mod shades;

use towermodes::Rotor;
use towermodes::tower::Rpm;
use towermodes_analysis::resonance::Campbell;
use towermodes_analysis::whirl::CoupledCampbell;

use crate::number::digits;
use crate::svg::{DataTable, Figure};
use crate::wording::{STRUCTURE_ONLY, operation_of, proved};

use above::{above_text, unresisted_text};
use field::drawing;
use lines::{Shown, shown};

/// The Campbell diagram of tower and blade: natural frequencies and excitations against the rotor
/// speed, with the crossings and the required margin in operation.
pub fn campbell(campbell: &Campbell) -> Figure {
    let shown = shown(campbell);
    Figure {
        name: "campbell".to_owned(),
        title: "Campbell diagram: natural frequencies and excitations against rotor speed"
            .to_owned(),
        description: description(campbell, &shown),
        drawing: drawing(campbell, &shown),
        table: table(campbell),
    }
}

/// The Campbell diagram of a whole turbine: the curves of its coupled modes, whirl modes of one
/// motion in one colour with the backward ones dashed, and the excitations, against the rotor
/// speed.
pub fn coupled_campbell(coupled: &CoupledCampbell) -> Figure {
    let figure = campbell(&coupled.campbell);
    let proof = proved(coupled);
    Figure {
        title: "Campbell diagram of the operating turbine: natural frequencies and excitations against rotor speed"
            .to_owned(),
        description: format!("{} {STRUCTURE_ONLY} {proof}", figure.description),
        ..figure
    }
}

fn description(campbell: &Campbell, shown: &Shown) -> String {
    let mut text = format!(
        "{} The diagram shows natural frequencies up to {} Hz and rotor speeds up to {} rpm, with the excitations {}. Operation: {}.",
        campbell.conclusion().join(" "),
        digits(shown.highest_hz(), 3),
        digits(shown.last_rpm, 3),
        excitations(&shown.multiples),
        operation_of(campbell)
    );
    let above = above_text(campbell, shown);
    let more =
        (shown.more_multiples > 0).then(|| format!("{} more excitations", shown.more_multiples));
    for not_shown in [above, unresisted_text(shown), more].into_iter().flatten() {
        text.push_str(&format!(" Not shown: {not_shown}."));
    }
    text
}

/// "1P, 3P, 6P, 9P", "1P to 30P".
fn excitations(multiples: &[usize]) -> String {
    let is_whole = multiples.windows(2).all(|pair| pair[1] == pair[0] + 1);
    match multiples {
        [first, _, _, .., last] if is_whole => format!("{first}P to {last}P"),
        multiples => {
            let names: Vec<String> = multiples.iter().map(|n| format!("{n}P")).collect();
            names.join(", ")
        }
    }
}

/// The lines with their points, then the excitations in operation. The frequency of a tower mode is
/// the same at every speed.
fn table(campbell: &Campbell) -> DataTable {
    let header = ["line", "rotor speed (rpm)", "frequency (Hz)"];
    let row = |name: &str, rpm: String, hz: f64| vec![name.to_owned(), rpm, format!("{hz:.4}")];
    let mut rows = Vec::new();
    for line in &campbell.lines {
        let is_level = line.points.windows(2).all(|pair| pair[0][1] == pair[1][1]);
        match line.points.first() {
            Some([_, hz]) if is_level => rows.push(row(&line.label, "any".to_owned(), *hz)),
            _ => rows.extend(
                line.points
                    .iter()
                    .map(|[rpm, hz]| row(&line.label, Rpm(*rpm).to_string(), *hz)),
            ),
        }
    }
    let Rotor {
        lowest_rpm,
        highest_rpm,
        ..
    } = campbell.rotor;
    let mut ends = vec![lowest_rpm, highest_rpm];
    ends.dedup();
    for multiple in &campbell.multiples {
        let hz = |rpm: f64| *multiple as f64 * rpm / 60.0;
        rows.extend(
            ends.iter()
                .map(|rpm| row(&format!("{multiple}P"), Rpm(*rpm).to_string(), hz(*rpm))),
        );
    }
    DataTable::new(header, rows)
}
