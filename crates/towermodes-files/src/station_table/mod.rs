//! Tables of cans or stations in CSV, as exported from drawings and spreadsheets; a tower file
//! refers to it with `stations = "cans.csv"`.
//!
//! A can is a row with bottom, top, diameters and wall, a station a row with height, diameter and
//! wall. The header gives the quantity and the unit of each column. Columns are separated by
//! commas, semicolons or tabs; with semicolons or tabs a comma may be the decimal separator.

mod cans;
mod header;
mod words;

use std::ops::Range;

use towermodes::Station;

use crate::csv_table::{MAX_MISTAKES, Numbers, Record, Records, no_rows, rows};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use header::{Header, Layout};

/// Largest number of rows: no tower has more, and each row needs memory in the solution.
const MAX_ROWS: usize = 100_000;

/// A station with the places of its values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Placed {
    pub(crate) station: Station,
    /// The places of height, diameter and wall.
    pub(crate) spans: [Range<usize>; 3],
}

/// The index of the material with a name, or of the default material for rows without a name; or
/// the mistake and a suggestion.
pub(crate) type MaterialOf<'m> =
    &'m dyn Fn(Option<&str>) -> Result<usize, (DiagnosticKind, String)>;

/// The stations of a table, from the base to the top, in metres.
///
/// # Errors
/// The mistakes at their places in the text; never an empty list.
pub(crate) fn stations(
    text: &str,
    material_of: MaterialOf<'_>,
) -> Result<Vec<Placed>, Vec<Diagnostic>> {
    let mut records = Records::new(text);
    let Some(first) = records.next() else {
        let mistake = Diagnostic::new(0..0, DiagnosticKind::EmptyFile);
        return Err(vec![mistake.with_hint(header::EXAMPLE)]);
    };
    let header = Header::of(&first.map_err(|mistake| vec![mistake])?)?;
    let mut reading = Reading {
        header: &header,
        numbers: Numbers::new(text, records.delimiter()),
        material_of,
        mistakes: Vec::new(),
    };
    let stations = match &header.layout {
        Layout::Cans(columns) => {
            let cans = reading.rows(records, |reading, record| reading.can(columns, record));
            cans::stations(cans, text, &mut reading.mistakes)
        }
        Layout::Stations(columns) => {
            reading.rows(records, |reading, record| reading.station(columns, record))
        }
    };
    if !reading.mistakes.is_empty() {
        return Err(reading.mistakes);
    }
    if stations.is_empty() {
        return Err(vec![no_rows(text)]);
    }
    Ok(stations)
}

/// Data that are collected while rows are read.
struct Reading<'a> {
    header: &'a Header,
    numbers: Numbers<'a>,
    material_of: MaterialOf<'a>,
    mistakes: Vec<Diagnostic>,
}

impl<'a> Reading<'a> {
    /// All rows; reading continues after a mistake, so that all mistakes are reported together.
    fn rows<T>(
        &mut self,
        records: Records<'a>,
        read: impl Fn(&mut Self, &Record<'a>) -> Option<T>,
    ) -> Vec<T> {
        let mut found = Vec::new();
        for record in rows(records, self.header.width, MAX_ROWS) {
            if self.mistakes.len() >= MAX_MISTAKES {
                break;
            }
            match record {
                Ok(record) => found.extend(read(self, &record)),
                Err(mistake) => self.mistakes.push(mistake),
            }
        }
        found
    }

    /// A row of a table of stations.
    fn station(&mut self, columns: &header::Stations, record: &Record<'a>) -> Option<Placed> {
        let [height, diameter, wall] = &columns.lengths;
        let (height_m, diameter_m) = (self.metres(height, record), self.metres(diameter, record));
        let wall_m = self.metres(wall, record);
        let material = self.material(columns.material, record);
        Some(Placed {
            station: Station {
                height_m: height_m?,
                outer_diameter_m: diameter_m?,
                wall_thickness_m: wall_m?,
                material: material?,
            },
            spans: [height, diameter, wall].map(|column| record.cells[column.index].span.clone()),
        })
    }

    /// A row of a table of cans.
    fn can(&mut self, columns: &header::Cans, record: &Record<'a>) -> Option<cans::Can> {
        let all = [
            &columns.bottom,
            &columns.top,
            &columns.bottom_diameter,
            &columns.top_diameter,
            &columns.wall,
        ];
        let metres = all.map(|column| self.metres(column, record));
        let material = self.material(columns.material, record);
        let [bottom_m, top_m, bottom_diameter_m, top_diameter_m, wall_m] = metres;
        let can = cans::Can {
            ends_m: [bottom_m?, top_m?],
            diameters_m: [bottom_diameter_m?, top_diameter_m?],
            wall_m: wall_m?,
            material: material?,
            spans: all.map(|column| record.cells[column.index].span.clone()),
        };
        match can.check() {
            Ok(()) => Some(can),
            Err(mistake) => {
                self.mistakes.push(mistake);
                None
            }
        }
    }

    /// A length of a row.
    fn metres(&mut self, column: &header::Length, record: &Record<'a>) -> Option<f64> {
        let cell = &record.cells[column.index];
        match self.numbers.number(cell, column.what) {
            Ok(value) => Some(column.unit.metres(value)),
            Err(mistake) => {
                self.mistakes.push(mistake);
                None
            }
        }
    }

    /// The material of a row.
    fn material(&mut self, column: Option<usize>, record: &Record<'a>) -> Option<usize> {
        let cell = column.and_then(|index| record.cells.get(index));
        let cell = cell.filter(|cell| !cell.text.is_empty());
        match (self.material_of)(cell.map(|cell| &*cell.text)) {
            Ok(index) => Some(index),
            Err((kind, hint)) => {
                let span = cell.map_or(record.span.clone(), |cell| cell.span.clone());
                let mistake = Diagnostic::new(span, kind).with_hint(hint);
                self.mistakes.push(mistake);
                None
            }
        }
    }
}
