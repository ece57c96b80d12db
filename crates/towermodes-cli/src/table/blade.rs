//! The modes of a rotating blade as text.

use towermodes::number::{four_digits, with_error};
use towermodes::{Blade, BladeMode, BladeSolution};
use towermodes_report::wording::{blade_mode_shape, completeness_of_blade, counted};

use super::text::{aligned, name_line, text_table};

/// The modes as a table, and a line with mass, speed, method and certificate.
pub(crate) fn blade(blade: &Blade, solution: &BladeSolution) -> String {
    let description = blade.description();
    let rotor_hz = description.rotor_speed_rad_per_s.abs() / std::f64::consts::TAU;
    let tip = match description.tip.mass_kg {
        0.0 => "no tip mass".to_owned(),
        kg => format!("tip mass {} kg", four_digits(kg)),
    };
    format!(
        "{}{}\n\nblade of {} kg from radius {} m to {} m, {tip} | {} rpm | bmodes, {} | {}\n",
        name_line(&description.name),
        modes(&solution.modes, rotor_hz),
        four_digits(blade.mass_kg()),
        description.hub_radius_m,
        description.tip_radius_m,
        rounded(60.0 * rotor_hz),
        counted(solution.elements, "element"),
        completeness_of_blade(solution),
    )
}

fn modes(modes: &[BladeMode], rotor_hz: f64) -> String {
    let error_hz = |mode: &BladeMode| mode.discretization_error_hz + mode.algebraic_error_hz;
    let shown =
        |value_hz: f64, mode: &BladeMode| with_error(value_hz, mode.frequency_hz, error_hz(mode));
    let frequencies = aligned(modes.iter().map(|mode| shown(mode.frequency_hz, mode)));
    let errors = aligned(modes.iter().map(|mode| shown(error_hz(mode), mode)));
    let rows = modes.iter().zip(frequencies.into_iter().zip(errors));
    let rows = rows.map(|(mode, (frequency, error))| {
        [
            mode.number.to_string(),
            blade_mode_shape(mode),
            frequency,
            error,
            per_revolution(mode.frequency_hz, rotor_hz),
        ]
    });
    let header = [
        "mode",
        "mode shape",
        "frequency Hz",
        "± error",
        "per revolution",
    ];
    text_table(header, rows, [0, 2, 3, 4])
}

/// "3.62 P".
fn per_revolution(frequency_hz: f64, rotor_hz: f64) -> String {
    if rotor_hz == 0.0 {
        return "-".to_owned();
    }
    format!("{:.2} P", frequency_hz / rotor_hz)
}

/// A rotor speed without the rounding of the conversion to rad/s and back.
fn rounded(rpm: f64) -> f64 {
    (rpm * 1e9).round() / 1e9
}
