//! The source of the shear modulus of a layer: its value, or the values from which it follows.

use towermodes::ShearModulus;
use towermodes::inputs::given_inputs;

use super::super::text::reading::Reading;
use super::super::text::table::Table;

/// The shear modulus with blank values: `Some(None)` if the layer has none, `None` after a mistake.
pub(super) fn shear_modulus(
    table: &Table<'_>,
    reading: &mut Reading,
) -> Option<Option<ShearModulus>> {
    if !table.knows("shear_modulus") {
        return Some(None);
    }
    let blanks = ShearModulus::blanks().into_iter();
    let given: Vec<ShearModulus> = blanks.filter(|m| table.get(m.key()).is_some()).collect();
    let Some(first) = given.first().copied() else {
        return unused(table, &[], reading).map(|()| None);
    };
    let source = first.key();
    if let Some(second) = given.iter().find(|modulus| modulus.key() != source) {
        let because = format!("together with {source}: both give the shear modulus");
        table.refuse_unused(second.key(), because, "keep one of the two", reading)?;
    }
    if first.correlation().is_none() {
        return of(first, table, reading).map(Some);
    }
    let names = ShearModulus::correlations().join("\" or \"");
    let hint = format!("correlation = \"{names}\"");
    let name = table.require("correlation", &hint, reading);
    let name = name.and_then(|name| name.get_ref().as_str());
    let is_named = |modulus: &ShearModulus| modulus.correlation() == name;
    match given.into_iter().find(is_named) {
        Some(modulus) => of(modulus, table, reading).map(Some),
        // The name is missing, or wrong, which is reported where the values are read.
        None => Some(Some(first)),
    }
}

/// This shear modulus, if no keys of another source are given.
fn of(modulus: ShearModulus, table: &Table<'_>, reading: &mut Reading) -> Option<ShearModulus> {
    let values = given_inputs(&Some(modulus)).into_iter();
    let used: Vec<&str> = values.map(|(input, _)| input.key).collect();
    unused(table, &used, reading).map(|()| modulus)
}

/// Refuses keys that belong to another source of the shear modulus.
fn unused(table: &Table<'_>, used: &[&str], reading: &mut Reading) -> Option<()> {
    let keys = [
        ("correlation", "without cone_resistance"),
        (
            "behaviour_index",
            "without correlation = \"robertson-cabal\"",
        ),
        ("earth_pressure_at_rest", "without void_ratio"),
        (
            "density",
            "without shear_wave_velocity, blow_count or correlation = \"robertson-cabal\"",
        ),
    ];
    let unused = |(key, _): &(&str, &str)| !used.contains(key) && table.get(key).is_some();
    let Some((key, because)) = keys.into_iter().find(unused) else {
        return Some(());
    };
    let hint = "remove it, or give the key it belongs to";
    table.refuse_unused(key, because, hint, reading)
}
