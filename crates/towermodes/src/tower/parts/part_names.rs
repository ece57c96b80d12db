//! The names of the parts of a tower.

/// The names of the parts of a tower, for messages and reports only.
///
/// Each list belongs to the list of the same name in the
/// [`TowerDescription`](crate::TowerDescription); a part beyond its end has no name, and neither
/// has one whose name is empty.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct PartNames {
    /// Of the materials.
    pub materials: Vec<String>,
    /// Of the masses along the tower.
    pub point_masses: Vec<String>,
    /// Of the layers of soil.
    pub soil: Vec<String>,
    /// Of the layers of the ground.
    pub ground: Vec<String>,
    /// Of the tables of added mass.
    pub added_mass: Vec<String>,
    /// Of the types of mooring lines.
    pub mooring_line_types: Vec<String>,
    /// Of the points of mooring lines.
    pub mooring_points: Vec<String>,
    /// Of the mooring lines.
    pub mooring_lines: Vec<String>,
    /// Of the sets of wires.
    pub wires: Vec<String>,
}
