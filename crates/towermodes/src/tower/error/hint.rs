//! What would be right instead of a mistake.

use super::Problem;

impl Problem {
    /// What would be right, in one sentence, where more can be said than the message says.
    pub fn hint(&self) -> Option<&'static str> {
        Some(match self {
            Self::NotFinite { .. } => "write an ordinary number, as 6.0 or 2.1e11",
            Self::OutOfScale { .. } => "look at the exponent and the unit",
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
            Self::NegativeInertia { .. } => {
                "products are the entries of the tensor (xy is minus the integral of x y dm), all in kg m2 about the body's own centre"
            }
            Self::Asymmetric { .. } => {
                "the order is x, y, z, rotation about x, y, z; entry (row, column) and entry (column, row) are the same quantity"
            }
            Self::Indefinite { .. } => {
                "look at the signs of the coupling: a force in x and the rotation about y that it makes have one sign, y and x the other"
            }
            Self::Free { .. } => {
                "clamp it, give it springs or soil there, or make it type = \"floating\""
            }
            Self::CouplingOfRigid => "leave coupling out, or give both springs a number",
            Self::SoilPoissonsRatio { .. } => "sand has about 0.3, saturated clay 0.5",
            Self::InfiniteAndFloating { .. } => {
                "write finite stiffnesses, or use type = \"springs\", where inf is allowed"
            }
            Self::WeightsWithoutBuoyancy => {
                "give hydrostatic and hydrostatic_height; leave [gravity] out to solve without weights"
            }
            Self::TooFewRows { .. } => "one row at the bottom and one at the surface are enough",
            Self::RowsDecrease { .. } => "list the rows from the bottom to the surface",
            Self::RowsOutsideTower { .. } | Self::WaterOutsideTower { .. } => {
                "heights are in the datum of the stations; a depth below it is negative"
            }
            Self::RowsWithoutDepth { .. } => "the first value of a row is its height in m",
            Self::WaterAroundTable => {
                "give its mass per length in [[added_mass]], which moves transversely alone, or give stations"
            }
            Self::BedAboveWater { .. } => "leave bed out if it is the lowest station",
            Self::TooFewWires { .. } => "count is the number of equally spaced wires",
            Self::WireAngle { .. } => "a wire at 45 degrees has angle_deg = 45",
            Self::StationsAndProperties => "keep one of the two",
            Self::ShearInSomeRows => {
                "give it in every row, or in none for a tower that does not shear"
            }
            Self::RigidInSomeRows { .. } => {
                "infinity is for a tower that does not twist, or stretch, at all; give every row a number otherwise"
            }
            Self::ShearCoefficient { .. } => {
                "a thin tube has about 0.53; shear = true uses Cowper's value"
            }
            Self::SpeedsFall { .. } => {
                "rpm = [lowest, highest]; a rotor of constant speed has one number"
            }
            Self::RotorTooFast { .. } => "speeds are in turns per minute",
            Self::Blades { .. } => {
                "give the number of blades of the rotor, as 3; leave [rotor] out if there is none"
            }
            Self::NotPositive { .. } | Self::Negative { .. } | Self::UnknownMaterial { .. } => {
                return None;
            }
        })
    }
}
