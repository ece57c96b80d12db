//! Warnings: possible values of a mooring system that are probably mistakes.

use thiserror::Error;

use super::error::MooringItem;
use crate::number::{Plain, Rounded};

/// A probable mistake that the user should check, with its numbers. Indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MooringWarning {
    /// A density that no water has.
    #[error(
        "the density of the water around the lines is {} kg/m3; sea water has 1025, fresh water 1000 kg/m3",
        Plain(*.density_kg_per_m3)
    )]
    Density {
        /// The density, kg/m³.
        density_kg_per_m3: f64,
    },
    /// A depth that is not that of the anchors.
    #[error(
        "all anchors are at z = {} m, but the depth is {} m: the seabed under the lines is taken at the anchors; make the depth {} m, or correct the anchors",
        Plain(-*.anchors_m), Plain(*.depth_m), Plain(*.anchors_m)
    )]
    OtherDepth {
        /// The given depth, m.
        depth_m: f64,
        /// The depth of the anchors, m.
        anchors_m: f64,
    },
    /// An axial stiffness in another unit, as its lines are stretched beyond all materials.
    #[error(
        "line type {} has an axial stiffness EA of {} N, and the {} N in its lines stretch them by {} %; EA is in N: a value in kN is multiplied by 1e3, one in MN by 1e6",
        .line_type + 1, Plain(*.axial_stiffness_n), Rounded(*.tension_n), Rounded(100.0 * .tension_n / .axial_stiffness_n)
    )]
    Soft {
        /// The type of lines.
        line_type: usize,
        /// Axial stiffness EA, N.
        axial_stiffness_n: f64,
        /// The largest tension of its lines, N.
        tension_n: f64,
    },
    /// An axial stiffness that no material has.
    #[error(
        "line type {} has an axial stiffness EA of {} N on a diameter of {} m: that is a modulus of {} GPa, and steel has 210 GPa; give EA in N and the diameter in m",
        .line_type + 1, Plain(*.axial_stiffness_n), Plain(*.diameter_m), Rounded(1e-9 * .modulus_pa)
    )]
    Stiff {
        /// The type of lines.
        line_type: usize,
        /// Axial stiffness EA, N.
        axial_stiffness_n: f64,
        /// Diameter of the displaced cylinder, m.
        diameter_m: f64,
        /// Stiffness by the area of this cylinder, Pa.
        modulus_pa: f64,
    },
    /// An anchor above the seabed.
    #[error(
        "the anchor point {} is at z = {} m, {} m above the seabed; its lines hang from it as from a pole. If it is on the seabed, the depth must be {} m instead of {} m",
        .point + 1, Plain(*.z_m), Plain(z_m + depth_m), Plain(-*.z_m), Plain(*.depth_m)
    )]
    AnchorAboveSeabed {
        /// The point.
        point: usize,
        /// Its height, m.
        z_m: f64,
        /// Depth of the seabed below still water, m.
        depth_m: f64,
    },
    /// An anchor above still water.
    #[error(
        "the anchor point {} is at z = {} m, above still water; z is the height above still water, so that a point on the seabed has z = {} m",
        .point + 1, Plain(*.z_m), Plain(-*.depth_m)
    )]
    AnchorAboveWater {
        /// The point.
        point: usize,
        /// Its height, m.
        z_m: f64,
        /// Depth of the seabed below still water, m.
        depth_m: f64,
    },
    /// A point without lines.
    #[error("no line ends at point {}, which has no effect; check that no line is missing", .point + 1)]
    WithoutLine {
        /// The point.
        point: usize,
    },
    /// A line that floats, as all others.
    #[error(
        "line type {} has a mass of {} kg/m and displaces {} kg/m of water with its diameter of {} m, so that it floats; give the mass in air in kg/m and the diameter in m",
        .line_type + 1, Plain(*.mass_kg_per_m), Rounded(*.water_kg_per_m), Plain(*.diameter_m)
    )]
    Floats {
        /// The type of lines.
        line_type: usize,
        /// Mass per length in air, kg/m.
        mass_kg_per_m: f64,
        /// Mass of the displaced water per length, kg/m.
        water_kg_per_m: f64,
        /// Diameter of the displaced cylinder, m.
        diameter_m: f64,
    },
    /// A line that is stretched far.
    #[error(
        "line {} is stretched by {:.1} %: its tension is {} N and its axial stiffness EA {} N; chains and steel ropes at rest are stretched by 0.1 %, polyester by 1 %; check its length, and that EA is in N",
        .line + 1, 100.0 * .tension_n / .axial_stiffness_n, Rounded(*.tension_n), Plain(*.axial_stiffness_n)
    )]
    Stretched {
        /// The line.
        line: usize,
        /// The larger tension of its ends, N.
        tension_n: f64,
        /// Axial stiffness EA, N.
        axial_stiffness_n: f64,
    },
    /// A line with both ends on the platform.
    #[error(
        "both ends of line {} are on the platform, so the line has no effect; attach one end to an anchor",
        .line + 1
    )]
    BothOnPlatform {
        /// The line.
        line: usize,
    },
    /// A line without horizontal tension.
    #[error(
        "line {} is slack: its length of {} m exceeds the path along the seabed and up to its end, so the line does not hold the platform; shorten it, or correct the \
         positions of its ends",
        .line + 1, Plain(*.length_m)
    )]
    Slack {
        /// The line.
        line: usize,
        /// Its length without tension, m.
        length_m: f64,
    },
    /// A line that leaves the water.
    #[error(
        "line {} reaches up to z = {} m, above still water; its buoyancy is that of a line under water over its whole length",
        .line + 1, Plain(*.z_m)
    )]
    AboveWater {
        /// The line.
        line: usize,
        /// Its greatest height, m.
        z_m: f64,
    },
}

impl MooringWarning {
    /// The part that the warning concerns.
    pub fn item(&self) -> MooringItem {
        match *self {
            Self::AnchorAboveSeabed { point, .. }
            | Self::AnchorAboveWater { point, .. }
            | Self::WithoutLine { point } => MooringItem::Point(point),
            Self::Density { .. } | Self::OtherDepth { .. } => MooringItem::Site,
            Self::Floats { line_type, .. }
            | Self::Soft { line_type, .. }
            | Self::Stiff { line_type, .. } => MooringItem::LineType(line_type),
            Self::Slack { line, .. }
            | Self::Stretched { line, .. }
            | Self::BothOnPlatform { line }
            | Self::AboveWater { line, .. } => MooringItem::Line(line),
        }
    }
}
