//! The natural frequencies of a whole turbine against its rotor speed, as JSON and as CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::Tower;
use towermodes::turbine::{BladeEnergy, TurbineEnergy, TurbinePart};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::ModeClass;
use towermodes_analysis::whirl::{
    AgainstRigid, Change, CoupledCampbell, CoupledCurve, CurvePoint, Meeting, NameRange,
    SolvedSpeed,
};

use super::campbell::{
    ClassJson, MarginJson, NamedJson, RotorJson, class_json, margin_json, not_checked,
};
use super::{ResultError, write_result_json};

/// The result of `towermodes campbell` for a turbine with flexible blades: curves of its natural
/// frequencies, with their proof, the distances from excitations, crossings and veerings.
///
/// Structure only: no aerodynamics, no controller, constant speeds.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct CoupledCampbellDocument<'a> {
    /// The worst verdict; at best `warn` if the list of modes does not cover all excitations, or if
    /// the turbine is unstable or not certified at an operating speed; `undecided` if nothing is
    /// checked.
    verdict: Verdict,
    /// Why nothing is checked; empty if the distances are checked.
    not_checked: Vec<String>,
    /// The tower.
    tower: NamedJson<'a>,
    /// The rotor.
    rotor: RotorJson,
    /// The required distance, as a fraction of the natural frequency.
    margin: f64,
    /// The frequency range (from, to), Hz, in which the turbine may have modes that are not in the
    /// list although an excitation comes close to them; null if the list covers all excitations.
    unjudged_hz: Option<[f64; 2]>,
    /// The multiples of the rotor speed.
    multiples: &'a [usize],
    /// The frequency up to which all modes are listed, Hz.
    limit_hz: f64,
    /// Whether eigenvalue counts prove at every speed that no mode below the limit is missing and
    /// that no mode is unstable.
    is_certified: bool,
    /// The rotor speeds at which the turbine was solved, in increasing order, with their
    /// certificates.
    speeds: Vec<SpeedJson>,
    /// The curves: tower and drivetrain by mean frequency, then the blades.
    curves: Vec<CurveJson>,
    /// The distance of every name from every multiple; `line` is the index of the curve that has
    /// the name at the nearest speed.
    margins: Vec<MarginJson<'a>>,
    /// The stiffness class of the first fore-aft and of the first side-side bending mode.
    classes: Vec<ClassJson>,
    /// Crossings and veerings of the curves, by rotor speed.
    meetings: Vec<MeetingJson>,
    /// The modes of the tower with a rigid rotor-nacelle assembly, and the coupled modes of the
    /// same names.
    against_rigid: Vec<AgainstRigidJson>,
    /// Assumptions of the reader, data that it omits, and possible input mistakes.
    warnings: Vec<String>,
}

/// A rotor speed.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct SpeedJson {
    /// Rotor speed, rpm.
    rotor_speed_rpm: f64,
    /// Whether it was added to follow curves that come close to each other.
    is_added: bool,
    /// Whether eigenvalue counts prove that no mode below the limit is missing and that no mode is
    /// unstable.
    is_complete: bool,
    /// Number of modes of negative energy if no mode is unstable; they may lie above the limit.
    negative_energy_expected: usize,
    /// Number of modes of negative energy that were found.
    negative_energy_found: usize,
    /// Intervals of frequency, Hz, in which counts do not exclude two more modes, one of positive
    /// and one of negative energy. There are none if the list is complete.
    unproven_hz: Vec<[f64; 2]>,
    /// Lowest number of unstable modes, whose amplitude grows without limit; 0 if there is none, or
    /// if this is not known.
    growing: usize,
    /// Number of motions slower than 1e-5 rad/s (1.6e-6 Hz), without the rotation of a free shaft;
    /// they are not among the modes.
    unresisted: usize,
}

