//! Input without effect.

use std::fmt;

/// A given value without effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Ineffective {
    /// A value without another one that it needs.
    Without {
        /// Its key in the tower file.
        key: &'static str,
        /// The key that is absent.
        needed: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// A mass at a clamped base.
    MassAtClampedBase,
    /// Guy wires at a clamped base.
    WiresAtClampedBase,
    /// A point mass without mass and inertia.
    EmptyPointMass,
    /// A centre of mass of a rotor-nacelle assembly without mass.
    CentreOfNothing,
    /// A material that no station has.
    UnusedMaterial,
    /// Soil whose springs are all zero.
    SoilOfZeros,
    /// A layer of soil below the tip of the pile.
    LayerBelowTip,
    /// A friction angle of sand beside the modulus k that takes its place.
    AngleBesideModulus,
    /// That sand is above the water, of which the table of RP 2GEO knows nothing.
    SandAboveWater,
    /// A value of a layer that its models do not use, by its key.
    KeyOfOtherModel(&'static str),
    /// A value of a layer that only a model of axial springs uses, by its key.
    KeyOfAxialModel(&'static str),
    /// Matlock's factor J in a layer with the model of Reese.
    FactorOfMatlock,
    /// A table of added mass that is all zero.
    AddedMassOfZeros,
    /// Water inside a tower that stands on a frame above it.
    FloodedBesideFrame,
    /// Water that adds no mass outside and is not inside.
    WaterOfZeros,
    /// Water whose level is below the surface of the ground.
    WaterBelowGround,
    /// Vertical guy wires, which have no horizontal stiffness.
    UprightWires,
}

impl fmt::Display for Ineffective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SandAboveWater => {
                "submerged = false has no effect on the modulus of this sand: the table of API RP 2GEO is for sand under water and is used above it too; edition = \"rp-2a\" has a figure for sand above water"
            }
            Self::Without {
                key,
                needed,
                remedy,
            } => return write!(f, "{key} has no effect without {needed}; {remedy}"),
            Self::KeyOfOtherModel(key) => {
                return write!(f, "{key} has no effect, because the models of this layer do not use it");
            }
            Self::KeyOfAxialModel(key) => {
                return write!(
                    f,
                    "{key} has no effect, because only axial = \"api\" in [ground] uses it"
                );
            }
            Self::MassAtClampedBase => {
                "a mass at the clamped base does not move and has no effect; check its height"
            }
            Self::WiresAtClampedBase => {
                "guy wires at the clamped base have no effect; check their height"
            }
            Self::EmptyPointMass => "neither mass nor inertia is given, so it has no effect",
            Self::CentreOfNothing => {
                "a centre of mass without mass has no effect; give the mass"
            }
            Self::UnusedMaterial => {
                "this material is not used by any station, so it has no effect; name the material in the stations that are made of it"
            }
            Self::SoilOfZeros => "all springs of this soil layer are zero, so it has no effect",
            Self::LayerBelowTip => {
                "this layer is below the tip of the pile, so it has no effect"
            }
            Self::AngleBesideModulus => {
                "subgrade_modulus replaces the friction angle, which has no effect; keep one of the two"
            }
            Self::FactorOfMatlock => {
                "the strength factor J belongs to Matlock's resistance and has no effect with reese-stiff-clay, which has its own formula for the resistance"
            }
            Self::AddedMassOfZeros => "all masses of this table are zero, so it has no effect",
            Self::FloodedBesideFrame => {
                "flooded applies to the stations of the tower, of which none is under water, so it has no effect; members with water inside are listed in flooded of [substructure]"
            }
            Self::WaterOfZeros => {
                "the added mass coefficient is zero and the tower is not flooded, so the water has no effect"
            }
            Self::WaterBelowGround => {
                "the water level is not above the surface of the ground, so there is no water around the tower"
            }
            Self::UprightWires => {
                "vertical guy wires have no horizontal stiffness; the angle is measured from the horizontal"
            }
        })
    }
}
