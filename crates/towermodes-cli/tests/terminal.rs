//! What is seen on a terminal: what long work is at while it lasts, nothing of it afterwards;
//! pictures as wide as the terminal.
//!
//! `script` (util-linux) gives the program a terminal; where there is none the tests say so and
//! pass.

use std::process::{Command, Output};

use towermodes_testing::{Says, assert_matches};

const PROGRAM: &str = env!("CARGO_BIN_EXE_towermodes");
const TOWER: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../examples/reference-tower.toml"
);

/// All that a terminal was sent, or nothing where no terminal can be had.
fn on_a_terminal(before: &str, arguments: &str) -> Option<String> {
    let command = format!("{before}'{PROGRAM}' {arguments}");
    // In the form of util-linux, which others do not understand.
    // The tests of the sessions move the whole program to a folder that is gone when they end.
    let done = Command::new("script")
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["-qec", &command, "/dev/null"])
        .env("TERM", "xterm")
        .env_remove("NO_COLOR")
        .output();
    match done {
        Ok(Output { status, stdout, .. }) if status.success() => String::from_utf8(stdout).ok(),
        _ => {
            eprintln!("skipped: no terminal by `script`");
            None
        }
    }
}

fn piped(arguments: &str) -> Output {
    let words = arguments.split(' ').map(|word| word.replace('\'', ""));
    let done = Command::new(PROGRAM).args(words).output();
    done.expect("the program runs")
}

/// The lines that stand on the screen when all is done.
fn screen(sent: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut column = 0;
    let mut rest = sent.chars();
    while let Some(c) = rest.next() {
        let last = lines.last_mut().expect("there is always a line");
        match c {
            '\r' => column = 0,
            '\n' => {
                lines.push(String::new());
                column = 0;
            }
            '\u{1b}' => {
                let sequence = rest.by_ref().take_while_inclusive();
                match sequence.as_str() {
                    "[2K" => last.clear(),
                    other => assert!(other.ends_with('m'), "not understood: {other:?}"),
                }
            }
            c => {
                let mut cells: Vec<char> = last.chars().collect();
                cells.resize(cells.len().max(column + 1), ' ');
                cells[column] = c;
                *last = cells.into_iter().collect();
                column += 1;
            }
        }
    }
    lines
        .iter()
        .map(|line| line.trim_end().to_owned())
        .collect()
}

trait Sequence {
    fn take_while_inclusive(&mut self) -> String;
}

impl<I: Iterator<Item = char>> Sequence for I {
    /// A control sequence: all up to its letter.
    fn take_while_inclusive(&mut self) -> String {
        let mut sequence = String::new();
        for c in self {
            sequence.push(c);
            if c.is_ascii_alphabetic() {
                break;
            }
        }
        sequence
    }
}

fn lines(text: &[u8]) -> Vec<String> {
    let text = String::from_utf8(text.to_vec()).expect("text");
    let lines = text.split('\n').map(|line| line.trim_end().to_owned());
    lines.collect()
}

#[test]
fn a_long_solve_says_what_it_is_at_and_leaves_nothing() {
    // As many as take long on this machine.
    for segments in [50_000, 200_000, 800_000] {
        let arguments = format!("solve '{TOWER}' --modes 4 --segments {segments}");
        let Some(sent) = on_a_terminal("", &arguments) else {
            return;
        };
        let done = piped(&arguments);
        assert_eq!(screen(&sent), lines(&done.stdout));
        assert_eq!(done.stderr, b"", "nothing on a pipe, however long it takes");
        if sent.contains(&format!(" modes on {segments} segments")) {
            sent.says(" %, ");
            sent.says(" s left: ");
            return;
        }
    }
    panic!("800 000 segments in half a second");
}

#[test]
fn a_short_solve_says_nothing_but_its_result() {
    let Some(sent) = on_a_terminal("", &format!("solve '{TOWER}' --segments 2 --modes 1")) else {
        return;
    };
    assert!(!sent.contains(" %, "), "{sent}");
}

