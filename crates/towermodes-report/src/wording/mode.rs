//! The shape of a mode as text.

use towermodes::modes::Shares;
use towermodes::{BladeFamily, BladeMode, Family, Mode};

/// Smaller fractions of the energy of a blade mode are omitted.
const LEAST: f64 = 0.01;
/// A mode with a smaller share in its own type of motion gets a remark.
const PURE: f64 = 0.9;
/// Types of motion with a smaller share are not in the remark.
const NOTABLE: f64 = 0.05;

/// The label of a tower mode; if less than 90 % of its energy is in its own type of motion, with
/// this share and the shares of other types that have 5 % or more: "2nd side-side bending (88 %; 12
/// % torsion)". With less than 60 % it is called coupled: "2nd side-side bending, coupled (58 %; 41
/// % fore-aft)".
pub fn mode_shape(mode: &Mode) -> String {
    if mode.share() >= PURE {
        return mode.label();
    }
    let label = match mode.is_coupled() {
        true => mode.label() + ", coupled",
        false => mode.label(),
    };
    with_shares(&label, mode.family, &mode.shares)
}

fn with_shares(label: &str, family: Family, shares: &Shares) -> String {
    let others = shares.beside(family).into_iter();
    let others = others.filter(|(_, share)| *share >= NOTABLE);
    let others: Vec<String> = others
        .map(|(family, share)| format!("{} {}", percent(share), family.name()))
        .collect();
    format!(
        "{label} ({}; {})",
        percent(shares.of(family)),
        others.join(", ")
    )
}

/// The label of a mode with less than 60 % of its energy in the type of motion that its name
/// states, with the shares: "2nd side-side bending (58 %; 41 % fore-aft)"; none for any other mode.
pub fn coupled_shape(label: &str, family: Family, shares: &Shares) -> Option<String> {
    shares
        .is_coupled(family)
        .then(|| with_shares(label, family, shares))
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
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
