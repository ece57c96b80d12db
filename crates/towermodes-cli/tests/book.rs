//! Whether what the book says is so: its links, its commands, its files.

use crate::pages;
use crate::sandbox;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use pages::links::{anchors, links, parts_of, prose, without_dots};
use pages::{Block, Page, pages, root};
use sandbox::{PROGRAM, Sandbox};

/// The page that the program prints itself.
const REFERENCE: &str = "book/src/reference/command-line.md";

/// Languages whose blocks are commands: of sessions the output is compared, the others are run by a
/// shell.
const SESSIONS: [&str; 2] = ["console", "trycmd"];
const SCRIPTS: [&str; 2] = ["sh", "bash"];

/// The word behind the language of a script that no test runs.
const NOT_RUN: &str = "norun";

/// Signs that stand behind a word and are not of it.
const AFTER_WORDS: [char; 5] = ['.', ',', ':', ';', ')'];

fn program(arguments: &[&str]) -> Output {
    let mut command = Command::new(PROGRAM);
    command.current_dir(root()).args(arguments);
    command.output().expect("the program runs")
}

fn blocks() -> Vec<Block> {
    pages().iter().flat_map(Page::blocks).collect()
}

#[test]
fn every_page_is_in_the_summary_once() {
    let book = root().join("book/src");
    let summary = fs::read_to_string(book.join("SUMMARY.md")).expect("the summary");
    let listed = links(&summary);
    let unique: BTreeSet<_> = listed.iter().cloned().collect();
    assert_eq!(listed.len(), unique.len(), "a page is listed twice");
    let names = pages().into_iter().map(|page| page.name);
    let there = names.filter_map(|name| name.strip_prefix("book/src/").map(str::to_owned));
    let there: BTreeSet<_> = there.filter(|name| name != "SUMMARY.md").collect();
    assert_eq!(unique, there);
}

#[test]
fn every_link_leads_somewhere() {
    let root = root();
    for page in pages() {
        let folder = Path::new(&page.name).parent().expect("a folder");
        for link in links(&page.text) {
            let (target, anchor) = parts_of(&link);
            let path = match target {
                "" => PathBuf::from(&page.name),
                _ => without_dots(&folder.join(target)),
            };
            let place = format!("{}: {link}", page.name);
            assert!(root.join(&path).exists(), "{place}: no such file");
            // What lies outside of the book's folder is not in the book that is built.
            let is_inside = path.starts_with("book/src") || page.name == "README.md";
            assert!(is_inside, "{place}: not in the book");
            if let Some(anchor) = anchor {
                let text = fs::read_to_string(root.join(&path)).expect("a page");
                let is_there = anchors(&text).iter().any(|name| name == anchor);
                assert!(is_there, "{place}: no such heading");
            }
        }
    }
}

/// The last author and the year of each "(Author & Author 1968)" or "Author et al. (1968)".
fn cited(text: &str) -> Vec<(String, String)> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let pairs = words.windows(4).filter_map(|four| {
        let after_year = four[3].trim_start_matches('(');
        let (year, rest) = after_year.split_at_checked(4)?;
        let is_year = year
            .parse()
            .is_ok_and(|year: u32| (1800..2100).contains(&year));
        let is_whole = rest.is_empty() || rest.starts_with([')', ',', ';', ':', '.']);
        let author = match four[2] {
            "al." => four[0],
            author => author,
        };
        let author = author.trim_start_matches('(').trim_end_matches(',');
        let author = author.strip_suffix("'s").unwrap_or(author);
        let is_name =
            author.starts_with(char::is_uppercase) && author.chars().all(char::is_alphabetic);
        (is_year && is_whole && is_name).then(|| (author.to_owned(), year.to_owned()))
    });
    pairs.collect()
}

#[test]
fn every_cited_work_is_on_the_page_of_sources() {
    let sources = fs::read_to_string(root().join("book/src/theory/sources.md")).expect("sources");
    let works: Vec<&str> = sources.split("\n- ").collect();
    let pages = pages()
        .into_iter()
        .filter(|page| page.name.starts_with("book/"));
    let mut count = 0;
    for page in pages.filter(|page| page.name != REFERENCE && !page.name.ends_with("sources.md")) {
        for (author, year) in cited(&page.text) {
            let is_listed = works
                .iter()
                .any(|work| work.contains(&author) && work.contains(&year));
            assert!(
                is_listed,
                "{}: {author} {year} is not on the page of sources",
                page.name
            );
            count += 1;
        }
    }
    assert!(count > 40, "only {count} citations");
}

#[test]
fn every_schema_is_on_a_page() {
    let path = root().join("book/src/reference/schemas.md");
    let page = fs::read_to_string(path).expect("the page");
    for kind in towermodes_files::RESULTS {
        let file = format!("crates/towermodes-files/schemas/{}.json}}}}", kind.name);
        assert!(page.contains(&file), "{file} is not included");
    }
}

