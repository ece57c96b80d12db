//! Suggestions for errors.

use super::{Place, Problem, TowerError};

impl TowerError {
    /// A suggestion in one sentence, unless the message contains it.
    pub fn hint(&self) -> Option<&'static str> {
        match (self.place, &self.problem) {
            (Place::PointMass { .. }, Problem::OutsideTower { .. }) => Some(
                "all heights use the datum of the stations; a mass on the tower top belongs to [rna]",
            ),
            (_, problem) => problem.hint(),
        }
    }
}

impl Problem {
    /// The suggestion for this problem at any place.
    fn hint(&self) -> Option<&'static str> {
        Some(match self {
            Self::NotFinite { .. } => "write a finite number, for example 6.0 or 2.1e11",
            Self::OutOfScale { .. } => "check exponent and unit",
            Self::ImpossibleModuli { .. } => {
                "both moduli are in Pa; for steel E is about 2.1e11 and G about 8.08e10"
            }
            Self::TooFewStations { .. } => "give at least one row at the base and one at the top",
            Self::HeightDecreases { .. } => {
                "list the stations from the base to the top; two rows at the same height define a step"
            }
            Self::HeightThrice { .. } => {
                "keep one row for the section below the step and one for the section above it"
            }
            Self::NoHeight { .. } => "the first value of a row is the height in m",
            Self::WallTooThick { .. } => {
                "a row is height, outer diameter, wall thickness, all in m; 27 mm is 0.027"
            }
            Self::OutsideTower { .. } => "all heights use the datum of the stations",
            Self::InertiaWithoutMass => "give the mass, or omit the inertia",
            Self::NegativeInertia { .. } => {
                "give all values in kg m2 about the centre of mass; products of inertia are entries of the tensor: xy is minus the integral of x y dm"
            }
            Self::Asymmetric { .. } => {
                "the order is x, y, z, rotation about x, y, z; entries (row, column) and (column, row) must be equal"
            }
            Self::Indefinite { .. } => {
                "no diagonal term may be negative, and the square of a coupling term must not exceed the product of its two diagonal terms"
            }
            Self::Free { .. } => {
                "clamp the base, add springs or soil for this motion, or use type = \"floating\""
            }
            Self::GearRatio { .. } => {
                "generator speed divided by rotor speed, for example 97; 1 without a gearbox"
            }
            Self::DrivetrainBeyondRna { .. } => {
                "give [rna] inertia xx with the rotor locked: it includes rotor_inertia and generator_inertia once each, without the gear ratio; generator_inertia is about the shaft of the generator"
            }
            Self::CouplingOfRigid => "omit coupling, or give finite lateral and rocking springs",
            Self::SoilPoissonsRatio { .. } => "sand has about 0.3, saturated clay 0.5",
            Self::ProfileWithoutFormula { .. } => {
                "use soil_profile = \"homogeneous\", or another formula"
            }
            Self::ExponentWithoutFormula { .. } => {
                "use formula = \"exact\", which holds for every exponent"
            }
            Self::EmbeddedInTwoStrata { .. } => {
                "write embedment = 0, or omit lower_shear_modulus for rock below the stratum"
            }
            Self::EmbeddedBelowStratum { .. } => {
                "soil_thickness is the depth of the rock below the surface of the soil, in m"
            }
            Self::OutOfRange { .. } | Self::TooLarge { .. } => "check value and unit",
            Self::TooFew { remedy, .. } => remedy,
            Self::Slope { .. } => "for a wire at 45 degrees write angle_deg = 45",
            Self::LossFactor { .. } => {
                "a loss factor is twice the damping ratio, as a fraction and not in percent: 0.004 for a damping ratio of 0.2 %"
            }
            Self::AddedMassFrequencies { .. } => {
                "list the rows by rising angular frequency, each frequency once"
            }
            Self::InfiniteAndFloating { .. } => {
                "write finite stiffnesses, or use type = \"springs\", where inf is allowed"
            }
            Self::WeightsWithoutBuoyancy => {
                "give hydrostatic and hydrostatic_height, or omit [gravity]"
            }
            Self::TooFewRows { .. } => "give at least one row at the bottom and one at the surface",
            Self::RowsDecrease { .. } => "list the rows from the bottom to the surface",
            Self::RowsOutsideTower { .. } | Self::WaterOutsideTower { .. } => {
                "all heights use the datum of the stations; heights below it are negative"
            }
            Self::RowsWithoutDepth { .. } => "the first value of a row is the height in m",
            Self::WaterAroundTable => {
                "give the added mass per length in [[added_mass]], or describe the tower by stations"
            }
            Self::BedAboveWater { .. } => "omit bed if the seabed is at the lowest station",
            Self::SurfaceAboveTower { .. }
            | Self::PileAboveSoil { .. }
            | Self::FirstLayerOffSurface { .. } => {
                "all heights use the datum of the stations; the stations reach down to the tip of the pile"
            }
            Self::FrameAboveSoil { .. } => {
                "all heights use one datum; members reach down to the tips of the piles"
            }
            Self::PilesSink => "give axial in [ground], or support the tips",
            Self::PileTurns => {
                "give axial = \"randolph-wroth\" in [ground], or a support that holds the rotation about z"
            }
            Self::PileWithoutTube { .. } => "give the piles as tubes",
            Self::TowerOnFrameInSoil { .. } => {
                "begin the tower at the surface of the ground or above it"
            }
            Self::PileWithoutDiameter => {
                "give pile_diameter in [ground], or describe the tower by stations"
            }
            Self::PileWithTwoDiameters => "remove pile_diameter",
            Self::NoLayers => "give at least one [[ground.layer]] with top and bottom",
            Self::LayersApart { .. } => {
                "list the layers from the surface down; each begins where the one above ends"
            }
            Self::LayerUpsideDown { .. } => {
                "top and bottom are heights, not depths: the bottom has the smaller value"
            }
            Self::LayersAboveTip { .. } => "give the soil down to the tip of the pile",
            Self::SoilValueMissing { .. } => {
                "give the value in [[ground.layer]], or choose another model"
            }
            Self::ModelOfOtherSoil { suited, .. } => suited,
            Self::AxialOfOtherSoil { .. } => {
                "the t-z curves of API are for sand and clay; axial = \"kraft\" or \"randolph-wroth\" can be used for every soil, with its shear modulus, and for rock, with youngs_modulus and poissons_ratio"
            }
            Self::CorrelationOfOtherSoil { .. } => {
                "sand: rix-stokoe, robertson-cabal, void_ratio; clay: mayne-rix, robertson-cabal; or give shear_modulus or shear_wave_velocity"
            }
            Self::ConeBelowStress { .. } => {
                "cone_resistance is in Pa, not kPa or MPa; q_t is corrected for the pore pressure behind the cone"
            }
            Self::TableRowsRise { .. } => "list the rows from the top of the layer down",
            Self::TableShorterThanLayer { .. } => {
                "give rows at the top and at the bottom of the layer, or beyond"
            }
            Self::StationsAndProperties => "remove one of the two",
            Self::ShearInSomeRows => {
                "give it in every row, or in no row for a tower without shear deformation"
            }
            Self::RigidInSomeRows { .. } => {
                "write inf in every row for a tower without torsion or axial deformation; otherwise give a number in every row"
            }
            Self::ShearCoefficient { .. } => {
                "a thin-walled tube has about 0.53; shear = true uses Cowper's value"
            }
            Self::SpeedsFall { .. } => {
                "write rpm = [lowest, highest], or one number for constant speed"
            }
            Self::RotorTooFast { .. } => "the unit is revolutions per minute (rpm)",
            Self::Blades { .. } => "give the number of blades, for example 3, or omit [rotor]",
            // The message already contains the suggestion.
            Self::Frame { .. }
            | Self::Mooring(_)
            | Self::Equilibrium(_)
            | Self::NotPositive { .. }
            | Self::Negative { .. }
            | Self::UnknownMaterial { .. } => {
                return None;
            }
        })
    }
}
