//! Reports that the program wrote.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Every example.
pub const EXAMPLES: [&str; 10] = [
    "floating.toml",
    "guyed.toml",
    "monopile.toml",
    "nrel-5mw-table.toml",
    "nrel-5mw.bmi",
    "nrel-5mw.toml",
    "nrel-5mw.yaml",
    "reference-tower-350t.toml",
    "reference-tower.toml",
    "small-turbine/ElastoDyn.dat",
];

/// The report of an example, as a file.
pub fn report_of(example: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    // Tests run side by side, each with a file of its own.
    let name = example.replace(['/', '.'], "-");
    let thread = format!("{:?}", std::thread::current().id()).replace(['(', ')'], "");
    let path = folder.join(format!("{name}-{thread}.html"));
    let done = Command::new(env!("CARGO_BIN_EXE_towermodes"))
        .current_dir(&root)
        .arg("report")
        .arg(Path::new("examples").join(example))
        .arg("--output")
        .arg(&path)
        .output()
        .expect("the program runs");
    // Margins may fail; the report says so.
    assert!(
        path.is_file(),
        "{example}: {}",
        String::from_utf8_lossy(&done.stderr)
    );
    path
}
