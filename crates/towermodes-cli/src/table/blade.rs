//! The modes of a rotating blade for people.

use towermodes::{Blade, BladeFamily, BladeMode, BladeSolution};

use super::text::{align_right, aligned, counted, four_digits, name_line, plain_table, with_error};

/// The modes as a table, and one line on what they are of.
pub(crate) fn blade(blade: &Blade, solution: &BladeSolution) -> String {
    let description = blade.description();
    let mut table = plain_table();
    table.set_header([
        "mode",
        "what it is",
        "frequency Hz",
        "± error",
        "per revolution",
    ]);
    let modes = || solution.modes.iter();
    let error_hz = |mode: &BladeMode| mode.discretization_error_hz + mode.algebraic_error_hz;
    let shown =
        |value_hz: f64, mode: &BladeMode| with_error(value_hz, mode.frequency_hz, error_hz(mode));
    let frequencies = aligned(modes().map(|mode| shown(mode.frequency_hz, mode)));
    let errors = aligned(modes().map(|mode| shown(error_hz(mode), mode)));
    let rotor_hz = description.rotor_speed_rad_per_s.abs() / std::f64::consts::TAU;
    for (mode, (frequency, error)) in modes().zip(frequencies.iter().zip(&errors)) {
        table.add_row([
            mode.number.to_string(),
            what_it_is(mode),
            frequency.clone(),
            error.clone(),
            per_revolution(mode.frequency_hz, rotor_hz),
        ]);
    }
    align_right(&mut table, [0, 2, 3, 4]);
    let tip = match description.tip.mass_kg {
        0.0 => "nothing at its tip".to_owned(),
        kg => format!("{} kg at its tip", four_digits(kg)),
    };
    format!(
        "{}{}\n\nblade of {} kg from radius {} m to {} m, {tip} | {} rpm | bmodes, {} | certified: {} below {} Hz, all listed\n",
        name_line(&description.name),
        table.trim_fmt(),
        four_digits(blade.mass_kg()),
        description.hub_radius_m,
        description.tip_radius_m,
        rounded(60.0 * rotor_hz),
        counted(solution.elements, "element"),
        counted(solution.certificate.count, "mode"),
        four_digits(solution.certificate.below_hz),
    )
}

/// "2nd flap (12 % torsion)".
fn what_it_is(mode: &BladeMode) -> String {
    let kinetic = &mode.kinetic;
    let shares = [
        (BladeFamily::Flap, kinetic.side_side),
        (BladeFamily::Lag, kinetic.fore_aft),
        (BladeFamily::Torsion, kinetic.torsion),
        (BladeFamily::Axial, kinetic.axial),
    ];
    let others = shares
        .into_iter()
        .filter(|(family, _)| *family != mode.family);
    let mut others: Vec<(BladeFamily, f64)> = others.filter(|(_, share)| *share >= 0.01).collect();
    others.sort_by(|a, b| b.1.total_cmp(&a.1));
    let others: Vec<String> = others
        .iter()
        .map(|(family, share)| format!("{:.0} % {}", 100.0 * share, family.name()))
        .collect();
    let label = format!("{} {}", ordinal(mode.order), mode.family.name());
    if others.is_empty() {
        return label;
    }
    format!("{label} ({})", others.join(", "))
}

/// "1st", "2nd", "3rd", "4th".
fn ordinal(number: usize) -> String {
    let ending = match (number % 10, number % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{number}{ending}")
}

/// "3.62 P".
fn per_revolution(frequency_hz: f64, rotor_hz: f64) -> String {
    if rotor_hz == 0.0 {
        return "-".to_owned();
    }
    format!("{:.2} P", frequency_hz / rotor_hz)
}

/// A speed as it was given, without what rounding to rad/s and back left.
fn rounded(rpm: f64) -> f64 {
    (rpm * 1e9).round() / 1e9
}
