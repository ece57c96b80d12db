//! `towermodes campbell`.

mod arguments;
pub(crate) mod coupled;

pub(crate) use arguments::CampbellArguments;

use towermodes::number;
use towermodes::turbine::Turbine;
use towermodes::{Options, Rotor, Solution, Tower};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{
    Assessment, Campbell, CampbellOptions, ChosenRotor, NotChecked, assess, reach_hz,
    solve_to_reach, verdicts_without,
};
use towermodes_analysis::soil_band::{SoilBand, soil_band};
use towermodes_files::{
    FileFormat, Note, NoteKind, RotorNotes, TowerInput, write_campbell_csv, write_campbell_json,
    write_coupled_campbell_csv, write_coupled_campbell_json,
};

use self::coupled::{Coupled, Diagram, coupled_of, diagram_of};
use crate::args::{Destination, Format, InputArguments, RotorArguments};
use crate::failure::Failure;
use crate::progress::{Progress, solve};
use crate::recipe::{Analysis, Answer};
use crate::table;

/// The type of diagram, with its data.
pub(crate) enum Plan {
    /// The diagram of the whole turbine.
    Turbine(Box<Turbine>),
    /// The diagram of the tower with a rigid rotor.
    Tower {
        options: Options,
        /// Why the rotor is rigid, if a user could expect the diagram of the turbine.
        reason: Vec<Note>,
        /// Factors of the stiffness of the soil.
        factors: Option<Vec<f64>>,
    },
}

impl Analysis for CampbellArguments {
    type Plan = Plan;

    fn files(&self) -> (&InputArguments, &Destination) {
        (&self.input, &self.destination)
    }

    fn check(&self, format: Format) -> Result<(), Failure> {
        if self.all && format != Format::Table {
            return Err("--all applies only to the table; JSON and CSV contain all pairs".into());
        }
        if self.soil.is_given() && format == Format::Csv {
            return Err(
                "--soil-factor applies to the table and to JSON; CSV contains the pairs for the soil of the file".into(),
            );
        }
        Ok(())
    }

    fn change(&self, input: &mut TowerInput) -> Result<(), Failure> {
        self.turbine.hold_generator(input);
        Ok(())
    }

    fn plan(&self, input: &mut TowerInput) -> Result<Plan, Failure> {
        match diagram_of(input, &self.turbine, self.is_of_tower_alone())? {
            Diagram::Turbine(turbine) => {
                // Its rotor turns.
                input.notes.retain(|note| note.kind != NoteKind::RigidRotor);
                Ok(Plan::Turbine(turbine))
            }
            Diagram::Tower(reason) => Ok(Plan::Tower {
                reason,
                factors: self.soil.factors(&input.description)?.map(<[f64]>::to_vec),
                options: self.solver.frequencies(input)?,
            }),
        }
    }

    /// Solves the tower or the turbine, and compares its frequencies with the excitations of the
    /// rotor; the exit code is 1 if a pair fails.
    fn answer(
        &self,
        tower: &Tower,
        input: &TowerInput,
        plan: Plan,
        format: Format,
    ) -> Result<Answer, Failure> {
        match plan {
            Plan::Turbine(turbine) => self.of_turbine(tower, input, &turbine, format),
            Plan::Tower {
                mut options,
                reason,
                factors,
            } => {
                let is_given = self.solver.has_modes();
                let solved = solved_to_reach(input, tower, &self.rotor, &mut options, is_given)?;
                let (solution, chosen) = solved;
                let (diagram, of_rotor) =
                    campbell_of(input, (tower, &solution), &chosen, &self.rotor)?;
                // Without verdicts there are only frequencies.
                let rotor = Some(&chosen.rotor).filter(|_| diagram.not_checked.is_empty());
                let factors = factors.filter(|_| format != Format::Csv);
                let of_factors =
                    |factors: Vec<f64>| self.band(input, (&solution, rotor), &options, &factors);
                let band = factors.map(of_factors).transpose()?;
                let answer = self.of_tower(
                    (tower, input),
                    (&solution, &diagram, band.as_ref()),
                    [reason, of_rotor, self.limits(tower, &diagram)].concat(),
                    format,
                )?;
                Ok(answer.verdict(judged(&diagram, input)))
            }
        }
    }
}

impl CampbellArguments {
    /// The notes on what verdicts are without: the weight, unless --no-gravity was given, and the
    /// foundation.
    fn limits(&self, tower: &Tower, campbell: &Campbell) -> Vec<Note> {
        let by_request = self.input.reading.options().without_gravity;
        let limits = verdicts_without(tower, campbell, by_request).into_iter();
        limits.map(Note::suspicious).collect()
    }

    /// The diagram of a tower.
    fn of_tower(
        &self,
        (tower, input): (&Tower, &TowerInput),
        (solution, campbell, band): (&Solution, &Campbell, Option<&SoilBand>),
        notes: Vec<Note>,
        format: Format,
    ) -> Result<Answer, Failure> {
        let all = [input.notes.as_slice(), &notes].concat();
        let text = || {
            let diagram = (campbell, solution.modes.as_slice());
            let text = table::campbell(tower, diagram, input.blade.is_some(), self.all);
            let band = band.map(|band| format!("\n{}", table::soil_band(band)));
            text + &band.unwrap_or_default()
        };
        let warnings = &solution.warnings;
        let answer = Answer::of(
            format,
            text,
            |json| write_campbell_json(tower, campbell, band, &all, warnings, json),
            |csv| write_campbell_csv(campbell, csv),
        )?;
        Ok(answer.notes(notes).warnings(warnings))
    }

