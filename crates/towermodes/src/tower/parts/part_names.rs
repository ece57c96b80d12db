//! The names of the parts of a tower.

use crate::mooring::MooringItem;
use crate::tower::error::Place;

/// The names of the parts of a tower, for messages and reports only.
///
/// Each list belongs to the list of the same name in the
/// [`TowerDescription`](crate::TowerDescription); a part beyond the end of the list, or with an
/// empty name, has no name.
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

impl PartNames {
    /// The name of the point mass or of the set of wires at a place, if it has a name.
    pub fn of(&self, place: Place) -> Option<&str> {
        let (names, index) = match place {
            Place::PointMass { index, .. } => (&self.point_masses, index),
            Place::Wires { index, .. } => (&self.wires, index),
            _ => return None,
        };
        let name = names.get(index).map(String::as_str);
        name.filter(|name| !name.is_empty())
    }

    /// The name of a part of the mooring lines, if it has a name.
    pub fn of_mooring(&self, item: MooringItem) -> Option<&str> {
        let (names, index) = match item {
            MooringItem::LineType(index) => (&self.mooring_line_types, index),
            MooringItem::Point(index) => (&self.mooring_points, index),
            MooringItem::Line(index) => (&self.mooring_lines, index),
            MooringItem::Site | MooringItem::Body(_) | MooringItem::Rod(_) => return None,
        };
        let name = names.get(index).map(String::as_str);
        name.filter(|name| !name.is_empty())
    }
}
