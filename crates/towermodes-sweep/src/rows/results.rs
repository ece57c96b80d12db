//! The results of rows, as columns.

use std::collections::TryReserveError;

use towermodes::ModeName;

use super::failed::FailedRows;
use super::row::Cells;
use super::warned::RowRemarks;

/// The results of successive rows of a sweep.
///
/// A value that was not computed is NaN, and the message of its row states the reason.
#[derive(Debug, Clone, PartialEq)]
pub struct Results {
    /// The number of the first row, from 0.
    pub first_row: u64,
    /// The modes that have columns.
    pub modes: Vec<ModeName>,
    /// [`Tower::structure_mass_kg`](towermodes::Tower::structure_mass_kg), kg; by row.
    pub mass_kg: Vec<f64>,
    /// Whether the list of modes is proved to be complete; by row.
    pub certified: Vec<bool>,
    /// Extrapolated frequencies, Hz; rows × modes, all modes of a row together.
    pub frequency_hz: Vec<f64>,
    /// Errors of the frequencies before extrapolation, which are conservative bounds of the errors
    /// after it, Hz; rows × modes.
    pub error_hz: Vec<f64>,
    /// The share of the energy of each mode in the type of motion that its name states: near 1 if
    /// the mode has one type of motion, below 0.6 if several modes share it, so that the name may
    /// belong to another mode in the next row; rows × modes.
    pub share: Vec<f64>,
    /// The failed rows and missing modes.
    pub failures: FailedRows,
    /// Rows that were solved in this run with input that is probably a mistake; result files do not
    /// contain this.
    pub warnings: RowRemarks,
    /// Rows that were solved in this run in which several modes share a motion; result files
    /// contain only the shares.
    pub shared: RowRemarks,
}

impl Results {
    /// Results of rows that are not solved yet.
    ///
    /// # Errors
    /// If the memory is not available.
    pub(crate) fn unsolved(
        first_row: u64,
        rows: usize,
        modes: &[ModeName],
    ) -> Result<Self, TryReserveError> {
        let numbers = |count: usize| -> Result<Vec<f64>, TryReserveError> {
            let mut numbers = Vec::new();
            numbers.try_reserve_exact(count)?;
            numbers.resize(count, f64::NAN);
            Ok(numbers)
        };
        let mut certified = Vec::new();
        certified.try_reserve_exact(rows)?;
        certified.resize(rows, false);
        let cells = rows.saturating_mul(modes.len());
        Ok(Self {
            first_row,
            modes: modes.to_vec(),
            mass_kg: numbers(rows)?,
            certified,
            frequency_hz: numbers(cells)?,
            error_hz: numbers(cells)?,
            share: numbers(cells)?,
            failures: FailedRows::default(),
            warnings: RowRemarks::default(),
            shared: RowRemarks::default(),
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.mass_kg.len()
    }

    /// The column of a mode: its index in [`modes`](Self::modes).
    pub fn mode(&self, name: ModeName) -> Option<usize> {
        self.modes.iter().position(|other| *other == name)
    }

    /// The frequencies of a mode, by its index in [`modes`](Self::modes), Hz.
    pub fn frequencies_hz(&self, mode: usize) -> impl Iterator<Item = f64> {
        column(&self.frequency_hz, mode, self.modes.len())
    }

    /// The errors of the frequencies of a mode, by its index in [`modes`](Self::modes), Hz.
    pub fn errors_hz(&self, mode: usize) -> impl Iterator<Item = f64> {
        column(&self.error_hz, mode, self.modes.len())
    }

    /// The shares of the energy of a mode in its type of motion, by its index in
    /// [`modes`](Self::modes).
    pub fn shares(&self, mode: usize) -> impl Iterator<Item = f64> {
        column(&self.share, mode, self.modes.len())
    }

    /// The message of each row; none for a complete row.
    pub fn sentences(&self) -> impl Iterator<Item = Option<&str>> {
        let mut failures = self.failures.iter().peekable();
        let rows = self.first_row..self.first_row + self.rows() as u64;
        rows.map(move |row| {
            let failure = failures.next_if(|(failed, _)| *failed == row)?;
            Some(failure.1)
        })
    }

    /// The cells of a row, by its index.
    pub(crate) fn cells(&mut self, row: usize) -> Cells<'_> {
        let modes = self.modes.len();
        let of_modes = row * modes..(row + 1) * modes;
        Cells {
            mass_kg: &mut self.mass_kg[row],
            certified: &mut self.certified[row],
            frequency_hz: &mut self.frequency_hz[of_modes.clone()],
            error_hz: &mut self.error_hz[of_modes.clone()],
            share: &mut self.share[of_modes],
        }
    }

    /// Adds the following rows; remarks on rows are added separately.
    ///
    /// # Errors
    /// If the memory is not available.
    pub(crate) fn append(&mut self, mut next: Self) -> Result<(), TryReserveError> {
        append(&mut self.mass_kg, &mut next.mass_kg)?;
        append(&mut self.certified, &mut next.certified)?;
        append(&mut self.frequency_hz, &mut next.frequency_hz)?;
        append(&mut self.error_hz, &mut next.error_hz)?;
        append(&mut self.share, &mut next.share)?;
        let mut failures = next.failures.iter();
        failures.try_for_each(|(row, sentence)| self.failures.push(row, sentence))
    }

    /// Makes room for further rows.
    ///
    /// # Errors
    /// If the memory is not available.
    pub(crate) fn reserve(&mut self, rows: usize) -> Result<(), TryReserveError> {
        let cells = rows.saturating_mul(self.modes.len());
        self.mass_kg.try_reserve_exact(rows)?;
        self.certified.try_reserve_exact(rows)?;
        self.frequency_hz.try_reserve_exact(cells)?;
        self.error_hz.try_reserve_exact(cells)?;
        self.share.try_reserve_exact(cells)
    }
}

fn append<T>(all: &mut Vec<T>, next: &mut Vec<T>) -> Result<(), TryReserveError> {
    all.try_reserve(next.len())?;
    all.append(next);
    Ok(())
}

fn column(numbers: &[f64], column: usize, columns: usize) -> impl Iterator<Item = f64> {
    numbers.iter().skip(column).step_by(columns).copied()
}
