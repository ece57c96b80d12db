//! Warnings: inputs and results that are possible but probably a mistake.

mod ineffective;
mod site;

pub use ineffective::Ineffective;
pub use site::Site;

use std::fmt;

use thiserror::Error;

use super::error::Place;
use super::frame::FrameWarning;
use super::parts::missing::MissingParts;
use crate::inputs::Quantity;
use crate::method::Method;
use crate::mooring::{MooringItem, MooringWarning};
use crate::number::{Apart, Plain, Rounded, end_of_range, significant};

/// A fact that a user should check; the computation continues.
///
/// The variant is its kind and the fields have the numbers, so that a program need not read the
/// words. [`site`](Self::site) gives the place in the description.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Warning {
    /// A diameter over 30 m.
    #[error(
        "{}outer diameter {} m{} is larger than 30 m; lengths are in m, not mm",
        .site.before(), Plain(*.outer_diameter_m), .site.after()
    )]
    LargeDiameter {
        /// The station and its height.
        site: Site,
        /// The diameter, m.
        outer_diameter_m: f64,
    },
    /// A tower over 1 km.
    #[error("the tower is {} m high, more than 1 km; lengths are in m, not mm", Plain(*.height_m))]
    TallTower {
        /// The highest station.
        site: Site,
        /// Base to top, m.
        height_m: f64,
    },
    /// A wall that is too thin or too thick for the diameter.
    #[error(
        "{}wall thickness {} m at z = {} m is 1/{} of the diameter {} m; expected 1/{:.0} to 1/{:.0}: check unit and decimal point of both",
        .site.before(),
        Plain(*.wall_thickness_m),
        Plain(.site.height_m.unwrap_or_default()),
        Plain(rounded(.outer_diameter_m / .wall_thickness_m)),
        Plain(*.outer_diameter_m),
        .most,
        .least
    )]
    UnusualWall {
        /// Which station.
        site: Site,
        /// Wall thickness, m.
        wall_thickness_m: f64,
        /// Outer diameter, m.
        outer_diameter_m: f64,
        /// The least ratio of diameter to wall that towers of this size and material have.
        least: f64,
        /// The largest.
        most: f64,
    },
    /// A value outside the range in which towers have the quantity.
    #[error(
        "{}{}{} is {}{}; expected {}; {}",
        .site.before(),
        .quantity.name(),
        .site.after(),
        Plain(*.value),
        .quantity.unit(),
        Range(*.least, *.most, .quantity.unit()),
        .quantity.likely_slip()
    )]
    Unusual {
        /// The quantity.
        quantity: Quantity,
        /// The site of the value; of several rows the one that is furthest outside.
        site: Site,
        /// The value.
        value: f64,
        /// The least that towers have; minus infinity if there is none.
        least: f64,
        /// The most that towers have; infinity if there is none.
        most: f64,
    },
    /// A value of one row that does not fit those of the adjacent rows.
    #[error(
        "{}{column}{} is {}{unit}, {} times the value expected from the adjacent rows ({}{unit}): check decimal point and exponent",
        .site.before(),
        .site.after(),
        Rounded(*.value),
        Plain(rounded(.value / .expected)),
        Rounded(*.expected)
    )]
    RowOutOfLine {
        /// The row.
        site: Site,
        /// The column, in words.
        column: &'static str,
        /// Its unit after a space.
        unit: &'static str,
        /// The value, in the unit of the column.
        value: f64,
        /// The value expected from the adjacent rows.
        expected: f64,
    },
    /// A given value without effect.
    #[error("{}{what}", .site.before())]
    NoEffect {
        /// The site of the value.
        site: Site,
        /// What it is.
        what: Ineffective,
    },
    /// A row below a step at the base, or above a step at the top, has no length.
    #[error("{}this row defines a step at the end of the tower{} and has no effect", .site.before(), .site.after())]
    UselessStation {
        /// The station and its height.
        site: Site,
    },
    /// The last row names another material than the row below it.
    #[error(
        "{}the material of the last row has no effect: the material of a row is used up to the next row; \
         to change the material at a height, give two rows at this height",
        .site.before()
    )]
    UselessMaterial {
        /// The last station.
        site: Site,
    },
    /// A rotor-nacelle assembly heavier than five towers.
    #[error(
        "{}the mass, {} kg, is more than five times the mass of the tower, {} kg",
        .site.before(), Plain(.rna_kg.round()), Plain(.tower_kg.round())
    )]
    HeavyRna {
        /// The assembly.
        site: Site,
        /// Mass of the assembly, kg.
        rna_kg: f64,
        /// Mass of the tower, kg.
        tower_kg: f64,
    },
    /// A heavy rotor-nacelle assembly without inertia.
    #[error(
        "{}the mass is {} kg, but no inertia is given: the second bending frequencies can be tens of percent too high and the torsional \
         frequency several times too high; give the inertia about the centre of mass in kg m2, or zeros for a point mass",
        .site.before(), Plain(*.mass_kg)
    )]
    RnaWithoutInertia {
        /// The assembly.
        site: Site,
        /// Its mass, kg.
        mass_kg: f64,
    },
    /// A point mass with inertia and no mass.
    #[error("{}an inertia is given but no mass; give the mass in kg", .site.before())]
    InertiaWithoutMass {
        /// The point mass.
        site: Site,
    },
    /// Couplings of translation and rotation that have one sign where they should have opposite
    /// ones.
    #[error(
        "the {what} has the same sign in the coupling of x with rotation about y ({}) and of y with rotation about x ({}); for equal \
         properties in both planes the signs are opposite",
        Plain(*.fore_aft), Plain(*.side_side)
    )]
    CouplingSigns {
        /// Which matrix.
        what: &'static str,
        /// Where it is.
        site: Site,
        /// Entry x, rotation about y.
        fore_aft: f64,
        /// Entry y, rotation about x.
        side_side: f64,
    },
    /// A coupling of a translation with the rotation about the same axis.
    #[error(
        "the {what} couples translation and rotation about the same axis (row {row}, column {column} is {}); bending couples x with \
         rotation about y and y with rotation about x: row 1, column 5 and row 2, column 4",
        Plain(*.value)
    )]
    CouplingAlongAxis {
        /// Which matrix.
        what: &'static str,
        /// Where it is.
        site: Site,
        /// Row of the entry, from 1.
        row: usize,
        /// Column of the entry, from 1.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// A foundation or a platform that acts above the tower's base.
    #[error(
        "the coupling terms of the {what} place it {} m above the tower base{}; below the base, row 1, column 5 is negative and row 2, \
         column 4 is positive: check the signs",
        Rounded(*.above_m), .site.after()
    )]
    ActsAbove {
        /// Which matrix.
        what: &'static str,
        /// Where it is.
        site: Site,
        /// How far above the base its centre is, by its entries, m.
        above_m: f64,
    },
    /// A pile between the ranges of the formulas for rigid and for flexible piles.
    #[error(
        "the pile is neither rigid nor flexible: {measure} is {}; the formulas of {formula} hold for rigid \
         piles, up to {}, and for flexible piles, from {}; the form with the smaller stiffness is used, which is too stiff; check the result with type = \
         \"winkler-pile\" and formula = \"exact\", or with [[soil]] along the pile",
        Plain(rounded(*.length)), Plain(rounded(*.rigid_at_most)), Plain(rounded(*.flexible_at_least))
    )]
    BetweenRigidAndFlexible {
        /// The key with the length of the pile.
        site: Site,
        /// The formula.
        formula: &'static str,
        /// What the limits are about.
        measure: &'static str,
        /// Its value.
        length: f64,
        /// Up to this a pile is rigid.
        rigid_at_most: f64,
        /// From this a pile is flexible.
        flexible_at_least: f64,
    },
    /// A formula for a foundation outside the range for which it was derived.
    #[error(
        "{quantity} is {}; {formula} holds for {}, so the stiffness is extrapolated; {remedy}",
        Plain(rounded(*.value)), Range(*.least, *.most, "")
    )]
    OutsideFormula {
        /// The key of the value.
        site: Site,
        /// The formula.
        formula: &'static str,
        /// What its range is about.
        quantity: &'static str,
        /// The value.
        value: f64,
        /// The least for which the formula holds; minus infinity if there is none.
        least: f64,
        /// The most; infinity if there is none.
        most: f64,
        /// What to do.
        remedy: &'static str,
    },
    /// Soil springs on the tower together with a foundation that contains the soil.
    #[error(
        "there is soil along the tower, and the stiffness of this foundation contains the soil already: the soil may be counted twice; model the \
         pile either by stations in soil, or by [foundation] with the lowest station at the surface of the soil"
    )]
    SoilTwice {
        /// The type of the foundation.
        site: Site,
    },
    /// Springs without coupling at a base under water.
    #[error(
        "the base is under water and its lateral and rocking springs have no coupling; the springs of the head of a pile are coupled, \
         and without the coupling the frequencies are too high: give the coupling, which is negative; a footing has none"
    )]
    NoCoupling {
        /// The key of the coupling.
        site: Site,
    },
    /// A tower that is under water.
    #[error(
        "{}the water level {} m is above the tower top at {} m; all heights use the datum of the stations, in m",
        .site.before(), Plain(*.level_m), Plain(*.top_m)
    )]
    UnderWater {
        /// The water.
        site: Site,
        /// Height of the surface, m.
        level_m: f64,
        /// Height of the tower's top, m.
        top_m: f64,
    },
    /// Soil too stiff for the segments.
    #[error(
        "the Winkler decay length of the soil, {} m, is smaller than the segment length there, {} m: the error estimate does not cover this; use more segments",
        Rounded(*.penetration_m), Rounded(*.segment_m)
    )]
    SoilUnresolved {
        /// How far motions reach into the soil, m.
        penetration_m: f64,
        /// Length that the segments resolve there, m.
        segment_m: f64,
    },
    /// Soil around a tower with a clamped base.
    #[error(
        "the base is clamped although soil springs are given; for a pile in soil give [foundation] with type = \"springs\" for the pile tip"
    )]
    SoilAndClamp,
    /// The springs of PISA on a pile without shear deformation.
    #[error(
        "the springs of PISA belong to a pile with shear deformation, which this tower does not have: the tower is too stiff; set shear = true, \
         or give the shear stiffness in the table of properties"
    )]
    PisaWithoutShear {
        /// The model of the layer.
        site: Site,
    },
    /// Piles of a frame that are so close that they soften each other.
    #[error(
        "the piles of members {first} and {second} are {} diameters apart, less than {}: each pile softens the soil of the other (group effect); the model neglects this, so the frequencies are too high; reduce factor in [ground]",
        Plain(rounded(*.diameters)), Plain(*.least)
    )]
    PileGroup {
        /// The ground.
        site: Site,
        /// Name of the uppermost member of one pile.
        first: String,
        /// The same of the other.
        second: String,
        /// Distance of their axes at the surface over the larger diameter.
        diameters: f64,
        /// Closer piles are a group.
        least: f64,
    },
    /// A pile of a frame that hardly reaches into the ground.
    #[error(
        "the pile of member {member} reaches {} m into the ground, less than its diameter of {} m; piles of jackets reach down by ten diameters and more: check the heights of its joints and the surface of the ground",
        Rounded(*.length_m), Plain(*.diameter_m)
    )]
    ShortPile {
        /// The ground.
        site: Site,
        /// Name of the uppermost member of the pile.
        member: String,
        /// Its length below the surface, m.
        length_m: f64,
        /// Its diameter there, m.
        diameter_m: f64,
    },
    /// A member of a frame in the ground that has no springs.
    #[error(
        "member {member} is below the surface of the ground, but has no springs of the soil: {why}"
    )]
    NoSpringsOfSoil {
        /// The ground.
        site: Site,
        /// Name of the member.
        member: String,
        /// Why it is no pile.
        why: &'static str,
    },
    /// A joint of a pile just above or below the surface of the ground.
    #[error(
        "joint {joint} is at {} m, close to the surface of the ground at {} m; give it the same height if it is at the surface",
        Apart(*.height_m, *.surface_m), Apart(*.surface_m, *.height_m)
    )]
    JointNearSurface {
        /// The ground.
        site: Site,
        /// Name of the joint.
        joint: String,
        /// Height of the joint, m.
        height_m: f64,
        /// Height of the surface before scour, m.
        surface_m: f64,
    },
    /// Water whose bed is not at the surface of the ground.
    #[error(
        "{}the bed of the water is at {} m, but the surface of the ground at {} m; omit bed: it follows from the surface and its scour",
        .site.before(), Plain(*.bed_m), Plain(*.surface_m)
    )]
    BedOffSurface {
        /// The bed.
        site: Site,
        /// Height of the bed, m.
        bed_m: f64,
        /// Height of the surface before scour, m.
        surface_m: f64,
    },
    /// Soil above the water table with water over it.
    #[error(
        "{}the soil is above the water table (submerged = false), but the water level at {} m is above the surface of the ground at {} m",
        .site.before(), Plain(*.level_m), Plain(*.surface_m)
    )]
    DryUnderWater {
        /// Where the soil is said to be dry.
        site: Site,
        /// Height of the water's surface, m.
        level_m: f64,
        /// Height of the ground's surface before scour, m.
        surface_m: f64,
    },
    /// Scour that leaves little of the embedment of a pile.
    #[error(
        "{}scour of {} m leaves {} m of the embedded length of {} m; check the scour and the height of the tip",
        .site.before(), Plain(*.scour_m), Plain(*.left_m), Plain(*.embedded_m)
    )]
    DeepScour {
        /// The scour.
        site: Site,
        /// Its depth, m.
        scour_m: f64,
        /// The embedment without it, m.
        embedded_m: f64,
        /// What is left of it, m.
        left_m: f64,
    },
    /// Mooring lines at rest.
    #[error("{}{warning}", named(.name, .warning.item()))]
    Mooring {
        /// The part of the moorings.
        site: Site,
        /// Its name; empty if it has none.
        name: String,
        /// What is doubtful.
        #[source]
        warning: MooringWarning,
    },
    /// Members and joints of the frame under the tower.
    #[error("{warning}")]
    Frame {
        /// The part of the frame.
        site: Site,
        /// What is doubtful.
        #[source]
        warning: FrameWarning,
    },
    /// A tower that begins far above or below the joints that carry it.
    #[error(
        "the tower begins at z = {} m, {} m from the highest joint of the transition piece at z = {} m, and everything between them is rigid; all heights use one datum: check the lowest station and the joints",
        Plain(*.base_m), Plain((.base_m - .joints_m).abs()), Plain(*.joints_m)
    )]
    HighTransition {
        /// The transition piece.
        site: Site,
        /// Where the tower begins, m.
        base_m: f64,
        /// Height of the highest joint of the transition piece, m.
        joints_m: f64,
    },
    /// A tower beside the joints that carry it.
    #[error(
        "the axis of the tower is {} m beside the middle of the joints that carry it; check the reference point of the transition piece and the positions of these joints",
        Rounded(*.beside_m)
    )]
    TowerBesideJoints {
        /// The transition piece.
        site: Site,
        /// The distance, m.
        beside_m: f64,
    },
    /// A transition piece whose reference point is far from the tower.
    #[error(
        "the reference point of the transition piece is at z = {} m, but the tower begins at z = {} m; the body of the transition piece is placed from this point: give the height of the lowest station",
        Plain(*.reference_m), Plain(*.base_m)
    )]
    FarReference {
        /// The transition piece.
        site: Site,
        /// Height of the reference point, m.
        reference_m: f64,
        /// Where the tower begins, m.
        base_m: f64,
    },
    /// A matrix of a floating platform was not symmetric.
    #[error(
        "the {what} is not symmetric: half the difference of opposite entries is up to {:.2} % of their size; the mean of both is used",
        100.0 * .difference
    )]
    Symmetrized {
        /// Which matrix.
        what: &'static str,
        /// Half the largest difference of opposite entries, as a fraction of their size.
        difference: f64,
    },
    /// Weights, buoyancy and mooring lines of a floating tower that are not in balance.
    #[error(
        "weight, buoyancy and the vertical force of the mooring lines leave {} N, {:.1} % of the weight: the platform does not float at its reference position; check masses, \
         ballast, displaced volume and lengths of lines (the force of moorings that are given as a matrix belongs to the buoyancy)",
        Rounded(*.residual_n), 100.0 * .share
    )]
    OutOfBalance {
        /// The key of the buoyancy.
        site: Site,
        /// The upward force that is left, N.
        residual_n: f64,
        /// The same as a fraction of the weight.
        share: f64,
    },
    /// A rigid platform that is not the members of the frame that floats.
    #[error(
        "[foundation] describes a floating platform of {} t with its centre at {}, but the members of the substructure have {} t and their centre at {}: mass and center are those of the members with growth and filling, without the tower and the transition piece",
        Rounded(.mass_kg / 1e3), Center(*.center_m), Rounded(.members_kg / 1e3), Center(*.members_m)
    )]
    OtherMembers {
        /// The mass or the centre.
        site: Site,
        /// Mass of the platform, kg.
        mass_kg: f64,
        /// Its centre, m.
        center_m: [f64; 3],
        /// Mass of the members, kg.
        members_kg: f64,
        /// Their centre, m.
        members_m: [f64; 3],
    },
    /// Mooring lines in another water than the tower or its members.
    #[error(
        "the mooring lines are in water of {} kg/m3, and {what} in water of {} kg/m3; give both the density of the same water",
        Plain(*.lines_kg_per_m3), Plain(*.others_kg_per_m3)
    )]
    OtherWater {
        /// The moorings.
        site: Site,
        /// What is in the other water, with its verb.
        what: &'static str,
        /// Density of the water around the lines, kg/m³.
        lines_kg_per_m3: f64,
        /// Density of the water around the tower or its members, kg/m³.
        others_kg_per_m3: f64,
    },
    /// Weights, buoyancy and mooring lines of a floating tower that push it aside or tilt it.
    #[error(
        "weights, buoyancy and mooring lines leave {} N horizontally and a moment of {} N m at the reference position, so the platform drifts or tilts from there; \
         check that no mooring line is missing, and the horizontal positions of masses, buoyancy and fairleads",
        Rounded(*.force_n), Rounded(*.moment_n_m)
    )]
    PushedAside {
        /// The key of the buoyancy.
        site: Site,
        /// The horizontal force that is left, N.
        force_n: f64,
        /// The moment about horizontal axes that is left, N m.
        moment_n_m: f64,
    },
    /// Principal moments of inertia that no mass distribution has.
    #[error(
        "{}a principal moment of inertia ({} kg m2) exceeds the sum of the other two ({} kg m2): this is physically impossible",
        .site.before(), Rounded(*.largest_kg_m2), Rounded(*.others_kg_m2)
    )]
    TriangleInequality {
        /// The body.
        site: Site,
        /// The largest moment, kg m².
        largest_kg_m2: f64,
        /// The sum of the other two, kg m².
        others_kg_m2: f64,
    },
    /// The lowest frequency is not that of a tower.
    #[error(
        "the lowest frequency, {frequency_hz:.4e} Hz, is outside the usual range of towers, 0.01 to 100 Hz; check the units"
    )]
    UnusualFrequency {
        /// The lowest frequency, Hz.
        frequency_hz: f64,
    },
    /// The list of modes ends between two modes of equal frequency.
    #[error(
        "{label} at {:.6} Hz has the same frequency as the last listed mode and is not listed; request one more mode to list the pair",
        Plain(*.frequency_hz)
    )]
    CutPair {
        /// The label of the mode that was left out.
        label: String,
        /// Its frequency, Hz.
        frequency_hz: f64,
    },
    /// More segments than requested are needed, one for each piece of the tower.
    #[error(
        "{used} segments are used instead of {asked}: each part of the tower between steps, changes of taper and point masses needs at least one"
    )]
    MoreSegments {
        /// Asked for.
        asked: usize,
        /// Used.
        used: usize,
    },
    /// The number of modes below the end of the list is different on another mesh, or for the
    /// extrapolated frequencies.
    #[error(
        "the list of modes may change with more segments: the errors are larger than the gap at its upper end, {} Hz",
        end_of_range(*.below_hz, *.last_hz, 4)
    )]
    UncertainEnd {
        /// The frequency of the last mode, Hz.
        last_hz: f64,
        /// Where the list was certified to end, Hz.
        below_hz: f64,
    },
    /// Added mass that decreases with frequency so fast that the count of modes proves nothing.
    #[error(
        "the list of modes is proved complete only outside {:.4} to {:.4} Hz: in that range the added mass decreases so fast with frequency that a mode may appear again, which is not listed",
        Plain(*.from_hz), Plain(*.to_hz)
    )]
    UncertainAddedMass {
        /// Where the interval begins, Hz.
        from_hz: f64,
        /// Where it ends, Hz.
        to_hz: f64,
    },
    /// Modes of the reference solution that a method does not have.
    #[error(
        "{} with {segments} segments has no mode that corresponds to {missing} of the reference modes below {} Hz; use more segments, or the method does not model the effect that causes the mode",
        .method.name(), Rounded(*.below_hz)
    )]
    NotFound {
        /// The method.
        method: Method,
        /// Number of segments or elements.
        segments: usize,
        /// How many of the modes.
        missing: usize,
        /// How high was looked, Hz.
        below_hz: f64,
    },
    /// A tower with shear deformation, solved by a method without it.
    #[error(
        "the method bmodes neglects shear deformation, so the frequencies are too high; use another method"
    )]
    ShearLeftOut,
    /// Gravity near the buckling load.
    #[error(
        "the tower is close to buckling: it buckles if gravity increases by {} % (buckling load factor 1 + {:.1e}); near buckling the lowest \
         frequencies go to zero and depend strongly on the input",
        significant(100.0 * (.load_factor - 1.0)), .load_factor - 1.0
    )]
    VergeOfBuckling {
        /// The buckling load factor, little above 1.
        load_factor: f64,
    },
    /// Elements of a BModes deck that extend over several rows of the tower.
    #[error(
        "the element from z = {} to {} m extends over several rows of the tower; the {quantity} of these rows differs by up to {:.0} % from \
         the value at the middle of the element, which is used; the error estimates include this; add element boundaries at the rows or use \
         another method",
        significant(*.base_m), significant(*.top_m), 100.0 * .change
    )]
    RowsMissed {
        /// The quantity that differs most within an element.
        quantity: &'static str,
        /// Lower end of the element, m.
        base_m: f64,
        /// Upper end of the element, m.
        top_m: f64,
        /// Difference from its value at the middle of the element, as a fraction of the larger.
        change: f64,
    },
    /// Modes whose frequencies do not converge at the order of the method.
    #[error(
        "{} not resolved: the frequency does not yet converge at the order of the method (error up to {:.1} %); use more segments or the \
         method spectral",
        Modes(*.number, *.others),
        100.0 * .worst
    )]
    Irregular {
        /// The number of the first of them in the list.
        number: usize,
        /// How many more there are.
        others: usize,
        /// The largest of their errors over their frequencies.
        worst: f64,
    },
    /// Modes that the segments do not resolve.
    #[error(
        "{} not resolved (error up to {:.0} %); use more segments; for the method spectral, a higher degree",
        Modes(*.number, *.others),
        100.0 * .worst
    )]
    Unresolved {
        /// The number of the first of them in the list.
        number: usize,
        /// How many more there are.
        others: usize,
        /// The largest of their errors over their frequencies.
        worst: f64,
    },
    /// Parts of the structure are in the source of the description and not in the tower.
    #[error(
        "{0}: the frequencies are those of the structure without the missing parts and do not allow a statement about resonance"
    )]
    PartsMissing(MissingParts),
    /// Fewer modes than requested are above the rounding error.
    #[error(
        "only the lowest {listed} of the {wanted} requested modes are listed: the higher ones cannot be resolved in double precision; \
         check whether the tower has almost no mass"
    )]
    OnlyCertain {
        /// How many modes are listed.
        listed: usize,
        /// Number of requested modes.
        wanted: usize,
    },
}

