//! `towermodes elastodyn tower`.

use towermodes::Tower;
use towermodes_files::Note;
use towermodes_files::elastodyn::{make_tower_file, write_tower_file};

use super::arguments::TowerArguments;
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, report};
use crate::output::{check_not_input, check_not_inputs, deliver};
use crate::table;

/// Reads any tower and writes the tower file; the quality of the fits goes to standard error.
pub(crate) fn run(arguments: &TowerArguments) -> Result<(), Failure> {
    check_not_input(&arguments.input.file, arguments.output())?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), arguments.output())?;
    let tower = input.tower_for_shapes()?;
    let mut options = arguments.options(input.damping_for_tower_file());
    // On a monopile the ElastoDyn tower is the part above it.
    options.from_m = options.from_m.or(input.joint_m);
    let made = make_tower_file(&tower, &options);
    let made = explained(made, (&tower, &input))?;
    let text = write_tower_file(&made.content, options.has_concentrated_masses)
        .map_err(Failure::failed)?;
    note(&input.notes);
    note(&input.notes_on_tower_file());
    note(&made.notes);
    note(&surrounded_base(&tower, options.from_m));
    report(&table::fits(&tower, &made.made));
    deliver(text.as_bytes(), arguments.output())
}

/// A note if the tower begins in soil or water, which is unlikely for ElastoDyn.
fn surrounded_base(tower: &Tower, from_m: Option<f64>) -> Vec<Note> {
    if from_m.is_some() || !tower.begins_in_soil_or_water() {
        return Vec::new();
    }
    vec![Note::suspicious(
        "the flexible tower begins at the lowest height, in soil or water; give the tower base of ElastoDyn with --from-height",
    )]
}
