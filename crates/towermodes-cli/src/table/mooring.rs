//! Mooring lines at rest as text.

use towermodes::mooring::{Attachment, MooringDescription};
use towermodes::number::{Plain, digits};
use towermodes_files::SolvedMooring;
use towermodes_report::wording::counted;

use super::text::text_table;

/// The motions of the platform, in the order of its stiffness.
const MOTIONS: [&str; 6] = ["surge", "sway", "heave", "roll", "pitch", "yaw"];

/// The lines with their tensions, then force and stiffness on the platform.
pub fn mooring(solved: &SolvedMooring<'_>) -> String {
    let description = solved.mooring.description();
    let [x, y, z] = description.reference_m.map(|at| Plain(at).to_string());
    let mut text = format!(
        "{}\n\n{}, seabed at z = {} m | at rest, platform at its reference position\n",
        lines(solved),
        counted(description.lines.len(), "line"),
        Plain(-description.depth_m),
    );
    for point in free_points(solved) {
        text.push_str(&point);
    }
    text.push_str(&format!(
        "\nforce (N), moment (N m) and stiffness (N/m, N, N m) on the platform about ({x}, {y}, {z}) m:\n\n{}\n",
        stiffness(solved)
    ));
    text
}

fn lines(solved: &SolvedMooring<'_>) -> String {
    let description = solved.mooring.description();
    let kn = |force_n: f64| digits(1e-3 * force_n, 5);
    let rows = solved.lines().into_iter().map(|line| {
        let [from, to] = line.points.map(|point| end(description, point - 1));
        let [first_n, second_n] = line.state.tensions_n;
        [
            line.number.to_string(),
            from,
            to,
            digits(line.length_m, 6),
            kn(first_n),
            kn(second_n),
            kn(line.state.horizontal_n),
            digits(line.state.on_seabed_m, 5),
        ]
    });
    let header = [
        "line",
        "from",
        "to",
        "length m",
        "first tension kN",
        "second tension kN",
        "horizontal kN",
        "on seabed m",
    ];
    text_table(header, rows, [0, 3, 4, 5, 6, 7])
}

/// The point at an end of a line: "anchor 1", "platform 4".
fn end(description: &MooringDescription, point: usize) -> String {
    let number = point + 1;
    match description.points[point].attachment {
        Attachment::Fixed => format!("anchor {number}"),
        Attachment::Platform => format!("platform {number}"),
        Attachment::Free => format!("free point {number}"),
        Attachment::Body(body) => format!("body {}", body + 1),
        Attachment::Rod(rod, end) => format!("rod {} {end:?}", rod + 1),
    }
}

/// Positions of the points that are held only by lines.
fn free_points(solved: &SolvedMooring<'_>) -> Vec<String> {
    let points = solved.mooring.description().points.iter();
    let points = (1..).zip(points.zip(&solved.state.points_m));
    let free = points.filter(|(_, (point, _))| point.attachment == Attachment::Free);
    let text = free.map(|(number, (_, at_m))| {
        let [x, y, z] = at_m.map(|at| digits(at, 6));
        format!("free point {number} at ({x}, {y}, {z}) m\n")
    });
    text.collect()
}

fn stiffness(solved: &SolvedMooring<'_>) -> String {
    let load = &solved.state.load;
    let rows = (0..6).map(|i| {
        let force = rounded(load.force[i], force_scale(&load.force, i));
        let entries = (0..6).map(|j| {
            let scale = (load.stiffness[i][i] * load.stiffness[j][j]).abs().sqrt();
            rounded(load.stiffness[i][j], scale)
        });
        let cells = [MOTIONS[i].to_owned(), force].into_iter().chain(entries);
        let cells: Vec<String> = cells.collect();
        std::array::from_fn::<String, 8, _>(|cell| cells[cell].clone())
    });
    let header: [&str; 8] = std::array::from_fn(|column| {
        ["", "force"]
            .iter()
            .chain(&MOTIONS)
            .nth(column)
            .copied()
            .unwrap_or("")
    });
    text_table(header, rows, 1..8)
}

/// The largest force, or the largest moment.
fn force_scale(force: &[f64; 6], of: usize) -> f64 {
    let same = if of < 3 { &force[..3] } else { &force[3..] };
    same.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Five digits with an exponent; 0 for a value that is a rounding error of the file relative to the
/// scale.
fn rounded(value: f64, scale: f64) -> String {
    match value.abs() <= 1e-7 * scale {
        true => "0".to_owned(),
        false => format!("{value:.4e}"),
    }
}
