//! Errors in the description of a tower, with the place and the values.

mod hint;
mod place;

pub use place::Place;

use std::fmt;

use thiserror::Error;

use super::floating::mistake::EquilibriumError;
use crate::mooring::MooringError;
use crate::number::{Apart, Plain, Rounded};

/// An invalid description of a tower: the place and the problem.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{place}: {problem}")]
pub struct TowerError {
    /// The place of the value.
    pub place: Place,
    /// The problem, with its numbers.
    #[source]
    pub problem: Problem,
}

/// An impossible value, with its numbers.
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
    /// Invalid mooring lines.
    #[error(transparent)]
    Mooring(#[from] MooringError),
    /// A floating tower without an equilibrium, at which the stiffness of its lines is requested.
    #[error(transparent)]
    Equilibrium(#[from] EquilibriumError),
    /// An invalid frame.
    #[error("{message}")]
    Frame {
        /// The text of a [`FrameError`](crate::frame::FrameError): the part and the mistake in it.
        message: String,
    },
    /// A magnitude that no quantity of a tower has, and for which computed numbers may not be
    /// finite.
    #[error(
        "{quantity} is {}{unit}; its magnitude must be from {} to {}{unit}",
        Plain(*.value), Plain(*.least), Plain(*.most)
    )]
    OutOfScale {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Its unit, after a space, or nothing.
        unit: &'static str,
        /// Smallest allowed magnitude other than zero.
        least: f64,
        /// Largest allowed magnitude.
        most: f64,
    },
    /// Zero or negative where only a positive number makes sense.
    #[error("{quantity} is {}{unit}; it must be positive", Plain(*.value))]
    NotPositive {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Its unit, after a space, or nothing.
        unit: &'static str,
    },
    /// Negative where zero is the least.
    #[error("{quantity} is {}{unit}; it must not be negative", Plain(*.value))]
    Negative {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Its unit, after a space, or nothing.
        unit: &'static str,
    },
    /// Values of E and G that no isotropic material has.
    #[error(
        "shear modulus {} Pa with Young's modulus {} Pa gives Poisson's ratio {}, outside the range -1 to 0.5",
        Plain(*.shear_modulus_pa), Plain(*.youngs_modulus_pa), Plain(rounded(*.poissons_ratio))
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
    #[error("a tower needs at least two stations, but has {count}")]
    TooFewStations {
        /// How many there are.
        count: usize,
    },
    /// A station below the previous station.
    #[error(
        "height {} m is below the previous station at {} m",
        Apart(*.height_m, *.previous_m), Apart(*.previous_m, *.height_m)
    )]
    HeightDecreases {
        /// This station's height, m.
        height_m: f64,
        /// The height of the station before, m.
        previous_m: f64,
    },
    /// A third station at one height.
    #[error(
        "three stations at height {} m; two define a step, and a third is not allowed",
        Plain(*.height_m)
    )]
    HeightThrice {
        /// The repeated height, m.
        height_m: f64,
    },
    /// All stations at one height.
    #[error("the tower has no height: all stations are at {} m", Plain(*.height_m))]
    NoHeight {
        /// The height of all of them, m.
        height_m: f64,
    },
    /// A wall that does not fit into the tube.
    #[error(
        "outer diameter {} m is less than twice the wall thickness {} m at z = {} m",
        Apart(*.outer_diameter_m, 2.0 * .wall_thickness_m),
        Apart(*.wall_thickness_m, 0.5 * .outer_diameter_m),
        Plain(*.height_m)
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
    /// A point mass or guy wires at a height outside the tower.
    #[error(
        "height {} m is not on the tower, which reaches from {} m to {} m",
        Apart(*.height_m, nearer(*.height_m, *.base_m, *.top_m)),
        Apart(*.base_m, *.height_m),
        Apart(*.top_m, *.height_m)
    )]
    OutsideTower {
        /// Height of the mass or of the wires, m.
        height_m: f64,
        /// Height of the base, m.
        base_m: f64,
        /// Height of the top, m.
        top_m: f64,
    },
    /// An RNA that has inertia but no mass.
    #[error("the rotor-nacelle assembly has an inertia but no mass")]
    InertiaWithoutMass,
    /// An inertia tensor with a negative principal moment.
    #[error(
        "the principal moments of inertia are {}, {} and {} kg m2; they must not be negative",
        Rounded(.principal_kg_m2[0]), Rounded(.principal_kg_m2[1]), Rounded(.principal_kg_m2[2])
    )]
    NegativeInertia {
        /// The principal moments, rising, kg m².
        principal_kg_m2: [f64; 3],
    },
    /// A matrix that is not symmetric.
    #[error(
        "the {what} is not symmetric: row {row}, column {column} is {} and row {column}, column {row} is {}",
        Plain(*.upper), Plain(*.lower)
    )]
    Asymmetric {
        /// Name of the matrix.
        what: &'static str,
        /// Row of the entry above the diagonal, from 1.
        row: usize,
        /// Column of the entry above the diagonal, from 1.
        column: usize,
        /// The entry above the diagonal.
        upper: f64,
        /// The entry below the diagonal.
        lower: f64,
    },
    /// A stiffness or inertia matrix with a negative eigenvalue.
    #[error("the {what} has a negative eigenvalue, {}", Rounded(*.eigenvalue))]
    Indefinite {
        /// Name of the matrix.
        what: &'static str,
        /// The smallest eigenvalue, in the units of the matrix.
        eigenvalue: f64,
    },
    /// A tower with motions that nothing resists.
    #[error("the tower is not supported: there is no stiffness against {motions}")]
    Free {
        /// The motions without stiffness.
        motions: FreeMotions,
    },
    /// A coupling spring, although a spring against one of the coupled motions is infinite.
    #[error("a coupling spring cannot be combined with an infinite lateral or rocking spring")]
    CouplingOfRigid,
    /// A Poisson's ratio of soil outside 0 to 0.5.
    #[error("Poisson's ratio of the soil is {}; it must be from 0 to 0.5", Plain(*.value))]
    SoilPoissonsRatio {
        /// The value given.
        value: f64,
    },
    /// A formula for piles that has no form for this profile of the soil.
    #[error("the formula of {formula} does not apply to this profile of the soil")]
    ProfileWithoutFormula {
        /// Authors and year.
        formula: &'static str,
    },
    /// A formula for piles on springs that has no form for this exponent of the depth.
    #[error(
        "the formula of {formula} holds for constant springs and for springs that grow with the depth; here they grow with the power {} of the depth",
        Plain(rounded(*.exponent))
    )]
    ExponentWithoutFormula {
        /// Authors and year.
        formula: &'static str,
        /// The exponent of the depth in the springs.
        exponent: f64,
    },
    /// A footing that is embedded in the upper one of two strata.
    #[error(
        "the footing is embedded by {} m in a stratum over another stratum; the formulas hold for a footing on the surface of two strata and for \
         an embedded one over rock",
        Plain(*.embedment_m)
    )]
    EmbeddedInTwoStrata {
        /// The embedment, m.
        embedment_m: f64,
    },
    /// A footing whose underside is not above the bottom of its stratum.
    #[error(
        "the underside of the footing is {} m below the surface of the soil, and the stratum ends at {} m",
        Plain(*.embedment_m), Plain(*.thickness_m)
    )]
    EmbeddedBelowStratum {
        /// The embedment, m.
        embedment_m: f64,
        /// Thickness of the stratum, m.
        thickness_m: f64,
    },
    /// A number outside its possible range.
    #[error(
        "{quantity} is {}{unit}; it must be from {} to {}{unit}",
        Plain(*.value), Plain(*.least), Plain(*.most)
    )]
    OutOfRange {
        /// The quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit after a space.
        unit: &'static str,
        /// The least possible value.
        least: f64,
        /// The largest possible value.
        most: f64,
    },
    /// A positive number beyond its largest possible value.
    #[error(
        "{quantity} is {}{unit}; it must be above 0 and at most {}{unit}",
        Plain(*.value), Plain(*.most)
    )]
    TooLarge {
        /// The quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit after a space.
        unit: &'static str,
        /// The largest possible value.
        most: f64,
    },
    /// Fewer than are needed.
    #[error("{quantity} is {count}; it must be at least {least}")]
    TooFew {
        /// Name of the entries.
        quantity: &'static str,
        /// How many there are.
        count: u64,
        /// Least number of entries.
        least: u64,
        /// What the user can do; may be empty.
        remedy: &'static str,
    },
    /// Rows of added mass by frequency that do not rise from above zero.
    #[error(
        "row {row} of the added mass by frequency is at {} rad/s; it must be finite and above {} rad/s, the frequency of the row before it",
        Plain(*.frequency), Plain(*.before)
    )]
    AddedMassFrequencies {
        /// Which row, from 1; that of frequency zero is not counted.
        row: usize,
        /// Its angular frequency, rad/s.
        frequency: f64,
        /// Angular frequency of the row before it, rad/s.
        before: f64,
    },
    /// An infinite stiffness for a floating platform.
    #[error(
        "the {what} has an infinite entry, but a floating platform cannot be rigidly supported"
    )]
    InfiniteAndFloating {
        /// Name of the matrix.
        what: &'static str,
    },
    /// Gravity on a floating platform without hydrostatic stiffness.
    #[error(
        "a floating platform with gravity needs the hydrostatic stiffness and its reference height"
    )]
    WeightsWithoutBuoyancy,
    /// Fewer than two rows around the tower.
    #[error("{what} needs at least two rows, but has {count}")]
    TooFewRows {
        /// The kind of rows.
        what: &'static str,
        /// How many there are.
        count: usize,
    },
    /// A row around the tower below the previous row.
    #[error(
        "height {} m is below the previous row at {} m",
        Apart(*.height_m, *.previous_m), Apart(*.previous_m, *.height_m)
    )]
    RowsDecrease {
        /// This row's height, m.
        height_m: f64,
        /// The height of the row before, m.
        previous_m: f64,
    },
    /// Rows that extend below or above the tower.
    #[error(
        "{what} extends from {} m to {} m, but the tower from {} m to {} m",
        Plain(*.bottom_m),
        Apart(*.surface_m, nearer(*.surface_m, *.base_m, *.top_m)),
        Apart(*.base_m, *.surface_m),
        Apart(*.top_m, *.surface_m)
    )]
    RowsOutsideTower {
        /// The kind of rows.
        what: &'static str,
        /// Height of the lowest row, m.
        bottom_m: f64,
        /// Height of the highest row, m.
        surface_m: f64,
        /// Height of the base, m.
        base_m: f64,
        /// Height of the top, m.
        top_m: f64,
    },
    /// All rows at one height.
    #[error("{what} has no depth: all rows are at {} m", Plain(*.height_m))]
    RowsWithoutDepth {
        /// The kind of rows.
        what: &'static str,
        /// The height of all of them, m.
        height_m: f64,
    },
    /// Water around a tower without diameters.
    #[error("[water] needs stations with diameters; a table of properties has none")]
    WaterAroundTable,
    /// A seabed that is not below the water level.
    #[error("the seabed at {} m is not below the water level at {} m", Plain(*.bed_m), Plain(*.level_m))]
    BedAboveWater {
        /// Height of the seabed, m.
        bed_m: f64,
        /// Height of the surface, m.
        level_m: f64,
    },
    /// Water that does not touch the tower.
    #[error(
        "the water does not touch the tower: its level is {} m and its bed {} m, but the tower extends from {} m to {} m",
        Plain(*.level_m), Plain(*.bed_m), Plain(*.base_m), Plain(*.top_m)
    )]
    WaterOutsideTower {
        /// Height of the seabed, m.
        bed_m: f64,
        /// Height of the surface, m.
        level_m: f64,
        /// Height of the base, m.
        base_m: f64,
        /// Height of the top, m.
        top_m: f64,
    },
    /// A surface of the ground above the tower.
    #[error(
        "the surface of the ground at {} m is above the tower top at {} m",
        Apart(*.surface_m, *.top_m), Apart(*.top_m, *.surface_m)
    )]
    SurfaceAboveTower {
        /// Height of the surface, m.
        surface_m: f64,
        /// Height of the top, m.
        top_m: f64,
    },
    /// A tower whose lowest station is not in the ground.
    #[error(
        "the tower does not reach into the soil: its lowest station is at {} m, the surface of the ground at {} m with scour of {} m; [ground] is for piles, whose stations reach down to the tip; a footing has a type in [foundation] with the modulus of its soil, without [ground]",
        Plain(*.tip_m), Plain(*.surface_m), Plain(*.scour_m)
    )]
    PileAboveSoil {
        /// Height of the surface before scour, m.
        surface_m: f64,
        /// Depth of general and local scour together, m.
        scour_m: f64,
        /// Height of the lowest station, m.
        tip_m: f64,
    },
    /// A frame without a member in the ground.
    #[error(
        "no member of the substructure that is steeper than 30 degrees reaches into the soil: its lowest joint is at {} m, the surface of the ground at {} m with scour of {} m",
        Plain(*.lowest_m), Plain(*.surface_m), Plain(*.scour_m)
    )]
    FrameAboveSoil {
        /// Height of the surface before scour, m.
        surface_m: f64,
        /// Depth of general and local scour together, m.
        scour_m: f64,
        /// Height of the lowest joint, m.
        lowest_m: f64,
    },
    /// Piles of a frame that nothing holds vertically.
    #[error(
        "the piles have no axial support: [ground] has no axial springs, and no support fixes them in z"
    )]
    PilesSink,
    /// A single pile under a frame that nothing prevents from rotating about its axis.
    #[error(
        "the single pile has no support against rotation about its axis: neither the springs along it nor a support have a torsional stiffness"
    )]
    PileTurns,
    /// A member in the ground without outer diameter.
    #[error(
        "member {member} is below the surface of the ground, and its section has no outer diameter, on which the springs of the soil depend"
    )]
    PileWithoutTube {
        /// Name of the member.
        member: String,
    },
    /// A tower on a frame that begins below the surface of the ground.
    #[error(
        "the tower begins at {} m on its substructure, below the surface of the ground at {} m (after scour); the piles must be part of the substructure",
        Apart(*.base_m, *.surface_m), Apart(*.surface_m, *.base_m)
    )]
    TowerOnFrameInSoil {
        /// Height of the base of the tower, m.
        base_m: f64,
        /// Height of the surface after scour, m.
        surface_m: f64,
    },
    /// A pile in the ground that is given by a table of properties without diameter.
    #[error("the ground needs the diameter of the pile; a table of properties has none")]
    PileWithoutDiameter,
    /// A diameter beside those of the stations or members.
    #[error("the diameter of the pile is given twice: its tubes have diameters")]
    PileWithTwoDiameters,
    /// A gear ratio that no gearbox has.
    #[error("the gear ratio is {}; it must be 0.001 to 10 000, or negative if the generator rotates in the opposite direction", Plain(*.gear_ratio))]
    GearRatio {
        /// The ratio.
        gear_ratio: f64,
    },
    /// A rotor and a generator with more inertia than the assembly that contains them.
    #[error(
        "rotor and generator have {} kg m2 about the shaft, more than the inertia xx of the rotor-nacelle assembly that contains them, {} kg m2",
        Apart(*.locked_kg_m2, *.xx_kg_m2), Apart(*.xx_kg_m2, *.locked_kg_m2)
    )]
    DrivetrainBeyondRna {
        /// Inertia of rotor and generator about the shaft, kg m².
        locked_kg_m2: f64,
        /// Inertia xx of the rotor-nacelle assembly, kg m².
        xx_kg_m2: f64,
    },
    /// Ground without layers.
    #[error("the ground has no layers")]
    NoLayers,
    /// A first layer that does not begin at the surface.
    #[error(
        "the first layer begins at {} m, but the surface of the ground is at {} m",
        Apart(*.top_m, *.surface_m), Apart(*.surface_m, *.top_m)
    )]
    FirstLayerOffSurface {
        /// Height of the layer's top, m.
        top_m: f64,
        /// Height of the surface, m.
        surface_m: f64,
    },
    /// Layers with a gap between them or that overlap.
    #[error(
        "the layer begins at {} m, but the layer above ends at {} m: {}",
        Apart(*.top_m, *.above_m), Apart(*.above_m, *.top_m),
        if .top_m < .above_m { "there is a gap between them" } else { "they overlap" }
    )]
    LayersApart {
        /// Height of the layer's top, m.
        top_m: f64,
        /// Height of the bottom of the layer above, m.
        above_m: f64,
    },
    /// A layer that ends above its top.
    #[error(
        "the bottom of the layer at {} m is not below its top at {} m",
        Plain(*.bottom_m), Plain(*.top_m)
    )]
    LayerUpsideDown {
        /// Height of its top, m.
        top_m: f64,
        /// Height of its bottom, m.
        bottom_m: f64,
    },
    /// Layers that do not reach down to the tip of the pile.
    #[error(
        "the lowest layer ends at {} m, above the tip of the pile at {} m",
        Apart(*.bottom_m, *.tip_m), Apart(*.tip_m, *.bottom_m)
    )]
    LayersAboveTip {
        /// Height of the bottom of the lowest layer, m.
        bottom_m: f64,
        /// Height of the lowest station, m.
        tip_m: f64,
    },
    /// A model of soil without a number that it needs.
    #[error("{user} needs {value}")]
    SoilValueMissing {
        /// Name of the missing value.
        value: &'static str,
        /// What needs it.
        user: &'static str,
    },
    /// A model of soil that has no formula for the kind of soil.
    #[error("the model {model} has no formula for {soil}")]
    ModelOfOtherSoil {
        /// The model.
        model: &'static str,
        /// The kind of soil.
        soil: &'static str,
        /// The models that have a formula for each kind of soil.
        suited: &'static str,
    },
    /// A model of axial springs that has no formula for the kind of soil.
    #[error("{model} has no formula for {soil}")]
    AxialOfOtherSoil {
        /// The model.
        model: &'static str,
        /// The kind of soil.
        soil: &'static str,
    },
    /// A correlation of the shear modulus that was made for another soil.
    #[error("{correlation} is a correlation for {own}, and this layer is {soil}")]
    CorrelationOfOtherSoil {
        /// The correlation.
        correlation: &'static str,
        /// The kind of soil for which it was made.
        own: &'static str,
        /// The kind of soil of the layer.
        soil: &'static str,
    },
    /// A cone resistance that the stress in the soil exceeds.
    #[error(
        "the cone resistance q_t is {} Pa at z = {} m, less than the stress of soil and water there, {} Pa, so the shear modulus would be negative",
        Plain(*.cone_pa), Plain(*.height_m), Rounded(*.stress_pa)
    )]
    ConeBelowStress {
        /// The height, m.
        height_m: f64,
        /// The cone resistance there, Pa.
        cone_pa: f64,
        /// The total vertical stress there, Pa.
        stress_pa: f64,
    },
    /// Rows of a table of p-y curves that do not go down.
    #[error(
        "height {} m is not below the previous row at {} m",
        Plain(*.height_m), Plain(*.previous_m)
    )]
    TableRowsRise {
        /// This row's height, m.
        height_m: f64,
        /// The height of the row before, m.
        previous_m: f64,
    },
    /// A table of p-y curves that does not cover its layer.
    #[error(
        "the rows reach from {} m down to {} m, but the layer from {} m to {} m",
        Plain(*.first_m), Plain(*.last_m), Plain(*.top_m), Plain(*.bottom_m)
    )]
    TableShorterThanLayer {
        /// Height of the first row, m.
        first_m: f64,
        /// Height of the last row, m.
        last_m: f64,
        /// Height of the layer's top, m.
        top_m: f64,
        /// Height of the layer's bottom, m.
        bottom_m: f64,
    },
    /// An angle from the horizontal outside 0 to 90 degrees.
    #[error("{quantity} is {} degrees; it must be from 0 to 90", Plain(*.value_deg))]
    Slope {
        /// Name of the angle.
        quantity: &'static str,
        /// Its value, degrees.
        value_deg: f64,
    },
    /// A loss factor outside 0 to 1.
    #[error("{quantity} is {}; it must be from 0 to 1", Plain(*.value))]
    LossFactor {
        /// Which loss factor.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Tubes and a property table for one tower.
    #[error("the tower has both stations and a table of properties")]
    StationsAndProperties,
    /// Shear stiffness in some rows of a property table.
    #[error("some rows have a shear stiffness and others have none")]
    ShearInSomeRows,
    /// An infinite stiffness in some rows of a property table.
    #[error("some rows of {column} are infinite and others are not")]
    RigidInSomeRows {
        /// The column.
        column: &'static str,
    },
    /// A shear coefficient outside 0 to 1.
    #[error("the shear coefficient is {}; it must be greater than 0 and at most 1", Plain(*.value))]
    ShearCoefficient {
        /// The value given.
        value: f64,
    },
    /// A rotor without blades, or with more than the largest allowed number.
    #[error("the rotor has {count} blades; the number must be from 1 to {most}")]
    Blades {
        /// Number of blades.
        count: usize,
        /// Largest allowed number.
        most: usize,
    },
    /// A lowest speed above the highest.
    #[error(
        "the lowest rotor speed, {} rpm, is above the highest, {} rpm",
        Plain(*.lowest_rpm), Plain(*.highest_rpm)
    )]
    SpeedsFall {
        /// The lowest speed, rpm.
        lowest_rpm: f64,
        /// The highest speed, rpm.
        highest_rpm: f64,
    },
    /// A highest rotor speed above the largest allowed speed.
    #[error(
        "the highest rotor speed is {} rpm; it must be at most {} rpm",
        Plain(*.highest_rpm), Plain(*.most_rpm)
    )]
    RotorTooFast {
        /// The speed, rpm.
        highest_rpm: f64,
        /// Largest allowed speed, rpm.
        most_rpm: f64,
    },
}

/// Which of the motions x, y, z and rotation about x, y, z of the whole tower nothing resists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FreeMotions(pub [bool; 6]);

impl fmt::Display for FreeMotions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const NAMES: [&str; 6] = [
            "translation in x",
            "translation in y",
            "translation in z",
            "rotation about x",
            "rotation about y",
            "rotation about z",
        ];
        let free = NAMES.iter().zip(self.0).filter(|(_, is_free)| *is_free);
        let names: Vec<&str> = free.map(|(name, _)| *name).collect();
        match names.split_last() {
            Some((last, [_, ..])) => {
                let others = names[..names.len() - 1].join(", ");
                write!(f, "{others} and {last}")
            }
            _ => write!(f, "{}", names.concat()),
        }
    }
}

/// The end of the tower that is nearer to a height, m.
fn nearer(height_m: f64, base_m: f64, top_m: f64) -> f64 {
    if height_m < base_m { base_m } else { top_m }
}

/// Rounded to four decimals.
fn rounded(value: f64) -> f64 {
    let scaled = (value * 1e4).round() / 1e4;
    if scaled.is_finite() { scaled } else { value }
}
