//! The modes of the reference solution with which modes are compared: those of the same name.

use super::super::on_mesh::model::Model;
use super::super::on_mesh::naming::{Identity, Naming, Wanted, identify};
use super::super::on_mesh::spectrum::{Found, ModeKey, Spectrum};
use super::super::request::options::Options;
use super::super::workspace::Workspace;
use crate::tower::Tower;

/// For each of `keys`, the place in `keys` of the mode that has its name on the model of the
/// workspace, which is solved for them. Where segments are coarse two frequencies of one subsystem
/// can be in another order than those of the beam; a mode without a partner keeps its own place.
///
/// `which` are the numbers of the modes in the list that was named last.
pub(super) fn pair_by_name(
    tower: &Tower,
    options: &Options,
    keys: &[ModeKey],
    which: &[usize],
    workspace: &mut Workspace,
) -> Vec<usize> {
    let Workspace {
        model,
        spectrum,
        naming,
        ..
    } = workspace;
    let found = coupled(keys, model, spectrum);
    let mut renamed = Naming::default();
    let wanted = Wanted::Names;
    identify(
        tower,
        options,
        model,
        spectrum,
        (&found, wanted),
        &mut renamed,
    );
    let name = |identity: &Identity| (identity.family, identity.order);
    let place_of = |(place, &index): (usize, &usize)| {
        let own = name(&naming.identities[index]);
        let same = renamed.identities.iter().position(|new| name(new) == own);
        let partner = same.and_then(|same| keys.iter().position(|key| *key == found[same].key));
        partner.unwrap_or(place)
    };
    which.iter().enumerate().map(place_of).collect()
}

/// The modes of the subsystems that couple motions, up to the highest of `keys`; only these can
/// change places.
fn coupled(keys: &[ModeKey], model: &Model, spectrum: &Spectrum) -> Vec<Found> {
    let mut found = Vec::new();
    for subsystem in (0..model.count()).filter(|&index| !model.has_single_motion(index)) {
        let own = keys.iter().filter(|key| key.subsystem == subsystem);
        let highest = own.map(|key| key.order).max().unwrap_or(0);
        let solved = spectrum.eigenvalues_of(subsystem).len();
        found.extend((1..=highest.min(solved)).map(|order| {
            let key = ModeKey {
                subsystem,
                order,
                is_turned: false,
            };
            let eigenvalue = spectrum.eigenvalue(model, key);
            Found { key, eigenvalue }
        }));
    }
    found
}
