//! Reports of the program: every example's is whole, small and always the same, and the sums of its
//! files are right.

use crate::program::{root, towermodes};
use std::fs;

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use towermodes_testing::{Says, arguments, rows, words};

/// Every example, with sentences that are true of it alone.
const EXAMPLES: &str = r#"
    floating.toml | The base is a rigid floating platform & gravity determines roll and pitch & No buckling load factor is given for a floating structure & The total includes the tower, the rotor-nacelle assembly, the platform and the added mass of the platform & Surge, sway, heave, roll, pitch and yaw are motions
    guyed.toml | The input has no [rotor] & Guy wires are linear springs that stay taut & Gravity is included as linear geometric stiffness, g = 9.80665
    monopile.toml | Soil is modelled by distributed linear springs & Still water
    nrel-5mw-table.toml | Cross-sections are given by a table & the input has no diameter
    nrel-5mw.bmi | an Euler-Bernoulli beam & Computed by the method bmodes & Give --rpm LOWEST,HIGHEST
    nrel-5mw.toml | a Rayleigh beam & The rotor has 3 blades at 6.9 to 12.1 rpm in operation.
    nrel-5mw.yaml | The rotor-nacelle assembly is one rigid body
    reference-tower-350t.toml | The rotor-nacelle assembly is one rigid body
    reference-tower.toml | There is no rotor-nacelle assembly. & The base is clamped
    small-turbine/ElastoDyn.dat | Torsion and axial deformation are not included & RotSpeed = 17 rpm is the initial speed of the simulation & Not checked: operating speeds unknown. & The table of the input has no rotary inertia.
"#;

/// Larger pages are hard to send.
const LARGEST: usize = 2_000_000;

fn report(arguments: &[&str], input: Stdio) -> Output {
    run(&[&["report"], arguments].concat(), input)
}

fn run(arguments: &[&str], input: Stdio) -> Output {
    let mut command = towermodes(arguments);
    command.stdin(input).output().expect("the program runs")
}

fn text(output: Output) -> String {
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// A file of a test alone.
fn file(name: &str, bytes: &[u8]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, bytes).expect("a file");
    path
}

/// A small tower; the é is one byte in Latin-1.
const TOWER: &[u8] = b"name = \"Tour d'\xe9t\xe9\"\n[material]\ndensity = 7850.0\nyoungs_modulus = 2.1e11\nshear_modulus = 8.08e10\n\
[tower]\nstations = [[0.0, 4.0, 0.02], [80.0, 4.0, 0.02]]\n";
/// Of these bytes, by sha256sum.
const SUM: &str = "d032545beae19b95451fcf78c5271c227712de740975767820a9d032ed13238b";
/// Of the same text in UTF-8.
const SUM_UTF8: &str = "71f3fc4b49277d18559a3ef894b8bdf22307a9dc382212c8ed366d70564ffb3d";

#[test]
fn every_example_has_a_small_report() {
    for [example, sentences] in rows(EXAMPLES) {
        let path = format!("examples/{example}");
        let page = text(report(&[&path], Stdio::null()));
        assert!(page.starts_with("<!DOCTYPE html>"), "{example}");
        assert!(page.ends_with("</html>\n"), "{example}");
        assert!(page.len() < LARGEST, "{example}: {} bytes", page.len());
        for sentence in words(sentences) {
            assert!(page.contains(sentence), "{example}: not said: {sentence}");
        }
        let again = text(report(&[&path], Stdio::null()));
        assert!(page == again, "{example} differs from time to time");
    }
}

#[test]
fn the_sums_are_those_of_the_bytes() {
    let path = file("latin1.toml", TOWER);
    let name = path.display().to_string();
    let page = text(report(&[&name, "--format", "md"], Stdio::null()));
    page.says("Tour d'\u{e9}t\u{e9}");
    page.says(&format!("| {} | {SUM} |", TOWER.len()));
}

