//! The coupled Campbell diagram of a turbine.

use towermodes::tower::Rotor;
use towermodes::turbine::{Turbine, TurbineModeName, TurbineModel, TurbineModes};

use crate::resonance::{Campbell, check_options, not_checked};

use super::curve::{CoupledCurve, CurvePoint, NameChange};
use super::follow::{Track, tracks};
use super::judged;
use super::meeting::{Meeting, meetings};
use super::named;
use super::options::{CoupledError, CoupledOptions, Headroom, check_limit, check_modes};
use super::refine::solved_speeds;
use super::solved::{Solved, SolvedSpeed};

/// Natural frequencies of a whole turbine against its rotor speed, with their distances from the
/// excitations.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledCampbell<S = TurbineModes> {
    /// The names along the curves as lines, with distances, classes, conclusion and verdict: a line
    /// is a piece of a curve with one name, and the distance of a name is the worst of all pieces
    /// with this name.
    pub campbell: Campbell,
    /// The frequency up to which all modes are followed, Hz.
    pub limit_hz: f64,
    /// The rotor speeds at which the turbine was solved, in increasing order, with their modes.
    pub speeds: Vec<SolvedSpeed<S>>,
    /// The curves: tower and drivetrain by mean frequency, then the blades.
    pub curves: Vec<CoupledCurve>,
    /// The names of all modes in the diagram: tower and drivetrain by mean frequency, then the
    /// blades.
    pub names: Vec<TurbineModeName>,
    /// Crossings and veerings of the curves, by rotor speed.
    pub meetings: Vec<Meeting>,
}

impl CoupledCampbell {
    /// The mode with a name at a rotor speed at which the turbine was solved, rpm.
    #[must_use]
    pub fn at_rpm(&self, name: TurbineModeName, rpm: f64) -> Option<&CurvePoint> {
        let mut points = self.curves.iter().filter_map(|curve| curve.at_rpm(rpm));
        points.find(|point| point.name == name)
    }

    /// The name of the mode with the opposite whirl direction, if it is in the diagram.
    #[must_use]
    pub fn whirls_with(&self, name: TurbineModeName) -> Option<TurbineModeName> {
        named::opposite(name).filter(|other| self.names.contains(other))
    }

    /// The places where curves change their names, by rotor speed.
    #[must_use]
    pub fn changes(&self) -> Vec<NameChange> {
        let mut changes: Vec<NameChange> = Vec::new();
        changes.extend(self.curves.iter().flat_map(CoupledCurve::changes));
        changes.retain(|change| change.frequency_hz <= self.limit_hz);
        changes.sort_by(|a, b| a.rotor_speed_rpm.total_cmp(&b.rotor_speed_rpm));
        changes
    }

    /// The largest known error of the frequencies of a name, Hz; see [`CoupledCurve::error_hz`].
    #[must_use]
    pub fn error_hz(&self, name: TurbineModeName) -> f64 {
        let has = |curve: &&CoupledCurve| curve.points.iter().any(|point| point.name == name);
        let own = self.curves.iter().filter(has);
        own.map(CoupledCurve::error_hz).fold(0.0, f64::max)
    }

    /// Whether a mode of a name has negative energy at some speed.
    #[must_use]
    pub fn has_negative_energy(&self, name: TurbineModeName) -> bool {
        let mut points = self.curves.iter().flat_map(|curve| &curve.points);
        points.any(|point| point.name == name && point.frequency.has_negative_energy)
    }

    /// Whether eigenvalue counts prove at every speed that no mode below the limit is missing and
    /// that no mode is unstable.
    #[must_use]
    pub fn is_certified(&self) -> bool {
        self.speeds.iter().all(|speed| speed.modes.is_complete)
    }

    /// The rotor speeds at which the turbine is unstable or its modes are not certified, rpm.
    #[must_use]
    pub fn uncertified_rpm(&self) -> Vec<f64> {
        let speeds = self.speeds.iter();
        let open = speeds.filter(|speed| !speed.modes.is_complete);
        open.map(|speed| speed.rotor_speed_rpm).collect()
    }
}

