//! The curves of a whole turbine as CSV: one line per curve and rotor speed.

use std::io::Write;

use towermodes::turbine::BladeMotion;
use towermodes_analysis::whirl::{CoupledCampbell, CurvePoint};

use super::ResultError;
use super::campbell::not_checked;

/// The columns before those of the energy.
const HEADER: [&str; 17] = [
    "curve",
    "curve_label",
    "partner",
    "rotor_speed_rpm",
    "frequency_hz",
    "lower_hz",
    "upper_hz",
    "error_hz",
    "multiplicity",
    "has_negative_energy",
    "is_complete",
    "label",
    "part",
    "order",
    "share",
    "second_part",
    "second_share",
];

/// The parts other than blades, in the order of their columns.
const STATIONARY: [&str; 12] = [
    "platform_surge",
    "platform_sway",
    "platform_heave",
    "platform_roll",
    "platform_pitch",
    "platform_yaw",
    "tower_fore_aft",
    "tower_side_side",
    "tower_torsion",
    "tower_axial",
    "yaw_drive",
    "shaft",
];

/// The multiblade harmonics, in the order of their columns.
const HARMONICS: [&str; 5] = ["collective", "forward", "backward", "tilt", "yaw"];

/// Writes a coupled Campbell diagram as CSV: one line per curve and rotor speed, with the name of
/// the mode there and the fractions of its elastic energy. Curves are counted from 0; `curve_label`
/// is the title of the curve, `is_complete` the certificate of the speed, `not_checked` the reason
/// why there are no verdicts on the diagram.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_coupled_campbell_csv(
    coupled: &CoupledCampbell,
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    let header = HEADER.map(str::to_owned).into_iter();
    let not_checked = not_checked(&coupled.campbell).join("; ");
    let last = ["not_checked".to_owned()];
    csv.write_record(header.chain(energy_columns()).chain(last))?;
    for (index, curve) in coupled.curves.iter().enumerate() {
        for point in &curve.points {
            let named = [
                index.to_string(),
                curve.title.clone(),
                curve.partner.map_or_else(String::new, |k| k.to_string()),
            ];
            let is_complete = is_complete(coupled, point).to_string();
            let row = named.into_iter().chain(numbers(point, is_complete));
            csv.write_record(row.chain([not_checked.clone()]))?;
        }
    }
    csv.flush()?;
    Ok(())
}

fn is_complete(coupled: &CoupledCampbell, point: &CurvePoint) -> bool {
    let mut speeds = coupled.speeds.iter();
    let own = speeds.find(|speed| speed.rotor_speed_rpm == point.rotor_speed_rpm);
    own.is_some_and(|speed| speed.modes.is_complete)
}

fn energy_columns() -> impl Iterator<Item = String> {
    let blades = BladeMotion::ALL.into_iter().flat_map(|motion| {
        let motion = motion.name().replace(' ', "_");
        HARMONICS.map(|harmonic| format!("{motion}_{harmonic}"))
    });
    STATIONARY.map(str::to_owned).into_iter().chain(blades)
}

/// The cells of a point, from the rotor speed on.
fn numbers(point: &CurvePoint, is_complete: String) -> Vec<String> {
    let (frequency, energy) = (&point.frequency, &point.energy);
    let mut row = vec![
        point.rotor_speed_rpm.to_string(),
        frequency.frequency_hz.to_string(),
        frequency.lower_hz.to_string(),
        frequency.upper_hz.to_string(),
        point.error_hz.map_or_else(String::new, |hz| hz.to_string()),
        frequency.multiplicity.to_string(),
        frequency.has_negative_energy.to_string(),
        is_complete,
        point.name.to_string(),
        point.name.part.to_string(),
        point.name.order.to_string(),
        point.share.to_string(),
        point
            .second
            .map_or_else(String::new, |(part, _)| part.to_string()),
        point
            .second
            .map_or_else(String::new, |(_, share)| share.to_string()),
    ];
    let stationary = [
        energy.tower_fore_aft,
        energy.tower_side_side,
        energy.tower_torsion,
        energy.tower_axial,
        energy.yaw_drive,
        energy.shaft,
    ];
    let blades = energy
        .blades
        .iter()
        .flat_map(|own| [own.collective, own.forward, own.backward, own.tilt, own.yaw]);
    let stationary = energy.platform.into_iter().chain(stationary);
    let shares = stationary.chain(blades);
    row.extend(shares.map(|share| share.to_string()));
    row
}
