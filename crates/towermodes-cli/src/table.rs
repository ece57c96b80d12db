//! A solution for people.

use comfy_table::{CellAlignment, Table, presets};
use towermodes::{Method, Mode, Solution, Tower};

/// Frequencies are shown with at least this many decimals, and at most with those a number holds.
const DECIMALS: std::ops::RangeInclusive<i32> = 4..=11;

/// The modes as a table, and one line on what they are of.
pub(crate) fn render(tower: &Tower, solution: &Solution) -> String {
    let mut text = String::new();
    if !tower.name().is_empty() {
        text.push_str(&printable(tower.name()));
        text.push_str("\n\n");
    }
    text.push_str(&modes(solution));
    text.push_str("\n\n");
    text.push_str(&summary(tower, solution));
    text.push('\n');
    text
}

fn modes(solution: &Solution) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table.set_header(["mode", "what it is", "frequency Hz", "± error", "period s"]);
    let modes = || solution.modes.iter();
    let frequencies = aligned(modes().map(|m| shown(m, m.frequency_hz)));
    let errors = aligned(modes().map(|m| shown(m, m.error_hz())));
    for (mode, (frequency, error)) in modes().zip(frequencies.iter().zip(&errors)) {
        table.add_row([
            mode.number.to_string(),
            mode.label(),
            frequency.clone(),
            error.clone(),
            four_digits(mode.period_s()),
        ]);
    }
    for column in [0, 2, 3, 4] {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.trim_fmt()
}

/// A frequency or its error, with as many decimals as show two digits of the error.
fn shown(mode: &Mode, value_hz: f64) -> String {
    // Far from 1 Hz an exponent says more than a row of zeros.
    if !(1e-4..1e6).contains(&mode.frequency_hz) {
        return format!("{value_hz:.6e}");
    }
    let decimals = 1 - mode.error_hz().log10().floor() as i32;
    let decimals = usize::try_from(decimals.clamp(*DECIMALS.start(), *DECIMALS.end()));
    let decimals = decimals.unwrap_or_default();
    let least = 0.1_f64.powi(i32::try_from(decimals).unwrap_or_default());
    if value_hz < least {
        return format!("<{least:.decimals$}");
    }
    format!("{value_hz:.decimals$}")
}

/// Pads numbers on the right so that their decimal points stand in one column.
fn aligned(numbers: impl Iterator<Item = String>) -> Vec<String> {
    let numbers: Vec<String> = numbers.collect();
    let decimals = |number: &String| number.find('.').map_or(0, |point| number.len() - point);
    let widest = numbers.iter().map(decimals).max().unwrap_or(0);
    let padded = |number: String| {
        let padding = widest - decimals(&number);
        number + &" ".repeat(padding)
    };
    numbers.into_iter().map(padded).collect()
}

/// Four significant digits.
fn four_digits(value: f64) -> String {
    if !(1e-4..1e9).contains(&value) {
        return format!("{value:.3e}");
    }
    let decimals = (3 - value.log10().floor() as i32).max(0);
    format!("{value:.*}", usize::try_from(decimals).unwrap_or_default())
}

/// A name without what would disturb a terminal: control characters and marks that turn the direction of writing.
fn printable(name: &str) -> String {
    let disturbs = |c: char| {
        c.is_control()
            || ('\u{202a}'..='\u{202e}').contains(&c)
            || ('\u{2066}'..='\u{2069}').contains(&c)
    };
    name.chars()
        .map(|c| if disturbs(c) { ' ' } else { c })
        .collect()
}

/// Tower mass, top mass, method, certificate.
fn summary(tower: &Tower, solution: &Solution) -> String {
    let top = match tower.rna().mass_kg {
        0.0 => "no top mass".to_owned(),
        kg => format!("top {}", tonnes(kg)),
    };
    let count = solution.certificate.count;
    let listed = if count > solution.modes.len() {
        "the list cuts a pair"
    } else {
        "all listed"
    };
    format!(
        "tower {}, {top} | {}, {} | certified: this {} has {} below {} Hz, {listed}",
        tonnes(tower.mass_kg()),
        solution.method.name(),
        fineness(solution),
        if is_beam(solution.method) {
            "beam"
        } else {
            "chain"
        },
        counted(count, "mode"),
        four_digits(solution.certificate.below_hz),
    )
}

/// "100 segments", or "1 element of degree 19".
fn fineness(solution: &Solution) -> String {
    let noun = if is_beam(solution.method) {
        "element"
    } else {
        "segment"
    };
    let degree = solution.degree.map(|degree| format!(" of degree {degree}"));
    counted(solution.segments, noun) + &degree.unwrap_or_default()
}

fn is_beam(method: Method) -> bool {
    matches!(method, Method::Bmodes | Method::Spectral)
}

/// "1 mode", "2 modes".
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

fn tonnes(kg: f64) -> String {
    if kg < 1e9 {
        format!("{:.3} t", kg / 1000.0)
    } else {
        format!("{:.6e} t", kg / 1000.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{aligned, four_digits};

    #[test]
    fn decimal_points_stand_in_one_column() {
        let numbers = ["0.25", "12.1234", "7"].map(String::from);
        assert_eq!(
            aligned(numbers.into_iter()),
            ["0.25  ", "12.1234", "7     "]
        );
    }

    #[test]
    fn four_digits_whatever_the_size() {
        assert_eq!(four_digits(3.33105), "3.331");
        assert_eq!(four_digits(0.046_871), "0.04687");
        assert_eq!(four_digits(123_456.0), "123456");
        assert_eq!(four_digits(1e-7), "1.000e-7");
    }
}