/// The coupled Campbell diagram of a turbine: structure only, without wind and controller, at
/// constant rotor speeds.
///
/// The turbine is solved at each of the speeds, on the default mesh. Modes are followed by their
/// shapes: the modal assurance criterion between one speed and the next in the inner product of the
/// elastic energy. If the shapes are ambiguous or curves exchange their order, speeds are added
/// between them, up to [`CoupledOptions::most_added`]. Curves that exchange their order but keep
/// their shapes cross; curves that approach each other, diverge again and exchange their shapes
/// veer. Two curves that exchange their shapes within 1/32 of a step count as crossing.
///
/// Names are those of the modes at each speed, which depend only on that speed: see
/// [`TurbineModes::modes`]. At a veering the name moves to the other curve together with the shape.
///
/// Frequencies are given in the fixed frame: a load on the tower at a frequency excites the modes
/// listed at this frequency. On a rotating blade, a forward whirl has this frequency minus the
/// rotor speed, a backward whirl this frequency plus the rotor speed. The frequencies of each name
/// are compared with the multiples of the rotor speed in the fixed frame, by the table of
/// [`campbell`](crate::campbell()): modes of the tower and the drivetrain as tower modes, modes of
/// the blades as blade modes. A blade mode that shares its energy with the tower counts as a tower
/// mode; see [`CurvePoint::class`].
///
/// Between two speeds f² is interpolated linearly in Ω², as for blades. For a whirl this is an
/// approximation, whose error is proportional to the square of the step.
///
/// `watch` is called before each solve with the rotor speed in rpm.
///
/// Source: Allemang & Brown, *A correlation coefficient for modal vector analysis* (1982).
///
/// # Errors
/// [`CoupledError`]: options or rotor are invalid, or the turbine cannot be solved at a speed.
pub fn coupled_campbell(
    turbine: &Turbine,
    rotor: &Rotor,
    options: &CoupledOptions,
    mut watch: impl FnMut(f64),
) -> Result<CoupledCampbell, CoupledError> {
    coupled_campbell_while(turbine, rotor, options, |rpm| {
        watch(rpm);
        true
    })
}

/// As [`coupled_campbell`], but cancelled when `goes_on` returns false before a rotor speed (rpm).
///
/// # Errors
/// As [`coupled_campbell`], and [`CoupledError::GivenUp`].
pub fn coupled_campbell_while(
    turbine: &Turbine,
    rotor: &Rotor,
    options: &CoupledOptions,
    mut goes_on: impl FnMut(f64) -> bool,
) -> Result<CoupledCampbell, CoupledError> {
    let blades = turbine.machine().blades;
    if rotor.blades != blades {
        let (rotor, turbine) = (rotor.blades, blades);
        return Err(CoupledError::Blades { rotor, turbine });
    }
    let mesh = turbine.mesh();
    let mut model = TurbineModel::new(turbine, &mesh)?;
    let mut finer = TurbineModel::new(turbine, &mesh.finer())?;
    let ends = ends_rpm(rotor, options)?;
    let headroom = Headroom::of(&options.speeds_rpm(rotor)?);
    check_modes(&mut model, check_limit(options.limit_hz)?, &headroom)?;
    let solved = diagram(rotor, options, |rpm, limit_hz, last| {
        if !goes_on(rpm) {
            return Err(CoupledError::GivenUp);
        }
        let last = last.map_or(&[][..], std::slice::from_ref);
        let modes = model.modes_from(limit_hz, rpm, last);
        let mut modes = modes.map_err(|error| CoupledError::At {
            rotor_speed_rpm: rpm,
            error,
        })?;
        if ends.contains(&rpm) {
            finer.estimate_errors(&mut modes);
        }
        Ok(modes)
    })?;
    let reasons = not_checked(turbine.tower(), rotor, options.speeds_are_known);
    Ok(CoupledCampbell {
        campbell: solved.campbell.unless(reasons),
        ..solved
    })
}

