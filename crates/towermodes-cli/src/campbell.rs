//! `towermodes campbell`.

pub(crate) mod coupled;

use towermodes::number;
use towermodes::turbine::Turbine;
use towermodes::{Options, Rotor, Solution, Tower};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{
    Assessment, Campbell, CampbellOptions, ChosenRotor, NotChecked, assess, reach_hz,
    solve_to_reach,
};
use towermodes_analysis::soil_band::{SoilBand, soil_band};
use towermodes_files::{
    FileFormat, Note, NoteKind, RotorNotes, TowerInput, write_campbell_csv, write_campbell_json,
    write_coupled_campbell_csv, write_coupled_campbell_json,
};

use self::coupled::{Answer, Coupled, answer_of, coupled_of};
use crate::args::{CampbellArguments, Format, Prescribed, RotorArguments};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, deliver};
use crate::progress::solve;
use crate::table;

/// Reads and solves the tower, and compares its frequencies with the excitations of the rotor; the
/// exit code is 1 if a pair fails.
pub(crate) fn run(arguments: &CampbellArguments) -> Result<(), Failure> {
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format()?;
    arguments.check(format)?;
    let mut input = tower_input(&arguments.input)?;
    arguments.turbine.hold_generator(&mut input);
    check_not_inputs(input.files(), output)?;
    let tower = input.tower()?;
    let reason = match answer_of(&input, &arguments.turbine, arguments.is_of_tower_alone())? {
        Answer::Turbine(turbine) => {
            return run_coupled(arguments, format, input, (&tower, &turbine));
        }
        Answer::Tower(reason) => reason,
    };
    let factors = arguments.soil.factors(&input.description)?;
    let prescribed = Prescribed::of(&mut input);
    let mut options = arguments.options(prescribed)?;
    let is_given = arguments.has_modes();
    let solved = solved_to_reach(&input, &tower, &arguments.rotor, &mut options, is_given);
    let (solution, chosen) = explained(solved, (&tower, &input))?;
    let compared = campbell_of(&input, (&tower, &solution), &chosen, &arguments.rotor);
    let (campbell, rotor_notes) = explained(compared, (&tower, &input))?;
    let band = match format {
        Format::Csv => None,
        Format::Table | Format::Json => {
            // Without verdicts there are only frequencies.
            let rotor = Some(&chosen.rotor).filter(|_| campbell.not_checked.is_empty());
            let of_factors =
                |factors| band(&input, (&solution, rotor), &options, arguments, factors);
            factors.map(of_factors).transpose()?
        }
    };
    let notes = [std::mem::take(&mut input.notes), reason, rotor_notes].concat();
    let mut result = Vec::new();
    match format {
        Format::Table => {
            let has_blade = input.blade.is_some();
            let text = table::campbell(
                &tower,
                (&campbell, &solution.modes),
                has_blade,
                arguments.all,
            );
            result.extend(text.into_bytes());
            let band = band.iter().map(table::soil_band);
            result.extend(band.flat_map(|text| format!("\n{text}").into_bytes()));
        }
        Format::Json => {
            write_campbell_json(
                &tower,
                &campbell,
                band.as_ref(),
                &notes,
                &solution.warnings,
                &mut result,
            )?;
        }
        Format::Csv => write_campbell_csv(&campbell, &mut result)?,
    }
    note(&notes);
    warn(&solution.warnings, &input);
    deliver(&result, output)?;
    judged(&campbell, &input)
}

/// The coupled diagram of a turbine; the exit code is 1 if a pair fails.
fn run_coupled(
    arguments: &CampbellArguments,
    format: Format,
    mut input: TowerInput,
    (tower, turbine): (&Tower, &Turbine),
) -> Result<(), Failure> {
    let solved = coupled_of(
        &input,
        (tower, turbine),
        &arguments.rotor,
        &arguments.turbine,
    );
    let solved = explained(solved, (tower, &input))?;
    let Coupled {
        diagram,
        against,
        notes,
        warnings,
    } = solved;
    // Its rotor turns.
    input.notes.retain(|note| note.kind != NoteKind::RigidRotor);
    let notes = [
        std::mem::take(&mut input.notes),
        notes,
        without_band(&input),
    ]
    .concat();
    let mut result = Vec::new();
    match format {
        Format::Table => {
            let text = table::coupled_campbell(tower, &diagram, &against, arguments.all);
            result.extend(text.into_bytes());
        }
        Format::Json => {
            let said: Vec<String> = notes.iter().map(ToString::to_string).collect();
            write_coupled_campbell_json(tower, &diagram, &against, &said, &mut result)?;
        }
        Format::Csv => write_coupled_campbell_csv(&diagram, &mut result)?,
    }
    note(&notes);
    warn(&warnings, &input);
    deliver(&result, arguments.destination.output())?;
    judged(&diagram.campbell, &input)
}

/// That verdicts for softer and stiffer soil are those of the other diagram.
fn without_band(input: &TowerInput) -> Vec<Note> {
    let sentence = "the verdicts are for the soil and the foundation of the file; --uncoupled gives those for half and twice their stiffness, with a rigid rotor";
    let has_soil = input.description.stands_in_soil();
    has_soil
        .then(|| Note::new(sentence.to_owned()))
        .into_iter()
        .collect()
}

