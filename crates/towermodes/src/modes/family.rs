//! The names of modes.

use std::fmt;

use crate::tower::{Motion, Plane};

/// The kind of motion of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Family {
    /// Bending in the plane of the wind: translation x, rotation about y.
    ForeAft,
    /// Bending across the wind: translation y, rotation about x.
    SideSide,
    /// Torsion about the tower's axis.
    Torsion,
    /// Axial motion.
    Axial,
    /// Rigid-body motion of a floating tower along x.
    Surge,
    /// Rigid-body motion of a floating tower along y.
    Sway,
    /// Rigid-body motion of a floating tower along z.
    Heave,
    /// Rigid-body rotation of a floating tower about x.
    Roll,
    /// Rigid-body rotation of a floating tower about y.
    Pitch,
    /// Rigid-body rotation of a floating tower about z.
    Yaw,
    /// Members of a substructure between its supports and its transition piece, which hardly moves:
    /// local brace modes.
    Substructure,
}

impl Family {
    /// All families, in the order in which equal shares of the energy name a mode.
    pub const ALL: [Self; 11] = [
        Self::ForeAft,
        Self::SideSide,
        Self::Torsion,
        Self::Axial,
        Self::Surge,
        Self::Sway,
        Self::Heave,
        Self::Roll,
        Self::Pitch,
        Self::Yaw,
        Self::Substructure,
    ];

    /// The rigid-body modes of a floating tower: along x, y, z, about x, y, z.
    pub const RIGID: [Self; 6] = [
        Self::Surge,
        Self::Sway,
        Self::Heave,
        Self::Roll,
        Self::Pitch,
        Self::Yaw,
    ];

    /// The family of the modes with this motion: bending, torsion or axial.
    pub fn of(motion: Motion) -> Self {
        match motion {
            Motion::Bending(Plane::ForeAft) => Self::ForeAft,
            Motion::Bending(Plane::SideSide) => Self::SideSide,
            Motion::Torsion => Self::Torsion,
            Motion::Axial => Self::Axial,
        }
    }

    /// Its name in results: `fore-aft`, `side-side`, `torsion`, `axial`, `surge`,
    /// `sway`, `heave`, `roll`, `pitch`, `yaw`, `substructure`.
    pub fn name(self) -> &'static str {
        match self {
            Self::ForeAft => "fore-aft",
            Self::SideSide => "side-side",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
            Self::Surge => "surge",
            Self::Sway => "sway",
            Self::Heave => "heave",
            Self::Roll => "roll",
            Self::Pitch => "pitch",
            Self::Yaw => "yaw",
            Self::Substructure => "substructure",
        }
    }

    /// Whether it is a rigid-body mode of a floating tower.
    pub fn is_rigid(self) -> bool {
        match self {
            Self::ForeAft | Self::SideSide | Self::Torsion | Self::Axial | Self::Substructure => {
                false
            }
            Self::Surge | Self::Sway | Self::Heave | Self::Roll | Self::Pitch | Self::Yaw => true,
        }
    }

    /// The name of one of its modes without the order: "fore-aft bending", "torsion".
    pub fn noun(self) -> &'static str {
        match self {
            Self::ForeAft => "fore-aft bending",
            Self::SideSide => "side-side bending",
            Self::Substructure => "local substructure bending",
            _ => self.name(),
        }
    }

    /// The label of its mode of an order (from 1): "2nd fore-aft bending"; for a rigid-body mode
    /// its name.
    pub fn label(self, order: usize) -> String {
        if self.is_rigid() {
            return self.name().to_owned();
        }
        format!("{} {}", Ordinal(order), self.noun())
    }

    /// The family of the same motion in the side-side plane, if it is one in the fore-aft plane.
    pub(crate) fn turned_to_side_side(self) -> Self {
        match self {
            Self::ForeAft => Self::SideSide,
            Self::Surge => Self::Sway,
            Self::Pitch => Self::Roll,
            other => other,
        }
    }

    /// The motion of the tower in modes of this family: surge and pitch belong to bending fore-aft,
    /// yaw to torsion. None for [`Family::Substructure`], whose modes hardly move the tower.
    pub fn motion(self) -> Option<Motion> {
        match self {
            Self::ForeAft | Self::Surge | Self::Pitch => Some(Motion::Bending(Plane::ForeAft)),
            Self::SideSide | Self::Sway | Self::Roll => Some(Motion::Bending(Plane::SideSide)),
            Self::Torsion | Self::Yaw => Some(Motion::Torsion),
            Self::Axial | Self::Heave => Some(Motion::Axial),
            Self::Substructure => None,
        }
    }
}

/// Displays a number as an English ordinal: 1st, 2nd, 3rd, 4th, 11th.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ordinal(
    /// The number.
    pub usize,
);

impl fmt::Display for Ordinal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let suffix = match (self.0 % 10, self.0 % 100) {
            (_, 11..=13) => "th",
            (1, _) => "st",
            (2, _) => "nd",
            (3, _) => "rd",
            _ => "th",
        };
        write!(f, "{}{suffix}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Family;

    #[test]
    fn labels_use_english_ordinals() {
        let label = |order| Family::Torsion.label(order);
        assert_eq!(label(1), "1st torsion");
        assert_eq!(label(2), "2nd torsion");
        assert_eq!(label(11), "11th torsion");
        assert_eq!(label(22), "22nd torsion");
        assert_eq!(label(113), "113th torsion");
    }
}
