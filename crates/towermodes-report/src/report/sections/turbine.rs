//! The whole turbine with its turning rotor: coupled modes, and how they move.

use towermodes::tower::Rpm;
use towermodes::turbine::{TurbineEnergy, TurbineError, TurbineMode, TurbineModes};

use super::super::content::TurbineResults;
use super::super::document::Block;
use super::super::table::Table;
use super::{own_picture, paragraph, table};
use crate::figures;
use crate::number::{NOTHING, digits, four_digits, frequency, percent};
use crate::wording::counted;

/// Shares of the elastic energy below this are left out.
const NOTABLE: f64 = 0.02;

pub(super) fn blocks(whole: &Result<TurbineResults, TurbineError>) -> Vec<Block> {
    let results = match whole {
        Ok(results) => results,
        Err(error) => {
            let text = format!("The turbine with its turning rotor was not solved: {error}.");
            return vec![paragraph(text)];
        }
    };
    let (turbine, modes) = (&results.turbine, &results.modes);
    let mut blocks = vec![
        paragraph(what(results)),
        paragraph(certificate(modes)),
        table(of_modes(modes)),
        paragraph(MEANING),
    ];
    if !modes.modes.is_empty() {
        blocks.push(own_picture(figures::whirl(turbine, modes)));
        blocks.push(Block::Whirl(figures::whirl_animation(turbine, modes)));
    }
    blocks
}

const MEANING: &str = "The name is that of the part with most of the elastic energy; the second name goes by kinetic energy and differs where motions are coupled. \
     Counts prove the frequency of the model within the given half-width; the error of the mesh is the change of the frequency to a finer mesh.";

fn what(results: &TurbineResults) -> String {
    let machine = results.turbine.machine();
    let generator = match machine.generator.is_locked {
        true => "turns at constant speed",
        false => "turns freely",
    };
    format!(
        "In this section the rotor is flexible and turns: tower, nacelle, drivetrain and {} blades vibrate together, and frequencies are those in axes that do not turn. The \
         generator {generator}. Structure only: no aerodynamics, no controller, constant rotor speed. The other sections take the rotor-nacelle assembly as a rigid body.",
        machine.blades
    )
}

fn speed(modes: &TurbineModes) -> Rpm {
    Rpm(modes.speed_rad_per_s * 30.0 / std::f64::consts::PI)
}

fn certificate(modes: &TurbineModes) -> String {
    let (count, limit) = (modes.modes.len(), four_digits(modes.limit_hz));
    let rpm = speed(modes);
    match modes.is_complete {
        true => format!(
            "At {rpm} rpm, the highest operating speed, there are {} below {limit} Hz. Counts prove that none is missing and that none is unstable.",
            counted(count, "mode")
        ),
        false => format!(
            "At {rpm} rpm, the highest operating speed, {} below {limit} Hz were found. The turbine is unstable or the list is not proved to be complete: {} of {} modes of negative energy were found.",
            counted(count, "mode"),
            modes.negative_energy_found,
            modes.negative_energy_expected
        ),
    }
}

fn of_modes(modes: &TurbineModes) -> Table {
    let mut table = Table::new(
        format!("Modes of the turbine at {} rpm", speed(modes)),
        [
            "#no.",
            "mode",
            "#f (Hz)",
            "#proved within (Hz)",
            "#error of the mesh (Hz)",
            "elastic energy",
            "by kinetic energy",
        ],
    );
    for (index, mode) in modes.modes.iter().enumerate() {
        let of = &mode.frequency;
        let mesh_hz = mode.discretization_error_hz;
        let half_hz = 0.5 * (of.upper_hz - of.lower_hz);
        table.push([
            (index + 1).to_string(),
            mode.name.to_string(),
            frequency(of.frequency_hz, mesh_hz.unwrap_or_default() + half_hz),
            digits(half_hz, 1),
            mesh_hz.map_or_else(|| NOTHING.to_owned(), |hz| digits(hz, 2)),
            shares(&mode.energy),
            second(mode),
        ]);
    }
    table
}

/// The parts with most of the energy: "flapwise backward whirl 97 %, drivetrain torsion 2 %".
fn shares(energy: &TurbineEnergy) -> String {
    let mut parts = energy.parts();
    parts.retain(|(_, share)| *share >= NOTABLE);
    parts.sort_by(|a, b| b.1.total_cmp(&a.1));
    let texts = parts
        .iter()
        .map(|(part, share)| format!("{part} {} %", percent(*share)));
    texts.collect::<Vec<String>>().join(", ")
}

/// The second name, where it is another part's.
fn second(mode: &TurbineMode) -> String {
    match mode.second_name.part == mode.name.part {
        true => "the same".to_owned(),
        false => mode.second_name.to_string(),
    }
}