/// A mode followed over the rotor speed by its shape.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct CurveJson {
    /// Its title: the name that it has over most of the operating speeds, with rotor speeds if
    /// another curve has this name over a larger range. The names at each speed are those of its
    /// points.
    label: String,
    /// The part of this name: `tower fore-aft`, `drivetrain torsion`, `flapwise backward whirl` …
    part: String,
    /// The order of this mode among the modes with this part, from 1.
    order: usize,
    /// Its names by increasing rotor speed.
    names: Vec<NameRangeJson>,
    /// For a backward whirl the index of the curve of the forward whirl, and vice versa; null
    /// otherwise.
    partner: Option<usize>,
    /// The largest estimated error of its frequencies, Hz.
    error_hz: f64,
    /// The rotor speed at which the mode is no longer found, rpm; null if it is not lost.
    lost_at_rpm: Option<f64>,
    /// Its points by increasing rotor speed.
    points: Vec<PointJson>,
}

/// Neighbouring rotor speeds at which a curve has one name.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct NameRangeJson {
    /// The name.
    label: String,
    /// Its part.
    part: String,
    /// Its order, from 1.
    order: usize,
    /// The lowest of these speeds, rpm.
    from_rpm: f64,
    /// The highest of these speeds, rpm.
    to_rpm: f64,
}

/// A part of the turbine with a fraction of the elastic energy.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct ShareJson {
    /// The part.
    part: String,
    /// The fraction.
    share: f64,
}

/// A mode of a curve at a rotor speed.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct PointJson {
    /// Rotor speed, rpm.
    rotor_speed_rpm: f64,
    /// Its number in the list of modes at this speed, from 1.
    number: usize,
    /// The natural frequency in the fixed frame, Hz.
    frequency_hz: f64,
    /// The lower bound proved by eigenvalue counts, Hz.
    lower_hz: f64,
    /// The upper bound proved by eigenvalue counts, Hz.
    upper_hz: f64,
    /// The estimated error of the mesh, Hz; known only at the ends of the diagram and of the
    /// operating range, otherwise null.
    error_hz: Option<f64>,
    /// Number of modes with this frequency.
    multiplicity: usize,
    /// Whether the energy of the mode in the fixed frame is negative: damping makes it grow.
    has_negative_energy: bool,
    /// Its name at this speed; no other mode has this name there.
    label: String,
    /// The fraction of the elastic energy of the mode in the part that its name states.
    share: f64,
    /// The other part with the most elastic energy; null if no other part has elastic energy.
    second: Option<ShareJson>,
    /// `tilt` or `yaw` for a whirl whose backward and forward waves are almost equal, as at
    /// standstill; null otherwise.
    nodding: Option<String>,
    /// Whether verdicts are given as for a mode of the tower: the mode is not named after a blade
    /// motion, or part of its energy is in the tower.
    counts_as_tower: bool,
    /// Class of the mode, by its energy. Modes of the class `substructure` have no verdict.
    class: ModeClass,
    /// Fractions of its elastic energy.
    energy: EnergyJson,
}

/// Fractions of the elastic energy of a mode; they sum to 1 without `tilt` and `yaw`.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct EnergyJson {
    /// A floating platform in surge, sway, heave, roll, pitch and yaw, with mooring, water and
    /// gravity; 0 for other foundations.
    platform: [f64; 6],
    /// Local motion of members of the frame below the tower, with the transition piece fixed; 0 for
    /// other foundations.
    substructure: f64,
    /// Bending of the tower downwind, with the soil and the foundation.
    tower_fore_aft: f64,
    /// Bending of the tower sideways, with the soil and the foundation.
    tower_side_side: f64,
    /// Torsion of the tower.
    tower_torsion: f64,
    /// Axial deformation of the tower.
    tower_axial: f64,
    /// The yaw drive.
    yaw_drive: f64,
    /// Torsion of the shaft.
    shaft: f64,
    /// Flapwise bending of the blades.
    flapwise: HarmonicsJson,
    /// Edgewise bending of the blades.
    edgewise: HarmonicsJson,
    /// Torsion of the blades.
    blade_torsion: HarmonicsJson,
    /// Axial deformation of the blades.
    blade_axial: HarmonicsJson,
}

