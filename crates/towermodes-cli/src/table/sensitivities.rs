//! The influence of the input values of a tower on its frequencies, as text.

use towermodes::number::{Plain, digits, four_digits};
use towermodes::{NoDerivative, Operation, TowerDescription};
use towermodes_analysis::influence::{
    Basis, Influence, Influences, NEGLIGIBLE, Tolerance, Tolerances,
};

use super::text::{align_right, aligned, name_line, plain_table, wrapped};

/// A row per input value by decreasing influence: its name, value and tolerance, and a column per
/// mode.
pub(crate) fn sensitivities(
    description: &TowerDescription,
    influences: &Influences,
    tolerances: &Tolerances,
    all: bool,
) -> String {
    let ranked = match tolerances.is_empty() {
        true => influences.ranked(),
        false => influences.ranked_with(tolerances, description),
    };
    let tolerance = |number: &Influence| tolerances.of(&number.name, description);
    let has_tolerances = !tolerances.is_empty();
    let matters = |number: &&&Influence| {
        let has_effect = !has_tolerances || tolerance(number).is_some();
        all || (has_effect && !is_negligible(number))
    };
    let shown: Vec<&Influence> = ranked.iter().filter(matters).copied().collect();
    let hidden = ranked.len() - shown.len();
    let mut table = plain_table();
    table.set_header(header(influences, has_tolerances));
    let columns: Vec<Vec<String>> = (0..influences.modes.len())
        .map(|mode| {
            let cell = |number: &&Influence| cell(number, mode, tolerance(number), has_tolerances);
            aligned(shown.iter().map(cell))
        })
        .collect();
    for (row, number) in shown.iter().enumerate() {
        let mut cells = vec![number.name.clone(), value(number), number.unit.to_owned()];
        if has_tolerances {
            cells.push(tolerance(number).map_or(String::new(), written));
        }
        cells.extend(columns.iter().map(|column| column[row].clone()));
        table.add_row(cells);
    }
    if has_tolerances {
        table.add_row(together(description, influences, tolerances));
    }
    let first = 3 + usize::from(has_tolerances);
    align_right(
        &mut table,
        [1].into_iter().chain(first..first + influences.modes.len()),
    );
    let mut text = format!("{}{}\n", name_line(&description.name), table.trim_fmt());
    for sentence in footer(&shown, hidden, has_tolerances) {
        text.push('\n');
        text.push_str(&wrapped(&sentence));
    }
    text.push('\n');
    text
}

fn is_negligible(number: &Influence) -> bool {
    let has_derivatives = number.derivatives.iter().all(Result::is_ok);
    has_derivatives && number.largest() < NEGLIGIBLE
}

fn header(influences: &Influences, has_tolerances: bool) -> Vec<String> {
    let mut header = vec!["input".to_owned(), "value".to_owned(), "unit".to_owned()];
    if has_tolerances {
        header.push("tolerance".to_owned());
    }
    let mode = |mode: &towermodes_analysis::influence::InfluencedMode| {
        format!("{}\n{} Hz", mode.label, four_digits(mode.frequency_hz))
    };
    header.extend(influences.modes.iter().map(mode));
    header
}

/// The value in the table: factors have none, and additions begin at zero.
fn value(number: &Influence) -> String {
    match number.operation {
        Operation::Set => Plain(number.value).to_string(),
        Operation::Scale | Operation::Add => String::new(),
    }
}

fn written(tolerance: Tolerance) -> String {
    match tolerance {
        Tolerance::Percent(percent) => format!("±{} %", Plain(percent)),
        Tolerance::Amount(amount) => format!("±{}", Plain(amount)),
    }
}

