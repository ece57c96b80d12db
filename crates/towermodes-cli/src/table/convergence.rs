//! The convergence of a method as text: errors, observed orders, and a picture of both.

use towermodes::Tower;
use towermodes_analysis::study::{Convergence, Fineness, Level};
use towermodes_report::terminal;
use towermodes_report::wording::coupled_shape;

use super::text::{align_right, plain_table, title};

/// The errors and orders of each mode, and their picture, which is `width` characters wide.
pub(crate) fn convergence(tower: &Tower, convergence: &Convergence, width: usize) -> String {
    let text = format!(
        "{}{}\n\n{}\n{}\n",
        title(tower),
        heading(convergence),
        legend(convergence),
        errors(convergence),
    );
    match terminal::convergence(convergence, (0..).map(mark), width).as_str() {
        "" => text,
        picture => format!("{text}\n{picture}"),
    }
}

/// A row per level with error and order of each mode.
fn errors(convergence: &Convergence) -> String {
    let mut table = plain_table();
    let (name, order) = match is_spectral(convergence) {
        true => ("degree", "digits"),
        false => ("n", "order"),
    };
    let mut header = vec![name.to_owned()];
    for index in 0..convergence.modes.len() {
        header.extend([mark(index).to_string(), order.into()]);
    }
    table.set_header(header);
    for level in &convergence.levels {
        let mut row = vec![named(level)];
        for (error, order) in level.errors.iter().zip(&level.orders) {
            row.push(error.map_or("-".into(), |error| format!("{error:+.1e}")));
            row.push(order.map_or(String::new(), |order| format!("{order:.2}")));
        }
        table.add_row(row);
    }
    align_right(&mut table, 0..=2 * convergence.modes.len());
    table.trim_fmt()
}

/// The number of a row, with the requested number if that differs.
fn named(level: &Level) -> String {
    let (asked, used) = (level.asked.number(), fineness(level));
    if asked == used {
        used.to_string()
    } else {
        format!("{used} (requested {asked})")
    }
}

/// The degree, or the number of segments used: a tower of many parts has a minimum number.
fn fineness(level: &Level) -> usize {
    match level.asked {
        Fineness::Degree(degree) => degree,
        Fineness::Segments(_) => level.segments,
    }
}

fn is_spectral(convergence: &Convergence) -> bool {
    let first = convergence.levels.first();
    matches!(first.map(|level| level.asked), Some(Fineness::Degree(_)))
}

fn heading(convergence: &Convergence) -> String {
    let beam = if convergence.rotary_inertia {
        "the reference solution"
    } else {
        "the reference solution without rotary inertia"
    };
    let order = if is_spectral(convergence) {
        "correct digits gained per degree"
    } else {
        "observed order p (the error is proportional to n^-p)"
    };
    format!(
        "{}: error relative to {beam}, and {order}",
        convergence.method.name()
    )
}

/// The mode of each mark, with the frequency it converges to.
fn legend(convergence: &Convergence) -> String {
    let modes = convergence.modes.iter().enumerate();
    modes
        .map(|(index, mode)| {
            format!(
                "{}  {}, {:.6} Hz\n",
                mark(index),
                coupled_shape(&mode.label, mode.family, &mode.shares)
                    .unwrap_or_else(|| mode.label.clone()),
                mode.frequency_hz
            )
        })
        .collect()
}

/// The character of a mode in the table and in the picture: 1 to 9, then letters.
fn mark(index: usize) -> char {
    let marks = ('1'..='9').chain('a'..='z');
    marks
        .chain(std::iter::repeat('*'))
        .nth(index)
        .unwrap_or('*')
}

#[cfg(test)]
mod tests {
    use super::{fineness, named};
    use towermodes_analysis::study::{Fineness, Level};

    #[test]
    fn segments_are_those_used() {
        let level = |asked| Level {
            asked,
            segments: 60,
            degrees_of_freedom: 360,
            frequencies_hz: Vec::new(),
            errors: Vec::new(),
            orders: Vec::new(),
        };
        assert_eq!(fineness(&level(Fineness::Segments(10))), 60);
        assert_eq!(fineness(&level(Fineness::Degree(8))), 8);
        let names = [10, 60].map(|asked| named(&level(Fineness::Segments(asked))));
        assert_eq!(names, ["60 (requested 10)", "60"]);
    }
}
