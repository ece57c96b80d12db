//! `towermodes campbell`.

use towermodes::number::four_digits;
use towermodes::tower::Rpm;
use towermodes::{Options, Solution, Tower};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{Campbell, CampbellError, FrequencyLine, campbell, reach_hz};
use towermodes_files::{Note, RotorNotes, TowerInput, write_campbell_csv, write_campbell_json};

use crate::args::{CampbellArguments, ChosenRotor, Format, Prescribed, RotorArguments};
use crate::failure::{Failure, note, warn};
use crate::input::tower_input;
use crate::output::{check_not_input, check_not_inputs, deliver};
use crate::progress::solve;
use crate::table;

/// How many modes are looked for, if nobody says, to come as high as the rotor's excitations.
const MOST_MODES: usize = 40;

/// Reads the tower, solves it, sets its frequencies against the rotor's excitations; a pair that
/// fails is exit code 1.
pub(crate) fn run(arguments: &CampbellArguments) -> Result<(), Failure> {
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format().map_err(Failure::Ending)?;
    arguments.check(format).map_err(Failure::Usage)?;
    let mut input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower().map_err(Failure::Input)?;
    // Said before a long solve.
    rotor_of(&input, &arguments.rotor)?;
    let prescribed = Prescribed::of(&mut input);
    let mut options = arguments.options(prescribed).map_err(Failure::Usage)?;
    let is_given = arguments.has_modes();
    let solution = solve_to_reach(&input, &tower, &arguments.rotor, &mut options, is_given)?;
    let (campbell, rotor_notes) = campbell_of(&input, &tower, &solution, &arguments.rotor)?;
    let notes = [std::mem::take(&mut input.notes), rotor_notes].concat();
    let mut result = Vec::new();
    match format {
        Format::Table => {
            result.extend(
                table::campbell(&tower, &campbell, input.blade.is_some(), arguments.all)
                    .into_bytes(),
            );
        }
        Format::Json => {
            write_campbell_json(&tower, &campbell, &notes, &solution.warnings, &mut result)?;
        }
        Format::Csv => write_campbell_csv(&campbell, &mut result)?,
    }
    note(&notes);
    warn(&solution.warnings, &input);
    deliver(&result, output)?;
    judged(&campbell)
}

/// Solves for the modes that the options ask for and, if nobody gave a number, for as many more as
/// the rotor's excitations reach.
///
/// # Errors
/// [`Failure::Unsolved`].
pub(crate) fn solve_to_reach(
    input: &TowerInput,
    tower: &Tower,
    arguments: &RotorArguments,
    options: &mut Options,
    is_given: bool,
) -> Result<Solution, Failure> {
    let mut solution = solve(tower, options).map_err(Failure::Unsolved)?;
    let Some(chosen) = arguments.rotor(input.description.rotor, input.blades) else {
        return Ok(solution);
    };
    let reach_hz = reach_hz(&chosen.rotor, &arguments.options());
    while !is_given && solution.certificate.below_hz < reach_hz && options.modes < MOST_MODES {
        let modes = (2 * options.modes).min(MOST_MODES);
        options.modes = modes.min(solution.degrees_of_freedom);
        if options.modes <= solution.modes.len() {
            break;
        }
        solution = solve(tower, options).map_err(Failure::Unsolved)?;
    }
    Ok(solution)
}

/// The rotor of the file, or of the command line.
pub(crate) fn rotor_of(
    input: &TowerInput,
    arguments: &RotorArguments,
) -> Result<ChosenRotor, Failure> {
    let rotor = arguments.rotor(input.description.rotor, input.blades);
    rotor.ok_or(Failure::NoRotor {
        format: input.format,
    })
}

