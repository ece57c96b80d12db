//! Why a tower is no deck.

use thiserror::Error;

use super::number::significant;

/// What a tower has that a deck of BModes could hold only as another tower.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BmodesWriteError {
    /// The base is held in a way that BModes has no hub_conn for.
    #[error(
        "the base is rigidly held against {held} only: BModes has bases that are clamped, free on springs, or held against z and \
         rotation about z; give finite springs"
    )]
    PartlyRigidBase {
        /// The motions that are held.
        held: String,
    },
    /// The two bending stiffnesses are in no constant ratio.
    #[error(
        "side-side bending stiffness over fore-aft is {} at {} m and {} at {} m: BModes has one stiffness for both planes, and one \
         factor between them for the whole tower",
        significant(*.ratio), significant(*.height_m), significant(*.other_ratio), significant(*.other_height_m)
    )]
    UnequalPlanes {
        /// The ratio at the base.
        ratio: f64,
        /// Height of the base, m.
        height_m: f64,
        /// Another ratio.
        other_ratio: f64,
        /// The height of that, m.
        other_height_m: f64,
    },
    /// The soil is not as stiff in x as in y.
    #[error(
        "the soil springs at {} m are {} N/m2 in x and {} N/m2 in y: BModes has one for both",
        significant(*.height_m), significant(*.x_n_per_m2), significant(*.y_n_per_m2)
    )]
    UnequalSoil {
        /// Height, m.
        height_m: f64,
        /// In x, N/m².
        x_n_per_m2: f64,
        /// In y, N/m².
        y_n_per_m2: f64,
    },
    /// The name of the file of sections cannot stand in a deck.
    #[error(
        "`{name}` cannot name the file of sections in a deck: at most 200 characters, on one line, and not both kinds of quotes"
    )]
    FileName {
        /// The name.
        name: String,
    },
}