/// Fractions by multiblade harmonic: collective, forward whirl, backward whirl.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct HarmonicsJson {
    /// All blades in phase.
    collective: f64,
    /// A wave that travels around the rotor in the direction of rotation.
    forward: f64,
    /// A wave that travels against the direction of rotation.
    backward: f64,
    /// Amplitude proportional to the cosine of the azimuth; `tilt + yaw = forward + backward`.
    tilt: f64,
    /// Amplitude proportional to the sine of the azimuth.
    yaw: f64,
}

/// A crossing or veering of two curves.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct MeetingJson {
    /// `crossing`: the curves cross and keep their shapes. `veering`: the curves approach, diverge
    /// again, and exchange their shapes.
    kind: &'static str,
    /// The indices of the curves, from 0.
    curves: [usize; 2],
    /// The names of the curves at this speed.
    labels: [String; 2],
    /// The rotor speed where they are closest, rpm.
    rotor_speed_rpm: f64,
    /// The mean of their frequencies at this speed, Hz.
    frequency_hz: f64,
    /// Their smallest distance, Hz; 0 for a crossing.
    least_distance_hz: f64,
}

/// A mode of the tower with a rigid rotor-nacelle assembly, and the coupled mode of the same name.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct AgainstRigidJson {
    /// Its name.
    label: String,
    /// The frequency with a rigid rotor-nacelle assembly, Hz.
    rigid_hz: f64,
    /// The coupled frequency at standstill, Hz; null if the turbine was not solved there.
    at_rest_hz: Option<f64>,
    /// The fraction of the elastic energy of this mode in the part that its name states.
    at_rest_share: Option<f64>,
    /// Coupled frequency divided by the frequency with rigid rotor, minus 1, at standstill; null if
    /// the share is below 0.6, because the motion is then distributed over several coupled modes.
    at_rest_difference: Option<f64>,
    /// The coupled frequency at the highest operating speed, Hz; null if no mode has the name
    /// there.
    at_highest_hz: Option<f64>,
    /// The fraction of the elastic energy of this mode in the part that its name states.
    at_highest_share: Option<f64>,
    /// Coupled frequency divided by the frequency with rigid rotor, minus 1, at the highest
    /// operating speed; null if the share is below 0.6.
    at_highest_difference: Option<f64>,
}

/// Writes a coupled Campbell diagram as indented JSON with a newline at the end. The tower has a
/// rigid rotor-nacelle assembly; `against_rigid` compares its modes with the coupled ones.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_coupled_campbell_json(
    tower: &Tower,
    coupled: &CoupledCampbell,
    against_rigid: &[AgainstRigid],
    warnings: &[String],
    writer: impl Write,
) -> Result<(), ResultError> {
    let campbell = &coupled.campbell;
    let margins = campbell.margins.iter();
    let meetings = coupled.meetings.iter();
    let document = CoupledCampbellDocument {
        verdict: coupled.verdict(),
        not_checked: not_checked(campbell),
        tower: NamedJson { name: tower.name() },
        rotor: RotorJson::of(campbell),
        margin: campbell.margin,
        unjudged_hz: campbell.uncovered_range_hz(),
        multiples: &campbell.multiples,
        limit_hz: coupled.limit_hz,
        is_certified: coupled.is_certified(),
        speeds: coupled.speeds.iter().map(speed).collect(),
        curves: coupled.curves.iter().map(curve).collect(),
        margins: margins
            .map(|margin| margin_json(campbell, margin))
            .collect(),
        classes: campbell.classes.iter().map(class_json).collect(),
        meetings: meetings.map(|meeting| met(coupled, meeting)).collect(),
        against_rigid: against_rigid.iter().map(compared).collect(),
        warnings: warnings.to_vec(),
    };
    write_result_json(&document, writer)
}

fn speed(solved: &SolvedSpeed) -> SpeedJson {
    SpeedJson {
        rotor_speed_rpm: solved.rotor_speed_rpm,
        is_added: solved.is_added,
        is_complete: solved.modes.is_complete,
        negative_energy_expected: solved.modes.negative_energy_expected,
        negative_energy_found: solved.modes.negative_energy_found,
        unproven_hz: solved.modes.unproven_hz.clone(),
        growing: solved.modes.growing,
        unresisted: solved.modes.unresisted,
    }
}