    /// The coupled diagram of a turbine.
    fn of_turbine(
        &self,
        tower: &Tower,
        input: &TowerInput,
        turbine: &Turbine,
        format: Format,
    ) -> Result<Answer, Failure> {
        let Coupled {
            diagram,
            against,
            notes,
            warnings,
        } = coupled_of(input, (tower, turbine), &self.rotor, &self.turbine)?;
        let limits = self.limits(tower, &diagram.campbell);
        let notes = [notes, without_band(input), limits].concat();
        let said = input.notes.iter().chain(&notes).map(ToString::to_string);
        let said: Vec<String> = said.collect();
        let answer = Answer::of(
            format,
            || table::coupled_campbell(tower, &diagram, &against, self.all),
            |json| write_coupled_campbell_json(tower, &diagram, &against, &said, json),
            |csv| write_coupled_campbell_csv(&diagram, csv),
        )?;
        let verdict = judged(&diagram.campbell, input);
        Ok(answer.notes(notes).warnings(&warnings).verdict(verdict))
    }

    /// Frequencies and verdicts for these factors of the soil stiffness.
    fn band(
        &self,
        input: &TowerInput,
        (solution, rotor): (&Solution, Option<&Rotor>),
        options: &Options,
        factors: &[f64],
    ) -> Result<SoilBand, Failure> {
        let limits = self.rotor.options();
        let of_rotor = rotor.map(|rotor| (rotor, &limits));
        let band = soil_band(&input.description, solution, factors, of_rotor, |tower| {
            solve(tower, options)
        });
        band.map_err(Failure::failed)
    }
}

/// The note that verdicts for softer and stiffer soil exist only for the diagram with a rigid
/// rotor.
fn without_band(input: &TowerInput) -> Vec<Note> {
    let sentence = "the verdicts apply to the stiffness of soil and foundation in the file; --uncoupled also gives verdicts for half and twice this stiffness, with a rigid rotor";
    let has_soil = input.description.stands_in_soil();
    has_soil
        .then(|| Note::suspicious(sentence.to_owned()))
        .into_iter()
        .collect()
}

/// Solves for the number of modes in the options and, if this number was not given, for as many
/// more as are needed to cover the excitations of the rotor. The rotor is that of the file, with
/// its data replaced by the options of the command line; without operating speeds its speeds are
/// the ends of the diagram.
///
/// # Errors
/// Those of [`solve`].
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
    let mut solver = Progress::of_one().solver(options.clone());
    let solution = match is_given {
        true => solver.solve_certain(tower),
        false => {
            let reach_hz = reach_hz(&chosen.rotor, &arguments.options());
            solve_to_reach(&mut solver, tower, reach_hz)
        }
    };
    options.modes = solver.options.modes;
    Ok((solution?, chosen))
}

/// The Campbell diagram of a solved tower, and of its blade if the files contain one, with its
/// notes.
///
/// # Errors
/// Those of [`assess`].
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
    notes.extend(arguments.note());
    notes.extend(
        remarks
            .iter()
            .map(|remark| Note::suspicious(remark.to_string())),
    );
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

/// The note on an assumed number of blades.
fn assumed_blades(chosen: &ChosenRotor) -> Option<Note> {
    chosen.blades_are_assumed.then(|| {
        Note::suspicious(format!(
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

/// Suggestions for each reason why there are no verdicts.
fn for_verdicts(reasons: &[NotChecked], format: FileFormat) -> String {
    const WHOLE: &str = "give a file that describes the whole structure; `towermodes convert --to toml` writes the data of this file as a tower file, to which you can add the missing parts";
    let speeds = match format {
        FileFormat::Toml => NO_ROTOR,
        _ => "give --rpm LOWEST,HIGHEST",
    };
    let hint = |reason: &NotChecked| match reason {
        NotChecked::PartsMissing(_) => WHOLE,
        NotChecked::SpeedsUnknown => speeds,
        NotChecked::SpeedsImplausible(_) => {
            "give the operating speeds in rpm ([rotor] rpm or --rpm)"
        }
        NotChecked::OutOfBalance(_) => {
            "check masses, displaced volume and mooring lines; the line `static balance` of solve gives weight, buoyancy and mooring force"
        }
    };
    match reasons {
        // The tower file to add to is the last.
        [NotChecked::SpeedsUnknown, NotChecked::PartsMissing(_)] => {
            format!("{WHOLE}; the operating speeds are also needed: {speeds}")
        }
        reasons => reasons.iter().map(hint).collect::<Vec<_>>().join("; "),
    }
}

/// The rotor data of a tower file, or the option that replaces them.
const NO_ROTOR: &str = "give --rpm LOWEST,HIGHEST, or add to the tower file:
  [rotor]
  blades = 3
  rpm = [6.9, 12.1]  # lowest and highest operating speed";
