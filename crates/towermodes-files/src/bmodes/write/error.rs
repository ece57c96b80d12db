//! Why a tower cannot be written as a deck.

use thiserror::Error;
use towermodes::number::Rounded;

/// A property of a tower that a BModes deck cannot represent.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BmodesWriteError {
    /// No `hub_conn` of BModes describes the support of the base.
    #[error(
        "the base is rigidly held only in {held}: a base of BModes is clamped, free on springs, or held in z and \
         rotation about z; use finite springs"
    )]
    PartlyRigidBase {
        /// The motions that are fixed.
        held: String,
    },
    /// The tower stands on a space frame.
    #[error(
        "the tower stands on a space frame, which BModes does not support: read the tower with --clamped to write it alone"
    )]
    OnFrame,
    /// The ratio of the two bending stiffnesses is not constant.
    #[error(
        "side-side bending stiffness over fore-aft is {} at {} m and {} at {} m: BModes has one stiffness for both planes, and one \
         factor between them for the whole tower",
        Rounded(*.ratio), Rounded(*.height_m), Rounded(*.other_ratio), Rounded(*.other_height_m)
    )]
    UnequalPlanes {
        /// The ratio at the base.
        ratio: f64,
        /// Height of the base, m.
        height_m: f64,
        /// Another ratio.
        other_ratio: f64,
        /// The height of this ratio, m.
        other_height_m: f64,
    },
    /// The soil has different stiffness in x and y.
    #[error(
        "the soil springs at {} m are {} N/m2 in x and {} N/m2 in y: BModes has one for both",
        Rounded(*.height_m), Rounded(*.x_n_per_m2), Rounded(*.y_n_per_m2)
    )]
    UnequalSoil {
        /// Height, m.
        height_m: f64,
        /// In x, N/m².
        x_n_per_m2: f64,
        /// In y, N/m².
        y_n_per_m2: f64,
    },
    /// The name of the section file cannot be written in a deck.
    #[error(
        "`{name}` cannot be the name of the section file in a deck: a name has at most 200 characters, one line, and not both kinds of quotes"
    )]
    FileName {
        /// The name.
        name: String,
    },
}