/// Frequencies and verdicts for these factors of the stiffness of the soil.
fn band(
    input: &TowerInput,
    (solution, rotor): (&Solution, Option<&Rotor>),
    options: &Options,
    arguments: &CampbellArguments,
    factors: &[f64],
) -> Result<SoilBand, Failure> {
    let limits = arguments.rotor.options();
    let of_rotor = rotor.map(|rotor| (rotor, &limits));
    let band = soil_band(&input.description, solution, factors, of_rotor, |tower| {
        solve(tower, options)
    });
    band.map_err(Failure::failed)
}

/// Solves for the modes that the options ask for and, if no number was given, for as many more as
/// the excitations of the rotor reach. The rotor is that of the file, with the options of the
/// command line in place of its data; without operating speeds it has the ends of the diagram.
///
/// # Errors
/// Of [`solve`].
pub(crate) fn solved_to_reach(
    input: &TowerInput,
    tower: &Tower,
    arguments: &RotorArguments,
    options: &mut Options,
    is_given: bool,
) -> Result<(Solution, ChosenRotor), Failure> {
    let chosen = match arguments.rotor(input) {
        Some(chosen) => chosen,
        None => {
            let solution = solve(tower, options)?;
            let given = arguments.given();
            given.without_speeds(input.blades, &solution, input.tip_radius_m())
        }
    };
    let solution = match is_given {
        true => solve(tower, options),
        false => {
            let reach_hz = reach_hz(&chosen.rotor, &arguments.options());
            solve_to_reach(options, reach_hz, |options| solve(tower, options))
        }
    };
    Ok((solution?, chosen))
}

/// The Campbell diagram of a solved tower, and of its blade if the files have one, with the notes
/// on it.
///
/// # Errors
/// Of [`assess`].
pub(crate) fn campbell_of(
    input: &TowerInput,
    (tower, solution): (&Tower, &Solution),
    chosen: &ChosenRotor,
    arguments: &RotorArguments,
) -> Result<(Campbell, Vec<Note>), Failure> {
    let blade = input.blade.as_ref();
    let options = CampbellOptions {
        speeds_are_known: chosen.speeds_are_known,
        ..arguments.options()
    };
    let assessment = assess(tower, solution, blade, &chosen.rotor, &options);
    let Assessment { campbell, remarks } = assessment?;
    let mut notes = notes_on(input, chosen);
    notes.extend(remarks.iter().map(|remark| Note::new(remark.to_string())));
    Ok((campbell, notes))
}

/// The notes of the reader and the program about the rotor.
pub(crate) fn notes_on(input: &TowerInput, chosen: &ChosenRotor) -> Vec<Note> {
    let RotorNotes {
        speeds,
        blades,
        others,
    } = &input.rotor_notes;
    let speeds = speeds.iter().filter(|_| !chosen.speeds_are_given);
    let blades = blades.iter().filter(|_| !chosen.blades_are_given);
    let notes = speeds.chain(blades).chain(others).cloned();
    notes.chain(assumed_blades(chosen)).collect()
}

/// The note on a number of blades that nobody gave.
fn assumed_blades(chosen: &ChosenRotor) -> Option<Note> {
    chosen.blades_are_assumed.then(|| {
        Note::new(format!(
            "the number of blades is not given; {} are assumed; --blades sets another number",
            chosen.rotor.blades
        ))
    })
}

/// An error if a pair fails, or if nothing is checked.
fn judged(campbell: &Campbell, input: &TowerInput) -> Result<(), Failure> {
    if !campbell.not_checked.is_empty() {
        let reasons: Vec<String> = campbell
            .not_checked
            .iter()
            .map(ToString::to_string)
            .collect();
        let hint = for_verdicts(&campbell.not_checked, input.format);
        return Err(Failure::failed(format!("not checked: {}", reasons.join("; "))).hint_of(hint));
    }
    let margins = campbell.margins.iter();
    match margins
        .filter(|margin| margin.verdict == Verdict::Fail)
        .count()
    {
        0 => Ok(()),
        failures => Err(Failure::failed(format!(
            "{} within the {} % margin in operation",
            pairs(failures), number::percent(campbell.margin)
        ))
        .hint("see the lines with FAIL above; change the operating speeds ([rotor] rpm or --rpm), the stiffness of the tower or the RNA mass")),
    }
}

/// "1 pair of excitation and natural frequency is".
fn pairs(count: usize) -> String {
    match count {
        1 => "1 pair of excitation and natural frequency is".to_owned(),
        n => format!("{n} pairs of excitation and natural frequency are"),
    }
}

/// What is needed for verdicts, for each reason why there are none.
fn for_verdicts(reasons: &[NotChecked], format: FileFormat) -> String {
    const WHOLE: &str = "a file with the whole structure gives verdicts; --to toml of convert writes what was read as a tower file, to which the missing parts can be added";
    let speeds = match format {
        FileFormat::Toml => NO_ROTOR,
        _ => "give --rpm LOWEST,HIGHEST",
    };
    match reasons {
        [NotChecked::PartsMissing(_)] => WHOLE.to_owned(),
        [NotChecked::SpeedsUnknown] => speeds.to_owned(),
        _ => format!("{WHOLE}; the operating speeds are needed too: {speeds}"),
    }
}

/// The rotor data of a tower file, or the option in their place.
const NO_ROTOR: &str = "give --rpm LOWEST,HIGHEST, or add to the tower file:
  [rotor]
  blades = 3
  rpm = [6.9, 12.1]  # lowest and highest operating speed";
