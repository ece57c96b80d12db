//! Why a description is not a tower, with the place and the numbers.

use std::fmt;

use thiserror::Error;

use crate::number::Plain;

/// Where in a [`TowerDescription`](super::TowerDescription) something is wrong.
///
/// Indices count from 0; `key` is the name the quantity has in a TOML file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// The list of stations as a whole.
    Stations,
    /// One value of one station: `height`, `diameter`, `wall` or `material`; of a row of a property table: `height` or its column.
    Station {
        /// Which station.
        index: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of one material: `density`, `youngs_modulus`, `shear_modulus`.
    Material {
        /// Which material.
        index: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of one point mass: `height` or `mass`.
    PointMass {
        /// Which point mass.
        index: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of the rotor-nacelle assembly: `mass`, `center` or `inertia`.
    Rna {
        /// Which of its values.
        key: &'static str,
    },
    /// The outfitting factor.
    OutfittingFactor,
    /// The shear coefficient.
    Shear,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stations => write!(f, "stations"),
            Self::Station { index, .. } => write!(f, "station {}", index + 1),
            Self::Material { index, .. } => write!(f, "material {}", index + 1),
            Self::PointMass { index, .. } => write!(f, "point mass {}", index + 1),
            Self::Rna { .. } => write!(f, "rotor-nacelle assembly"),
            Self::OutfittingFactor => write!(f, "outfitting factor"),
            Self::Shear => write!(f, "shear"),
        }
    }
}

/// A description that no tower can have: where, and what is wrong.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{place}: {problem}")]
pub struct TowerError {
    /// Where it is wrong.
    pub place: Place,
    /// What is wrong, with the numbers.
    #[source]
    pub problem: Problem,
}

/// What is wrong with a value, with the numbers.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Problem {
    /// NaN or infinite.
    #[error("{quantity} is {value}, not a finite number")]
    NotFinite {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// Zero or negative where only a positive number makes sense.
    #[error("{quantity} is {}{unit}, but must be positive", Plain(*.value))]
    NotPositive {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Its unit, after a space, or nothing.
        unit: &'static str,
    },
    /// Negative where zero is the least.
    #[error("{quantity} is {}{unit}, but cannot be negative", Plain(*.value))]
    Negative {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Its unit, after a space, or nothing.
        unit: &'static str,
    },
    /// E and G that no isotropic material has.
    #[error(
        "shear modulus {shear_modulus_pa:e} Pa with Young's modulus {youngs_modulus_pa:e} Pa means \
         Poisson's ratio {}, outside (-1, 0.5)", Plain(rounded(*.poissons_ratio))
    )]
    ImpossibleModuli {
        /// E, Pa.
        youngs_modulus_pa: f64,
        /// G, Pa.
        shear_modulus_pa: f64,
        /// E/(2G) − 1.
        poissons_ratio: f64,
    },
    /// Fewer than two stations.
    #[error("a tower needs at least two stations, got {count}")]
    TooFewStations {
        /// How many there are.
        count: usize,
    },
    /// Heights that go down.
    #[error("height {} m is below the station before it ({} m)", Plain(*.height_m), Plain(*.previous_m))]
    HeightDecreases {
        /// This station's height, m.
        height_m: f64,
        /// The height of the station before, m.
        previous_m: f64,
    },
    /// A third station at one height.
    #[error("a third station at height {height_m} m: two make a step, a third means nothing")]
    HeightThrice {
        /// The repeated height, m.
        height_m: f64,
    },
    /// All stations at one height.
    #[error("the tower has no height: every station is at {height_m} m")]
    NoHeight {
        /// The height all have, m.
        height_m: f64,
    },
    /// A wall that does not fit into the tube.
    #[error(
        "outer diameter {outer_diameter_m} m is less than twice the wall {wall_thickness_m} m at z = {height_m} m"
    )]
    WallTooThick {
        /// Outer diameter, m.
        outer_diameter_m: f64,
        /// Wall thickness, m.
        wall_thickness_m: f64,
        /// Height of the station, m.
        height_m: f64,
    },
    /// A station names a material that is not in the list.
    #[error("material number {} does not exist; there are {count}", .index + 1)]
    UnknownMaterial {
        /// The index given.
        index: usize,
        /// How many materials there are.
        count: usize,
    },
    /// A point mass beside the tower.
    #[error(
        "height {} m is not on the tower, which reaches from {} m to {} m",
        Plain(*.height_m), Plain(*.base_m), Plain(*.top_m)
    )]
    OutsideTower {
        /// Height of the mass, m.
        height_m: f64,
        /// Height of the base, m.
        base_m: f64,
        /// Height of the top, m.
        top_m: f64,
    },
    /// An RNA that has inertia but no mass.
    #[error("the assembly has an inertia but no mass")]
    InertiaWithoutMass,
    /// A centre of mass off the tower's axis.
    #[error(
        "the centre of mass is {x_m} m fore-aft and {y_m} m side-side of the tower's axis; \
         eccentric machines couple bending with torsion, which this version does not solve yet"
    )]
    EccentricRna {
        /// Fore-aft offset, m.
        x_m: f64,
        /// Side-side offset, m.
        y_m: f64,
    },
    /// Products of inertia, which couple the families of modes.
    #[error(
        "products of inertia (xy {xy}, xz {xz}, yz {yz} kg m2) couple bending with torsion, \
         which this version does not solve yet"
    )]
    ProductsOfInertia {
        /// Entry xy, kg m².
        xy: f64,
        /// Entry xz, kg m².
        xz: f64,
        /// Entry yz, kg m².
        yz: f64,
    },
    /// Tubes and a property table for one tower.
    #[error("the tower is given twice, by stations and by a table of properties")]
    StationsAndProperties,
    /// Shear stiffness in some rows of a property table.
    #[error("some rows have a shear stiffness and some have none")]
    ShearInSomeRows,
    /// A shear coefficient no section has.
    #[error("shear coefficient {value} is outside (0, 1]")]
    ShearCoefficient {
        /// The value given.
        value: f64,
    },
}

