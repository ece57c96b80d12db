//! The tables of the whole turbine.

use towermodes::Rotor;
use towermodes::number::with_error;
use towermodes::tower::Rpm;
use towermodes::turbine::{Nodding, TurbineEnergy, TurbineModeName, TurbineModes};
use towermodes_analysis::whirl::{AgainstRigid, Change, CoupledCampbell};

use super::super::super::table::Table;
use crate::number::{NOTHING, digits, four_digits, frequency, percent, signed_percent, typeset};

/// Smaller shares of the elastic energy are omitted.
const NOTABLE: f64 = 0.02;

/// The modes by name with their frequencies at the lowest speed of the diagram and at both ends of
/// the operating range, the other mode of each whirl pair, and the changes over the rotor speed.
pub(super) fn names(coupled: &CoupledCampbell) -> Table {
    let rotor = &coupled.campbell.rotor;
    let first_rpm = coupled.speeds.first().map_or(0.0, |of| of.rotor_speed_rpm);
    let mut speeds = vec![first_rpm, rotor.lowest_rpm, rotor.highest_rpm];
    speeds.dedup();
    let heads = speeds.iter().map(|rpm| format!("#Hz at {} rpm", Rpm(*rpm)));
    let heads: Vec<String> = heads.collect();
    let columns = ["mode"].into_iter();
    let columns = columns.chain(heads.iter().map(String::as_str));
    let columns = columns.chain(["whirl partner", "along the rotor speed"]);
    let mut table = Table::new("Coupled modes against the rotor speed", columns);
    let is_shown = |name: &&TurbineModeName| {
        let mut speeds = speeds.iter();
        speeds.any(|rpm| coupled.at_rpm(**name, *rpm).is_some())
    };
    for name in coupled.names.iter().filter(is_shown) {
        let sign = match coupled.has_negative_energy(*name) {
            true => " (negative energy)",
            false => "",
        };
        let partner = coupled.whirls_with(*name).map(|other| other.to_string());
        let mut row = vec![format!("{name}{sign}")];
        row.extend(speeds.iter().map(|rpm| at(coupled, *name, *rpm)));
        row.push(partner.unwrap_or_else(|| NOTHING.to_owned()));
        row.push(character(coupled, *name));
        table.push(row);
    }
    table
}

/// The changes over the rotor speed: "yaw at 0 to 8.3 rpm; on another curve from 11.95 rpm".
fn character(coupled: &CoupledCampbell, name: TurbineModeName) -> String {
    let speeds = coupled.speeds.iter().map(|speed| speed.rotor_speed_rpm);
    let points = speeds.filter_map(|rpm| Some((rpm, coupled.at_rpm(name, rpm)?.nodding())));
    let points: Vec<(f64, Option<Nodding>)> = points.collect();
    let runs = points.chunk_by(|a, b| a.1 == b.1);
    let nodding = runs.filter_map(|run| {
        let (from, to) = (Rpm(run[0].0), Rpm(run[run.len() - 1].0));
        let nodding = run[0].1?;
        Some(match run.len() == points.len() {
            true => nodding.to_string(),
            false => format!("{nodding} at {from} to {to} rpm"),
        })
    });
    let changes = coupled.changes().into_iter();
    let changes = changes.filter(|change| change.after == name);
    let changes = changes.map(|change| {
        let rpm = four_digits(change.rotor_speed_rpm);
        format!("from {rpm} rpm on the curve of {}", change.before)
    });
    let texts: Vec<String> = nodding.chain(changes).collect();
    match texts.is_empty() {
        true => NOTHING.to_owned(),
        false => texts.join("; "),
    }
}

/// The frequency of a name at a speed.
fn at(coupled: &CoupledCampbell, name: TurbineModeName, rpm: f64) -> String {
    let hz = coupled
        .at_rpm(name, rpm)
        .map(|point| point.frequency.frequency_hz);
    hz.map_or_else(
        || NOTHING.to_owned(),
        |hz| typeset(&with_error(hz, hz, coupled.error_hz(name))),
    )
}

