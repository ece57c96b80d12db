//! `towermodes solve`.

mod arguments;
mod several;

pub(crate) use arguments::{SolveArguments, SolveFormat};

use towermodes::frame::{Frame, FrameOptions, FrameSolution, FrameSolveError, solve_frame};
use towermodes::{Blade, BladeMode, BladeSolution, Solver, Warning};
use towermodes_files::{
    BladeInput, FileFormat, Input, Interface, MooringInput, Note, OutNodes, SolvedMooring,
    SolvedSubstructure, SubdynInput, TowerInput, write_blade_csv, write_blade_json, write_csv,
    write_json, write_json_with_sensitivities, write_mooring_csv, write_mooring_json,
    write_substructure_csv, write_substructure_json,
};
use towermodes_report::terminal::{blade_shapes, shapes};

use super::sensitivities::influences_of;
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::input;
use crate::messages::{note, warn};
use crate::output::{Finished, check_not_input, check_not_inputs};
use crate::progress::solve;
use crate::table;
use crate::terminal;

/// The last line of the table of a tower whose files describe a turbine with flexible blades.
const RIGID: &str =
    "rotor and nacelle are one rigid body here; `towermodes campbell` gives the coupled modes\n";

/// Reads and solves the tower, the blade, the substructure or the mooring lines and prints the
/// result; warnings go to standard error.
pub(crate) fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    for file in &arguments.files {
        check_not_input(file, arguments.destination.output())?;
    }
    let format = arguments.destination.format()?;
    arguments.check(format)?;
    let [file] = &arguments.files[..] else {
        return several::run(arguments, format);
    };
    let result = match input(file, &arguments.reading)? {
        Input::Tower(tower) => of_tower(&tower, arguments, format)?,
        Input::Blade(blade) => of_blade(&blade, arguments, format)?,
        Input::Substructure(input) => of_substructure(&input, arguments, format)?,
        Input::Mooring(input) => of_mooring(&input, arguments, format)?,
    };
    result.deliver(arguments.destination.output())
}

fn of_tower(
    input: &TowerInput,
    arguments: &SolveArguments,
    format: SolveFormat,
) -> Result<Finished, Failure> {
    check_not_inputs(input.files(), arguments.destination.output())?;
    arguments.reading.check(&[input.format])?;
    let borders_m = input.prescribed.borders_m.clone();
    let has_own_heights = borders_m.is_some();
    arguments.check_heights(format, has_own_heights)?;
    let mut options = arguments.options(input, format)?;
    let tower = input.tower()?;
    let nodes = OutNodes::of_tower(&tower, borders_m, arguments.points(), input.layout);
    if format == SolveFormat::Bmodes {
        options.heights_m = nodes.heights_m();
    }
    let solution = solve(&tower, &options);
    let solution = explained(solution, (&tower, input))?;
    let result = match format {
        SolveFormat::Table => {
            let mut text = table::solution(&tower, &solution);
            if input.turbine.is_some() {
                text += RIGID;
            }
            let draw = |width| shapes(&tower, &solution, width);
            Finished::Text(with_picture(text, draw, arguments))
        }
        SolveFormat::Json if arguments.sensitivities => {
            let influences = influences_of(&input.description, None, &options);
            let influences = explained(influences, (&tower, input))?;
            let of_numbers = (&input.description, &influences);
            let notes = &input.notes;
            Finished::data(|json| {
                write_json_with_sensitivities(&tower, &solution, of_numbers, notes, json)
            })?
        }
        SolveFormat::Json => {
            Finished::data(|json| write_json(&tower, &solution, &input.notes, json))?
        }
        SolveFormat::Csv => Finished::data(|csv| write_csv(&solution, csv))?,
        SolveFormat::Bmodes => Finished::Data(nodes.of_solution(&tower, &solution).into_bytes()),
    };
    note(&input.notes);
    warn(&solution.warnings, input);
    Ok(result)
}

fn of_blade(
    input: &BladeInput,
    arguments: &SolveArguments,
    format: SolveFormat,
) -> Result<Finished, Failure> {
    check_not_inputs(input.files(), arguments.destination.output())?;
    arguments.check_for_blade()?;
    arguments.reading.check(&[FileFormat::Bmodes])?;
    let blade = Blade::new(input.description.clone())?;
    let nodes = OutNodes::of_blade(&blade, input.layout);
    let radii_m = match format {
        SolveFormat::Bmodes => nodes.heights_m(),
        SolveFormat::Table if arguments.plot => nodes.heights_m(),
        _ => nodes.borders_m().to_vec(),
    };
    let modes = arguments.model.modes.unwrap_or(input.modes);
    let of_tip = |warning: &Warning| Note::suspicious(format!("tip body: {warning}"));
    let mut notes = input.notes.clone();
    notes.extend(blade.warnings().iter().map(of_tip));
    let solution = Solver::default()
        .blade(&blade, modes, &radii_m)
        .map_err(|error| {
            note(&notes);
            Failure::from(error)
        })?;
    let result = match format {
        SolveFormat::Table => Finished::Text(blade_text(&blade, &solution, arguments)),
        SolveFormat::Json => {
            Finished::data(|json| write_blade_json(&blade, &solution, &notes, json))?
        }
        SolveFormat::Csv => Finished::data(|csv| write_blade_csv(&solution, csv))?,
        SolveFormat::Bmodes => {
            Finished::Data(nodes.of_blade_solution(&blade, &solution).into_bytes())
        }
    };
    note(&notes);
    note(&coarse(&solution));
    Ok(result)
}