fn curve(curve: &CoupledCurve) -> CurveJson {
    CurveJson {
        label: curve.title.clone(),
        part: curve.name.part.to_string(),
        order: curve.name.order,
        names: curve.names().iter().map(name_range).collect(),
        partner: curve.partner,
        error_hz: curve.error_hz(),
        lost_at_rpm: curve.lost.map(|end| end.rotor_speed_rpm),
        points: curve.points.iter().map(point).collect(),
    }
}

fn name_range(range: &NameRange) -> NameRangeJson {
    NameRangeJson {
        label: range.name.to_string(),
        part: range.name.part.to_string(),
        order: range.name.order,
        from_rpm: range.from_rpm,
        to_rpm: range.to_rpm,
    }
}

fn share((part, share): (TurbinePart, f64)) -> ShareJson {
    ShareJson {
        part: part.to_string(),
        share,
    }
}

fn point(point: &CurvePoint) -> PointJson {
    let frequency = &point.frequency;
    PointJson {
        rotor_speed_rpm: point.rotor_speed_rpm,
        number: point.mode + 1,
        frequency_hz: frequency.frequency_hz,
        lower_hz: frequency.lower_hz,
        upper_hz: frequency.upper_hz,
        error_hz: point.error_hz,
        multiplicity: frequency.multiplicity,
        has_negative_energy: frequency.has_negative_energy,
        label: point.name.to_string(),
        share: point.share,
        second: point.second.map(share),
        nodding: point.nodding().map(|nodding| nodding.to_string()),
        counts_as_tower: point.class().counts_as_tower(),
        class: point.class(),
        energy: shares(&point.energy),
    }
}

fn shares(energy: &TurbineEnergy) -> EnergyJson {
    let [flapwise, edgewise, blade_torsion, blade_axial] =
        energy.blades.map(|energy| harmonics(&energy));
    EnergyJson {
        platform: energy.platform,
        substructure: energy.substructure,
        tower_fore_aft: energy.tower_fore_aft,
        tower_side_side: energy.tower_side_side,
        tower_torsion: energy.tower_torsion,
        tower_axial: energy.tower_axial,
        yaw_drive: energy.yaw_drive,
        shaft: energy.shaft,
        flapwise,
        edgewise,
        blade_torsion,
        blade_axial,
    }
}

fn harmonics(energy: &BladeEnergy) -> HarmonicsJson {
    HarmonicsJson {
        collective: energy.collective,
        forward: energy.forward,
        backward: energy.backward,
        tilt: energy.tilt,
        yaw: energy.yaw,
    }
}

fn met(coupled: &CoupledCampbell, meeting: &Meeting) -> MeetingJson {
    MeetingJson {
        kind: meeting.kind.name(),
        curves: meeting.curves,
        labels: meeting
            .curves
            .map(|curve| coupled.curves[curve].name_at(meeting.rotor_speed_rpm))
            .map(|name| name.to_string()),
        rotor_speed_rpm: meeting.rotor_speed_rpm,
        frequency_hz: meeting.frequency_hz,
        least_distance_hz: meeting.least_distance_hz,
    }
}

fn compared(row: &AgainstRigid) -> AgainstRigidJson {
    let hz = |change: Option<Change>| change.map(|change| change.coupled_hz);
    let share = |change: Option<Change>| change.map(|change| change.share);
    let difference = |change: Option<Change>| change.and_then(|change| change.difference);
    AgainstRigidJson {
        label: row.name.to_string(),
        rigid_hz: row.rigid_hz,
        at_rest_hz: hz(row.at_rest),
        at_rest_share: share(row.at_rest),
        at_rest_difference: difference(row.at_rest),
        at_highest_hz: hz(row.at_highest),
        at_highest_share: share(row.at_highest),
        at_highest_difference: difference(row.at_highest),
    }
}