/// The speeds at which errors are estimated, rpm: the ends of the diagram and of the operating
/// range. Between them the errors change little.
fn ends_rpm(rotor: &Rotor, options: &CoupledOptions) -> Result<Vec<f64>, CoupledError> {
    check_options(rotor, &options.common())?;
    let speeds = options.speeds_rpm(rotor)?;
    let ends = [speeds.first(), speeds.last()]
        .into_iter()
        .flatten()
        .copied();
    Ok(ends.chain([rotor.lowest_rpm, rotor.highest_rpm]).collect())
}

/// As [`coupled_campbell`], with a function that solves at a rotor speed (rpm) up to a frequency
/// (Hz), given the modes at another speed.
pub(super) fn diagram<S: Solved>(
    rotor: &Rotor,
    options: &CoupledOptions,
    mut solve: impl FnMut(f64, f64, Option<&S>) -> Result<S, CoupledError>,
) -> Result<CoupledCampbell<S>, CoupledError> {
    let common = options.common();
    check_options(rotor, &common)?;
    let limit_hz = check_limit(options.limit_hz)?;
    let speeds_rpm = options.speeds_rpm(rotor)?;
    let sought_hz = Headroom::of(&speeds_rpm).above(limit_hz);
    let solve = |rpm: f64, last: Option<&S>| solve(rpm, sought_hz, last);
    let speeds = solved_speeds(&speeds_rpm, limit_hz, options.most_added, solve)?;
    let (curves, tracks) = curves(&speeds, rotor, limit_hz);
    let names = named::all_names(&curves, rotor);
    let lines = judged::lines(&curves, &names);
    let first = judged::first_bending(&curves, &lines, rotor);
    Ok(CoupledCampbell {
        campbell: Campbell {
            rotor: *rotor,
            margin: options.margin,
            multiples: common.multiples_of(rotor),
            known_to_hz: Some(limit_hz),
            margins: judged::worst(&lines, rotor, &common),
            classes: first.iter().map(|(of, class, _)| (*of, *class)).collect(),
            first_bending: first.iter().map(|(.., curve)| *curve).collect(),
            shared: judged::shared_first(&curves, rotor),
            lines,
            not_checked: Vec::new(),
        },
        limit_hz,
        meetings: meetings(&speeds, &tracks, limit_hz),
        speeds,
        curves,
        names,
    })
}

/// The curves that are below the limit at some speed, in their order, with their tracks.
fn curves<S: Solved>(
    speeds: &[SolvedSpeed<S>],
    rotor: &Rotor,
    limit_hz: f64,
) -> (Vec<CoupledCurve>, Vec<Track>) {
    let curve = |track: &Track| {
        let places = (track.first..).zip(&track.modes);
        let points = places.map(|(speed, mode)| CurvePoint {
            rotor_speed_rpm: speeds[speed].rotor_speed_rpm,
            ..speeds[speed].modes.point(*mode)
        });
        let points: Vec<CurvePoint> = points.collect();
        let last_hz = points.last().map(|point| point.frequency.frequency_hz);
        let is_left = last_hz.is_some_and(|hz| hz > limit_hz);
        CoupledCurve {
            name: points[0].name,
            title: String::new(),
            partner: None,
            lost: track.lost.filter(|_| !is_left),
            points,
        }
    };
    let is_shown = |curve: &CoupledCurve| {
        let mut points = curve.points.iter();
        points.any(|point| point.frequency.frequency_hz <= limit_hz)
    };
    let all = tracks(speeds)
        .into_iter()
        .map(|track| (curve(&track), track));
    let all = all.filter(|(curve, _)| is_shown(curve));
    let (mut curves, tracks): (Vec<CoupledCurve>, Vec<Track>) = all.unzip();
    named::name(&mut curves, rotor);
    let mut both: Vec<(CoupledCurve, Track)> = curves.into_iter().zip(tracks).collect();
    both.sort_by(|a, b| {
        let [a, b] = [a, b].map(|(curve, _)| named::mean_hz(&curve.points, rotor));
        a.total_cmp(&b)
    });
    both.sort_by_key(|(curve, _)| named::is_of_blades(curve.name));
    let (mut curves, tracks): (Vec<CoupledCurve>, Vec<Track>) = both.into_iter().unzip();
    named::pair(&mut curves);
    (curves, tracks)
}
