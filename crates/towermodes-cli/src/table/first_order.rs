//! The scatter of frequencies to first order as text.

use towermodes::Tower;
use towermodes::number::{Rounded, digits};
use towermodes_sweep::{FirstOrder, MarginCheck, ModeScatter, NoScatter, Scatter};

use super::text::{align_right, aligned, plain_table, title, wrapped};

/// Mean and standard deviation of each mode; the share of each input; the probability that a margin
/// is violated; an explanation of the numbers.
pub fn first_order(
    tower: &Tower,
    found: &FirstOrder,
    check: Option<&MarginCheck>,
    is_correlated: bool,
) -> String {
    let mut text = title(tower);
    text.push_str(&statistics(found));
    text.push_str("\n\n");
    text.push_str(&shares(found));
    text.push('\n');
    if let Some(check) = check {
        text.push('\n');
        text.push_str(&probabilities(found, check));
        text.push('\n');
    }
    for sentence in footer(found, check.is_some(), is_correlated) {
        text.push('\n');
        text.push_str(&wrapped(&sentence));
    }
    text.push('\n');
    text
}

fn known(mode: &ModeScatter) -> Option<&Scatter> {
    mode.scatter.as_ref().ok()
}

fn statistics(found: &FirstOrder) -> String {
    let mut table = plain_table();
    let header = [
        "first order",
        "mean",
        "std. dev.",
        "shift of the mean by curvature",
    ];
    table.set_header(header);
    for mode in &found.modes {
        let name = format!("{}, Hz", mode.name.label());
        let numbers = known(mode).map(|scatter| {
            let shift = scatter.mean_shift_hz;
            [
                digits(scatter.mean_hz, 5),
                digits(scatter.deviation_hz, 3),
                shift.map_or("not known".to_owned(), |shift| digits(shift, 2)),
            ]
        });
        let numbers = numbers.unwrap_or_else(|| ["-"; 3].map(str::to_owned));
        table.add_row(std::iter::once(name).chain(numbers));
    }
    align_right(&mut table, 1..4);
    table.trim_fmt()
}

/// A row for each input, a column for each mode.
fn shares(found: &FirstOrder) -> String {
    let mut table = plain_table();
    let mut header = vec!["share of the variance", "mean", "std. dev.", "unit"];
    let labels: Vec<String> = found.modes.iter().map(|mode| mode.name.label()).collect();
    header.extend(labels.iter().map(String::as_str));
    table.set_header(header);
    let column = |mode: &ModeScatter| {
        let cell = |index: usize| match known(mode) {
            Some(scatter) => format!("{:.1} %", 100.0 * scatter.shares[index] + 0.0),
            None => "-".to_owned(),
        };
        aligned((0..found.inputs.len()).map(cell))
    };
    let columns: Vec<Vec<String>> = found.modes.iter().map(column).collect();
    for (row, input) in found.inputs.iter().enumerate() {
        let mut cells = vec![
            input.name.clone(),
            Rounded(input.mean).to_string(),
            digits(input.deviation, 3),
            input.unit.to_owned(),
        ];
        cells.extend(columns.iter().map(|column| column[row].clone()));
        table.add_row(cells);
    }
    align_right(
        &mut table,
        [1, 2].into_iter().chain(4..4 + found.modes.len()),
    );
    table.trim_fmt()
}

/// A row for each mode, a column for each multiple of the rotor speed.
fn probabilities(found: &FirstOrder, check: &MarginCheck) -> String {
    let mut table = plain_table();
    let name = format!(
        "probability of a distance below {} %",
        Rounded(100.0 * check.margin)
    );
    let multiples = check.multiples.iter();
    let multiples = multiples.map(|multiple| format!("{multiple}P"));
    table.set_header(std::iter::once(name).chain(multiples));
    for mode in &found.modes {
        let cells = match known(mode) {
            Some(scatter) => scatter.violated.iter().copied().map(percent).collect(),
            None => vec!["-".to_owned(); check.multiples.len()],
        };
        table.add_row(std::iter::once(mode.name.label()).chain(cells));
    }
    align_right(&mut table, 1..=check.multiples.len());
    table.trim_fmt()
}

/// A probability in percent. Very small ones are not given, because a normal distribution is not
/// accurate there.
fn percent(probability: f64) -> String {
    match 100.0 * probability {
        percent if percent < 1e-4 => "0 %".to_owned(),
        percent => format!("{} %", digits(percent, 3)),
    }
}

fn footer(found: &FirstOrder, has_check: bool, is_correlated: bool) -> Vec<String> {
    let mut sentences = vec![
        "first order: the frequencies are linear functions of the varied inputs, with the derivatives at the mean values of the inputs; no rows are solved"
            .to_owned(),
    ];
    sentences.push(
        "shift of the mean by curvature: estimated second-order shift of the mean, not included in the mean above; if the shift is not small compared with the standard deviation, solve rows (without --first-order)"
            .to_owned(),
    );
    if has_check {
        sentences.push("probability: assumes a normal distribution of the frequency".to_owned());
    }
    if is_correlated {
        sentences.push(
            "the inputs are correlated: covariance terms are split equally between the two inputs, so a share may be negative"
                .to_owned(),
        );
    }
    for mode in &found.modes {
        if let Err(reason) = &mode.scatter {
            let remedy = match reason {
                NoScatter::NoDerivative { .. } => "solve rows (without --first-order)",
                _ => "move the mean values towards the original tower, or solve rows",
            };
            sentences.push(format!("{}: {reason}; {remedy}", mode.name.label()));
        }
    }
    sentences
}
