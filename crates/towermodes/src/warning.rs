//! Inputs and results that are possible but look like a slip.

use thiserror::Error;

use crate::method::Method;
use crate::number::{Plain, significant};

/// Something a user should look at; the computation goes on.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Warning {
    /// A diameter over 30 m.
    #[error(
        "outer diameter {} m at z = {} m is over 30 m; lengths are in metres, not millimetres",
        Plain(*.outer_diameter_m), Plain(*.height_m)
    )]
    LargeDiameter {
        /// The diameter, m.
        outer_diameter_m: f64,
        /// Where, m.
        height_m: f64,
    },
    /// A tower over 1 km.
    #[error("the tower is {} m tall, over 1 km; lengths are in metres, not millimetres", Plain(*.height_m))]
    TallTower {
        /// Base to top, m.
        height_m: f64,
    },
    /// A wall outside 1/500 to 1/10 of the diameter.
    #[error(
        "wall {} m at z = {} m is 1/{:.1} of the diameter {} m; tubular towers have 1/500 to 1/10",
        Plain(*.wall_thickness_m), Plain(*.height_m), .outer_diameter_m / .wall_thickness_m, Plain(*.outer_diameter_m)
    )]
    UnusualWall {
        /// Wall thickness, m.
        wall_thickness_m: f64,
        /// Outer diameter, m.
        outer_diameter_m: f64,
        /// Where, m.
        height_m: f64,
    },
    /// A value far from what towers have.
    #[error("{quantity} is {}{unit}; {usual}", Plain(*.value))]
    Unusual {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Its unit, after a space, or nothing.
        unit: &'static str,
        /// What is usual.
        usual: &'static str,
    },
    /// A row below a step at the base, or above a step at the top, has no length.
    #[error("the end row at z = {} m has no length beyond the step there and changes nothing", Plain(*.height_m))]
    UselessStation {
        /// Its height, m.
        height_m: f64,
    },
    /// The last row names another material than the row below it.
    #[error(
        "the material of the last row holds for nothing: a row's material reaches up to the next row; \
         to change it at a height, write two rows there"
    )]
    UselessMaterial,
    /// A rotor-nacelle assembly heavier than five towers.
    #[error(
        "the rotor-nacelle assembly ({} kg) is heavier than five towers (one is {} kg)",
        Plain(.rna_kg.round()), Plain(.tower_kg.round())
    )]
    HeavyRna {
        /// Mass of the assembly, kg.
        rna_kg: f64,
        /// Mass of the tower, kg.
        tower_kg: f64,
    },
    /// Couplings of translation and rotation that have one sign where they should have opposite ones.
    #[error(
        "the {what} couples x with rotation about y and y with rotation about x with the same sign ({} and {}); what is the same in both \
         planes has opposite signs",
        Plain(*.fore_aft), Plain(*.side_side)
    )]
    CouplingSigns {
        /// Which matrix.
        what: &'static str,
        /// Entry x, rotation about y.
        fore_aft: f64,
        /// Entry y, rotation about x.
        side_side: f64,
    },
    /// Soil too stiff for the segments.
    #[error(
        "soil lets motions in by {} m only, less than a segment there ({} m): errors do not show what happens between; use more segments",
        Plain(significant(*.penetration_m)), Plain(significant(*.segment_m))
    )]
    SoilUnresolved {
        /// How far motions reach into the soil, m.
        penetration_m: f64,
        /// Length that the segments resolve there, m.
        segment_m: f64,
    },
    /// Soil around a tower whose base is clamped all the same.
    #[error(
        "the base is clamped below soil: the soil holds what the clamp leaves; a pile has type = \"springs\" at its tip"
    )]
    SoilAndClamp,
    /// A matrix of a floating platform was not symmetric.
    #[error(
        "the {what} of the platform is not symmetric (entries differ by up to {:.2} %); the mean of both halves is used",
        100.0 * .difference
    )]
    Symmetrized {
        /// Which matrix.
        what: &'static str,
        /// The largest difference of two entries that should be equal, as a share of the larger.
        difference: f64,
    },
    /// Principal moments of inertia that no mass distribution has.
    #[error(
        "a principal moment of inertia of the rotor-nacelle assembly ({} kg m2) exceeds the sum of the other two \
         ({} kg m2), which no mass distribution has",
        Plain(*.largest_kg_m2), Plain(*.others_kg_m2)
    )]
    TriangleInequality {
        /// The largest moment, kg m².
        largest_kg_m2: f64,
        /// The sum of the other two, kg m².
        others_kg_m2: f64,
    },
    /// The lowest frequency is not that of a tower.
    #[error(
        "the lowest frequency, {frequency_hz:.4e} Hz, is outside 0.01 to 100 Hz, where towers are; check the units"
    )]
    UnusualFrequency {
        /// The lowest frequency, Hz.
        frequency_hz: f64,
    },
    /// The number of modes asked for cuts a repeated pair.
    #[error(
        "{label} at {:.6} Hz equals the last mode and was cut off; ask for one mode more to see the pair",
        Plain(*.frequency_hz)
    )]
    CutPair {
        /// The label of the mode that was left out.
        label: String,
        /// Its frequency, Hz.
        frequency_hz: f64,
    },
    /// More segments were needed than asked for, one for each piece of the tower.
    #[error(
        "{used} segments are used, not {asked}: each part of the tower between steps, kinks and masses needs one"
    )]
    MoreSegments {
        /// Asked for.
        asked: usize,
        /// Used.
        used: usize,
    },
    /// The number of modes below the end of the list is another on another mesh, or the extrapolated frequencies say so.
    #[error(
        "with more segments another mode may come into the list or leave it: it ends at {:.4} Hz, and errors reach beyond that",
        Plain(*.below_hz)
    )]
    UncertainEnd {
        /// Where the list was certified to end, Hz.
        below_hz: f64,
    },
    /// Modes of the measure that a method does not have near it.
    #[error(
        "{} with {segments} segments has no mode like {missing} of those compared below {} Hz, and none is looked for above; more segments may have it, or the method leaves out what makes it",
        .method.name(), Plain(significant(*.below_hz))
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
    /// A tower that shears, solved as one that does not.
    #[error(
        "BModes has no shear deformation: it is left out, and the frequencies are too high for it; other methods have it"
    )]
    ShearLeftOut,
    /// Elements that see less of the tower than there is.
    #[error(
        "BModes takes the section at the middle of each of {elements} elements, but the tower has {pieces} linear pieces; what lies \
         between is not seen, and the errors do not show it; use more elements"
    )]
    PiecesUnseen {
        /// Elements used.
        elements: usize,
        /// Linear pieces of the tower.
        pieces: usize,
    },
    /// Elements that are cut elsewhere than at a steep ramp.
    #[error(
        "the tower changes by {:.0} % within {} m at z = {} m, where BModes' elements are {} m long and no border is: the errors given may be \
         far too small; give the deck a border there, or use another method",
        100.0 * .change,
        significant(*.ramp_m),
        significant(*.height_m),
        significant(*.element_m)
    )]
    RampUnseen {
        /// The middle of the ramp, m.
        height_m: f64,
        /// The length of the ramp, m.
        ramp_m: f64,
        /// The length of the element over it, m.
        element_m: f64,
        /// How much mass or stiffness differ over it, as a share of the larger.
        change: f64,
    },
    /// Modes that the segments do not resolve.
    #[error(
        "{} not resolved (error up to {:.0} %); use more segments, or a higher degree",
        if *.others == 0 { format!("mode {number} is") } else { format!("mode {number} and {others} more are") },
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
}
