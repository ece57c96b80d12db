//! A folder in which the commands of the book can be typed: the examples, and files under the names
//! that pages and help texts use for those of a reader.

// Each test uses a part of it.
#![allow(dead_code)]

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::pages::{Page, root};

/// The program that is tested.
pub const PROGRAM: &str = env!("CARGO_BIN_EXE_towermodes");

/// A sweep of `tower.toml`.
const STUDY: &str = r#"[sweep]
base = "tower.toml"
sampling = "sobol"
rows = 100
[sweep.vary]
"rna.mass" = { uniform = [3.3e5, 3.7e5] }
"scale(stations[*].wall)" = { normal = [1.0, 0.02] }
"#;

/// A folder that is gone when the test is.
pub struct Sandbox(PathBuf);

impl Sandbox {
    /// A new one, with everything in it.
    pub fn new(name: &str) -> Self {
        let sandbox = Self(folder(name));
        let root = root();
        for part in ["examples", "crates/towermodes-cli/tests/inputs"] {
            copy_folder(&root.join(part), &sandbox.0.join(part));
        }
        // A file that is no tower.
        fs::copy(root.join("README.md"), sandbox.0.join("README.md")).expect("copied");
        sandbox.make_towers();
        sandbox.make_decks();
        sandbox
    }

    /// Another one with the same files, faster than a new one.
    pub fn another(&self, name: &str) -> Self {
        let sandbox = Self(folder(name));
        copy_folder(&self.0, &sandbox.0);
        sandbox
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Writes the blocks of a page that begin with the name of a file.
    pub fn write_files_of(&self, page: &Page) {
        for block in page.blocks() {
            if let Some(name) = block.file_name() {
                self.write(name, &block.text);
            }
        }
    }

    /// Programs that the scripts call, and nothing is installed for: the folders to look for
    /// programs in. `generate-tower` prints a tower, `man` what it is given.
    #[cfg(unix)]
    pub fn commands(&self) -> std::ffi::OsString {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = self.0.join("bin");
        fs::create_dir_all(&folder).expect("a folder");
        fs::create_dir_all(self.0.join(".local/share/bash-completion/completions"))
            .expect("a folder");
        for (name, script) in [("generate-tower", "cat tower.toml"), ("man", "cat > page")] {
            let file = folder.join(name);
            fs::write(&file, format!("#!/bin/sh\n{script}\n")).expect("written");
            fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).expect("executable");
        }
        symlink(PROGRAM, folder.join("towermodes")).expect("linked");
        let mut path = folder.into_os_string();
        path.push(":");
        path.push(std::env::var_os("PATH").unwrap_or_default());
        path
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("written");
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).expect("a file")
    }

    fn copy(&self, from: &str, to: &str) {
        fs::copy(self.0.join(from), self.0.join(to)).expect("copied");
    }

    fn run(&self, arguments: &str) {
        let mut command = Command::new(PROGRAM);
        command.current_dir(&self.0).args(arguments.split(' '));
        let output = command.output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{arguments}: {said}");
    }

    /// The same tower in several formats.
    fn make_towers(&self) {
        self.copy("examples/nrel-5mw.toml", "tower.toml");
        let values = "rna.mass,scale(stations[*].wall)\n330000,0.95\n350000,1.00\n370000,1.05\n";
        self.write("values.csv", values);
        self.write("study.toml", STUDY);
        let from = "crates/towermodes-cli/tests/inputs/design/mass.toml";
        self.copy(from, "design.toml");
        let from = "crates/towermodes-cli/tests/inputs/measured/tower.toml";
        self.copy(from, "measured.toml");
        self.copy("examples/nrel-5mw.bmi", "deck.bmi");
        self.copy("examples/nrel-5mw_sections.dat", "nrel-5mw_sections.dat");
        self.copy("examples/nrel-5mw.yaml", "turbine.yaml");
        // On a transition piece at 15 m, as the tower of HAWC2 is said to be.
        let turbine = self.read("examples/nrel-5mw.yaml");
        let raised = turbine.replace("[0.0, 87.6]", "[15.0, 102.6]");
        self.write("IEA-15-240-RWT.yaml", &raised);
        self.write("IEA_15MW_RWT_Tower_st.dat", &hawc2_tower());
        self.run("elastodyn tower examples/nrel-5mw.toml --output Tower.dat");
    }

    /// Decks of OpenFAST whose shapes are right, a floating one, and a blade.
    fn make_decks(&self) {
        let deck = self.read("examples/small-turbine/ElastoDyn.dat");
        for name in ["Blade.dat", "Tower.dat"] {
            let (from, to) = (
                format!("examples/small-turbine/{name}"),
                format!("NREL5MW_{name}"),
            );
            self.copy(&from, &to);
        }
        let named = |tower: &str| {
            let deck = deck.replace("\"Blade.dat\"", "\"NREL5MW_Blade.dat\"");
            deck.replace("\"Tower.dat\"", &format!("\"{tower}\""))
        };
        for name in ["NREL5MW_ElastoDyn.dat", "Turbine_ElastoDyn.dat"] {
            self.write(name, &named("NREL5MW_Tower.dat"));
        }
        self.run("elastodyn patch NREL5MW_ElastoDyn.dat");
        self.run("convert examples/floating.toml --to bmodes --output OC3Hywind.bmi");
        self.run("elastodyn tower examples/floating.toml --output OC3_Tower.dat");
        let floating = named("OC3_Tower.dat");
        let floating = floating.replace("            78.0   TowerHt", "            87.6   TowerHt");
        let words = "             0.0   TowerBsHt";
        let floating = floating.replace(words, "            10.0   TowerBsHt");
        self.write("OC3_ElastoDyn.dat", &floating);
        self.make_blade();
    }

    /// A round tower on its side that turns.
    fn make_blade(&self) {
        self.run("convert examples/nrel-5mw-table.toml --to bmodes --output blade.bmi");
        let deck = self.read("blade.bmi");
        let words = "2                      beam_type";
        let deck = deck.replacen(words, "1                      beam_type", 1);
        let words = "0.0                    rot_rpm";
        let deck = deck.replacen(words, "6.0                    rot_rpm", 1);
        self.write("blade.bmi", &deck);
    }
}

