//! A comparison of methods as text, in the layout of the paper's tables: a row per mode, a column
//! per method.

use towermodes::{Family, Method, Tower};
use towermodes_analysis::study::{Column, Comparison};

use super::coupled::coupled_modes;
use super::text::{align_right, plain_table, title};

/// Frequencies, differences from the reference solution, degrees of freedom and times.
pub fn comparison(tower: &Tower, comparison: &Comparison) -> String {
    let columns = &comparison.columns;
    let mut table = plain_table();
    let mut add = |first: String, cell: &dyn Fn(usize) -> String| {
        table.add_row(std::iter::once(first).chain((0..columns.len()).map(cell)));
    };
    add("frequency, Hz".into(), &|i| columns[i].method.name().into());
    add("segments or elements".into(), &|i| fineness(&columns[i]));
    for (row, mode) in comparison.modes.iter().enumerate() {
        let pair = if mode.is_pair { " (double)" } else { "" };
        add(mode.label.clone() + pair, &|i| {
            frequency(columns[i].frequencies_hz[row])
        });
    }
    add(String::new(), &|_| String::new());
    add("relative difference from spectral".into(), &|_| {
        String::new()
    });
    for (row, mode) in comparison.modes.iter().enumerate() {
        let difference = |i: usize| columns[i].relative_differences[row];
        add(mode.label.clone(), &|i| {
            difference(i).map_or("-".into(), shown_difference)
        });
    }
    add(String::new(), &|_| String::new());
    add("degrees of freedom".into(), &|i| {
        columns[i].degrees_of_freedom.to_string()
    });
    add("time per solve".into(), &|i| {
        columns[i].seconds_per_solve.map_or("-".into(), shown_time)
    });
    align_right(&mut table, 1..=columns.len());
    let note = note(comparison).map_or_else(String::new, |note| format!("\n{note}\n"));
    let modes = comparison.modes.iter();
    let modes = modes.map(|mode| (mode.label.clone(), mode.family, &mode.shares));
    let coupled = match coupled_modes("", modes) {
        none if none.is_empty() => none,
        line => format!("\n{line}"),
    };
    format!("{}{}\n{note}{coupled}", title(tower), table.trim_fmt())
}

/// "60", or "degree 17".
fn fineness(column: &Column) -> String {
    match column.degree {
        Some(degree) => format!("degree {degree}"),
        None => column.segments.to_string(),
    }
}

fn frequency(value_hz: Option<f64>) -> String {
    match value_hz {
        None => "-".into(),
        Some(hz) if hz == 0.0 || (1e-2..1e5).contains(&hz) => format!("{hz:.5}"),
        Some(hz) => format!("{hz:.5e}"),
    }
}

fn shown_difference(difference: f64) -> String {
    if difference.abs() < 1e-10 {
        "0".into()
    } else {
        format!("{difference:+.1e}")
    }
}

fn shown_time(seconds: f64) -> String {
    match seconds {
        ..1e-3 => format!("{:.0} us", seconds * 1e6),
        ..1.0 => format!("{:.1} ms", seconds * 1e3),
        _ => format!("{seconds:.1} s"),
    }
}

/// The explanation of large differences of `bmodes`.
fn note(comparison: &Comparison) -> Option<&'static str> {
    let of = |method| {
        comparison
            .columns
            .iter()
            .find(|column| column.method == method)
    };
    let bmodes = of(Method::Bmodes)?;
    let mut modes = comparison.modes.iter();
    let bending = modes.position(|mode| mode.family == Family::ForeAft)?;
    let differs = bmodes.relative_differences[bending]?.abs() > 1e-4;
    differs.then_some(
        "The method bmodes neglects rotary inertia in bending and shear deformation; if the tower has them, the differences of bmodes include their effect.",
    )
}
