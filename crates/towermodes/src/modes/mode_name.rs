//! The name of a mode by family and order, which stays with the mode where frequencies cross.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use super::family::Family;

/// The name of a mode: its family and its order in it, from 1.
///
/// A mode keeps its name when its place in the list changes, for example when two frequencies
/// cross. Its text consists of family and order, `fore-aft 1`; a rigid-body mode of a floating
/// tower has the name of its motion alone, `surge`.
///
/// # Example
/// ```
/// use towermodes::{Family, ModeName};
///
/// let second: ModeName = "side-side 2".parse()?;
/// assert_eq!(second, ModeName { family: Family::SideSide, order: 2 });
/// assert_eq!(second.to_string(), "side-side 2");
/// assert_eq!(second.column(), "side_side_2");
/// assert_eq!("surge".parse::<ModeName>()?.column(), "surge");
/// # Ok::<(), towermodes::ModeNameError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ModeName {
    /// The kind of motion.
    pub family: Family,
    /// Order within the family, from 1; 1 for the rigid-body modes of a floating tower.
    pub order: usize,
}

impl ModeName {
    /// The name as the beginning of a column's name: `fore_aft_1`, `surge`.
    pub fn column(&self) -> String {
        self.to_string().replace(['-', ' '], "_")
    }

    /// The name in words: "1st fore-aft bending".
    pub fn label(&self) -> String {
        self.family.label(self.order)
    }
}

impl fmt::Display for ModeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.family.is_rigid() {
            true => f.write_str(self.family.name()),
            false => write!(f, "{} {}", self.family.name(), self.order),
        }
    }
}

/// Why a text is not the name of a mode.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ModeNameError {
    /// The text does not begin with the name of a family.
    #[error(
        "`{text}` is not the name of a mode; a mode name is a type and a number, such as `fore-aft 1`, or one of surge, sway, \
         heave, roll, pitch, yaw; the types are fore-aft, side-side, torsion and axial"
    )]
    Family {
        /// The text.
        text: String,
    },
    /// The text is `coupled`, which is not the name of a mode.
    #[error(
        "`{text}` is not the name of a mode: a coupled mode has the name of one of its motions, such as `fore-aft 1`; the types are \
         fore-aft, side-side, torsion and axial, and for floating towers surge, sway, heave, roll, pitch, yaw"
    )]
    Coupled {
        /// The text.
        text: String,
    },
    /// The order is missing, 0 or not a number.
    #[error("`{text}` has no number; write `{family} 1` for the first mode of this type")]
    Order {
        /// The text.
        text: String,
        /// The name of its family.
        family: &'static str,
    },
    /// A rigid-body mode with an order other than 1.
    #[error("`{text}` has a number, but a tower has only one mode `{family}`; write `{family}`")]
    RigidOrder {
        /// The text.
        text: String,
        /// The name of its family.
        family: &'static str,
    },
}

/// Reads `fore-aft 1`; `fore_aft_1` and `fore-aft-1` are the same.
impl FromStr for ModeName {
    type Err = ModeNameError;

    fn from_str(text: &str) -> Result<Self, ModeNameError> {
        let quoted = || text.chars().take(40).collect();
        let plain = text.trim().to_ascii_lowercase().replace(['_', ' '], "-");
        let found = Family::ALL.into_iter().find_map(|family| {
            let rest = plain.strip_prefix(family.name())?;
            (rest.is_empty() || rest.starts_with('-')).then_some((family, rest))
        });
        let Some((family, rest)) = found else {
            let text = quoted();
            return Err(match plain.starts_with("coupled") {
                true => ModeNameError::Coupled { text },
                false => ModeNameError::Family { text },
            });
        };
        let order = match rest.strip_prefix('-').unwrap_or(rest) {
            "" if family.is_rigid() => Some(1),
            digits if digits.bytes().all(|byte| byte.is_ascii_digit()) => digits.parse().ok(),
            _ => None,
        };
        let name = family.name();
        match order {
            Some(1..) if family.is_rigid() && order != Some(1) => Err(ModeNameError::RigidOrder {
                text: quoted(),
                family: name,
            }),
            Some(order @ 1..) => Ok(Self { family, order }),
            _ => Err(ModeNameError::Order {
                text: quoted(),
                family: name,
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ModeName, ModeNameError};
    use crate::modes::Family;

    #[test]
    fn every_name_is_read_back() {
        for family in Family::ALL {
            for order in if family.is_rigid() { 1..2 } else { 1..12 } {
                let name = ModeName { family, order };
                assert_eq!(name.to_string().parse(), Ok(name));
                assert_eq!(name.column().parse(), Ok(name));
            }
        }
    }

    #[test]
    fn other_texts_are_refused_with_what_is_right() {
        let error = |text: &str| text.parse::<ModeName>().expect_err("no name");
        assert!(matches!(error("fore"), ModeNameError::Family { .. }));
        assert!(matches!(error(""), ModeNameError::Family { .. }));
        assert!(matches!(error("yawing"), ModeNameError::Family { .. }));
        assert!(error("coupled 1").to_string().contains("`fore-aft 1`"));
        for text in [
            "torsion",
            "torsion 0",
            "torsion -1",
            "torsion x",
            "torsion 1.5",
        ] {
            assert!(
                error(text).to_string().contains("write `torsion 1`"),
                "{text}"
            );
        }
        assert!(matches!(error("surge 2"), ModeNameError::RigidOrder { .. }));
        assert!(matches!(
            error("axial 99999999999999999999999"),
            ModeNameError::Order { .. }
        ));
    }
}
