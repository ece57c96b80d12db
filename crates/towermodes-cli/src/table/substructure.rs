//! The modes of a substructure as text.

use towermodes::frame::FrameMode;
use towermodes::number::{end_of_range, with_error};
use towermodes_files::{LargestMotion, SolvedSubstructure};
use towermodes_report::wording::counted;

use super::text::{aligned, name_line, text_table, tonnes};

/// The modes as a table, and a line with mass, parts, method and the proof of completeness.
pub fn substructure(solved: &SolvedSubstructure<'_>) -> String {
    let (frame, solution) = (solved.frame, solved.solution);
    let description = frame.description();
    let held = match solved.is_clamped() {
        true => "interface joints held",
        false => "interface joints free",
    };
    let method = match solution.degree {
        Some(degree) => format!("spectral, degree {degree}"),
        None => "subdyn".to_owned(),
    };
    format!(
        "{}{}\n\nsubstructure {}, {}, {} | {held} | {method} | complete: no mode is missing below {} Hz\n",
        name_line(solved.name),
        modes(solved),
        tonnes(frame.mass_kg()),
        counted(description.joints.len(), "joint"),
        counted(description.members.len(), "member"),
        end_of_range(solution.complete_below_hz, 0.0, 4),
    )
}

fn modes(solved: &SolvedSubstructure<'_>) -> String {
    let all = &solved.solution.modes;
    let error_hz = |mode: &FrameMode| mode.error_hz + mode.discretization_error_hz;
    let shown =
        |value_hz: f64, mode: &FrameMode| with_error(value_hz, mode.frequency_hz, error_hz(mode));
    let frequencies = aligned(all.iter().map(|mode| shown(mode.frequency_hz, mode)));
    let errors = aligned(all.iter().map(|mode| shown(error_hz(mode), mode)));
    let rows = all
        .iter()
        .enumerate()
        .zip(frequencies.into_iter().zip(errors));
    let rows = rows.map(|((index, mode), (frequency, error))| {
        let largest = LargestMotion::of(mode, solved.frame);
        [
            (index + 1).to_string(),
            frequency,
            error,
            described(&largest),
        ]
    });
    let header = ["mode", "frequency Hz", "± error", "largest motion"];
    text_table(header, rows, [0, 1, 2])
}

/// "joint 19 in x", "joint 19 about z".
fn described(largest: &LargestMotion) -> String {
    let joint = &largest.joint;
    match largest.direction.strip_prefix("rotation_") {
        Some(axis) => format!("joint {joint} about {axis}"),
        None => format!("joint {joint} in {}", largest.direction),
    }
}
