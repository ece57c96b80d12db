//! Mooring lines at rest as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::mooring::{LineState, Mooring, MooringState};

use super::columns::Cell::{Count, Number};
use super::columns::{Column, write_columns_csv};
use super::{ResultError, write_result_json};
use crate::input::Note;

/// A mooring system with its state at the reference position of the platform.
#[derive(Debug, Clone, Copy)]
pub struct SolvedMooring<'a> {
    /// The mooring system.
    pub mooring: &'a Mooring,
    /// Its state.
    pub state: &'a MooringState,
}

/// A mooring line with its state: a row of the tables and of the CSV.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LineAtRest {
    /// Number in the list of lines, from 1.
    pub number: usize,
    /// First and second point of the line: positions in the list of points, from 1.
    pub points: [usize; 2],
    /// Unstretched length, m.
    pub length_m: f64,
    /// Its state.
    #[serde(flatten)]
    pub state: LineState,
}

impl SolvedMooring<'_> {
    /// The lines in the order of the file.
    pub fn lines(&self) -> Vec<LineAtRest> {
        let lines = self.mooring.description().lines.iter();
        let lines = (1..).zip(lines.zip(&self.state.lines));
        let line = lines.map(|(number, (line, state))| LineAtRest {
            number,
            points: line.points.map(|point| point + 1),
            length_m: line.length_m,
            state: *state,
        });
        line.collect()
    }
}

/// The result of `towermodes solve` for a file of MoorDyn or MAP++.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct MooringDocument<'a> {
    /// Depth of the seabed below still water, m.
    depth_m: f64,
    /// Density of the water, kg/m³.
    water_density_kg_per_m3: f64,
    /// Acceleration of gravity, m/s².
    gravity_m_per_s2: f64,
    /// The reference point of force, moment and stiffness on the platform, m.
    reference_m: [f64; 3],
    /// Force (N) and moment about the reference point (N m) on the platform: x, y, z, about x, y,
    /// z.
    force: [f64; 6],
    /// Stiffness −∂F/∂u of the lines for motions of the platform (N/m, N, N m), in the order of the
    /// force.
    stiffness: [[f64; 6]; 6],
    /// The lines in the order of the file.
    lines: Vec<LineAtRest>,
    /// Positions of the points, m: x, y, z (up from still water).
    points_m: &'a [[f64; 3]],
    /// Assumptions, omitted data and probable mistakes.
    warnings: Vec<String>,
}

/// Writes mooring lines at rest as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_mooring_json(
    solved: &SolvedMooring<'_>,
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    let description = solved.mooring.description();
    let document = MooringDocument {
        depth_m: description.depth_m,
        water_density_kg_per_m3: description.water_density_kg_per_m3,
        gravity_m_per_s2: description.gravity_m_per_s2,
        reference_m: description.reference_m,
        force: solved.state.load.force,
        stiffness: solved.state.load.stiffness,
        lines: solved.lines(),
        points_m: &solved.state.points_m,
        warnings: notes.iter().map(ToString::to_string).collect(),
    };
    write_result_json(&document, writer)
}

/// Writes mooring lines at rest as CSV with a header, one row per line.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_mooring_csv(
    solved: &SolvedMooring<'_>,
    writer: impl Write,
) -> Result<(), ResultError> {
    write_columns_csv(&COLUMNS, &solved.lines(), writer)
}

/// The quantities of a line: the columns of the CSV.
#[rustfmt::skip]
static COLUMNS: [Column<LineAtRest>; 10] = [
    Column { key: "number", unit: "", meaning: "place in the list, from 1", value: |l| Count(l.number) },
    Column { key: "points[0]", unit: "", meaning: "first point, from 1", value: |l| Count(l.points[0]) },
    Column { key: "points[1]", unit: "", meaning: "second point, from 1", value: |l| Count(l.points[1]) },
    Column { key: "length_m", unit: "m", meaning: "unstretched length", value: |l| Number(l.length_m) },
    Column { key: "tensions_n[0]", unit: "N", meaning: "tension at the first point", value: |l| Number(l.state.tensions_n[0]) },
    Column { key: "tensions_n[1]", unit: "N", meaning: "tension at the second point", value: |l| Number(l.state.tensions_n[1]) },
    Column { key: "horizontal_n", unit: "N", meaning: "horizontal tension", value: |l| Number(l.state.horizontal_n) },
    Column { key: "vertical_n", unit: "N", meaning: "downward force at the upper end", value: |l| Number(l.state.vertical_n) },
    Column { key: "on_seabed_m", unit: "m", meaning: "length on the seabed", value: |l| Number(l.state.on_seabed_m) },
    Column { key: "extreme_z_m", unit: "m", meaning: "lowest height of the line; greatest height if the line is lighter than water", value: |l| Number(l.state.extreme_z_m) },
];
