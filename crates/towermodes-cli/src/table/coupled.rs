//! The modes that share their motion with others, in a line below a table that contains only their
//! names.

use towermodes::Family;
use towermodes::modes::Shares;
use towermodes_report::wording::{coupled_shape, listed};

use super::text::wrapped;

/// "less than 60 % of the energy is in the type of motion that the name states: 2nd side-side
/// bending (58 %; 42 % torsion) and 1st torsion (57 %; 43 % side-side)", after `before`; empty if
/// there are none.
pub(super) fn coupled_modes<'m>(
    before: &str,
    modes: impl IntoIterator<Item = (String, Family, &'m Shares)>,
) -> String {
    let modes = modes.into_iter();
    let coupled = modes.filter_map(|(label, family, shares)| coupled_shape(&label, family, shares));
    let coupled: Vec<String> = coupled.collect();
    let modes = listed(&coupled);
    let sentence = format!(
        "{before}less than 60 % of the energy is in the type of motion that the name states: {modes}"
    );
    match coupled.is_empty() {
        true => String::new(),
        false => wrapped(&sentence) + "\n",
    }
}