/// "mode 3 is", or "5 modes (the first is mode 3) are": the number of the first mode in the list
/// and how many others there are.
struct Modes(usize, usize);

impl fmt::Display for Modes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self(number, 0) => write!(f, "mode {number} is"),
            Self(number, others) => {
                write!(f, "{} modes (the first is mode {number}) are", others + 1)
            }
        }
    }
}

impl Warning {
    /// The site of the value that the warning is about; none if the warning is about the result.
    pub fn site(&self) -> Option<&Site> {
        match self {
            Self::LargeDiameter { site, .. }
            | Self::TallTower { site, .. }
            | Self::UselessStation { site }
            | Self::UselessMaterial { site }
            | Self::HeavyRna { site, .. }
            | Self::UnusualWall { site, .. }
            | Self::Unusual { site, .. }
            | Self::RowOutOfLine { site, .. }
            | Self::NoEffect { site, .. }
            | Self::RnaWithoutInertia { site, .. }
            | Self::InertiaWithoutMass { site }
            | Self::CouplingSigns { site, .. }
            | Self::CouplingAlongAxis { site, .. }
            | Self::ActsAbove { site, .. }
            | Self::BetweenRigidAndFlexible { site, .. }
            | Self::OutsideFormula { site, .. }
            | Self::SoilTwice { site }
            | Self::PisaWithoutShear { site }
            | Self::PileGroup { site, .. }
            | Self::ShortPile { site, .. }
            | Self::NoSpringsOfSoil { site, .. }
            | Self::JointNearSurface { site, .. }
            | Self::NoCoupling { site }
            | Self::UnderWater { site, .. }
            | Self::BedOffSurface { site, .. }
            | Self::DryUnderWater { site, .. }
            | Self::DeepScour { site, .. }
            | Self::OutOfBalance { site, .. }
            | Self::PushedAside { site, .. }
            | Self::OtherMembers { site, .. }
            | Self::OtherWater { site, .. }
            | Self::Mooring { site, .. }
            | Self::Frame { site, .. }
            | Self::HighTransition { site, .. }
            | Self::TowerBesideJoints { site, .. }
            | Self::FarReference { site, .. }
            | Self::TriangleInequality { site, .. } => Some(site),
            Self::SoilUnresolved { .. }
            | Self::SoilAndClamp
            | Self::Symmetrized { .. }
            | Self::PartsMissing(_)
            | Self::UnusualFrequency { .. }
            | Self::CutPair { .. }
            | Self::MoreSegments { .. }
            | Self::UncertainEnd { .. }
            | Self::UncertainAddedMass { .. }
            | Self::NotFound { .. }
            | Self::ShearLeftOut
            | Self::VergeOfBuckling { .. }
            | Self::RowsMissed { .. }
            | Self::Irregular { .. }
            | Self::Unresolved { .. }
            | Self::OnlyCertain { .. } => None,
        }
    }