/// Every word between backticks, and every line of a block.
fn code(page: &Page) -> Vec<String> {
    let text = prose(&page.text).replace('\n', " ");
    let spans = text.split('`').skip(1).step_by(2).map(str::to_owned);
    let blocks = page.blocks().into_iter();
    let lines = blocks.flat_map(|block| {
        let lines: Vec<_> = block.text.lines().map(str::to_owned).collect();
        lines
    });
    spans.chain(lines).collect()
}

/// The words in which the reference names something: the commands of two words, or what begins with
/// two dashes.
fn words_of_the_reference() -> (BTreeSet<String>, BTreeSet<String>) {
    let reference = String::from_utf8(program(&["reference"]).stdout).expect("text");
    let headings = reference
        .lines()
        .filter_map(|line| line.strip_prefix("## `towermodes "));
    let commands = headings.map(|line| line.trim_end_matches('`').to_owned());
    let options = reference
        .split(['`', ' '])
        .filter(|word| word.starts_with("--"));
    let options = options.map(|word| word.trim_end_matches(AFTER_WORDS).to_owned());
    (commands.collect(), options.collect())
}

#[test]
fn commands_and_options_that_are_named_are_there() {
    let (mut commands, mut options) = words_of_the_reference();
    commands.extend(["help", "reference"].map(str::to_owned));
    options.extend(["--help", "--version"].map(str::to_owned));
    // Of cargo, of SLURM and of Dask.
    let others = [
        "--workspace",
        "--path",
        "--release",
        "--root",
        "--features",
        "--locked",
        "--bench",
        "--test",
        "--array",
        "--cpus-per-task",
        "--job-name",
        "--mem",
        "--requeue",
        "--time",
        "--wait",
        "--lifetime",
    ];
    options.extend(others.map(str::to_owned));
    let is_name = |word: &str| {
        word.starts_with(|sign: char| sign.is_ascii_lowercase()) && !word.contains(['.', '/'])
    };
    for page in pages() {
        // Python imports a package of this name.
        let is_command = |code: &String| !code.contains("import towermodes");
        for code in code(&page).into_iter().filter(is_command) {
            let mut words = code
                .split_whitespace()
                .skip_while(|word| *word != "towermodes")
                .skip(1);
            if let Some(command) = words.next().filter(|word| is_name(word)) {
                let holds = commands.contains(command);
                assert!(holds, "{}: no command {command} in `{code}`", page.name);
                let second = words
                    .next()
                    .filter(|word| command == "elastodyn" && is_name(word));
                let both = second.map(|second| format!("{command} {second}"));
                let holds = both.iter().all(|both| commands.contains(both));
                assert!(holds, "{}: `{code}`", page.name);
            }
            // Cargo has options of its own.
            if code.starts_with("cargo ") {
                continue;
            }
            for word in code.split([' ', '=']).filter(|word| word.starts_with("--")) {
                let word = word.trim_end_matches(AFTER_WORDS);
                let is_name =
                    word.len() > 2 && word[2..].starts_with(|sign: char| sign.is_ascii_lowercase());
                let holds = !is_name || options.contains(word);
                assert!(holds, "{}: no option {word} in `{code}`", page.name);
            }
        }
    }
}

/// A command that no test runs may be wrong tomorrow. What cannot be run says so: `sh norun`, for
/// what builds the program or for pipes to programs that may not be there.
#[test]
fn every_command_is_run() {
    for block in blocks() {
        let (place, language) = (&block.place, block.language());
        let is_session = SESSIONS.contains(&language);
        if is_session {
            assert_eq!(
                block.info, language,
                "{place}: sessions are compared, all of them"
            );
        } else if SCRIPTS.contains(&language) {
            let word = block.info[language.len()..].trim();
            let holds = word.is_empty() || word == NOT_RUN;
            assert!(holds, "{place}: what is {word}?");
            let own = block
                .text
                .lines()
                .filter(|line| line.starts_with("towermodes"));
            let is_needed = own.clone().all(|line| line.contains('|'));
            assert!(word.is_empty() || is_needed, "{place}: this can be run");
        } else {
            let typed = block
                .text
                .lines()
                .find(|line| line.starts_with("$ ") || line.starts_with("towermodes "));
            // The usage of each command stands in the reference.
            let is_usage = block.place.starts_with(REFERENCE);
            assert!(
                typed.is_none() || is_usage,
                "{place}: a command in a block of {language:?}: {typed:?}"
            );
        }
    }
    for page in pages() {
        let indented = prose(&page.text);
        let typed = indented
            .lines()
            .find(|line| line.starts_with("    towermodes ") || line.starts_with("    $ "));
        assert!(
            typed.is_none(),
            "{}: a command that is only indented: {typed:?}",
            page.name
        );
    }
}

/// The scripts of a page are run one after the other in a folder with the examples and a reader's
/// files; each must end with exit code 0. Those of the reference know nothing of each other.
#[cfg(unix)]
#[test]
fn the_scripts_do_what_they_should() {
    let fresh = Sandbox::new("scripts");
    for page in pages() {
        let blocks = page.blocks();
        let is_run =
            |block: &&Block| SCRIPTS.contains(&block.language()) && !block.info.contains(NOT_RUN);
        let scripts: Vec<&Block> = blocks.iter().filter(is_run).collect();
        let together = if page.name == REFERENCE {
            1
        } else {
            scripts.len().max(1)
        };
        for scripts in scripts.chunks(together) {
            let sandbox = fresh.another(&page.name.replace(['/', '.'], "-"));
            sandbox.write_files_of(&page);
            run_in(&sandbox, scripts);
        }
    }
}

