//! Verdicts in tables on a terminal.

use clap::builder::styling::{AnsiColor, Style};
use towermodes_analysis::Verdict;
use towermodes_report::wording::verdict_word;

/// The verdicts that have a colour.
const VERDICTS: [Verdict; 3] = [Verdict::Pass, Verdict::Warn, Verdict::Fail];

/// How a verdict is shown; the word says the same without colour.
fn style(verdict: Verdict) -> Style {
    match verdict {
        Verdict::Pass => AnsiColor::Green.on_default(),
        Verdict::Warn => AnsiColor::Yellow.on_default().bold(),
        Verdict::Fail => AnsiColor::Red.on_default().bold(),
        Verdict::Undecided => Style::new(),
    }
}

/// A text with the verdicts of its tables in colour. The terminal, or `NO_COLOR`, decides whether
/// they are seen: `anstream` removes them.
pub(super) fn coloured(text: &str) -> String {
    let lines = text
        .split_inclusive('\n')
        .map(|line| match line.starts_with(' ') {
            true => line
                .split_inclusive([' ', '\n'])
                .map(coloured_word)
                .collect(),
            false => line.to_owned(),
        });
    lines.collect()
}

fn coloured_word(word: &str) -> String {
    let bare = word.trim_end();
    let is_own = |verdict: &Verdict| [verdict_word(*verdict), verdict.name()].contains(&bare);
    match VERDICTS.into_iter().find(is_own).map(style) {
        Some(style) => format!("{style}{bare}{style:#}{}", &word[bare.len()..]),
        None => word.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::coloured;

    #[test]
    fn verdicts_of_tables_have_a_colour_and_other_words_have_none() {
        let text = "FAIL as a sentence\n 1st torsion  PASS\n at 3 m  +0.6 % warn  bypass\n";
        let shown = "FAIL as a sentence\n 1st torsion  \u{1b}[32mPASS\u{1b}[0m\n at 3 m  +0.6 % \u{1b}[1m\u{1b}[33mwarn\u{1b}[0m  bypass\n";
        assert_eq!(coloured(text), shown);
    }
}
