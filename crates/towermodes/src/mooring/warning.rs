//! Warnings: possible values of a mooring system that are probably mistakes.

use thiserror::Error;

use super::description::{Attachment, Carrier, MooringDescription, MooringLine, MooringPoint};
use super::error::MooringItem;
use super::state::{LineState, MooringState};
use super::system::Mooring;
use crate::number::{Plain, Rounded};

/// Anchors higher than this fraction of the depth are above the seabed.
const ROUNDED: f64 = 1e-6;
/// Lines that are stretched by more are too short or too soft: chains and steel ropes at rest are
/// stretched by 0.1 %, ropes of polyester by 1 %.
const STRETCH: f64 = 0.02;

/// A probable mistake that the user should check, with its numbers. Indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MooringWarning {
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
    /// A line that floats.
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
            Self::Floats { line_type, .. } => MooringItem::LineType(line_type),
            Self::Slack { line, .. }
            | Self::Stretched { line, .. }
            | Self::BothOnPlatform { line }
            | Self::AboveWater { line, .. } => MooringItem::Line(line),
        }
    }
}

impl Mooring {
    /// Probable mistakes in this mooring system at a given state.
    pub fn warnings(&self, state: &MooringState) -> Vec<MooringWarning> {
        let mooring = &self.description;
        let mut warnings = floating(mooring);
        warnings.extend(anchors(mooring));
        warnings.extend(without_line(mooring));
        for (line, (given, found)) in mooring.lines.iter().zip(&state.lines).enumerate() {
            warnings.extend(stretch(mooring, line, given, found));
            warnings.extend(of_line(mooring, line, given, found, state));
        }
        warnings
    }
}

/// Types of lines that are lighter than the water that they displace.
fn floating(mooring: &MooringDescription) -> Vec<MooringWarning> {
    let types = mooring.line_types.iter().enumerate();
    let found = types.filter_map(|(line_type, kind)| {
        let area_m2 = std::f64::consts::FRAC_PI_4 * kind.diameter_m * kind.diameter_m;
        let water_kg_per_m = mooring.water_density_kg_per_m3 * area_m2;
        let floats = kind.mass_kg_per_m < water_kg_per_m;
        floats.then_some(MooringWarning::Floats {
            line_type,
            mass_kg_per_m: kind.mass_kg_per_m,
            water_kg_per_m,
            diameter_m: kind.diameter_m,
        })
    });
    found.collect()
}

/// Anchors that are not on the seabed.
fn anchors(mooring: &MooringDescription) -> Vec<MooringWarning> {
    let depth_m = mooring.depth_m;
    let points = mooring.points.iter().enumerate();
    let fixed = points.filter(|(_, point)| point.attachment == Attachment::Fixed);
    let found = fixed.filter_map(|(point, anchor)| match anchor.position_m[2] {
        z_m if z_m > 0.0 => Some(MooringWarning::AnchorAboveWater {
            point,
            z_m,
            depth_m,
        }),
        z_m => (z_m + depth_m > ROUNDED * depth_m).then_some(MooringWarning::AnchorAboveSeabed {
            point,
            z_m,
            depth_m,
        }),
    });
    found.collect()
}

/// Points that no line ends at, and that neither weigh nor float.
fn without_line(mooring: &MooringDescription) -> impl Iterator<Item = MooringWarning> {
    let is_end = |point: usize| {
        let mut lines = mooring.lines.iter();
        lines.any(|line| line.points.contains(&point))
    };
    let points = mooring.points.iter().enumerate();
    let is_idle = move |(index, point): &(usize, &MooringPoint)| {
        !is_end(*index) && point.mass_kg == 0.0 && point.volume_m3 == 0.0
    };
    let idle = points.filter(is_idle);
    idle.map(|(point, _)| MooringWarning::WithoutLine { point })
}

fn stretch(
    mooring: &MooringDescription,
    line: usize,
    given: &MooringLine,
    found: &LineState,
) -> Option<MooringWarning> {
    let tension_n = found.tensions_n[0].max(found.tensions_n[1]);
    let axial_stiffness_n = mooring.line_types[given.line_type].axial_stiffness_n;
    (tension_n > STRETCH * axial_stiffness_n).then_some(MooringWarning::Stretched {
        line,
        tension_n,
        axial_stiffness_n,
    })
}

/// What its ends and its shape say about a line.
fn of_line(
    mooring: &MooringDescription,
    line: usize,
    given: &MooringLine,
    found: &LineState,
    state: &MooringState,
) -> Vec<MooringWarning> {
    let mut warnings = Vec::new();
    if given
        .points
        .iter()
        .all(|point| is_on_platform(mooring, *point))
    {
        warnings.push(MooringWarning::BothOnPlatform { line });
    } else if found.is_slack {
        let length_m = given.length_m;
        warnings.push(MooringWarning::Slack { line, length_m });
    }
    let ends_m = given.points.map(|point| state.points_m[point][2]);
    let z_m = ends_m[0].max(ends_m[1]).max(found.extreme_z_m);
    if z_m > 0.0 {
        warnings.push(MooringWarning::AboveWater { line, z_m });
    }
    warnings
}

fn is_on_platform(mooring: &MooringDescription, point: usize) -> bool {
    let carrier = match mooring.points[point].attachment {
        Attachment::Platform => Carrier::Platform,
        Attachment::Fixed => Carrier::Fixed,
        Attachment::Free => Carrier::Free,
        Attachment::Body(body) => mooring.bodies[body].carrier,
        Attachment::Rod(rod, _) => mooring.rods[rod].carrier,
    };
    carrier == Carrier::Platform
}
