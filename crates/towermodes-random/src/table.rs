//! The results of the study as tables in Markdown.

use std::fmt::Write as _;

use towermodes::Method;

use super::class::Class;
use super::rotors::TurbineClass;
use super::tally::Tally;

/// A table of the percentage of covered modes and the median of estimated/true error, for each
/// class and method.
pub fn table(methods: &[Method], rows: &[(Class, Vec<Tally>)]) -> String {
    let mut text = String::from("| class | modes |");
    for method in methods {
        let _ = write!(text, " {} |", method.name());
    }
    text.push_str("\n|---|--:|");
    text.push_str(&"--:|".repeat(methods.len()));
    text.push('\n');
    for (class, tallies) in rows {
        let modes = tallies.iter().map(Tally::modes).max().unwrap_or(0);
        let _ = write!(text, "| {} | {modes} |", class.name());
        for tally in tallies {
            let _ = write!(text, " {} |", cell(tally));
        }
        text.push('\n');
    }
    text
}

/// The table for turbines: number of modes, coverage, median of estimated/true error and largest
/// true/estimated error of each class.
pub fn turbine_table(rows: &[(TurbineClass, Tally)]) -> String {
    let mut text = String::from(
        "| class | modes | covered, % | median estimated/true | largest true/estimated |\n|---|--:|--:|--:|--:|\n",
    );
    for (class, tally) in rows {
        let percent = (1e4 * tally.coverage()).floor() / 100.0;
        let number =
            |value: Option<f64>| value.map_or("–".to_owned(), |value| format!("{value:.2}"));
        let _ = writeln!(
            text,
            "| {} | {} | {percent:.2} | {} | {} |",
            class.name(),
            tally.modes(),
            number(tally.median_ratio()),
            number(tally.least_ratio().map(f64::recip)),
        );
    }
    text
}

fn cell(tally: &Tally) -> String {
    let median = match tally.median_ratio() {
        Some(ratio) => format!("{ratio:.2}"),
        None => "–".to_owned(),
    };
    // Nothing but all is 100 %.
    let percent = (1e4 * tally.coverage()).floor() / 100.0;
    format!("{percent:.2} · {median}")
}
