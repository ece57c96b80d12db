//! Statistics of a sweep as text: frequencies, violated margins, failures.

use towermodes::number::{Rounded, digits};
use towermodes::{Tower, printable};
use towermodes_report::wording::structure_mass;
use towermodes_sweep::{MarginCheck, MarginSummary, ModeSummary, QUANTILES, Statistics, Summary};

use super::text::{align_right, plain_table, title, wrapped};

/// Largest number of failures that are listed.
const MOST_FAILURES: usize = 10;

/// Statistics of the mass and of each frequency; the share of the rows in which a margin is
/// violated; the rows that failed.
pub(crate) fn sweep_summary(
    tower: &Tower,
    summary: &Summary,
    check: Option<&MarginCheck>,
) -> String {
    let mut text = title(tower);
    text.push_str(&statistics(tower, summary));
    text.push('\n');
    if let Some(check) = check {
        text.push('\n');
        text.push_str(&margins(summary, check));
        text.push('\n');
        text.extend(spread(summary).map(|line| wrapped(&line) + "\n"));
    }
    text.push_str(&failures(summary));
    text
}

/// A row for the mass and each mode.
fn statistics(tower: &Tower, summary: &Summary) -> String {
    let mut table = plain_table();
    let quantiles = QUANTILES.map(|share| format!("{} %", Rounded(100.0 * share)));
    let mut header = vec!["".to_owned()];
    header.extend(["mean", "std. dev.", "lowest"].map(str::to_owned));
    header.extend(quantiles);
    header.extend(["highest", "largest error"].map(str::to_owned));
    let columns = header.len();
    table.set_header(header);
    let mass = cells(summary.mass_kg.as_ref(), 1e-3, 4);
    let first = std::iter::once(format!("{}, t", structure_mass(tower.frame())));
    table.add_row(first.chain(mass).chain([String::new()]));
    for mode in &summary.modes {
        let error = match mode.frequency_hz {
            Some(_) => digits(mode.largest_error_hz, 2),
            None => String::new(),
        };
        let frequency = cells(mode.frequency_hz.as_ref(), 1.0, 5);
        let name = std::iter::once(format!("{}, Hz", mode.name.label()));
        table.add_row(name.chain(frequency).chain([error]));
    }
    align_right(&mut table, 1..columns);
    table.trim_fmt()
}

/// Mean, deviation, lowest, quantiles, highest.
fn cells(of: Option<&Statistics>, factor: f64, count: usize) -> Vec<String> {
    let Some(of) = of else {
        return vec!["-".to_owned(); 4 + QUANTILES.len()];
    };
    let shown = |value: f64| digits(factor * value, count);
    let mut cells = vec![
        shown(of.mean),
        digits(factor * of.deviation, 3),
        shown(of.min),
    ];
    cells.extend(of.quantiles.iter().map(|value| shown(*value)));
    cells.push(shown(of.max));
    cells
}

/// A row for each mode, a column for each multiple of the rotor speed.
fn margins(summary: &Summary, check: &MarginCheck) -> String {
    let mut table = plain_table();
    let name = format!(
        "share of rows with a distance below {} %",
        Rounded(100.0 * check.margin)
    );
    let multiples = check
        .multiples
        .iter()
        .map(|multiple| format!("{multiple}P"));
    table.set_header(std::iter::once(name).chain(multiples));
    for mode in &summary.modes {
        table.add_row(
            std::iter::once(mode.name.label()).chain(shares(mode, summary.rows_are_independent)),
        );
    }
    align_right(&mut table, 1..=check.multiples.len());
    table.trim_fmt()
}

/// The largest effect of the frequency errors on a share of violated rows, if it is more than a
/// thousandth of the rows.
fn spread(summary: &Summary) -> Option<String> {
    let modes = summary.modes.iter();
    let all = modes.flat_map(|mode| mode.margins.iter().map(move |margin| (mode, margin)));
    let width = |margin: &MarginSummary| {
        let [least, most] = margin.probability_within_errors();
        most - least
    };
    let with_rows = all.filter(|(_, margin)| margin.count > 0);
    let (mode, margin) = with_rows.max_by(|a, b| width(a.1).total_cmp(&width(b.1)))?;
    let [least, most] = margin.probability_within_errors();
    (most - least > 1e-3).then(|| {
        format!(
            "the errors of the frequencies can change these shares: the share of {}P with {} is between {} and {} %; more segments narrow this range",
            margin.multiple,
            mode.name.label(),
            digits(100.0 * least, 3),
            digits(100.0 * most, 3),
        )
    })
}

/// "2.3 ± 0.4 %"; without the standard error if the rows are not independent random ones.
fn shares(mode: &ModeSummary, are_independent: bool) -> impl Iterator<Item = String> {
    mode.margins.iter().map(move |margin| match margin.count {
        0 => "-".to_owned(),
        _ => {
            let [share, error] = [margin.probability(), margin.standard_error()];
            match are_independent && error > 0.0 {
                true => format!(
                    "{} \u{b1} {} %",
                    digits(100.0 * share, 3),
                    digits(100.0 * error, 2)
                ),
                false => format!("{} %", digits(100.0 * share, 3)),
            }
        }
    })
}

/// The failed rows by their message.
fn failures(summary: &Summary) -> String {
    let rows = summary.rows;
    if summary.failed == 0 {
        return format!("\nall {rows} rows are solved\n");
    }
    let mut text = format!(
        "\n{} of {rows} rows have no complete result:\n",
        summary.failed
    );
    for kind in summary.failures.iter().take(MOST_FAILURES) {
        let count = match kind.count {
            1 => format!("row {}", kind.row),
            count => format!("{count} rows, first row {}", kind.row),
        };
        text.push_str(&format!("  {count}: {}\n", printable(&kind.sentence)));
    }
    let listed = summary.failures.iter().take(MOST_FAILURES);
    let others = summary.failed - listed.map(|kind| kind.count).sum::<u64>();
    if others > 0 {
        text.push_str(&format!("  {others} rows with other messages\n"));
    }
    text
}
