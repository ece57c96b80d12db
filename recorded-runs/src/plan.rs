//! Which runs there are: commands and options for each tower.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What of an output must stay the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// JSON: numbers, keys and structure.
    Json,
    /// Text for programs: the sequence of numbers.
    Numbers,
    /// Text for people: nothing but the exit code.
    Words,
}

/// One run of the program.
#[derive(Debug, Clone)]
pub struct Run {
    /// Arguments; `{file}` stands for a file in a folder of its own that the run writes.
    pub arguments: Vec<String>,
    /// What of its output must stay the same.
    pub kind: Kind,
    /// The ending of the file it writes, if its result is not on standard output.
    pub writes: Option<&'static str>,
}

impl Run {
    fn new(kind: Kind, arguments: &str, file: &str) -> Self {
        let mut arguments: Vec<String> = arguments.split_whitespace().map(str::to_owned).collect();
        if !file.is_empty() {
            arguments.push(file.to_owned());
        }
        Self {
            arguments,
            kind,
            writes: None,
        }
    }

    /// The arguments as a file name.
    pub fn name(&self) -> String {
        let joined = self.arguments.join(" ");
        let plain = |c: char| {
            if c.is_alphanumeric() || "-.,".contains(c) {
                c
            } else {
                '_'
            }
        };
        joined.chars().map(plain).collect()
    }
}

const METHODS: [&str; 7] = [
    "rmje-exact",
    "rmje",
    "cardanic-exact",
    "cardanic",
    "lumped",
    "bmodes",
    "spectral",
];

/// Options of every tower that is solved.
const SOLVES: &[(Kind, &str)] = &[
    (Kind::Json, "solve --format json --points 21"),
    (Kind::Json, "solve --format json --points 5 --modes 20"),
    (
        Kind::Json,
        "solve --format json --points 5 --no-rotary-inertia",
    ),
    (Kind::Json, "solve --format json --points 5 --no-gravity"),
    (Kind::Json, "solve --format json --points 5 --no-rna"),
    (
        Kind::Json,
        "solve --format json --points 5 --segments 37 --modes 3",
    ),
    (
        Kind::Json,
        "solve --format json --points 5 --method spectral --degree 8",
    ),
    (
        Kind::Json,
        "solve --format json --points 5 --method cardanic --hinges 0.25",
    ),
    (Kind::Numbers, "solve --format csv"),
    (Kind::Numbers, "solve --format bmodes --method bmodes"),
    (Kind::Words, "solve --plot"),
    (Kind::Json, "campbell --format json --rpm 6.9,12.1"),
    (
        Kind::Json,
        "campbell --format json --rpm 9 --margin 10 --multiples 1,2,3,6 --method lumped",
    ),
    (Kind::Numbers, "campbell --format csv --rpm 6.9,12.1"),
    (Kind::Words, "campbell --rpm 6.9,12.1 --all"),
    (Kind::Json, "compare --format json --segments 20 --modes 6"),
    (
        Kind::Words,
        "compare --methods rmje,bmodes --segments 10,20",
    ),
    (
        Kind::Json,
        "converge --format json --modes 4 --segments 10,20,40",
    ),
    (
        Kind::Json,
        "converge --format json --method spectral --degrees 6,8",
    ),
    (
        Kind::Words,
        "converge --method bmodes --modes 4 --segments 10,20,40",
    ),
    (Kind::Json, "check --format json"),
    (Kind::Words, "check"),
    (Kind::Numbers, "convert --to toml"),
    (Kind::Numbers, "convert --to elastodyn"),
    (Kind::Numbers, "convert --to windio"),
    (Kind::Numbers, "elastodyn tower --nodes 10"),
    (Kind::Words, "report --format md"),
    (Kind::Words, "plot --what tower"),
    (Kind::Json, "parameters --format json"),
    (Kind::Json, "sensitivities --format json --modes 4"),
    (Kind::Json, "damping --format json --modes 4"),
    (Kind::Numbers, "damping --format csv --modes 4"),
];

const PICTURES: [&str; 5] = ["shapes", "structure", "convergence", "campbell", "error"];

/// Options of each tower of the folder `kinds`: one foundation, soil model or attachment each, in
/// every output that depends on it.
const KINDS: &[(Kind, &str)] = &[
    (Kind::Json, "solve --format json --points 5"),
    (Kind::Words, "solve"),
    (Kind::Json, "check --format json"),
    (Kind::Words, "check"),
    (Kind::Json, "parameters --format json"),
    (Kind::Json, "sensitivities --format json --modes 4"),
    (Kind::Json, "damping --format json --modes 4"),
    (Kind::Words, "report --format md"),
    (Kind::Words, "report --format html"),
    (Kind::Words, "plot --what tower"),
    (Kind::Numbers, "convert --to toml"),
    (Kind::Numbers, "convert --to elastodyn"),
    (Kind::Numbers, "convert --to windio"),
    (Kind::Words, "campbell"),
];

/// Pairs that `check` compares.
const PAIRS: [(&str, &str); 5] = [
    ("examples/nrel-5mw.toml", "examples/nrel-5mw.bmi"),
    ("examples/nrel-5mw.toml", "examples/nrel-5mw.yaml"),
    ("examples/nrel-5mw.toml", "examples/nrel-5mw-table.toml"),
    ("examples/nrel-5mw.toml", "examples/reference-tower.toml"),
    ("examples/cans.toml", "examples/monopile.toml"),
];

