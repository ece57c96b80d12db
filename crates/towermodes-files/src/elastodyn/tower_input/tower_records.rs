//! The records of a tower file in their order: the only table that is used for reading, writing,
//! names and messages.

use super::super::record::{ANY, Kind, PERCENT, POSITIVE, Record, record};

/// The number of rows.
pub(crate) const ROWS: Record = record(
    "NTwInpSt",
    "Number of input stations to specify tower geometry",
    Kind::Count(1),
);

/// A flag that only FAST 7 has.
pub(crate) const CALC_MODE: Record = record("CalcTMode", "flag of FAST 7", Kind::Other);

/// Structural damping: first and second fore-aft, first and second side-side mode.
pub(crate) const DAMPING: [Record; 4] = [
    record(
        "TwrFADmp(1)",
        "Tower 1st fore-aft mode structural damping ratio (%)",
        PERCENT,
    ),
    record(
        "TwrFADmp(2)",
        "Tower 2nd fore-aft mode structural damping ratio (%)",
        PERCENT,
    ),
    record(
        "TwrSSDmp(1)",
        "Tower 1st side-to-side mode structural damping ratio (%)",
        PERCENT,
    ),
    record(
        "TwrSSDmp(2)",
        "Tower 2nd side-to-side mode structural damping ratio (%)",
        PERCENT,
    ),
];

/// Tuners of the modal stiffnesses, in the order of [`DAMPING`], and factors of the columns of
/// mass, fore-aft and side-side stiffness.
pub(crate) const FACTORS: [Record; 7] = [
    record(
        "FAStTunr(1)",
        "Tower fore-aft modal stiffness tuner, 1st mode (-)",
        POSITIVE,
    ),
    record(
        "FAStTunr(2)",
        "Tower fore-aft modal stiffness tuner, 2nd mode (-)",
        POSITIVE,
    ),
    record(
        "SSStTunr(1)",
        "Tower side-to-side stiffness tuner, 1st mode (-)",
        POSITIVE,
    ),
    record(
        "SSStTunr(2)",
        "Tower side-to-side stiffness tuner, 2nd mode (-)",
        POSITIVE,
    ),
    record(
        "AdjTwMa",
        "Factor to adjust tower mass density (-)",
        POSITIVE,
    ),
    record(
        "AdjFASt",
        "Factor to adjust tower fore-aft stiffness (-)",
        POSITIVE,
    ),
    record(
        "AdjSSSt",
        "Factor to adjust tower side-to-side stiffness (-)",
        POSITIVE,
    ),
];

/// The columns of the distributed properties with their units.
pub(crate) const COLUMNS: [(&str, &str); 4] = [
    ("HtFract", "(-)"),
    ("TMassDen", "(kg/m)"),
    ("TwFAStif", "(Nm^2)"),
    ("TwSSStif", "(Nm^2)"),
];

/// The coefficients of x² to x⁶ of the shape with a name, the n-th of its plane.
macro_rules! shape {
    ($name:literal, $mode:literal) => {
        [
            record(
                concat!($name, "(2)"),
                concat!("Mode ", $mode, ", coefficient of x^2 term"),
                ANY,
            ),
            record(
                concat!($name, "(3)"),
                "      , coefficient of x^3 term",
                ANY,
            ),
            record(
                concat!($name, "(4)"),
                "      , coefficient of x^4 term",
                ANY,
            ),
            record(
                concat!($name, "(5)"),
                "      , coefficient of x^5 term",
                ANY,
            ),
            record(
                concat!($name, "(6)"),
                "      , coefficient of x^6 term",
                ANY,
            ),
        ]
    };
}

/// The names of the four shapes, without the number of the coefficient.
pub(crate) const SHAPES: [&str; 4] = ["TwFAM1Sh", "TwFAM2Sh", "TwSSM1Sh", "TwSSM2Sh"];

/// The coefficients of the four shapes.
pub(crate) const COEFFICIENTS: [[Record; 5]; 4] = [
    shape!("TwFAM1Sh", "1"),
    shape!("TwFAM2Sh", "2"),
    shape!("TwSSM1Sh", "1"),
    shape!("TwSSM2Sh", "2"),
];

/// The number of concentrated masses.
pub(crate) const MASSES: Record = record(
    "NTwCMass",
    "Number of tower concentrated masses",
    Kind::Count(0),
);

/// The columns of the concentrated masses with their units.
pub(crate) const MASS_COLUMNS: [(&str, &str); 2] = [("HtFract", "(-)"), ("TwCMass", "(kg)")];

/// All parameters of a tower file.
pub(crate) fn all() -> impl Iterator<Item = &'static Record> {
    let single = [&ROWS, &CALC_MODE, &MASSES];
    let lists = DAMPING.iter().chain(&FACTORS);
    let lists = lists.chain(COEFFICIENTS.iter().flatten());
    single.into_iter().chain(lists)
}
