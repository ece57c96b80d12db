//! What the user can do about an error of a sweep. The program has options for it, the Python
//! package arguments: each face calls the remedy by its own name.

use crate::parts::PartsError;
use crate::table::{TableError, TableProblem};

/// What the user can do about an error of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Remedy {
    /// Remove the results in the folder.
    RemoveResults,
    /// Leave out a column of the table.
    IgnoreColumn {
        /// The name of the column.
        name: String,
    },
    /// Write at least so many rows into a part.
    LargerParts {
        /// The least number of rows of a part.
        rows: u64,
    },
    /// Write the parts as CSV.
    Csv,
}

impl TableError {
    /// What the user can do about it, besides what the message says.
    pub fn remedy(&self) -> Option<Remedy> {
        match &*self.problem {
            TableProblem::Unknown { name, .. } => Some(Remedy::IgnoreColumn { name: name.clone() }),
            _ => None,
        }
    }
}

impl PartsError {
    /// What the user can do about it, besides what the message says.
    pub fn remedy(&self) -> Option<Remedy> {
        match self {
            Self::OtherSweep { .. } | Self::Plan { .. } | Self::Foreign { .. } => {
                Some(Remedy::RemoveResults)
            }
            Self::ManyParts { least, .. } => Some(Remedy::LargerParts { rows: *least }),
            Self::NoParquet => Some(Remedy::Csv),
            Self::Table(error) => error.remedy(),
            _ => None,
        }
    }
}
