//! `towermodes elastodyn patch`.

use std::path::Path;

use towermodes_files::elastodyn::{patched, unified_diff};
use towermodes_files::encoded_as;

use super::arguments::PatchArguments;
use super::deck::{Judged, judged};
use crate::failure::Failure;
use crate::messages::report;
use crate::output::{back_up, deliver, replace};
use crate::table;

/// Writes the coefficients of the computed modes into the tower file of the deck.
pub(crate) fn run(arguments: &PatchArguments) -> Result<(), Failure> {
    let judged = judged(&arguments.deck)?;
    let Judged { deck, shapes, .. } = &judged;
    let old = &deck.tower_source;
    let new = patched(&old.text, &deck.coefficient_spans, &shapes.coefficients())
        .map_err(Failure::failed)?;
    if arguments.diff {
        let diff = unified_diff(&old.name, &old.name, &old.text, &new);
        return deliver(diff.as_bytes(), None);
    }
    let changes = table::changes(&deck.tower, shapes);
    if arguments.dry_run {
        return deliver(changes.as_bytes(), None);
    }
    report(&changes);
    if new == old.text {
        report(&format!(
            "{}: unchanged, the coefficients are already those of the computed modes\n",
            old.name
        ));
        return Ok(());
    }
    let path = Path::new(&old.name);
    let bytes = std::fs::read(path).map_err(|e| Failure::unwritable(old.name.clone(), &e))?;
    if arguments.backup {
        let backup = back_up(path, &bytes)?;
        report(&format!("{}: backup written\n", backup.display()));
    }
    replace(path, &encoded_as(&new, &bytes))?;
    report(&format!("{}: written\n", old.name));
    Ok(())
}
