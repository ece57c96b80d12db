//! `towermodes design`.

use std::path::PathBuf;

use clap::Args;
use towermodes::TowerDescription;
use towermodes_design::design::{Design, DesignError, design};
use towermodes_files::{DesignStudy, read_design_study, write_design_json};
use towermodes_report::figures::{self, DesignedMode};
use towermodes_report::svg::Figure;

use super::plot::deliver_picture;
use crate::args::{FoundArguments, InputArguments, PictureFile, TextFormat};
use crate::failure::Failure;
use crate::found::{check_output, study_source, write_tower};
use crate::input::tower_input;
use crate::messages::{note, warn, warn_texts};
use crate::output::{Finished, check_not_input, check_not_inputs, check_place};
use crate::progress::searching;
use crate::studies::design::{StudyError, document, located, options, problem, warnings};
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes design tower.toml design.toml
  towermodes design tower.toml design.toml --output lighter.toml
  towermodes design tower.toml design.toml --format json
  towermodes design tower.toml design.toml --plot before-after.svg

A design file is a TOML file with [design]; for example:
  [design.variables]
  \"stations[*].wall\" = { between = [0.012, 0.060], each = \"can\", order = \"falling\", step = 0.001 }
  \"scale(stations[*].diameter)\" = { between = [0.8, 1.2] }

  [design.frequencies]
  \"fore-aft 1\" = { between = \"1P-3P\", margin = 0.1 }
  \"side-side 1\" = { min = 0.25 }

  [design.limits]
  diameter_to_wall = 200
  cone_angle = 3

The margins of a design file are fractions: 0.1 is 10 % of the frequency. (--margin of `campbell` and `report` is in percent.)

The search starts from the original tower, uses exact derivatives and ends at a local minimum of the mass; its KKT residual is printed as a check (0 at an exact minimum). The final tower is solved again with error estimates. If no tower is found that meets the limits, the message gives the nearest one. `towermodes parameters FILE` lists the names of the input values.

Exit codes: 0 the tower is found, 1 no tower is found that meets the limits, the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `design`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct DesignArguments {
    #[command(flatten)]
    input: InputArguments,

    /// Design file: a TOML file with the design variables, frequency targets and limits ([design])
    study: PathBuf,

    #[command(flatten)]
    found: FoundArguments,

    /// Draw the tower before and after, with the target bands of its frequencies (.svg or .png)
    #[arg(long, value_name = "PATH")]
    plot: Option<PathBuf>,
}

/// Finds the tower of a design file, and writes it.
pub(crate) fn run(arguments: &DesignArguments) -> Result<(), Failure> {
    check_output(&arguments.found, &arguments.input, &arguments.study)?;
    let picture = PictureFile::requested(arguments.plot.as_deref())?;
    let written = [arguments.found.output(), picture.map(|(path, _)| path)];
    if let [_, Some(path)] = written {
        check_not_input(&arguments.input.file, Some(path))?;
        check_not_input(&arguments.study, Some(path))?;
        check_place(path)?;
    }
    let study = study_source(&arguments.study, &arguments.input)?;
    let study = read_design_study(&study)?;
    let input = tower_input(&arguments.input)?;
    for output in written {
        check_not_inputs(input.files(), output)?;
    }
    let tower = input.tower()?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    let problem = problem(&study, &input).map_err(refused)?;
    let options = options(&study, &input);
    let (mut solver, line) = searching(options);
    let found = design(&input.description, &problem, &mut solver);
    drop(line);
    let found = found.map_err(|error| failure(error, &study, &input.description))?;
    let warnings = warnings(&found);
    let result = match arguments.found.format {
        TextFormat::Json => {
            let document = document(&input, &problem, &found, &warnings);
            Finished::data(|json| write_design_json(&document, json))?
        }
        TextFormat::Table => {
            Finished::Text(table::design(&input.description.name, &problem, &found))
        }
    };
    warn_texts(&warnings);
    if let Some(file) = picture {
        deliver_picture(figure(&input.description, &found), &tower, file)?;
    }
    if let Some(output) = arguments.found.output() {
        write_tower(&input, &found.tower, output)?;
    }
    result.deliver(None)
}

/// The tower before and after.
fn figure(before: &TowerDescription, found: &Design) -> Figure {
    let labels = found.reached.iter().map(|of| of.goal.mode.label());
    let labels: Vec<String> = labels.collect();
    let modes = found.reached.iter().zip(&labels);
    let modes = modes.map(|(of, label)| DesignedMode {
        label,
        band_hz: [of.goal.min_hz, of.goal.max_hz],
        before_hz: of.before_hz,
        after_hz: of.after_hz,
    });
    let modes: Vec<DesignedMode<'_>> = modes.collect();
    figures::design([before, &found.tower], found.mass_kg, &modes)
}

fn refused(error: StudyError) -> Failure {
    match error {
        StudyError::Input(error) | StudyError::Window(error) => Failure::from(error),
        StudyError::NoRotorSpeeds => Failure::usage(
            "the design file uses multiples of the rotor speed, but the tower file has no [rotor] rpm",
        )
        .hint(ROTOR),
    }
}

/// The rotor data of a tower file; there is no option for them.
const ROTOR: &str = "add to the tower file:
  [rotor]
  blades = 3
  rpm = [6.9, 12.1]  # lowest and highest operating speed";

/// Adds the line of the design file to an error that such a line explains.
fn failure(error: DesignError, study: &DesignStudy, tower: &TowerDescription) -> Failure {
    match (located(&error, study, tower), &error) {
        (Some(place), DesignError::NoDerivative { .. }) => Failure::unreached(place),
        (Some(place), _) => Failure::from(place),
        (None, _) => Failure::from(error),
    }
}