fn of_substructure(
    input: &SubdynInput,
    arguments: &SolveArguments,
    format: SolveFormat,
) -> Result<Finished, Failure> {
    check_not_inputs(input.files(), arguments.destination.output())?;
    arguments.reading.check(&[FileFormat::SubDyn])?;
    arguments.check_for_substructure(format)?;
    let (options, interface) = arguments.for_substructure(input)?;
    let frame = input.frame(interface)?;
    let mut notes = input.notes.clone();
    notes.push(input.note_on_parts());
    notes.extend(input.warnings(&frame));
    let (solution, fewer) = solved_frame(&frame, &options, arguments).map_err(|error| {
        note(&notes);
        Failure::from(error)
    })?;
    let solved = SolvedSubstructure {
        name: &input.title,
        frame: &frame,
        solution: &solution,
    };
    let mut mechanism = solved.mechanism();
    let is_free = interface == Interface::Free && !input.interface_joints.is_empty();
    for warning in mechanism.iter_mut().filter(|_| is_free) {
        warning.message += "; --clamped fixes the interface joints";
    }
    notes.extend(fewer.into_iter().chain(mechanism));
    let result = match format {
        SolveFormat::Table | SolveFormat::Bmodes => Finished::Text(table::substructure(&solved)),
        SolveFormat::Json => Finished::data(|json| write_substructure_json(&solved, &notes, json))?,
        SolveFormat::Csv => Finished::data(|csv| write_substructure_csv(&solved, csv))?,
    };
    note(&notes);
    Ok(result)
}

/// The modes of a frame: the requested number, or the default number as far as the frame has so
/// many modes, with a note if they cannot be resolved.
fn solved_frame(
    frame: &Frame,
    options: &FrameOptions,
    arguments: &SolveArguments,
) -> Result<(FrameSolution, Option<Note>), FrameSolveError> {
    let result = solve_frame(frame, options);
    let (modes, note) = match &result {
        Err(FrameSolveError::Modes { available, .. }) => (*available, None),
        Err(FrameSolveError::Unresolved { resolved, .. }) => {
            let message = format!(
                "the frame has only {resolved} modes that can be resolved: the others have no mass, or are too stiff for double precision"
            );
            (*resolved, Some(Note::new(message)))
        }
        _ => return result.map(|solution| (solution, None)),
    };
    if modes == 0 || arguments.asks_for_modes() {
        return result.map(|solution| (solution, None));
    }
    let options = FrameOptions {
        modes,
        ..options.clone()
    };
    Ok((solve_frame(frame, &options)?, note))
}

fn of_mooring(
    input: &MooringInput,
    arguments: &SolveArguments,
    format: SolveFormat,
) -> Result<Finished, Failure> {
    arguments.reading.check(&[FileFormat::MoorDyn])?;
    arguments.check_for_mooring(format)?;
    let mooring = input.mooring()?;
    let state = input.at_rest(&mooring)?;
    let mut notes = input.notes.clone();
    notes.extend(input.warnings(&mooring, &state));
    let solved = SolvedMooring {
        mooring: &mooring,
        state: &state,
    };
    let result = match format {
        SolveFormat::Table | SolveFormat::Bmodes => Finished::Text(table::mooring(&solved)),
        SolveFormat::Json => Finished::data(|json| write_mooring_json(&solved, &notes, json))?,
        SolveFormat::Csv => Finished::data(|csv| write_mooring_csv(&solved, csv))?,
    };
    note(&notes);
    Ok(result)
}

fn blade_text(blade: &Blade, solution: &BladeSolution, arguments: &SolveArguments) -> String {
    let table = table::blade(blade, solution);
    let draw = |width| blade_shapes(blade, solution, width);
    with_picture(table, draw, arguments)
}

/// A table, with the mode shapes below it if they are requested and the terminal is wide enough.
fn with_picture(
    table: String,
    draw: impl Fn(usize) -> String,
    arguments: &SolveArguments,
) -> String {
    if !arguments.plot {
        return table;
    }
    match draw(terminal::width_of(arguments.destination.output())).as_str() {
        "" => table,
        picture => format!("{table}\n{picture}"),
    }
}

/// A larger relative error gives a note.
const COARSE: f64 = 0.01;

/// A note if the elements of a deck are too few for its modes.
fn coarse(solution: &BladeSolution) -> Vec<Note> {
    let share = |mode: &BladeMode| mode.discretization_error_hz / mode.frequency_hz;
    let coarse: Vec<&BladeMode> = solution
        .modes
        .iter()
        .filter(|m| share(m) > COARSE)
        .collect();
    let Some(first) = coarse.first() else {
        return Vec::new();
    };
    let largest = coarse
        .iter()
        .fold(0.0_f64, |most, mode| most.max(share(mode)));
    vec![Note::suspicious(format!(
        "the {} elements of the deck are too few: the errors are up to {:.1} % (mode {} and {} more); add elements in el_loc",
        solution.elements,
        100.0 * largest,
        first.number,
        coarse.len() - 1
    ))]
}
