//! `towermodes explore`.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::Instant;

use clap::Args;
use towermodes::Options;
use towermodes_explore::server::Server;
use towermodes_explore::{Exploration, Explorer, POINTS, Reporter, State};
use towermodes_files::TowerInput;

use super::report::page_of;
use crate::args::{
    InputArguments, ReadingArguments, RotorArguments, SolverArguments, up_to_excitations,
};
use crate::failure::Failure;
use crate::input::{input_of, set_numbers};
use crate::messages::{hear, note, warn};
use crate::output::deliver;

const EXAMPLES: &str = "Examples:
  towermodes explore examples/monopile.toml
  towermodes explore turbine.yaml --part tower --rpm 5,7.56
  towermodes explore examples/nrel-5mw.toml --set rna.mass=360000
  towermodes explore examples/monopile.toml --against examples/monopile-layers.toml

The program opens a page in the browser and serves it until Ctrl-C ends it. On the page, input values are changed with sliders, and the tower is solved again after each change; the file is not changed. The page starts with the values of --set; they can be reset to the values of the file.

Only this machine can open the page, and only with the secret token in the printed address. The page needs no network.

Exit codes: 1 the port is taken, or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `explore`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("modes", up_to_excitations))]
pub(crate) struct ExploreArguments {
    #[command(flatten)]
    input: InputArguments,

    #[command(flatten)]
    solver: SolverArguments,

    #[command(flatten)]
    rotor: RotorArguments,

    /// Another tower, of a file in any format, shown beside this one and in the diagram: the page
    /// lists the differences of all results
    #[arg(long, value_name = "FILE")]
    against: Option<PathBuf>,

    /// Port on this machine [default: any free port]
    #[arg(long, value_name = "PORT")]
    port: Option<u16>,

    /// Print the address of the page without opening it in the browser
    #[arg(long)]
    no_open: bool,
}

/// Reads the tower, opens the page, and serves it until the program is ended.
pub(crate) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let given = &arguments.input.reading;
    let file = unchanged(&arguments.input.file, given)?;
    let against = arguments.against.as_ref();
    let against = against.map(|path| unchanged(path, given)).transpose()?;
    let formats = [Some(&file), against.as_ref()].into_iter().flatten();
    given.check(&formats.map(|input| input.format).collect::<Vec<_>>())?;
    let mut changed = file.clone();
    set_numbers(&mut changed, &arguments.input.reading)?;
    let tower = changed.tower()?;
    let state = State::between(&file, &changed);
    note(&changed.notes);
    warn(tower.warnings(), &changed);
    let against = against.zip(arguments.against.as_deref());
    let against = against.map(|(other, path)| exploration(other, path, arguments));
    let explorer = Explorer::new(Exploration {
        against: against.transpose()?.map(Box::new),
        ..exploration(file, &arguments.input.file, arguments)?
    });
    let failed = |error| not_served(arguments.port, &error);
    let server = Server::bind(arguments.port.unwrap_or(0)).map_err(failed)?;
    let address = server.address() + &state.fragment();
    deliver(format!("{address}\n").as_bytes(), None)?;
    let is_opened = !arguments.no_open && open::that_detached(&address).is_ok();
    hear(match is_opened {
        true => "the page opens in the browser; Ctrl-C ends the program",
        false => "open this address in a browser; Ctrl-C ends the program",
    });
    server.run(explorer).map_err(failed)
}

/// The tower of a file, before any input value is set: the page can reset the values.
fn unchanged(path: &Path, given: &ReadingArguments) -> Result<TowerInput, Failure> {
    let mut reading = given.clone();
    reading.settings.clear();
    input_of(path, &reading)
}

/// The data for the explorer.
fn exploration(
    file: TowerInput,
    path: &Path,
    arguments: &ExploreArguments,
) -> Result<Exploration, Failure> {
    let options = Options {
        points: POINTS,
        ..arguments.solver.options(&file)?
    };
    Ok(Exploration {
        input: file,
        options,
        covers_excitations: !arguments.solver.has_modes(),
        rotor: arguments.rotor.given(),
        campbell: arguments.rotor.options(),
        file: path.to_string_lossy().into_owned(),
        reading: arguments.input.reading.words(),
        solving: arguments.solver.words(),
        rotating: arguments.rotor.words(),
        against: None,
        report: reporter(),
        clock,
    })
}

/// The failure if the page cannot be served.
fn not_served(port: Option<u16>, error: &io::Error) -> Failure {
    match port {
        Some(port) => Failure::failed(format!("port {port} cannot be used: {error}"))
            .hint("without --port the program uses any free port"),
        None => Failure::failed(format!(
            "the page cannot be served on this machine: {error}"
        )),
    }
}

/// Milliseconds since the first call.
fn clock() -> f64 {
    static START: OnceLock<Instant> = OnceLock::new();
    1e3 * START.get_or_init(Instant::now).elapsed().as_secs_f64()
}

/// Writes the reports of `towermodes report`.
fn reporter() -> Reporter {
    Box::new(|input, words| page_of(&input, words).map_err(|failure| failure.to_string()))
}
