//! Results and inputs that are possible but look like a slip.

use std::fmt;

/// Something a user should look at; the computation goes on.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// A diameter over 30 m.
    LargeDiameter {
        /// The diameter, m.
        outer_diameter_m: f64,
        /// Where, m.
        height_m: f64,
    },
    /// A tower over 1 km.
    TallTower {
        /// Base to top, m.
        height_m: f64,
    },
    /// A wall outside 1/500 to 1/10 of the diameter.
    UnusualWall {
        /// Wall thickness, m.
        wall_thickness_m: f64,
        /// Outer diameter, m.
        outer_diameter_m: f64,
        /// Where, m.
        height_m: f64,
    },
    /// A row below a step at the base, or above a step at the top, has no length.
    UselessStation {
        /// Its height, m.
        height_m: f64,
    },
    /// A rotor-nacelle assembly heavier than five towers.
    HeavyRna {
        /// Mass of the assembly, kg.
        rna_kg: f64,
        /// Mass of the tower, kg.
        tower_kg: f64,
    },
    /// Principal moments of inertia that no mass distribution has.
    TriangleInequality {
        /// The largest moment, kg m².
        largest_kg_m2: f64,
        /// The sum of the other two, kg m².
        others_kg_m2: f64,
    },
    /// The lowest frequency is not that of a tower.
    UnusualFrequency {
        /// The lowest frequency, Hz.
        frequency_hz: f64,
    },
    /// The number of modes asked for cuts a repeated pair.
    CutPair {
        /// The label of the mode that was left out.
        label: String,
        /// Its frequency, Hz.
        frequency_hz: f64,
    },
    /// More segments were needed than asked for, one for each piece of the tower.
    MoreSegments {
        /// Asked for.
        asked: usize,
        /// Used.
        used: usize,
    },
    /// A mode that the segments do not resolve.
    Unresolved {
        /// Its number in the list.
        number: usize,
        /// Estimated discretization error over frequency.
        relative_error: f64,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LargeDiameter {
                outer_diameter_m,
                height_m,
            } => write!(
                f,
                "outer diameter {outer_diameter_m} m at z = {height_m} m is over 30 m; lengths are in metres, not millimetres"
            ),
            Self::TallTower { height_m } => write!(
                f,
                "the tower is {height_m} m tall, over 1 km; lengths are in metres, not millimetres"
            ),
            Self::UnusualWall {
                wall_thickness_m: t,
                outer_diameter_m: d,
                height_m,
            } => write!(
                f,
                "wall {t} m at z = {height_m} m is 1/{:.0} of the diameter {d} m; tubular towers have 1/500 to 1/10",
                d / t
            ),
            Self::UselessStation { height_m } => write!(
                f,
                "the end row at z = {height_m} m has no length beyond the step there and changes nothing"
            ),
            Self::HeavyRna { rna_kg, tower_kg } => write!(
                f,
                "the rotor-nacelle assembly ({rna_kg} kg) is heavier than five towers (one is {tower_kg:.0} kg)"
            ),
            Self::TriangleInequality {
                largest_kg_m2,
                others_kg_m2,
            } => write!(
                f,
                "a moment of inertia of the rotor-nacelle assembly ({largest_kg_m2:e} kg m2) exceeds the sum of the other two \
                 ({others_kg_m2:e} kg m2), which no mass distribution has"
            ),
            Self::UnusualFrequency { frequency_hz } => write!(
                f,
                "the lowest frequency, {frequency_hz:.4e} Hz, is outside 0.01 to 100 Hz, where towers are; check the units"
            ),
            Self::CutPair {
                label,
                frequency_hz,
            } => write!(
                f,
                "{label} at {frequency_hz:.6} Hz equals the last mode and was cut off; ask for one mode more to see the pair"
            ),
            Self::MoreSegments { asked, used } => write!(
                f,
                "{used} segments are used, not {asked}: each linear piece of the tower needs at least one"
            ),
            Self::Unresolved {
                number,
                relative_error,
            } => write!(
                f,
                "mode {number} is not resolved (error about {:.0} %); use more segments",
                100.0 * relative_error
            ),
        }
    }
}
