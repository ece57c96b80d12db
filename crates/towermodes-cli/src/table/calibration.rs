//! Fitted input values as text.

use towermodes::number::{Rounded, digits};
use towermodes_design::calibration::{Calibration, Fitted};
use towermodes_report::wording::counted;

use super::text::{align_right, name_line, plain_table, text_table, wrapped};

/// The unknowns, the measurements, correlations, singular values and remarks.
pub fn calibration(name: &str, result: &Calibration) -> String {
    let mut text = name_line(name);
    text.push_str(&unknowns(result));
    text.push_str("\n\n");
    text.push_str(&measured(result));
    text.push_str("\n\n");
    if result.unknowns.iter().any(|one| one.prior.is_some()) {
        text.push_str(&priors(result));
        text.push_str("\n\n");
    }
    if result.unknowns.len() > 1 {
        text.push_str(&correlations(result));
        text.push_str("\n\n");
    }
    text.push_str(&summary(result));
    for remark in result.remarks() {
        text.push_str(&wrapped(&format!("- {remark}")));
        text.push('\n');
    }
    text
}

/// A row for each unknown: its value before and after the fit, and its uncertainty.
fn unknowns(result: &Calibration) -> String {
    let row = |(index, one): (usize, &Fitted)| {
        let interval = one
            .interval
            .map_or("at its bound".to_owned(), |[low, high]| {
                format!("{} to {}", short(low), short(high))
            });
        [
            one.name.clone(),
            one.unit.to_owned(),
            one.before
                .map_or("-".to_owned(), |value| Rounded(value).to_string()),
            short(one.value),
            one.deviation
                .map_or("-".to_owned(), |deviation| digits_or_power(deviation, 2)),
            interval,
            decided_by(result, index),
        ]
    };
    let header = [
        "fitted input",
        "unit",
        "before",
        "fitted",
        "std. dev.",
        "68 % interval",
        "largest source of information",
    ];
    text_table(header, result.unknowns.iter().enumerate().map(row), 2..5)
}

/// A number with four digits.
fn short(value: f64) -> String {
    digits_or_power(value, 4)
}

fn digits_or_power(value: f64, count: usize) -> String {
    match value.abs() {
        1e-3..1e6 => digits(value, count),
        _ => Rounded(format!("{value:.*e}", count - 1).parse().unwrap_or(value)).to_string(),
    }
}

/// The measurement or prior with the largest share of an unknown's variance.
fn decided_by(result: &Calibration, index: usize) -> String {
    let shares = &result.shares[index];
    let largest = shares.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1));
    let Some((place, share)) = largest else {
        return "-".to_owned();
    };
    let data = result.measured.len();
    let name = match place.checked_sub(data) {
        None => result.measured[place].mode.to_string(),
        Some(prior) => {
            let mut with_prior = result.unknowns.iter().filter(|one| one.prior.is_some());
            let own = with_prior.nth(prior);
            own.map_or(String::new(), |one| {
                match one.name == result.unknowns[index].name {
                    true => "its prior".to_owned(),
                    false => format!("the prior of {}", one.name),
                }
            })
        }
    };
    format!("{name} ({:.0} %)", 100.0 * share)
}

/// A row for each measurement.
fn measured(result: &Calibration) -> String {
    let rows = result.measured.iter().map(|one| {
        [
            one.mode.label(),
            format!("{:.5}", one.measured_hz),
            digits(one.deviation_hz, 2),
            format!("{:.5}", one.before_hz),
            format!("{:.5}", one.fitted_hz),
            format!("{:+.2}", one.residual),
        ]
    });
    let header = [
        "measured mode",
        "measured, Hz",
        "std. dev.",
        "before, Hz",
        "fitted, Hz",
        "residual/std. dev.",
    ];
    text_table(header, rows, 1..6)
}

/// A row for each prior: how far the fitted value differs from its mean.
fn priors(result: &Calibration) -> String {
    let with_prior = result.unknowns.iter().filter_map(|one| {
        let prior = one.prior?;
        Some([
            one.name.clone(),
            one.unit.to_owned(),
            short(prior.mean),
            digits_or_power(prior.deviation, 2),
            short(one.value),
            one.prior_residual
                .map_or("-".to_owned(), |residual| format!("{residual:+.2}")),
        ])
    });
    let header = [
        "prior of",
        "unit",
        "mean",
        "std. dev.",
        "fitted",
        "residual/std. dev.",
    ];
    text_table(header, with_prior, 2..6)
}

fn correlations(result: &Calibration) -> String {
    let mut table = plain_table();
    let names = result.unknowns.iter().map(|one| one.name.clone());
    table.set_header(std::iter::once("correlation".to_owned()).chain(names.clone()));
    for (name, row) in names.zip(&result.correlations) {
        let cells = row.iter().map(|value| match value.is_nan() {
            true => "-".to_owned(),
            false => format!("{value:+.3}"),
        });
        table.add_row(std::iter::once(name).chain(cells));
    }
    align_right(&mut table, 1..=result.unknowns.len());
    table.trim_fmt()
}

/// Chi-square, the singular values, the certificate.
fn summary(result: &Calibration) -> String {
    let values = result.directions.iter();
    let values = values.map(|one| match one.singular_value < 0.005 {
        true => "0".to_owned(),
        false => digits(one.singular_value, 3),
    });
    let values: Vec<String> = values.collect();
    let certificate = match result.is_certified {
        true => " No mode is missing below the reported frequencies (eigenvalue count).",
        false => "",
    };
    // Below this it is rounding.
    let chi_square = match result.chi_square < 1e-6 {
        true => "0".to_owned(),
        false => digits(result.chi_square, 3),
    };
    let text = format!(
        "Chi-square {} with {} of freedom. Singular values of the scaled Jacobian (below 1: not determined): {}.{certificate}",
        chi_square,
        counted(result.degrees_of_freedom, "degree"),
        values.join(", ")
    );
    wrapped(&text) + "\n"
}