#[test]
fn standard_input_has_a_sum_too() {
    let path = file("latin1-input.toml", TOWER);
    let input = fs::File::open(path).expect("a file");
    let page = text(report(&["-", "--format", "md"], input.into()));
    page.says("towermodes plot - --what tower");
    page.says("&lt;standard input\\> (as UTF-8)");
    page.says(&format!("| {} | {SUM_UTF8} |", TOWER.len() + 2));
}

#[test]
fn the_command_is_quoted_for_a_shell() {
    let title = "it's \"A\" & <B>";
    let arguments = [
        "examples/reference-tower.toml",
        "--title",
        title,
        "--format",
        "md",
    ];
    let page = text(report(&arguments, Stdio::null()));
    let command = "towermodes report examples/reference-tower.toml --title 'it'\\''s \"A\" & <B>' --format md";
    page.says(command);
}

#[test]
fn a_file_of_the_report_is_what_standard_output_is() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report.md");
    let name = path.display().to_string();
    let line = format!("examples/reference-tower.toml --format md --output {name}");
    let arguments = arguments(&line);
    assert_eq!(text(report(&arguments, Stdio::null())), "");
    let written = fs::read_to_string(&path).expect("a report");
    let page = text(report(&arguments[..3], Stdio::null()));
    // All but the command.
    let without = |page: &str| {
        let lines = page.lines();
        let lines = lines.filter(|l| !l.starts_with("towermodes report"));
        lines.collect::<Vec<_>>().join("\n")
    };
    assert_eq!(without(&written), without(&page));
}

/// The pictures of a report in Markdown: what is said of each, and the command below it without its
/// output.
fn pictures(page: &str) -> Vec<(String, Vec<String>)> {
    let mut pictures = Vec::new();
    let mut said = String::new();
    for line in page.lines() {
        if line.starts_with("**Figure ") {
            let description = line.split_once("** ").map_or("", |(_, text)| text);
            said = description.replace('\\', "");
        }
        if let Some(command) = line.strip_prefix("towermodes plot ") {
            let words = command.split(" --output").next().unwrap_or_default();
            let words = std::iter::once("plot").chain(words.split(' '));
            pictures.push((said.clone(), words.map(str::to_owned).collect()));
        }
    }
    pictures
}

/// The words of a picture that the program draws.
fn description(arguments: &[&str]) -> String {
    let picture = text(run(arguments, Stdio::null()));
    let start = picture.find("<desc").expect("a description");
    let start = start + picture[start..].find('>').expect("its start") + 1;
    let end = picture.find("</desc>").expect("its end");
    picture[start..end]
        .replace("&apos;", "'")
        .replace("&#39;", "'")
}

#[test]
fn the_commands_of_a_report_draw_its_pictures() {
    let options = "--method rmje-exact --segments 30 --no-rotary-inertia --modes 6 --rpm 6.9,12.1 --margin 7.5";
    let cases = [
        ("examples/nrel-5mw.bmi", options),
        ("examples/nrel-5mw.bmi", "--rpm 9"),
        (
            "examples/nrel-5mw.toml",
            "--method cardanic --hinges 0.15 --modes 6",
        ),
    ];
    for (file, options) in cases {
        let arguments: Vec<&str> = [file, "--format", "md"]
            .into_iter()
            .chain(options.split(' '))
            .collect();
        let page = text(report(&arguments, Stdio::null()));
        let pictures = pictures(&page);
        assert_eq!(pictures.len(), 4, "{page}");
        for (said, command) in pictures {
            let words: Vec<&str> = command.iter().map(String::as_str).collect();
            // A picture that is drawn alone has the conclusion too, which the report has once.
            let described = description(&words);
            let conclusion = described.strip_suffix(&said);
            let conclusion = conclusion.unwrap_or_else(|| panic!("{command:?}: {described}"));
            assert!(
                page.contains(conclusion.trim()),
                "{command:?}: {conclusion}"
            );
        }
    }
    // Each of these options changes what is to be seen.
    let plain = description(&arguments(
        "plot examples/nrel-5mw.bmi --what shapes --modes 6",
    ));
    let other = arguments("plot examples/nrel-5mw.bmi --what shapes --modes 6 --method rmje-exact");
    let other_beam = [&other[..], &["--no-rotary-inertia"]].concat();
    assert_ne!(description(&other), description(&other_beam));
    assert_ne!(plain, description(&other));
}

