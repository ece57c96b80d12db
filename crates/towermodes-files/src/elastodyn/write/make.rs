//! A complete tower file for a tower: the result of the analysis as the content of a file, with
//! notes.

use towermodes::Tower;
use towermodes_analysis::elastodyn::{
    Coarseness, ConcentratedMass as ListedMass, MadeTower, MakeError, MakeOptions, TowerShapes,
    TowerStation, make_tower,
};

use super::super::tower_input::tower_file::{ConcentratedMass, TowerFile, TowerRow};
use super::writer::header_with_heights;
use crate::note::Note;

/// A tower file, and the tower that it contains.
#[derive(Debug, Clone, PartialEq)]
pub struct MadeTowerFile {
    /// The content of the file.
    pub content: TowerFile,
    /// The tower in the model of ElastoDyn.
    pub made: MadeTower,
    /// Notes on data that the file does not contain.
    pub notes: Vec<Note>,
}

/// Makes the tower file of a tower.
///
/// # Errors
/// [`MakeError`].
pub fn make_tower_file(tower: &Tower, options: &MakeOptions) -> Result<MadeTowerFile, MakeError> {
    let made = make_tower(tower, options)?;
    Ok(MadeTowerFile {
        content: content(tower, &made),
        notes: notes(tower, &made),
        made,
    })
}

fn content(tower: &Tower, made: &MadeTower) -> TowerFile {
    let name = match tower.name() {
        "" => "Tower file made by towermodes",
        name => name,
    };
    let what = match tower.missing_parts() {
        Some(missing) => format!("WARNING: {missing}. {name}"),
        None => name.to_owned(),
    };
    let row = |station: &TowerStation| TowerRow {
        height_fraction: station.height_fraction,
        mass_kg_per_m: station.mass_kg_per_m,
        fore_aft_n_m2: station.bending_n_m2.fore_aft,
        side_side_n_m2: station.bending_n_m2.side_side,
    };
    let mass = |mass: &ListedMass| ConcentratedMass {
        height_fraction: mass.height_fraction,
        mass_kg: mass.mass_kg,
    };
    let (fore_aft, side_side) = (&made.modes.fore_aft, &made.modes.side_side);
    TowerFile {
        header: header_with_heights(&what, tower.top_m(), made.from_m),
        fore_aft_damping_percent: fore_aft.damping_percent,
        side_side_damping_percent: side_side.damping_percent,
        fore_aft_tuners: fore_aft.tuners,
        side_side_tuners: side_side.tuners,
        mass_factor: made.model.mass_factor,
        fore_aft_factor: made.model.stiffness_factors.fore_aft,
        side_side_factor: made.model.stiffness_factors.side_side,
        rows: made.model.stations.iter().map(row).collect(),
        coefficients: made.shapes.coefficients(),
        concentrated_masses: made.model.concentrated_masses.iter().map(mass).collect(),
    }
}

fn notes(tower: &Tower, made: &MadeTower) -> Vec<Note> {
    let mut notes = torsion_notes(&made.shapes);
    let spread = made.spread_masses;
    if spread > 0 {
        notes.push(Note::new(format!(
            "{spread} point mass{} distributed over 1/{} of the height; only OpenFAST 4.2 and newer accept concentrated masses (option --openfast 4.2)",
            if spread == 1 { " is" } else { "es are each" },
            made.model.nodes
        )));
    }
    if tower.rna().mass_kg == 0.0 {
        notes.push(Note::new(
            "the shapes are those of a tower without RNA: with a rotor-nacelle assembly they differ",
        ));
    }
    if tower.missing_parts().is_some() {
        notes.push(Note::left_out(
            "the parts of the structure that this model lacks are named only in the second line: the shapes and frequencies are those of the tower without them",
        ));
    }
    notes.extend(
        made.coarseness
            .map(|coarseness| coarseness_note(&coarseness, made)),
    );
    notes
}

fn coarseness_note(coarseness: &Coarseness, made: &MadeTower) -> Note {
    Note::new(format!(
        "{} rows change the mass of the tower by {:+.2} % and its flexibility by {:+.2} %; without --stations there are {} rows",
        made.model.stations.len(),
        100.0 * coarseness.difference.mass,
        100.0 * coarseness.difference.flexibility.fore_aft,
        coarseness.accurate_rows
    ))
}

/// The notes on modes that were skipped because of their torsion, and on shapes with torsion.
pub fn torsion_notes(shapes: &TowerShapes) -> Vec<Note> {
    let skipped = shapes.passed_over.iter().map(|mode| {
        format!(
            "mode {} ({}, {:.4} Hz) is skipped: {:.0} % of its energy is torsion, which ElastoDyn's towers do not have",
            mode.number, mode.label, mode.frequency_hz, 100.0 * mode.torsion_share
        )
    });
    let used = shapes.with_torsion().map(|shape| {
        format!(
            "{:.0} % of the energy of the {} ({:.4} Hz) is torsion, which ElastoDyn's towers do not have: only its bending is used",
            100.0 * shape.torsion_share, shape.label, shape.frequency_hz
        )
    });
    skipped.chain(used).map(Note::new).collect()
}
