//! What the user can do about an error of a sweep. The command line has options for it, the Python
//! package has arguments, so each has its own texts.

use crate::slice::SliceError;
use crate::table::{TableError, TableProblem};

/// A suggestion for an error of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Remedy {
    /// Leave out a column of the table.
    IgnoreColumn {
        /// The name of the column.
        name: String,
    },
    /// Write the results as CSV.
    Csv,
}

impl TableError {
    /// A suggestion in addition to the message.
    pub fn remedy(&self) -> Option<Remedy> {
        match &*self.problem {
            TableProblem::Unknown { name, .. } => Some(Remedy::IgnoreColumn { name: name.clone() }),
            _ => None,
        }
    }
}

impl SliceError {
    /// A suggestion in addition to the message.
    pub fn remedy(&self) -> Option<Remedy> {
        match self {
            Self::NoParquet => Some(Remedy::Csv),
            Self::Table(error) => error.remedy(),
            _ => None,
        }
    }
}