#[test]
fn studies_have_a_bar() {
    for segments in [
        "1000,2000,4000,8000",
        "10000,20000,40000,80000,160000",
        "100000,200000,400000,800000,1000000",
    ] {
        let arguments = format!("converge '{TOWER}' --modes 4 --segments {segments}");
        let Some(sent) = on_a_terminal("", &arguments) else {
            return;
        };
        // The terminal has narrower lines.
        let words = |lines: Vec<String>| lines.join(" ").split_whitespace().collect::<String>();
        let text = piped(&arguments).stdout;
        assert_eq!(words(screen(&sent)), words(lines(&text)));
        let levels = segments.split(',').count();
        if sent.contains(&format!("of {levels}, ")) {
            sent.says(" s left: ");
            return;
        }
    }
    panic!("a study of 2 500 000 segments in half a second");
}

#[test]
fn pictures_are_as_wide_as_the_terminal() {
    for columns in [20, 30, 47, 80, 133] {
        let arguments = format!("solve '{TOWER}' --modes 8 --plot");
        let before = format!("stty rows 24 cols {columns}; ");
        let Some(sent) = on_a_terminal(&before, &arguments) else {
            return;
        };
        let screen = screen(&sent);
        let drawn = screen.iter().filter(|line| line.contains(['│', '┤']));
        let widths: Vec<usize> = drawn.map(|line| line.chars().count()).collect();
        let widest = widths.iter().max().copied();
        // An axis of 8 characters and one more, diagrams of 16 with two between them; five
        // diagrams, for equal planes share one.
        let diagrams = ((columns - 7) / 18).min(5);
        let room = 7 + 18 * diagrams;
        let is_there = columns >= 30;
        assert_eq!(widest.is_some(), is_there, "{columns}");
        let holds = widest.is_none_or(|w| (room - 17..=room).contains(&w));
        assert!(holds, "{columns}: {widest:?}");
    }
}

/// What nobody reads on a terminal is not poured on it unasked; a pipe gets it as ever.
#[test]
fn pictures_and_pages_are_not_sent_to_a_terminal_unasked() {
    for (arguments, name) in [
        (format!("plot '{TOWER}' --what tower"), "picture.svg"),
        (format!("plot '{TOWER}' --what tower --png"), "picture.png"),
        (format!("report '{TOWER}'"), "report.html"),
    ] {
        let Some(sent) = on_a_terminal("", &format!("{arguments}; echo code $?")) else {
            return;
        };
        let hint = format!("give --output {name}");
        assert!(sent.contains(&hint) && sent.contains("code 2"), "{sent}");
        assert!(sent.len() < 1000);
    }
    let tower = format!("plot '{TOWER}' --what tower");
    let forced = on_a_terminal("", &format!("{tower} --output -"));
    assert!(forced.is_none_or(|sent| sent.contains("</svg>")));
    assert!(piped(&tower).stdout.starts_with(b"<svg"));
}