/// A command that serves a page until it is ended.
#[cfg(unix)]
const SERVED: &str = "towermodes explore ";

/// Such a command prints the address of its page; then it is ended.
#[cfg(unix)]
fn serves(line: &str, sandbox: &Sandbox, path: &std::ffi::OsStr) {
    use std::io::{BufRead, BufReader};
    use std::process::Stdio;
    let mut served = Command::new("sh")
        .args(["-e", "-c", &format!("exec {line} --no-open")])
        .current_dir(sandbox.path())
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .env("PATH", path)
        .spawn()
        .expect("a shell");
    let mut address = String::new();
    let output = served.stdout.take().expect("its output");
    let read = BufReader::new(output).read_line(&mut address);
    let _ = served.kill();
    let _ = served.wait();
    let holds = read.is_ok() && address.starts_with("http://127.0.0.1:");
    assert!(holds, "{line}: {address:?}");
}

#[cfg(unix)]
fn run_in(sandbox: &Sandbox, scripts: &[&Block]) {
    let path = sandbox.commands();
    for script in scripts {
        let mut shell = Command::new("sh");
        shell
            .args(["-e", "-c", &script.text])
            .current_dir(sandbox.path())
            .stdin(std::process::Stdio::null())
            .env("PATH", &path)
            .env("HOME", sandbox.path());
        if script.text.contains(SERVED) {
            for line in script.text.lines() {
                let holds = line.starts_with(SERVED);
                assert!(holds, "{}: {line} with others", script.place);
                serves(line, sandbox, &path);
            }
            continue;
        }
        let output = shell.output().expect("a shell");
        let said = String::from_utf8_lossy(&output.stderr);
        let is_done = output.status.success();
        assert!(is_done, "{}: {}\n{said}", script.place, script.text);
    }
}

/// What is shown of a tower file is one: whole, or put below the last whole one of its page, or
/// else below the first tower.
#[test]
fn the_towers_are_towers() {
    let sandbox = Sandbox::new("towers");
    let first = root().join("examples/reference-tower.toml");
    let first = fs::read_to_string(first).expect("the example");
    for page in pages() {
        let mut whole = first.clone();
        let blocks = page.blocks();
        for block in blocks.iter().filter(|block| block.language() == "toml") {
            let mut text = block.text.clone();
            if text.contains("[sweep]") {
                let study = sandbox.path().join("shown-study.toml");
                fs::write(&study, text).expect("written");
                let output = program(&["sweep", &study.display().to_string()]);
                let said = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{}: {said}", block.place);
                continue;
            }
            if text.contains("[design.") {
                let study = sandbox.path().join("shown-design.toml");
                fs::write(&study, text).expect("written");
                let study = study.display().to_string();
                let output = program(&["design", "examples/nrel-5mw.toml", &study]);
                // A study that no tower meets is a study too.
                let said = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.code() != Some(2), "{}: {said}", block.place);
                continue;
            }
            if text.contains("[[measured]]") {
                let measured = sandbox.path().join("shown-measured.toml");
                fs::write(&measured, text).expect("written");
                let measured = measured.display().to_string();
                let output = program(&["calibrate", "examples/monopile.toml", &measured]);
                let said = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{}: {said}", block.place);
                continue;
            }
            if text.contains("[tower") {
                whole.clone_from(&text);
            } else {
                text = format!("{whole}\n{text}");
            }
            let file = sandbox.path().join("shown.toml");
            fs::write(&file, text).expect("written");
            let output = program(&["check", &file.display().to_string()]);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{}: {said}", block.place);
        }
    }
}

#[test]
fn the_command_line_is_that_of_the_program() {
    let page = root().join(REFERENCE);
    let output = program(&["reference"]);
    assert!(output.status.success());
    if std::env::var_os("TRYCMD").is_some_and(|what| what == "overwrite") {
        fs::write(&page, &output.stdout).expect("written");
    }
    let in_book = fs::read(&page).expect("the page");
    let holds = output.stdout == in_book;
    assert!(holds, "run: towermodes reference > {REFERENCE}");
}

/// The chapter with the table of methods.
const METHODS: &str = "book/src/theory/method.md";

/// Help, report and book describe a method in the same words.
#[test]
fn the_methods_are_those_of_the_library() {
    let chapter = fs::read_to_string(root().join(METHODS)).expect("the page");
    let command_line = fs::read_to_string(root().join(REFERENCE)).expect("the page");
    for method in towermodes::Method::ALL {
        let (name, description) = (method.name(), method.description());
        let row = format!("| `{name}` | {description} |");
        assert!(chapter.contains(&row), "{METHODS}: {row}");
        let value = format!("`{name}` ({description})");
        assert!(command_line.contains(&value), "{REFERENCE}: {value}");
    }
}