/// Runs on files of their own; those of `explore`, a server, are left out.
const OTHERS: &[(Kind, &str)] = &[
    (Kind::Json, "verify --format json"),
    (
        Kind::Json,
        "sweep examples/studies/uncertainty.toml --first-order --format json",
    ),
    (
        Kind::Numbers,
        "sweep crates/towermodes-cli/tests/inputs/sweeps/beside-the-axis.toml",
    ),
    (
        Kind::Numbers,
        "sweep examples/nrel-5mw.toml crates/towermodes-cli/tests/inputs/sweeps/failing.csv",
    ),
    (
        Kind::Json,
        "design examples/nrel-5mw.toml crates/towermodes-cli/tests/inputs/design/mass.toml --format json",
    ),
    (
        Kind::Words,
        "design examples/nrel-5mw.toml crates/towermodes-cli/tests/inputs/design/impossible.toml",
    ),
    (
        Kind::Json,
        "calibrate examples/nrel-5mw.toml crates/towermodes-cli/tests/inputs/measured/tower.toml --format json",
    ),
    (
        Kind::Json,
        "calibrate examples/monopile.toml crates/towermodes-cli/tests/inputs/measured/prior.toml --format json",
    ),
    (Kind::Json, "schema solve"),
    (Kind::Words, "completions bash"),
    (Kind::Words, "man solve"),
];

/// Commands that are not run: they serve a page until they are ended.
pub const NOT_RUN: &[&str] = &["explore"];

/// The folder of the project.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All runs.
pub fn runs(root: &Path) -> Vec<Run> {
    let examples = files(root, "examples");
    let inputs = files(root, "crates/towermodes-cli/tests/inputs");
    let peers = peers();
    let mut runs = Vec::new();
    for tower in examples.iter().chain(&peers) {
        runs.extend(
            SOLVES
                .iter()
                .map(|&(kind, arguments)| Run::new(kind, arguments, tower)),
        );
        for method in METHODS {
            let arguments = format!("solve --format json --points 5 --method {method}");
            runs.push(Run::new(Kind::Json, &arguments, tower));
        }
        let deck = Run::new(Kind::Numbers, "convert --to bmodes --output {file}", tower);
        runs.push(Run {
            writes: Some("bmi"),
            ..deck
        });
        if tower.contains("ElastoDyn") {
            runs.push(Run::new(
                Kind::Json,
                "elastodyn validate --format json",
                tower,
            ));
            runs.push(Run::new(Kind::Numbers, "elastodyn patch --diff", tower));
            runs.push(Run::new(
                Kind::Json,
                "solve --format json --rotor free",
                tower,
            ));
            runs.push(Run::new(Kind::Words, "elastodyn validate", tower));
        }
    }
    for tower in &files(root, "recorded-runs/kinds") {
        runs.extend(
            KINDS
                .iter()
                .map(|&(kind, arguments)| Run::new(kind, arguments, tower)),
        );
    }
    for tower in &examples {
        let picture = |what| Run::new(Kind::Words, &format!("plot --what {what}"), tower);
        runs.extend(PICTURES.map(picture));
    }
    for input in &inputs {
        runs.push(Run::new(
            Kind::Json,
            "solve --format json --points 5",
            input,
        ));
        runs.push(Run::new(Kind::Words, "solve", input));
    }
    for (first, second) in PAIRS {
        runs.push(Run::new(
            Kind::Json,
            &format!("check --format json {first}"),
            second,
        ));
        runs.push(Run::new(Kind::Words, &format!("check {first}"), second));
    }
    runs.extend(
        OTHERS
            .iter()
            .map(|&(kind, arguments)| Run::new(kind, arguments, "")),
    );
    let names = runs.iter().filter_map(|run| run.arguments.first().cloned());
    let mut commands: BTreeSet<String> = names.collect();
    commands.extend(NOT_RUN.iter().map(|name| (*name).to_owned()));
    let help = |command: &String| Run::new(Kind::Words, &format!("{command} --help"), "");
    runs.extend(commands.iter().map(help));
    runs
}

/// The towers in a folder of the project and the folders in it, as paths from the project's.
fn files(root: &Path, folder: &str) -> Vec<String> {
    let mut paths = Vec::new();
    collect(&root.join(folder), &mut paths);
    let relative = |path: &PathBuf| {
        let path = path.strip_prefix(root).unwrap_or(path);
        path.to_string_lossy().into_owned()
    };
    let mut names: Vec<String> = paths.iter().map(relative).collect();
    names.sort();
    names
}

/// Input files of other programs, if they are at hand.
fn peers() -> Vec<String> {
    let Ok(folder) = std::env::var("TOWERMODES_PEER_DATA") else {
        return Vec::new();
    };
    let mut paths = Vec::new();
    collect(Path::new(&folder), &mut paths);
    let mut names: Vec<String> = paths
        .iter()
        .map(|p| p.to_string_lossy().into_owned())
        .collect();
    names.retain(|name| !name.ends_with(".out") && !name.contains("schema"));
    names.sort();
    names
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return;
    };
    for path in entries.flatten().map(|entry| entry.path()) {
        let ending = path
            .extension()
            .and_then(|e| e.to_str())
            .unwrap_or_default();
        if path.is_dir() {
            collect(&path, paths);
        } else if ["toml", "bmi", "dat", "yaml", "csv"].contains(&ending) {
            paths.push(path);
        }
    }
}