/// To four digits after the point.
fn rounded(value: f64) -> f64 {
    let scaled = (value * 1e4).round() / 1e4;
    if scaled.is_finite() { scaled } else { value }
}

impl Problem {
    /// What would be right, in one sentence, where more can be said than the message says.
    pub fn hint(&self) -> Option<&'static str> {
        Some(match self {
            Self::NotFinite { .. } => "write an ordinary number, as 6.0 or 2.1e11",
            Self::ImpossibleModuli { .. } => {
                "both moduli are in Pa; for steel E is about 2.1e11 and G about 8.08e10"
            }
            Self::TooFewStations { .. } => "one row at the base and one at the top are enough",
            Self::HeightDecreases { .. } => {
                "list the stations from the base to the top; two rows at one height are a step"
            }
            Self::HeightThrice { .. } => "keep the row below the step and the row above it",
            Self::NoHeight { .. } => "the first value of a row is its height above the datum in m",
            Self::WallTooThick { .. } => {
                "a row is height, outer diameter, wall thickness, all in m; 27 mm is 0.027"
            }
            Self::OutsideTower { .. } => {
                "heights are in the datum of the stations; what sits on top belongs into [rna]"
            }
            Self::InertiaWithoutMass => "give the mass, or leave the inertia out",
            Self::EccentricRna { .. } => {
                "put the centre of mass on the axis, center = [0, 0, z], to solve the centred machine"
            }
            Self::ProductsOfInertia { .. } => {
                "leave xy, xz and yz out to solve the centred machine"
            }
            Self::StationsAndProperties => "keep one of the two",
            Self::ShearInSomeRows => {
                "give it in every row, or in none for a tower that does not shear"
            }
            Self::ShearCoefficient { .. } => {
                "a thin tube has about 0.53; shear = true uses Cowper's value"
            }
            Self::NotPositive { .. } | Self::Negative { .. } | Self::UnknownMaterial { .. } => {
                return None;
            }
        })
    }
}
