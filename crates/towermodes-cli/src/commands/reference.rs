//! The command line as a chapter of the book, generated from the definitions of clap, so that both
//! always agree.

use clap::builder::StyledStr;
use clap::{Arg, Command, CommandFactory};

use super::Arguments;
use crate::failure::Failure;
use crate::output::deliver;

/// The introduction of the chapter.
const INTRODUCTION: &str = "# The command line

Every command with its arguments and options. This chapter is printed by `towermodes reference`; a test compares it with the output of the program.
`towermodes COMMAND --help` shows the text of a command in the terminal, `towermodes man COMMAND` shows it as a manual page. Exit codes are on
[a separate page](exit-codes.md).
";

/// `towermodes reference`.
pub(crate) fn run() -> Result<(), Failure> {
    let mut program = Arguments::command();
    program.build();
    deliver(chapter(&program).as_bytes(), None)
}

/// The chapter: a list of all commands, and a section for each.
fn chapter(program: &Command) -> String {
    let name = program.get_name();
    let commands = commands_of(program, name);
    let mut text = INTRODUCTION.to_owned();
    text.push_str("\n| command | |\n|---|---|\n");
    for (name, command) in &commands {
        let anchor = name.replace(' ', "-");
        let about = command.get_about().map(plain).unwrap_or_default();
        text.push_str(&format!("| [`{name}`](#{anchor}) | {about} |\n"));
    }
    for (name, command) in &commands {
        text.push_str(&section(name, command));
    }
    text
}

/// All commands with their full names; each command is before its subcommands.
fn commands_of<'a>(parent: &'a Command, name: &str) -> Vec<(String, &'a Command)> {
    let shown = parent
        .get_subcommands()
        .filter(|command| !command.is_hide_set() && command.get_name() != "help");
    let mut commands = Vec::new();
    for command in shown {
        let name = format!("{name} {}", command.get_name());
        let below = commands_of(command, &name);
        commands.push((name, command));
        commands.extend(below);
    }
    commands
}

/// The section of one command: description, usage, arguments, examples.
fn section(name: &str, command: &Command) -> String {
    let about = command.get_about().map(plain).unwrap_or_default();
    let usage = command.clone().render_usage().to_string();
    let usage = usage.trim().trim_start_matches("Usage: ").to_owned();
    let mut text = format!("\n## `{name}`\n\n{about}.\n\n```text\n{usage}\n```\n");
    text.push_str(&arguments(command));
    for heading in headings(command) {
        text.push_str(&options(command, heading));
    }
    if let Some(after) = command.get_after_help() {
        text.push_str(&after_help(&after.to_string()));
    }
    text
}

/// The table of positional arguments.
fn arguments(command: &Command) -> String {
    let rows: Vec<String> = command
        .get_positionals()
        .filter(|argument| !argument.is_hide_set())
        .map(|argument| row(&format!("`{argument}`"), argument))
        .collect();
    table("argument", &rows)
}

/// The headings of the options, in order; the first is none.
fn headings(command: &Command) -> Vec<Option<&str>> {
    let mut headings = vec![None];
    for option in command.get_opts().chain(command.get_arguments()) {
        let heading = option.get_help_heading();
        if !option.is_positional() && !headings.contains(&heading) {
            headings.push(heading);
        }
    }
    headings
}

/// The table of the options under one heading.
fn options(command: &Command, heading: Option<&str>) -> String {
    let is_one = |option: &&Arg| {
        !option.is_positional()
            && !option.is_hide_set()
            && option.get_id() != "help"
            && option.get_help_heading() == heading
    };
    let rows: Vec<String> = command
        .get_arguments()
        .filter(is_one)
        .map(|option| row(&option_name(option), option))
        .collect();
    let first = heading.map_or_else(|| "option".to_owned(), str::to_lowercase);
    table(&first, &rows)
}

/// An option with its short form first.
fn option_name(option: &Arg) -> String {
    let short = option.get_short().map(|short| format!("`-{short}`, "));
    // clap writes `--format <FORMAT>`, of a flag `--format`.
    format!("{}`{option}`", short.unwrap_or_default())
}