impl Drop for Sandbox {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Where a sandbox of this name is.
fn folder(name: &str) -> PathBuf {
    let name = format!("towermodes-{name}-{}", std::process::id());
    std::env::temp_dir().join(name)
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder") {
        let path = entry.expect("an entry").path();
        let target = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy_folder(&path, &target);
        } else {
            fs::copy(&path, target).expect("copied");
        }
    }
}

/// The tube of `examples/nrel-5mw.toml` in nineteen columns: r m x_cg y_cg ri_x ri_y x_sh y_sh E G
/// I_x I_y K k_x k_y A θ x_e y_e.
fn hawc2_tower() -> String {
    let mut text = "#1 Tower\n$1 41 Flexible\n".to_owned();
    for row in 0..=40 {
        let share = f64::from(row) / 40.0;
        let (height, outer) = (87.6 * share, 6.0 - 2.13 * share);
        let inner = outer - 2.0 * (0.0351 - 0.0104 * share);
        let area = std::f64::consts::FRAC_PI_4 * (outer.powi(2) - inner.powi(2));
        let inertia = std::f64::consts::PI / 64.0 * (outer.powi(4) - inner.powi(4));
        let (radius, mass) = ((inertia / area).sqrt(), 8500.0 * area);
        writeln!(
            text,
            "{height} {mass} 0 0 {radius} {radius} 0 0 2.1e11 8.08e10 {inertia} {inertia} {} 0.5 0.5 {area} 0 0 0",
            2.0 * inertia
        )
        .expect("written");
    }
    text
}
