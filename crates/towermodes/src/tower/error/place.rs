//! The place of a value in a description.

use std::fmt;

use super::super::frame::part::FramePart;
use crate::mooring::MooringItem;

/// The place of a value in a [`TowerDescription`](crate::tower::TowerDescription), for errors and
/// warnings.
///
/// Indices count from 0; `key` is the name the quantity has in a TOML file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// The list of stations as a whole.
    Stations,
    /// One value of one station: `height`, `diameter`, `wall` or `material`; of a row of a property
    /// table: `height` or its column.
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
    /// One value of one point mass: `height`, `mass` or `inertia`.
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
    /// One value of the foundation: its key.
    Foundation {
        /// Which of its values.
        key: &'static str,
    },
    /// A part of the mooring lines of a floating platform.
    Mooring {
        /// Which part.
        item: MooringItem,
    },
    /// A part of the frame that carries the tower.
    Substructure {
        /// Which part.
        part: FramePart,
    },
    /// One value of a layer of soil: `rows`, or of one of its rows `height`, `x`, `y`, `z`,
    /// `torsion`.
    Soil {
        /// Which layer.
        layer: usize,
        /// Which of its rows.
        row: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of the ground: `surface`, `factor`, `submerged`, `axial`, `scour`, or of its scour
    /// `general` or `local`.
    Ground {
        /// Which of its values.
        key: &'static str,
    },
    /// One value of a layer of the ground: its key, or `type` or `model`.
    GroundLayer {
        /// Which layer.
        index: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of a row of a layer that is a table: `height`, `displacement`, `reaction`.
    GroundRow {
        /// Which layer.
        layer: usize,
        /// Which of its rows.
        row: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of a table of added mass: `rows`, or of one of its rows `height` or `mass`.
    AddedMass {
        /// Which table.
        table: usize,
        /// Which of its rows.
        row: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of the water: its key.
    Water {
        /// Which of its values.
        key: &'static str,
    },
    /// One value of a set of wires: `height`, `count`, `stiffness` or `angle_deg`.
    Wires {
        /// Which set.
        index: usize,
        /// Which of its values.
        key: &'static str,
    },
    /// One value of the rotor: `blades` or `rpm`.
    Rotor {
        /// Which of its values.
        key: &'static str,
    },
    /// One value of the damping: its key.
    Damping {
        /// Which of its values.
        key: &'static str,
    },
    /// One value of the drivetrain: its key.
    Drivetrain {
        /// Which of its values.
        key: &'static str,
    },
    /// The acceleration of gravity.
    Gravity,
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
            Self::Foundation { .. } => write!(f, "foundation"),
            Self::Mooring { item } => write!(f, "{item}"),
            Self::Substructure { .. } => write!(f, "substructure"),
            Self::Soil { layer, row, .. } => {
                write!(f, "row {} of soil layer {}", row + 1, layer + 1)
            }
            Self::Ground { .. } => write!(f, "ground"),
            Self::GroundLayer { index, .. } => write!(f, "ground layer {}", index + 1),
            Self::GroundRow { layer, row, .. } => {
                write!(f, "row {} of ground layer {}", row + 1, layer + 1)
            }
            Self::AddedMass { table, row, .. } => {
                write!(f, "row {} of added mass {}", row + 1, table + 1)
            }
            Self::Water { .. } => write!(f, "water"),
            Self::Wires { index, .. } => write!(f, "wires {}", index + 1),
            Self::Rotor { .. } => write!(f, "rotor"),
            Self::Damping { .. } => write!(f, "damping"),
            Self::Drivetrain { .. } => write!(f, "drivetrain"),
            Self::Gravity => write!(f, "gravity"),
            Self::OutfittingFactor => write!(f, "outfitting factor"),
            Self::Shear => write!(f, "shear"),
        }
    }
}
