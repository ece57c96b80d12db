//! The shape of a mode in words.

use towermodes::{BladeFamily, BladeMode, Mode};

/// Smaller fractions of the energy are left out.
const LEAST: f64 = 0.01;

/// The label of a tower mode with the other motions that have 1 % of its energy or more: "1st
/// fore-aft bending (8 % torsion)".
pub fn mode_shape(mode: &Mode) -> String {
    let others = mode.other_parts();
    let others = others.iter().map(|(family, share)| (family.name(), *share));
    with_others(mode.label(), others)
}

/// The label of a blade mode with the other motions that have 1 % of its kinetic energy or more:
/// "2nd flap (12 % torsion)".
pub fn blade_mode_shape(mode: &BladeMode) -> String {
    let kinetic = &mode.kinetic;
    let mut others = vec![
        (BladeFamily::Flap, kinetic.side_side),
        (BladeFamily::Lag, kinetic.fore_aft),
        (BladeFamily::Torsion, kinetic.torsion),
        (BladeFamily::Axial, kinetic.axial),
    ];
    others.retain(|(family, _)| *family != mode.family);
    others.sort_by(|a, b| b.1.total_cmp(&a.1));
    let others = others.iter().map(|(family, share)| (family.name(), *share));
    with_others(mode.family.label(mode.order), others)
}

fn with_others(label: String, others: impl Iterator<Item = (&'static str, f64)>) -> String {
    let shown = others.filter(|(_, fraction)| *fraction >= LEAST);
    let shown: Vec<String> = shown
        .map(|(name, fraction)| format!("{:.0} % {name}", 100.0 * fraction))
        .collect();
    match shown.is_empty() {
        true => label,
        false => format!("{label} ({})", shown.join(", ")),
    }
}