    /// The parts that the tower lacks, if the warning is about them.
    pub fn missing_parts(&self) -> Option<&MissingParts> {
        match self {
            Self::PartsMissing(missing) => Some(missing),
            _ => None,
        }
    }

    /// The place of this value in the description.
    pub fn place(&self) -> Option<Place> {
        self.site().and_then(|site| site.place)
    }
}

/// "at least 1 m", "at most 20 m", "1 to 20 m".
struct Range(f64, f64, &'static str);

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Self(least, most, unit) = self;
        let [low, high] = [least, most].map(|limit| Plain(rounded(limit)));
        match (least.is_finite(), most.is_finite()) {
            (true, true) if low == high => write!(f, "about {low}{unit}"),
            (true, true) => write!(f, "{low} to {high}{unit}"),
            (true, false) => write!(f, "at least {low}{unit}"),
            _ => write!(f, "at most {high}{unit}"),
        }
    }
}

/// A point as `[x, y, z] m`.
struct Center([f64; 3]);

impl std::fmt::Display for Center {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [x, y, z] = self.0;
        write!(f, "[{x:.2}, {y:.2}, {z:.2}] m")
    }
}

/// "`north`: ", unless the name is the default name of the part.
fn named(name: &str, item: MooringItem) -> String {
    match name.is_empty() || name == item.to_string() {
        true => String::new(),
        false => format!("`{name}`: "),
    }
}

/// Rounded to three digits, because a limit is not a measured value.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}