#[test]
fn a_tower_file_from_standard_input_is_not_converted_to_itself() {
    let path = file("input.toml", TOWER);
    let input = fs::File::open(path).expect("a file");
    let page = text(report(&["-", "--format", "md"], input.into()));
    page.says("The input has no \\[rotor\\]");
    assert!(!page.contains("convert the tower to TOML"), "{page}");
}

#[test]
fn margins_are_said_as_they_were_given() {
    for margin in ["0.03", "2.55"] {
        let line = format!("examples/nrel-5mw.toml --format md --margin {margin}");
        let page = text(report(&arguments(&line), Stdio::null()));
        page.says(&format!("FAIL at a required margin of {margin} %"));
        page.says(&format!(
            "The margin, the required distance, is {margin} %."
        ));
    }
}

/// Every coefficient of the tower file, and the frequencies that the command prints beside it, are
/// in the report, digit by digit.
#[test]
fn shapes_for_elastodyn_are_those_of_the_tower_file() {
    for options in [&[][..], &["--no-rotary-inertia", "--method", "lumped"]] {
        let path = "examples/nrel-5mw.toml";
        let page = text(report(
            &[&[path, "--format", "md"], options].concat(),
            Stdio::null(),
        ));
        let made = run(&["elastodyn", "tower", path], Stdio::null());
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        let file = text(made);
        let is_of_shape = |line: &&str| line.contains("FAM") || line.contains("SSM");
        let coefficients: Vec<&str> = file
            .lines()
            .filter(is_of_shape)
            .filter_map(|line| line.split_whitespace().next())
            .collect();
        assert_eq!(coefficients.len(), 20, "{file}");
        let frequencies = said
            .lines()
            .filter(|line| line.contains("bending"))
            .flat_map(|line| line.split_whitespace().filter(|word| word.len() == 7));
        let frequencies: Vec<&str> = frequencies.filter(|word| word.contains('.')).collect();
        assert!(frequencies.len() >= 8, "{said}");
        for number in coefficients.iter().chain(&frequencies) {
            let number = number.replace('-', "\u{2212}");
            page.says(&format!("| {number} |"));
        }
    }
}

#[test]
fn the_summary_repeats_what_a_reader_could_not_find() {
    let path = file("alone.dat", b"");
    let path = path.to_str().expect("UTF-8");
    let made = ["elastodyn", "tower", "examples/nrel-5mw.toml", "-o", path];
    text(run(&made, Stdio::null()));
    let page = text(report(&[path, "-f", "md"], Stdio::null()));
    let summary = page.split("## 2.").next().unwrap_or_default();
    assert!(
        summary.contains(
            "- **Not in the model**: The tower extends from 0 m to 87.6 m, clamped, without RNA"
        ),
        "{summary}"
    );
    let whole = text(report(
        &["examples/nrel-5mw.toml", "-f", "md"],
        Stdio::null(),
    ));
    assert!(!whole.contains("Not in the model"), "{whole}");
}

#[test]
fn the_ending_of_the_file_says_how_it_is_written() {
    let written = |name: &str, options: &[&str]| {
        let path = file(name, b"");
        let path = path.to_str().expect("UTF-8");
        let arguments = [&["examples/reference-tower.toml", "-o", path], options].concat();
        text(report(&arguments, Stdio::null()));
        let text = fs::read_to_string(path).expect("a report");
        text.chars().take(9).collect::<String>()
    };
    for name in ["ending.md", "ending.MD", "ending.markdown"] {
        assert_eq!(written(name, &[]), "# Natural", "{name}");
    }
    for name in ["ending.html", "ending.htm", "ending", "md"] {
        assert_eq!(written(name, &[]), "<!DOCTYPE", "{name}");
    }
    assert_eq!(written("told.page", &["-f", "html"]), "<!DOCTYPE");
    assert_eq!(written("told", &["-f", "md"]), "# Natural");
}