fn table(first: &str, rows: &[String]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    format!("\n| {first} | |\n|---|---|\n{}", rows.concat())
}

/// A table row: name, description, possible values, default.
fn row(name: &str, argument: &Arg) -> String {
    let help = argument.get_help().map(plain).unwrap_or_default();
    let help = help.trim_end_matches('.');
    format!(
        "| {name} | {help}{}{} |\n",
        values(argument),
        default(argument)
    )
}

/// The possible values with their descriptions.
fn values(argument: &Arg) -> String {
    if !argument.get_action().takes_values() {
        return String::new();
    }
    let values = argument.get_possible_values();
    let shown = values.iter().filter(|value| !value.is_hide_set());
    let named: Vec<String> = shown
        .map(|value| {
            let help = value.get_help().map(plain).unwrap_or_default();
            let help = help.trim_end_matches('.');
            if help.is_empty() {
                format!("`{}`", value.get_name())
            } else {
                format!("`{}` ({help})", value.get_name())
            }
        })
        .collect();
    if named.is_empty() {
        String::new()
    } else {
        format!(": {}", named.join(", "))
    }
}

fn default(argument: &Arg) -> String {
    let values = argument.get_default_values();
    let is_shown = !argument.is_hide_default_value_set() && argument.get_action().takes_values();
    if values.is_empty() || !is_shown {
        return String::new();
    }
    let values: Vec<_> = values.iter().map(|value| value.to_string_lossy()).collect();
    format!(" [default: `{}`]", values.join(","))
}

/// The text after the options: examples as a code block, sentences as paragraphs.
fn after_help(text: &str) -> String {
    let mut markdown = String::new();
    for paragraph in text.trim().split("\n\n") {
        let mut lines = paragraph.lines();
        match lines.next() {
            Some("Example:" | "Examples:") => {
                let lines: Vec<_> = lines.map(str::trim_start).collect();
                markdown.push_str(&format!("\n```sh\n{}\n```\n", lines.join("\n")));
            }
            _ => markdown.push_str(&format!("\n{}\n", escaped(paragraph))),
        }
    }
    markdown
}

/// A help text in one line, without the colours of a terminal.
fn plain(text: &StyledStr) -> String {
    let text = text.to_string();
    let words: Vec<_> = text.split_whitespace().collect();
    escaped(&words.join(" ")).replace('|', "\\|")
}

/// Escapes Markdown characters; text between backticks is code and unchanged.
fn escaped(text: &str) -> String {
    let parts = text.split('`').enumerate().map(|(index, part)| {
        if index % 2 == 1 {
            return part.to_owned();
        }
        let mut escaped = part.replace('<', "&lt;");
        for sign in ['*', '_'] {
            escaped = escaped.replace(sign, &format!("\\{sign}"));
        }
        escaped
    });
    parts.collect::<Vec<_>>().join("`")
}

#[cfg(test)]
mod tests {
    use clap::Arg;

    use super::{after_help, default, escaped};

    #[test]
    fn signs_mean_themselves_outside_of_code() {
        assert_eq!(
            escaped("a HAWC2 _st.dat < 2 `a_b`"),
            "a HAWC2 \\_st.dat &lt; 2 `a_b`"
        );
    }

    /// A default that the help text describes is not repeated.
    #[test]
    fn a_default_is_said_once() {
        let hidden = Arg::new("title")
            .long("title")
            .default_value("")
            .hide_default_value(true);
        assert_eq!(default(&hidden), "");
        let shown = Arg::new("nodes").long("nodes").default_value("20");
        assert_eq!(default(&shown), " [default: `20`]");
    }

    #[test]
    fn examples_become_a_block() {
        let text = "Examples:\n  towermodes verify\n\nExit codes: 0\nor 1.";
        let expected = "\n```sh\ntowermodes verify\n```\n\nExit codes: 0\nor 1.\n";
        assert_eq!(after_help(text), expected);
    }
}
