//! `towermodes campbell` for a turbine with flexible blades.

use towermodes::turbine::Turbine;
use towermodes::{Options, Tower, Warning};
use towermodes_analysis::resonance::ChosenRotor;
use towermodes_analysis::whirl::{
    AgainstRigid, CoupledCampbell, CoupledOptions, RotorSpeeds, coupled_campbell, coupled_limit_hz,
};
use towermodes_files::{Note, TowerInput};

use super::{assumed_blades, solved_to_reach};
use crate::args::{RotorArguments, TurbineArguments};
use crate::failure::Failure;
use crate::progress::Progress;

/// Usual number of speeds that are added where curves come close, for the progress.
const USUALLY_ADDED: usize = 10;

/// The coupled diagram of a turbine, with the modes of the tower with a rigid rotor for comparison.
pub(crate) struct Coupled {
    pub(crate) diagram: CoupledCampbell,
    pub(crate) against: Vec<AgainstRigid>,
    /// The notes of the reader on the turbine and the rotor, and the limits of the diagram.
    pub(crate) notes: Vec<Note>,
    /// Possible mistakes in the input of the tower.
    pub(crate) warnings: Vec<Warning>,
}

/// The type of diagram.
pub(crate) enum Diagram {
    /// The diagram of the whole turbine.
    Turbine(Box<Turbine>),
    /// The diagram of the tower with a rigid rotor, with a note on the reason if a user could
    /// expect the diagram of the turbine.
    Tower(Vec<Note>),
}

/// The diagram of the turbine if the input has one, unless options request the diagram of the tower
/// alone; `alone` is whether options are given that apply only to the tower alone.
///
/// # Errors
/// At the place of an impossible value of the turbine; wrong usage for options of a turbine if
/// there is none.
pub(crate) fn diagram_of(
    input: &TowerInput,
    arguments: &TurbineArguments,
    alone: bool,
) -> Result<Diagram, Failure> {
    if arguments.uncoupled {
        return Ok(Diagram::Tower(Vec::new()));
    }
    let turbine = input.whole_turbine()?;
    match (turbine, arguments.is_given()) {
        (None, true) => Err(Failure::usage(
            "--generator, --limit and --speeds apply only to a turbine with flexible blades; the input has none",
        )),
        (None, false) => Ok(Diagram::Tower(without_turbine(input))),
        (Some(_), true) if alone => Err(Failure::usage(
            "--generator, --limit and --speeds apply only to the turbine with flexible blades; --method, --segments, --modes, --no-rotary-inertia, --hinges, --no-limits and --soil-factor apply only to the tower with a rigid rotor; omit the options of one of these two groups",
        )),
        (Some(_), false) if alone => Ok(Diagram::Tower(vec![Note::suspicious(
            "the rotor is rigid in this diagram, because options are given that apply only to the tower with a rigid rotor (--method, --segments, --modes, --no-rotary-inertia, --hinges, --no-limits, --soil-factor); without these options the diagram shows the turbine with flexible blades".to_owned(),
        )])),
        (Some(turbine), _) => Ok(Diagram::Turbine(Box::new(turbine))),
    }
}

/// The note on the reason why the rotor is rigid in the diagram, although the files describe a
/// rotating rotor.
fn without_turbine(input: &TowerInput) -> Vec<Note> {
    let Some(reason) = &input.turbine_missing else {
        return Vec::new();
    };
    let rigid = "so the diagram shows the tower with a rigid rotor".to_owned();
    vec![reason.clone(), Note::suspicious(rigid)]
}

/// Solves a turbine at its rotor speeds, and its tower with a rigid rotor-nacelle assembly.
///
/// # Errors
/// Those of the solver and of [`coupled_campbell`].
pub(crate) fn coupled_of(
    input: &TowerInput,
    (tower, turbine): (&Tower, &Turbine),
    rotor: &RotorArguments,
    arguments: &TurbineArguments,
) -> Result<Coupled, Failure> {
    let mut options = Options::default();
    let (rigid, chosen) = solved_to_reach(input, tower, rotor, &mut options, false)?;
    let common = rotor.options();
    let usual_hz = coupled_limit_hz(&chosen.rotor, &common, &rigid, turbine);
    let speeds = arguments.speeds.unwrap_or(common.speeds);
    let options = CoupledOptions {
        margin: common.margin,
        multiples: common.multiples,
        speeds: RotorSpeeds::Equal(speeds),
        speeds_are_known: chosen.speeds_are_known,
        ..CoupledOptions::up_to(arguments.limit.unwrap_or(usual_hz))
    };
    let names = (0..speeds + USUALLY_ADDED).map(|k| format!("rotor speed {}", k + 1));
    let progress = Progress::of(names);
    let mut is_first = true;
    let diagram = coupled_campbell(turbine, &chosen.rotor, &options, |_| {
        if !std::mem::take(&mut is_first) {
            progress.done();
        }
    });
    let diagram = diagram?;
    let remarks = diagram.remarks(turbine);
    let remarks = remarks
        .iter()
        .map(|remark| Note::suspicious(remark.to_string()));
    Ok(Coupled {
        against: diagram.against(&rigid),
        notes: notes(input, &chosen)
            .into_iter()
            .chain(rotor.note())
            .chain(remarks)
            .collect(),
        diagram,
        warnings: rigid.warnings,
    })
}

/// The notes on the rotor speeds and on the turbine; notes on a single blade do not apply.
fn notes(input: &TowerInput, chosen: &ChosenRotor) -> Vec<Note> {
    let speeds = input.rotor_notes.speeds.iter();
    let speeds = speeds.filter(|_| !chosen.speeds_are_given);
    let notes = speeds.chain(&input.turbine_notes).cloned();
    notes.chain(assumed_blades(chosen)).collect()
}