/// The natural frequencies of a solved tower, and of its blade if the files have one, against the
/// rotor's excitations; with what the user should know of the rotor. A blade that has no modes at
/// one of the speeds is left out with a note: the tower's margins are as good.
///
/// # Errors
/// [`Failure::NoRotor`] if neither the file nor the command line says how fast the rotor runs;
/// [`Failure::Campbell`].
pub(crate) fn campbell_of(
    input: &TowerInput,
    tower: &Tower,
    solution: &Solution,
    arguments: &RotorArguments,
) -> Result<(Campbell, Vec<Note>), Failure> {
    let chosen = rotor_of(input, arguments)?;
    let options = arguments.options();
    let mut notes = notes_on(input, &chosen);
    let warnings = tower.rotor_warnings(&chosen.rotor);
    notes.extend(
        warnings
            .iter()
            .map(|warning| Note::new(warning.to_string())),
    );
    let diagram = |blade| campbell(tower, solution, blade, &chosen.rotor, &options);
    let campbell = match diagram(input.blade.as_ref()) {
        Err(error @ (CampbellError::Blade { .. } | CampbellError::NoBlade(_))) => {
            let message = format!("the modes of the blade are left out: {error}");
            notes.push(Note::new(message));
            diagram(None)
        }
        other => other,
    };
    let campbell = campbell.map_err(Failure::Campbell)?;
    let lost = |line| lost_note(line, chosen.rotor.lowest_rpm, chosen.rotor.highest_rpm);
    notes.extend(campbell.lines.iter().filter_map(lost));
    notes.extend(unjudged(&campbell));
    Ok((campbell, notes))
}

/// Excitations that reach higher than the modes that are known.
fn unjudged(campbell: &Campbell) -> Option<Note> {
    let [known_hz, reach_hz] = campbell.unjudged_hz()?;
    Some(Note::new(format!(
        "the list of modes ends at {} Hz and excitations count up to {} Hz: modes between these are not judged (--modes)",
        four_digits(known_hz),
        four_digits(reach_hz)
    )))
}

/// What the reader and the program decided of the rotor.
fn notes_on(input: &TowerInput, chosen: &ChosenRotor) -> Vec<Note> {
    let RotorNotes {
        speeds,
        blades,
        others,
    } = &input.rotor_notes;
    let speeds = speeds.iter().filter(|_| !chosen.speeds_are_given);
    let blades = blades.iter().filter(|_| !chosen.blades_are_given);
    let assumed = chosen.blades_are_assumed.then(|| {
        Note::new(format!(
            "nobody says how many blades the rotor has; {} are assumed (--blades)",
            chosen.rotor.blades
        ))
    });
    let notes = speeds.chain(blades).chain(others).cloned();
    notes.chain(assumed).collect()
}

/// That a mode of a blade was lost, and what that does to its margins.
fn lost_note(line: &FrequencyLine, lowest_rpm: f64, highest_rpm: f64) -> Option<Note> {
    let end = line.lost?;
    let [last_rpm, _] = *line.points.last()?;
    let margins = if last_rpm < lowest_rpm {
        "there are no margins of it"
    } else if last_rpm < highest_rpm {
        "its margins are those of the speeds before, and none passes"
    } else {
        "that is beyond operation, and its margins hold"
    };
    Some(Note::new(format!(
        "{} is lost: at {} rpm no mode is like it (the one left for it has a modal assurance criterion of {:.2}), so its line ends at {} rpm; {margins}",
        line.label,
        Rpm(end.rotor_speed_rpm),
        end.alike,
        Rpm(last_rpm)
    )))
}