/// The places where curves change their names.
pub(super) fn changes(coupled: &CoupledCampbell) -> Table {
    let columns = ["curve of", "continues as", "#rotor speed (rpm)", "#f (Hz)"];
    let mut table = Table::new("Names that change along the curves", columns);
    let changes = coupled.changes();
    for change in &changes {
        table.push([
            change.before.to_string(),
            change.after.to_string(),
            four_digits(change.rotor_speed_rpm),
            four_digits(change.frequency_hz),
        ]);
    }
    let rotor = &coupled.campbell.rotor;
    let operation = rotor.lowest_rpm..=rotor.highest_rpm;
    table.with_only("those in operation", |row| {
        operation.contains(&changes[row].rotor_speed_rpm)
    })
}

/// The places where curves cross or veer.
pub(super) fn meetings(coupled: &CoupledCampbell) -> Table {
    let mut table = Table::new(
        "Crossings and veerings of the curves",
        [
            "curves",
            "interaction",
            "#rotor speed (rpm)",
            "#f (Hz)",
            "#least distance (Hz)",
        ],
    );
    for meeting in &coupled.meetings {
        let name = |curve: usize| coupled.curves[curve].name_at(meeting.rotor_speed_rpm);
        let names = meeting.curves.map(name);
        let distance_hz = meeting.least_distance_hz;
        table.push([
            format!("{} and {}", names[0], names[1]),
            meeting.kind.name().to_owned(),
            four_digits(meeting.rotor_speed_rpm),
            four_digits(meeting.frequency_hz),
            match distance_hz > 0.0 {
                true => digits(distance_hz, 3),
                false => "0".to_owned(),
            },
        ]);
    }
    let rotor = &coupled.campbell.rotor;
    let operation = rotor.lowest_rpm..=rotor.highest_rpm;
    table.with_only("those in operation", |row| {
        operation.contains(&coupled.meetings[row].rotor_speed_rpm)
    })
}

/// The modes at a rotor speed.
pub(super) fn modes(modes: &TurbineModes) -> Table {
    let speed = Rpm(modes.rotor_speed_rpm);
    let mut table = Table::new(
        format!("Modes of the turbine at {speed} rpm, the highest operating speed"),
        [
            "#no.",
            "mode",
            "#f (Hz)",
            "#bound of the solver error (± Hz)",
            "#mesh error (Hz)",
            "elastic energy",
        ],
    );
    for (index, mode) in modes.modes.iter().enumerate() {
        let of = &mode.frequency;
        let mesh_hz = mode.discretization_error_hz;
        let half_hz = 0.5 * (of.upper_hz - of.lower_hz);
        table.push([
            (index + 1).to_string(),
            mode.label(),
            frequency(of.frequency_hz, mesh_hz.unwrap_or_default() + half_hz),
            digits(half_hz, 1),
            mesh_hz.map_or_else(|| NOTHING.to_owned(), |hz| digits(hz, 2)),
            shares(&mode.energy),
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

/// The modes of the tower with a rigid rotor and with the flexible one.
pub(super) fn against_rigid(rows: &[AgainstRigid], rotor: &Rotor) -> Table {
    let highest = format!("#at {} rpm (Hz)", Rpm(rotor.highest_rpm));
    let mut table = Table::new(
        "Modes of the tower with the rotor as a rigid body and with the flexible rotor",
        [
            "tower mode",
            "#rigid rotor (Hz)",
            "#flexible, at rest (Hz)",
            "#vs rigid (%)",
            &highest,
            "#vs rigid (%)",
        ],
    );
    let hz = |change: Option<Change>| {
        change.map_or_else(|| NOTHING.to_owned(), |of| four_digits(of.coupled_hz))
    };
    let difference =
        |change: Option<Change>| change.map_or_else(|| NOTHING.to_owned(), change_in_words);
    for row in rows {
        table.push([
            row.name.to_string(),
            four_digits(row.rigid_hz),
            hz(row.at_rest),
            difference(row.at_rest),
            hz(row.at_highest),
            difference(row.at_highest),
        ]);
    }
    table
}

/// The difference in percent, or the share of a mode that is not the same motion.
fn change_in_words(change: Change) -> String {
    match change.difference {
        Some(difference) => signed_percent(difference),
        None => format!("share {} %", percent(change.share)),
    }
}