/// Not even in JSON, which holds names as they are.
#[test]
fn a_terminal_gets_no_marks_of_names() {
    let folder = std::env::temp_dir().join(format!("towermodes-mark-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let tower = folder.join("t.toml");
    let text = std::fs::read_to_string(TOWER).expect("the example");
    let text = text.replacen("name = \"", "name = \"\\u202Egpj.", 1);
    std::fs::write(&tower, text).expect("written");
    let sent = on_a_terminal("", &format!("solve '{}' -f json", tower.display()));
    std::fs::remove_dir_all(&folder).expect("ours");
    assert!(sent.is_none_or(|sent| sent.contains("gpj.") && !sent.contains('\u{202e}')));
}

#[test]
fn a_long_sweep_says_its_rate_and_leaves_one_line() {
    let folder = std::env::temp_dir().join(format!("towermodes-rate-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::copy(TOWER, folder.join("tower.toml")).expect("copied");
    // As many as take long on this machine.
    for rows in [20_000, 200_000, 2_000_000] {
        let study = format!(
            "[sweep]\nbase = \"tower.toml\"\nsampling = \"random\"\nrows = {rows}\n\
             [sweep.vary]\n\"scale(stations[*].wall)\" = {{ uniform = [0.9, 1.1] }}\n"
        );
        let path = folder.join("study.toml");
        std::fs::write(&path, study).expect("written");
        let output = folder.join(format!("results-{rows}.csv"));
        let arguments = format!("sweep '{}' --output '{}'", path.display(), output.display());
        let Some(sent) = on_a_terminal("", &arguments) else {
            break;
        };
        if sent.contains(" rows/s, ") {
            sent.says(&format!(" of {rows} rows"));
            let shown = screen(&sent);
            let words: Vec<&String> = shown.iter().filter(|line| !line.is_empty()).collect();
            assert_matches!(words[..], [line] if line.contains(&format!(": all {rows} rows")));
            break;
        }
        assert!(rows < 2_000_000, "two million rows in half a second");
    }
    std::fs::remove_dir_all(&folder).expect("ours");
}

/// The arguments of a command with the paths of the examples.
fn with_examples(arguments: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
    arguments.replace("examples/", folder)
}

/// Everything that a pipe gets is on a narrow terminal too, in lines that fit.
#[test]
fn tables_fit_the_terminal() {
    for arguments in [
        "solve examples/jacket.toml",
        "solve examples/floating.toml examples/monopile.toml",
        "campbell examples/nrel-5mw-turbine.toml",
        "campbell examples/monopile-layers.toml",
        "compare examples/nrel-5mw.toml",
        "converge examples/cans.toml --segments 10,20",
        "sensitivities examples/monopile.toml",
        "damping examples/jacket.toml",
        "parameters examples/monopile-foundation.toml",
        "check examples/nrel-5mw.toml",
        "check examples/nrel-5mw.toml examples/nrel-5mw.bmi",
        "verify elements",
    ] {
        let arguments = with_examples(arguments);
        let Some(sent) = on_a_terminal(
            "stty rows 24 cols 80; ",
            &format!("{arguments} 2>/dev/null"),
        ) else {
            return;
        };
        let shown = screen(&sent);
        let too_wide = shown.iter().find(|line| line.chars().count() > 80);
        assert_eq!(too_wide, None, "{arguments}");
        let shown: Vec<&str> = shown.iter().flat_map(|line| line.split(' ')).collect();
        let text = piped(&arguments).stdout;
        let text = String::from_utf8(text).expect("text");
        // Times differ from run to run, and pictures are drawn for their width.
        let is_measured =
            |line: &&str| line.contains("time per solve") || line.contains('\u{2524}');
        let words = text.lines().filter(|line| !is_measured(line));
        let mut words = words.take_while(|line| !line.contains('\u{2502}'));
        let lacking = words.find(|line| !line.split(' ').all(|word| shown.contains(&word)));
        assert_eq!(lacking, None, "{arguments}");
    }
}

/// A conclusion is wrapped for the terminal, not for a file and then again.
#[test]
fn sentences_are_wrapped_once() {
    let arguments = with_examples("campbell examples/nrel-5mw-turbine.toml");
    let Some(sent) = on_a_terminal("stty rows 24 cols 70; ", &arguments) else {
        return;
    };
    let shown = screen(&sent);
    let begin = shown.iter().position(|line| line.starts_with("6 warnings"));
    let lines = shown[begin.expect("the conclusion")..].iter();
    let lines: Vec<&String> = lines.take_while(|line| !line.is_empty()).collect();
    let (_, full) = lines.split_last().expect("lines");
    assert!(full.len() > 3, "{lines:?}");
    // The longest word, a number with its unit, and a space are 13 characters.
    assert!(
        full.iter().all(|line| line.chars().count() > 70 - 13),
        "{lines:#?}"
    );
}

#[test]
fn verdicts_have_colours_on_a_terminal_only() {
    let arguments = with_examples("campbell examples/monopile-layers.toml");
    let Some(sent) = on_a_terminal("", &arguments) else {
        return;
    };
    sent.says("\u{1b}[32mPASS\u{1b}[0m");
    assert!(sent.contains("mWARN\u{1b}[0m"), "{sent}");
    let plain = on_a_terminal("NO_COLOR=1 ", &arguments);
    assert!(plain.is_some_and(|sent| !sent.contains('\u{1b}') && sent.contains("PASS")));
    assert!(!piped(&arguments).stdout.contains(&0x1b));
    let json = on_a_terminal("", &format!("{arguments} --format json"));
    assert!(json.is_some_and(|sent| !sent.contains('\u{1b}')));
}
