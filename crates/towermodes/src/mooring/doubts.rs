//! Finds the values of a mooring system that are possible but probably mistakes.

use super::description::{Attachment, Carrier, MooringDescription, MooringLine, MooringPoint};
use super::state::{LineState, MooringState};
use super::system::Mooring;
use super::warning::MooringWarning;

/// An anchor above the seabed by more than this fraction of the depth is not on the seabed.
const ROUNDED: f64 = 1e-6;
/// Lines that are stretched by more are too short or too soft: chains and steel ropes at rest are
/// stretched by 0.1 %, ropes of polyester by 1 %.
const STRETCH: f64 = 0.02;

/// If a line is stretched by more than this fraction, EA is given in another unit: no mooring line
/// is stretched so much.
const OTHER_UNIT: f64 = 0.5;
/// An upper limit of the modulus of all materials, Pa.
const STIFFEST_PA: f64 = 1e13;
/// Densities of the water of lakes and seas, kg/m³.
const WATER_KG_PER_M3: std::ops::RangeInclusive<f64> = 900.0..=1100.0;

impl Mooring {
    /// Probable mistakes in this mooring system, in a given state.
    pub fn warnings(&self, state: &MooringState) -> Vec<MooringWarning> {
        let mooring = &self.description;
        let mut warnings: Vec<MooringWarning> = self.site().collect();
        warnings.extend(floating(mooring));
        let types = 0..mooring.line_types.len();
        let soft: Vec<_> = types.map(|of| soft(mooring, of, state)).collect();
        for (line_type, soft) in soft.iter().enumerate() {
            warnings.extend(stiff(mooring, line_type).or(*soft));
        }
        warnings.extend(anchors(mooring));
        warnings.extend(without_line(mooring));
        for (line, (given, found)) in mooring.lines.iter().zip(&state.lines).enumerate() {
            // Otherwise the line is stretched or slack because its type is too soft.
            if soft[given.line_type].is_none() {
                warnings.extend(stretch(mooring, line, given, found));
                warnings.extend(slack(mooring, line, given, found));
            }
            warnings.extend(of_line(mooring, line, given, found, state));
        }
        warnings
    }

    /// Depth and density.
    fn site(&self) -> impl Iterator<Item = MooringWarning> {
        let (depth_m, anchors_m) = (self.given_depth_m, self.description.depth_m);
        let density_kg_per_m3 = self.description.water_density_kg_per_m3;
        let is_usual = WATER_KG_PER_M3.contains(&density_kg_per_m3);
        let density = (!is_usual).then_some(MooringWarning::Density { density_kg_per_m3 });
        let depth =
            (depth_m != anchors_m).then_some(MooringWarning::OtherDepth { depth_m, anchors_m });
        density.into_iter().chain(depth)
    }
}

/// The largest tension in lines of a type, N.
fn largest_tension_n(mooring: &MooringDescription, line_type: usize, state: &MooringState) -> f64 {
    let lines = mooring.lines.iter().zip(&state.lines);
    let own = lines.filter(|(given, _)| given.line_type == line_type);
    let tensions_n = own.flat_map(|(_, found)| found.tensions_n);
    tensions_n.fold(0.0, f64::max)
}

/// A type of lines with a larger strain than any material allows.
fn soft(
    mooring: &MooringDescription,
    line_type: usize,
    state: &MooringState,
) -> Option<MooringWarning> {
    let tension_n = largest_tension_n(mooring, line_type, state);
    let axial_stiffness_n = mooring.line_types[line_type].axial_stiffness_n;
    (tension_n > OTHER_UNIT * axial_stiffness_n).then_some(MooringWarning::Soft {
        line_type,
        axial_stiffness_n,
        tension_n,
    })
}

/// A type of lines that is stiffer than all materials.
fn stiff(mooring: &MooringDescription, line_type: usize) -> Option<MooringWarning> {
    let kind = &mooring.line_types[line_type];
    let (axial_stiffness_n, diameter_m) = (kind.axial_stiffness_n, kind.diameter_m);
    let area_m2 = kind.area_m2();
    let modulus_pa = axial_stiffness_n / area_m2;
    // Without a diameter nothing is known about the material.
    (area_m2 > 0.0 && modulus_pa > STIFFEST_PA).then_some(MooringWarning::Stiff {
        line_type,
        axial_stiffness_n,
        diameter_m,
        modulus_pa,
    })
}

/// Types of lines that are lighter than the displaced water, if all types are: otherwise heavier
/// lines may hold them.
fn floating(mooring: &MooringDescription) -> Vec<MooringWarning> {
    let density_kg_per_m3 = mooring.water_density_kg_per_m3;
    let types = || mooring.line_types.iter();
    if !types().all(|kind| kind.floats_in(density_kg_per_m3)) {
        return Vec::new();
    }
    let found = types()
        .enumerate()
        .map(|(line_type, kind)| MooringWarning::Floats {
            line_type,
            mass_kg_per_m: kind.mass_kg_per_m,
            water_kg_per_m: density_kg_per_m3 * kind.area_m2(),
            diameter_m: kind.diameter_m,
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

/// Points without lines, weight and buoyancy.
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

/// A line that does not end at the platform and has no horizontal tension.
fn slack(
    mooring: &MooringDescription,
    line: usize,
    given: &MooringLine,
    found: &LineState,
) -> Option<MooringWarning> {
    let length_m = given.length_m;
    (found.is_slack && !is_on_platform_alone(mooring, given))
        .then_some(MooringWarning::Slack { line, length_m })
}

/// Warnings about the ends of a line and its highest point.
fn of_line(
    mooring: &MooringDescription,
    line: usize,
    given: &MooringLine,
    found: &LineState,
    state: &MooringState,
) -> Vec<MooringWarning> {
    let mut warnings = Vec::new();
    if is_on_platform_alone(mooring, given) {
        warnings.push(MooringWarning::BothOnPlatform { line });
    }
    let ends_m = given.points.map(|point| state.points_m[point][2]);
    let z_m = ends_m[0].max(ends_m[1]).max(found.extreme_z_m);
    if z_m > 0.0 {
        warnings.push(MooringWarning::AboveWater { line, z_m });
    }
    warnings
}

/// Whether both ends of a line are on the platform.
fn is_on_platform_alone(mooring: &MooringDescription, line: &MooringLine) -> bool {
    let mut points = line.points.iter();
    points.all(|point| is_on_platform(mooring, *point))
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
