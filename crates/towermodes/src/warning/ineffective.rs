//! What a user gave and what changes nothing.

use std::fmt;

/// Something that was given and has no effect at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Ineffective {
    /// A mass at a base that does not move.
    MassAtClampedBase,
    /// Wires at a base that does not move.
    WiresAtClampedBase,
    /// A point mass without mass and inertia.
    EmptyPointMass,
    /// A centre of mass of a rotor-nacelle assembly without mass.
    CentreOfNothing,
    /// A material that no station has.
    UnusedMaterial,
    /// Soil whose springs are all zero.
    SoilOfZeros,
    /// A table of added mass that is all zero.
    AddedMassOfZeros,
    /// Water that adds no mass outside and is not inside.
    WaterOfZeros,
    /// Wires that stand upright, which hold nothing sideways.
    UprightWires,
}

impl fmt::Display for Ineffective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::MassAtClampedBase => {
                "the base is clamped, so a mass there never moves and has no effect; look at its height"
            }
            Self::WiresAtClampedBase => {
                "the base is clamped, so wires there hold nothing and have no effect; look at their height"
            }
            Self::EmptyPointMass => "it has neither mass nor inertia and has no effect",
            Self::CentreOfNothing => {
                "a centre of mass is given but no mass, so it has no effect; give the mass"
            }
            Self::UnusedMaterial => {
                "no part of the tower is of this material, so it has no effect; name it in the rows that it is for"
            }
            Self::SoilOfZeros => "every spring is zero, so this soil has no effect",
            Self::AddedMassOfZeros => "every mass is zero, so this table has no effect",
            Self::WaterOfZeros => {
                "the added mass coefficient is zero and the tower is not flooded, so the water has no effect"
            }
            Self::UprightWires => {
                "wires at this angle stand upright and hold nothing sideways; the angle is from the horizontal"
            }
        })
    }
}
