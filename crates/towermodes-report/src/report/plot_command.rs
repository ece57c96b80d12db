//! The commands that reproduce the pictures and results of a report.

use towermodes::GAUSS_HINGE_POSITION;
use towermodes::Options;
use towermodes::number;
use towermodes_analysis::resonance::{Campbell, DEFAULT_MARGIN};

use super::content::ReportContent;
use super::shell::quoted;

/// The Campbell diagram of a whole turbine.
pub(super) const COUPLED: &str = "coupled-campbell";

/// The command that draws the picture `what`.
pub(super) fn plot_command(content: &ReportContent, what: &str) -> String {
    let mut words = vec![format!("--what {what}")];
    match what {
        "shapes" | "structure" => words.push(solved(&content.options)),
        "campbell" => {
            words.push(solved(&content.options));
            if content.turbine.is_some() {
                words.push("--uncoupled".to_owned());
            }
            if let Some(Ok(campbell)) = &content.campbell {
                words.push(rotor(campbell));
            }
        }
        COUPLED => {
            words[0] = "--what campbell".to_owned();
            if let Some(Ok(results)) = &content.turbine {
                words.push(format!("--limit {}", results.coupled.limit_hz));
                words.push(rotor(&results.coupled.campbell));
            }
        }
        "error" => words.push(asked(&content.options)),
        _ => {}
    }
    words.push(format!("--output {what}.svg"));
    command(content, "plot", &words)
}

/// A command on the file of the report, with the same reading options. A file name that looks like
/// an option comes last, after `--`.
pub(super) fn command(content: &ReportContent, name: &str, options: &[String]) -> String {
    let file = content.main_file();
    let is_dashed = file.starts_with('-') && file != "-";
    let file = quoted(file);
    let (first, last) = match is_dashed {
        true => (String::new(), format!("-- {file}")),
        false => (file, String::new()),
    };
    let start = [
        format!("towermodes {name}"),
        first,
        content.circumstances.reading.clone(),
    ];
    let words = start.iter().chain(options).chain([&last]);
    let words: Vec<&str> = words.map(String::as_str).collect();
    let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
    words.join(" ")
}

/// The options of a solution. The method is always included, because a file may prescribe another
/// one.
fn solved(options: &Options) -> String {
    format!("--method {} {}", options.method.name(), asked(options))
}

/// The options that apply to every method.
fn asked(options: &Options) -> String {
    let mut text = format!("--modes {}", options.modes);
    if let Some(segments) = options.segments {
        text.push_str(&format!(" --segments {segments}"));
    }
    if !options.rotary_inertia {
        text.push_str(" --no-rotary-inertia");
    }
    if options.hinge_position != GAUSS_HINGE_POSITION {
        text.push_str(&format!(" --hinges {}", options.hinge_position));
    }
    text
}

fn rotor(campbell: &Campbell) -> String {
    let rotor = &campbell.rotor;
    let multiples: Vec<String> = campbell.multiples.iter().map(ToString::to_string).collect();
    let mut text = format!(
        "--rpm {},{} --blades {} --multiples {}",
        rotor.lowest_rpm,
        rotor.highest_rpm,
        rotor.blades,
        multiples.join(",")
    );
    if campbell.margin != DEFAULT_MARGIN {
        text.push_str(&format!(" --margin {}", number::percent(campbell.margin)));
    }
    text
}
