//! The Campbell diagram: natural frequencies and excitations against the rotor speed.

mod above;
mod extent;
mod field;
mod key;
mod kind;
mod layout;
mod lines;
mod marks;
mod numbers;
mod rays;
mod shades;

use towermodes_analysis::resonance::Campbell;
use towermodes_analysis::whirl::CoupledCampbell;

use crate::number::digits;
use crate::svg::Figure;
use crate::wording::{STRUCTURE_ONLY, conclusion_text, operation_of, proved};

use above::{above_text, unresisted_text};
use field::drawing;
pub(super) use kind::part_colour;
use lines::{Shown, shown};

/// The Campbell diagram of tower and blade: natural frequencies and excitations against the rotor
/// speed, with the crossings and the required margin in operation.
pub fn campbell(campbell: &Campbell) -> Figure {
    with_conclusion(campbell, campbell_beside_conclusion(campbell))
}

/// As [`campbell`], for a place where the conclusion is stated separately.
pub fn campbell_beside_conclusion(campbell: &Campbell) -> Figure {
    let shown = shown(campbell);
    Figure {
        name: "campbell".to_owned(),
        title: "Campbell diagram: natural frequencies and excitations against rotor speed"
            .to_owned(),
        description: description(campbell, &shown),
        drawing: drawing(campbell, &shown),
        table: numbers::table(campbell),
    }
}

/// The Campbell diagram of a whole turbine: the curves of its coupled modes, whirl modes of one
/// motion in one colour with the backward ones dashed, and the excitations, against the rotor
/// speed.
pub fn coupled_campbell(coupled: &CoupledCampbell) -> Figure {
    let figure = coupled_campbell_beside_conclusion(coupled);
    let proof = proved(coupled);
    let figure = with_conclusion(&coupled.campbell, figure);
    Figure {
        description: format!("{} {STRUCTURE_ONLY} {proof}", figure.description),
        ..figure
    }
}

/// As [`coupled_campbell`], for a place where the conclusion and the certificate are stated
/// separately.
pub fn coupled_campbell_beside_conclusion(coupled: &CoupledCampbell) -> Figure {
    Figure {
        title: "Campbell diagram of the operating turbine: natural frequencies and excitations against rotor speed"
            .to_owned(),
        ..campbell_beside_conclusion(&coupled.campbell)
    }
}

fn with_conclusion(campbell: &Campbell, figure: Figure) -> Figure {
    let conclusion = conclusion_text(&campbell.conclusion());
    Figure {
        description: format!("{conclusion} {}", figure.description),
        ..figure
    }
}

fn description(campbell: &Campbell, shown: &Shown) -> String {
    let mut text = format!(
        "The diagram shows natural frequencies up to {} Hz and rotor speeds up to {} rpm, with the excitations {}. Operation: {}.",
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