/// Whether the rotor may run as it does.
fn judged(campbell: &Campbell) -> Result<(), Failure> {
    let fails = |verdict: &Verdict| *verdict == Verdict::Fail;
    let verdicts = campbell.margins.iter().map(|margin| margin.verdict);
    match verdicts.filter(fails).count() {
        0 => Ok(()),
        failures => Err(Failure::Resonant {
            failures,
            margin: campbell.margin,
        }),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;
    use towermodes::{BladeDescription, BladeFamily, BladeSection};
    use towermodes_analysis::resonance::{Excited, FrequencyLine, LineEnd};

    use super::{campbell_of, lost_note};
    use crate::args::{Arguments, Command, Prescribed};
    use crate::input::tower_input;
    use crate::progress::solve;

    /// i_f > i_e, and soft in torsion: the propeller moment turns it over where it turns fast
    /// enough.
    fn unstable_blade() -> BladeDescription {
        let root = BladeSection {
            mass_kg_per_m: 1.0,
            flap_inertia_kg_m: 1e-2,
            edge_inertia_kg_m: 1e-6,
            flap_n_m2: 1.0,
            edge_n_m2: 1.5,
            torsion_n_m2: 1e-4,
            axial_n: 1e7,
            ..BladeSection::default()
        };
        let tip = BladeSection { span: 1.0, ..root };
        BladeDescription {
            tip_radius_m: 1.0,
            sections: vec![root, tip],
            borders: vec![0.0, 0.25, 0.5, 0.75, 1.0],
            tip_is_pulled: true,
            ..BladeDescription::default()
        }
    }

    /// A blade that turns over, and one that is none, take nothing from the tower's margins.
    #[test]
    fn a_blade_without_modes_leaves_the_tower() {
        let file = "../../examples/nrel-5mw.toml";
        let line = [
            "towermodes",
            "campbell",
            file,
            "--rpm",
            "90",
            "--modes",
            "2",
        ];
        let Command::Campbell(arguments) = Arguments::parse_from(line).command else {
            panic!("another command");
        };
        let mut input = tower_input(&arguments.input).expect("a tower");
        let tower = input.tower().expect("a tower");
        let prescribed = Prescribed::of(&mut input);
        let options = arguments.options(prescribed).expect("options");
        let solution = solve(&tower, &options).expect("modes");
        let mut of_blade = |blade: Option<BladeDescription>| {
            input.blade = blade;
            campbell_of(&input, &tower, &solution, &arguments.rotor).expect("a diagram")
        };
        let (without, notes) = of_blade(None);
        assert_eq!(
            (without.lines.len(), without.margins.len(), notes.len()),
            (2, 8, 1)
        );
        // Two modes are fewer than 90 rpm excite.
        assert!(notes[0].to_string().contains("are not judged"));
        let backwards = BladeDescription {
            hub_radius_m: 2.0,
            ..unstable_blade()
        };
        for (blade, why) in [
            (unstable_blade(), "the blade at "),
            (backwards, "the blade: "),
        ] {
            let (campbell, notes) = of_blade(Some(blade));
            assert_eq!(campbell, without);
            assert_eq!(notes.len(), 2, "{notes:?}");
            let said = notes[0].to_string();
            let expected = format!("the modes of the blade are left out: {why}");
            assert!(said.starts_with(&expected), "{said}");
        }
    }

    #[test]
    fn a_lost_mode_is_said_with_its_numbers() {
        let (family, order) = (BladeFamily::Flap, 2);
        let line = FrequencyLine {
            of: Excited::Blade { family, order },
            label: "blade 2nd flap".to_owned(),
            points: vec![[0.0, 1.0], [9.5, 1.5]],
            error_hz: 0.0,
            lost: Some(LineEnd {
                rotor_speed_rpm: 10.0,
                alike: 0.125,
            }),
        };
        let said = |lowest_rpm: f64, highest_rpm: f64| {
            let note = lost_note(&line, lowest_rpm, highest_rpm).expect("a note");
            note.to_string()
        };
        let text = said(5.0, 12.0);
        assert_eq!(
            text,
            "blade 2nd flap is lost: at 10 rpm no mode is like it (the one left for it has a modal assurance criterion of 0.12), so its line \
             ends at 9.5 rpm; its margins are those of the speeds before, and none passes"
        );
        assert!(said(9.8, 12.0).ends_with("there are no margins of it"));
        assert!(said(5.0, 9.0).ends_with("its margins hold"));
        let whole = FrequencyLine { lost: None, ..line };
        assert_eq!(lost_note(&whole, 5.0, 12.0), None);
    }
}