#[test]
fn a_file_that_looks_like_an_option_is_drawn_by_the_commands() {
    let path = file(
        "-dash.toml",
        &TOWER
            .iter()
            .copied()
            .filter(u8::is_ascii)
            .collect::<Vec<u8>>(),
    );
    let folder = path.parent().expect("a folder");
    let in_folder = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_towermodes"));
        command
            .current_dir(folder)
            .args(arguments)
            .stdin(Stdio::null());
        text(command.output().expect("the program runs"))
    };
    let page = in_folder(&["report", "-f", "md", "--", "-dash.toml"]);
    let shapes = "--what tower --output tower.svg -- -dash.toml";
    page.says(&format!("towermodes plot {shapes}"));
    in_folder(&[&["plot"], &shapes.split(' ').collect::<Vec<_>>()[..]].concat());
    in_folder(&["elastodyn", "tower", "--output", "-", "--", "-dash.toml"]);
}

#[test]
fn who_made_and_checked_it_stands_below_the_title() {
    let fields = [
        ("--project", "Project", "Dogger \u{fc}ber <all>"),
        ("--document", "Document", "T-17-003"),
        ("--revision", "Revision", "C"),
        ("--author", "Author", "J. Doe"),
        ("--checker", "Checked by", "R. Roe"),
        ("--date", "Date", "22 November 2026"),
    ];
    let options = fields
        .iter()
        .flat_map(|(option, _, value)| [*option, *value]);
    let arguments: Vec<&str> = ["examples/reference-tower.toml", "-f", "md"]
        .into_iter()
        .chain(options)
        .collect();
    let page = text(report(&arguments, Stdio::null()));
    let head = page.split("## 1.").next().expect("a head");
    let lines: Vec<&str> = head.lines().filter(|line| line.starts_with("- ")).collect();
    let expected = fields.map(|(_, name, value)| {
        format!(
            "- **{name}**: {}",
            value.replace('<', "&lt;").replace('>', "\\>")
        )
    });
    assert_eq!(lines, expected);
    // The command that makes it again has them too.
    page.says("--document T-17-003 --revision C --author 'J. Doe'");
    let without = text(report(
        &["examples/reference-tower.toml", "-f", "md"],
        Stdio::null(),
    ));
    let head = without.split("## 1.").next().expect("a head");
    assert_eq!(
        head.lines().filter(|line| !line.is_empty()).count(),
        1,
        "{head}"
    );
}

/// Every file that was read, the companions too, is in the report as it is on the disk.
#[test]
fn the_files_of_the_input_are_in_the_report() {
    let root = root();
    for (example, files) in [
        ("examples/monopile.toml", &["examples/monopile.toml"][..]),
        (
            "examples/nrel-5mw.bmi",
            &["examples/nrel-5mw.bmi", "examples/nrel-5mw_sections.dat"],
        ),
    ] {
        let page = text(report(&[example, "-f", "md"], Stdio::null()));
        let appendix = page.split("## Appendix B. Input files").nth(1);
        let appendix = appendix.expect("the appendix");
        for file in files {
            let bytes = fs::read_to_string(root.join(file)).expect("a file");
            let holds = appendix.contains(&bytes);
            assert!(holds, "{file} is not in the report of {example}");
        }
        assert_eq!(appendix.matches("```text").count(), files.len());
        assert!(!appendix.contains("Not byte by byte"), "{appendix}");
    }
    // A byte of Latin-1 is said, and the text is right.
    let path = file("latin1-embedded.toml", TOWER);
    let name = path.display().to_string();
    let page = text(report(&[&name, "-f", "md"], Stdio::null()));
    let appendix = page.split("## Appendix B. Input files").nth(1);
    let appendix = appendix.expect("the appendix");
    appendix.says_all("name = \"Tour d'\u{e9}t\u{e9}\" & not encoded in UTF-8");
}
