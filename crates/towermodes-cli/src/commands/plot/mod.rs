//! `towermodes plot`.

mod arguments;
mod soil;
mod study;

pub(crate) use arguments::PlotArguments;

use std::path::Path;

use towermodes::turbine::Turbine;
use towermodes::{Options, Solution, Tower, TowerDescription, Warning};
use towermodes_files::{Note, NoteKind, TowerInput};
use towermodes_report::figures::{TitleWords, titled};
use towermodes_report::svg::{Figure, Look, Theme};
use towermodes_report::wording::computed_by;
use towermodes_report::{figures, raster};

use self::arguments::{PictureFormat, What};
use super::campbell::coupled::{Coupled, Diagram, coupled_of, diagram_of};
use super::campbell::{campbell_of, solved_to_reach};
use crate::args::PictureFile;
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, check_terminal, deliver_bytes};
use crate::progress::solve;

/// Reads the tower, solves it if necessary, and writes the picture as SVG or PNG.
pub(crate) fn run(arguments: &PlotArguments) -> Result<(), Failure> {
    arguments.check()?;
    let format = arguments.format()?;
    let output = arguments.output();
    let (what, example) = match format {
        PictureFormat::Svg(..) => ("an SVG", "picture.svg"),
        PictureFormat::Png(..) => ("a PNG", "picture.png"),
    };
    check_terminal(arguments.asked_output(), what, example)?;
    check_not_input(&arguments.input.file, output)?;
    let mut input = tower_input(&arguments.input)?;
    arguments.turbine.hold_generator(&mut input);
    check_not_inputs(input.files(), output)?;
    let tower = input.tower()?;
    let drawn = drawn(&mut input, &tower, arguments);
    let drawn = explained(drawn, (&tower, &input))?;
    let (notes, warnings) = (drawn.notes, drawn.warnings);
    let words = TitleWords {
        title: arguments.title.as_deref(),
        computed: drawn.computed.as_deref(),
        conclusion: &drawn.conclusion,
    };
    let figure = titled(drawn.figure, &tower, &words);
    let picture = match format {
        PictureFormat::Svg(look) => figure.to_svg(look).into_bytes(),
        PictureFormat::Png(theme, scale) => raster::png(&figure, theme, scale)?,
    };
    note(&input.notes);
    note(&notes);
    warn(&warnings, &input);
    deliver_bytes(&picture, output)
}

/// Writes the picture that a command draws in addition to its result, with the name of the tower
/// above it.
pub(crate) fn deliver_picture(
    figure: Figure,
    tower: &Tower,
    (path, format): (&Path, PictureFile),
) -> Result<(), Failure> {
    let words = TitleWords {
        title: None,
        computed: None,
        conclusion: &[],
    };
    let figure = titled(figure, tower, &words);
    let picture = match format {
        PictureFile::Svg => figure.to_svg(Look::Standalone).into_bytes(),
        PictureFile::Png => raster::png(&figure, Theme::Light, 2.0)?,
    };
    deliver_bytes(&picture, Some(path))
}

/// A picture with its notes and warnings.
struct Drawn {
    figure: Figure,
    /// The method: "rmje-exact, 100 segments".
    computed: Option<String>,
    /// The conclusion in sentences.
    conclusion: Vec<String>,
    notes: Vec<Note>,
    warnings: Vec<Warning>,
}

impl Drawn {
    fn new(figure: Figure, warnings: &[Warning]) -> Self {
        Self {
            figure,
            computed: None,
            conclusion: Vec::new(),
            notes: Vec::new(),
            warnings: warnings.to_vec(),
        }
    }

    fn computed(self, how: String) -> Self {
        let computed = Some(how);
        Self { computed, ..self }
    }
}

fn drawn(
    input: &mut TowerInput,
    tower: &Tower,
    arguments: &PlotArguments,
) -> Result<Drawn, Failure> {
    match arguments.what {
        What::Tower => {
            let figure = figures::tower(&input.description, tower);
            Ok(Drawn::new(figure, tower.warnings()))
        }
        What::Shapes => solved(input, tower, arguments, figures::shapes),
        What::Structure => solved(input, tower, arguments, figures::structure),
        What::Campbell => campbell(input, tower, arguments),
        What::Convergence => study::convergence(tower, arguments),
        What::Error => study::error(tower, arguments),
        What::Soil => soil::stiffness(input, tower, arguments),
        What::Scour => soil::scour(input, tower, arguments),
    }
}

fn options(input: &TowerInput, arguments: &PlotArguments) -> Result<Options, Failure> {
    arguments.options(input).map_err(Failure::from)
}

/// A picture of the modes of a tower.
fn solved(
    input: &TowerInput,
    tower: &Tower,
    arguments: &PlotArguments,
    picture: impl Fn(&TowerDescription, &Tower, &Solution) -> Figure,
) -> Result<Drawn, Failure> {
    let options = options(input, arguments)?;
    let solution = solve(tower, &options)?;
    let figure = picture(&input.description, tower, &solution);
    Ok(Drawn::new(figure, &solution.warnings).computed(computed_by(&solution)))
}

fn campbell(
    input: &mut TowerInput,
    tower: &Tower,
    arguments: &PlotArguments,
) -> Result<Drawn, Failure> {
    let reason = match diagram_of(input, &arguments.turbine, arguments.is_of_tower_alone())? {
        Diagram::Turbine(turbine) => {
            // Its rotor turns.
            input.notes.retain(|note| note.kind != NoteKind::RigidRotor);
            return coupled(input, (tower, &turbine), arguments);
        }
        Diagram::Tower(reason) => reason,
    };
    let mut options = options(input, arguments)?;
    let is_given = arguments.has_modes();
    let rotor = &arguments.rotor;
    let (solution, chosen) = solved_to_reach(input, tower, rotor, &mut options, is_given)?;
    let (campbell, mut notes) = campbell_of(input, (tower, &solution), &chosen, rotor)?;
    notes.extend(reason);
    let drawn = Drawn::new(figures::campbell(&campbell), &solution.warnings);
    Ok(Drawn {
        notes,
        conclusion: campbell.conclusion(),
        ..drawn.computed(computed_by(&solution))
    })
}

/// The diagram of a turbine with flexible blades.
fn coupled(
    input: &TowerInput,
    (tower, turbine): (&Tower, &Turbine),
    arguments: &PlotArguments,
) -> Result<Drawn, Failure> {
    let solved = coupled_of(
        input,
        (tower, turbine),
        &arguments.rotor,
        &arguments.turbine,
    )?;
    let Coupled { diagram, notes, .. } = solved;
    let drawn = Drawn::new(figures::coupled_campbell(&diagram), &[]);
    let how = format!("coupled modes at {} rotor speeds", diagram.speeds.len());
    Ok(Drawn {
        notes,
        conclusion: diagram.campbell.conclusion(),
        ..drawn.computed(how)
    })
}