/// The elasticity, or the effect of the tolerance in percent of the frequency.
fn cell(
    number: &Influence,
    mode: usize,
    tolerance: Option<Tolerance>,
    has_tolerances: bool,
) -> String {
    match &number.derivatives[mode] {
        Err(NoDerivative::AtRest) => return "-".to_owned(),
        Err(NoDerivative::Repeated) => return "splits".to_owned(),
        Err(NoDerivative::OneSided) => return "one-sided".to_owned(),
        Ok(_) => {}
    }
    if !has_tolerances {
        let of_unit = || {
            number
                .percent_per_unit(mode)
                .map_or("-".to_owned(), |percent| per_unit(percent, number.unit))
        };
        return number.elasticities[mode].map_or_else(of_unit, elasticity);
    }
    let effect = tolerance.and_then(|tolerance| number.percent(tolerance, mode));
    effect.map_or(String::new(), |percent| format!("±{}", percent_of(percent)))
}

/// The derivative with respect to an input value that is zero: "+2.31 % per m".
fn per_unit(percent: f64, unit: &str) -> String {
    match (percent == 0.0, unit) {
        (true, _) => "0".to_owned(),
        (_, "") => format!("{}{} %", sign(percent), digits(percent.abs(), 3)),
        _ => format!("{}{} % per {unit}", sign(percent), digits(percent.abs(), 3)),
    }
}

fn sign(value: f64) -> char {
    if value < 0.0 { '-' } else { '+' }
}

/// An elasticity with its sign and three decimals; inputs are not known more accurately.
fn elasticity(value: f64) -> String {
    match value.abs() < 5e-5 {
        true => "0".to_owned(),
        false => format!("{value:+.4}"),
    }
}

fn percent_of(percent: f64) -> String {
    match percent < 5e-5 {
        true => "0 %".to_owned(),
        false => format!("{} %", digits(percent, 2)),
    }
}

/// The last row: the combined effect of all tolerances.
fn together(
    description: &TowerDescription,
    influences: &Influences,
    tolerances: &Tolerances,
) -> Vec<String> {
    let mut row = vec!["all together".to_owned()];
    row.extend(["", "", ""].map(str::to_owned));
    for (index, mode) in influences.modes.iter().enumerate() {
        let effect_hz = tolerances.together_hz(influences, description, index);
        row.push(format!(
            "±{}",
            percent_of(100.0 * effect_hz / mode.frequency_hz)
        ));
    }
    row
}

fn footer(shown: &[&Influence], hidden: usize, has_tolerances: bool) -> Vec<String> {
    let has = |basis: Basis| shown.iter().any(|number| number.basis == basis);
    let lacks = |reason: NoDerivative| {
        let all = shown.iter().flat_map(|number| &number.derivatives);
        all.into_iter().any(|derivative| *derivative == Err(reason))
    };
    let mut sentences = vec![match has_tolerances {
        false => "elasticity: percent of the frequency per percent of the input value".to_owned(),
        true => "change of the frequency caused by the tolerance of the input value; all together: root of the sum of squares"
            .to_owned(),
    }];
    if has(Basis::TowerHeight) && !has_tolerances {
        sentences.push("a height is changed by one percent of the tower height".to_owned());
    }
    if has(Basis::Zero) && !has_tolerances {
        sentences.push(
            "per unit: percent of the frequency per unit of the input value, for values that are zero and for add(...)".to_owned(),
        );
    }
    if lacks(NoDerivative::Repeated) {
        sentences.push(
            "splits: the input value couples the mode with another mode of the same frequency, and their frequencies separate".to_owned(),
        );
    }
    if lacks(NoDerivative::OneSided) {
        sentences.push(
            "one-sided: the derivatives for an increase and a decrease differ, or one of them does not exist"
                .to_owned(),
        );
    }
    if hidden > 0 {
        let hidden_values = if hidden == 1 {
            "1 input value is"
        } else {
            &format!("{hidden} input values are")
        };
        let reason = match has_tolerances {
            false => "no listed frequency changes by more than 0.0001 % per percent",
            true => {
                "they have no tolerance, or no listed frequency changes by more than 0.0001 % per percent"
            }
        };
        sentences.push(format!(
            "{hidden_values} not shown because {reason} (use --all)"
        ));
    }
    sentences
}
