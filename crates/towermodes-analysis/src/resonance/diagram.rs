//! The Campbell diagram: lines of tower and blade, distances, classes.

use super::campbell::{
    BEYOND_OPERATION, Campbell, CampbellError, CampbellOptions, Excited, FrequencyLine, Margin,
};
use super::class::class;
use super::margin::margin;
use super::mode_class::ModeClass;
use super::not_checked::not_checked;
use super::reach::known_to_hz;
use super::sweep::{blade_lines, speeds_rpm};
use towermodes::blade::BladeDescription;
use towermodes::modes::{Family, Holders, ModeName};
use towermodes::tower::Rotor;
use towermodes::tower::Tower;
use towermodes::{Mode, Solution};

/// The largest number of speeds at which a blade is solved.
const MOST_SPEEDS: usize = 1000;

/// The Campbell diagram of a tower, and of a blade if given: natural frequencies against the
/// multiples of the rotor speed, with distances and verdicts.
///
/// The multiple n has the excitation frequency n Ω/60 Hz at Ω rpm. Its distance from a natural
/// frequency f (Hz) is d = n Ω/(60 f) − 1 at the operating speed with the smallest |d|; 0 if it
/// crosses f. A tower mode has one frequency at all speeds.
///
/// The frequencies of blade modes are given in the rotating frame. Blade modes are solved at
/// [`CampbellOptions::speeds`] equally spaced speeds from standstill to 1.2 times the highest
/// operating speed, and at the lowest and highest operating speed. They keep their names at
/// standstill and are followed by their shapes: greedy assignment by descending modal assurance
/// criterion (with the masses of the blade), so that names do not jump where lines cross. Between
/// two speeds f² is linear in Ω² (Southwell), so distances are exact except where modes veer. A
/// line ends ([`FrequencyLine::lost`]) if no mode at the next speed has a similar shape, among
/// eight times as many modes. If it ends below the highest operating speed, its distances cover the
/// speeds before the end and the verdict is at best WARN; if it ends below the lowest operating
/// speed, it has no distances.
///
/// With the margin m, and f shifted by its estimated error towards the excitation:
///
/// | mode and multiple | fail | warn | pass |
/// |---|---|---|---|
/// | tower mode, n = 1 and n = number of blades | \|d\| < m | m ≤ \|d\| < 2 m | 2 m ≤ \|d\| |
/// | tower mode, other n; blade mode, any n | never | \|d\| < m | m ≤ \|d\| |
///
/// A pair with a distance of 2 m or more that is below m only with the error of f gives a warning,
/// not a failure, because the frequency is not known accurately enough.
///
/// An error of 10 to 20 % in a stiffness changes a frequency by 5 to 10 %: the distance of a pair
/// with a warning could then be at the limit. Other multiples are weaker; whether they are relevant
/// depends on loads, which are not in this model. Local modes of a
/// [substructure](ModeClass::Substructure) have lines in the diagram but no distances: the tower
/// top, which the rotor excites, hardly moves in them. A frequency of 0 (a rigid-body mode without
/// stiffness) is not checked; other rigid-body modes of a floating platform are checked like all
/// modes.
///
/// There are no verdicts and no classes ([`Campbell::not_checked`]) if the operating speeds are
/// unknown ([`CampbellOptions::speeds_are_known`]) or [implausible](Tower::rotor_warnings), if the
/// tower lacks [parts](Tower::missing_parts) of the structure, or if its platform is not in
/// equilibrium: more than a tenth of the weight is [not balanced](Tower::vertical_imbalance).
///
/// The error of a line is [`FrequencyLine::error_hz`]; for blade modes it is estimated at the first
/// and the last speed.
///
/// Sources: Germanischer Lloyd, *Guideline for the Certification of Wind Turbines* (2010);
/// Southwell & Gough, ARC R&M 766 (1921); Allemang & Brown, *A correlation coefficient for modal
/// vector analysis* (1982).
///
/// # Errors
/// [`CampbellError`]: options, rotor or blade are invalid, the solution belongs to another tower,
/// or the blade cannot be solved.
///
/// # Example
/// See the [crate's front page](crate).
pub fn campbell(
    tower: &Tower,
    solution: &Solution,
    blade: Option<&BladeDescription>,
    rotor: &Rotor,
    options: &CampbellOptions,
) -> Result<Campbell, CampbellError> {
    check(tower, solution, rotor, options)?;
    let last_rpm = BEYOND_OPERATION * rotor.highest_rpm;
    let modes = solution.modes.iter();
    let mut lines: Vec<FrequencyLine> = modes.map(|mode| tower_line(mode, last_rpm)).collect();
    if let Some(blade) = blade {
        let speeds_rpm = speeds_rpm(rotor, options.speeds);
        lines.extend(blade_lines(blade, options.blade_modes, &speeds_rpm)?);
    }
    let first = first_bending_modes(solution);
    let class_of = |index: usize| class(solution.modes[index].frequency_hz, rotor);
    let diagram = Campbell {
        rotor: *rotor,
        margin: options.margin,
        classes: first
            .iter()
            .map(|(plane, index)| (*plane, class_of(*index)))
            .collect(),
        first_bending: first.iter().map(|(_, index)| *index).collect(),
        shared: Vec::new(),
        known_to_hz: known_to_hz(solution),
        multiples: options.multiples_of(rotor),
        margins: margins(&lines, rotor, options),
        lines,
        not_checked: Vec::new(),
    };
    Ok(diagram.unless(not_checked(tower, rotor, options.speeds_are_known)))
}

/// The distances of all lines, for each line in the order of the multiples.
pub(crate) fn margins(
    lines: &[FrequencyLine],
    rotor: &Rotor,
    options: &CampbellOptions,
) -> Vec<Margin> {
    let multiples = options.multiples_of(rotor);
    let pairs = lines
        .iter()
        .enumerate()
        .flat_map(|line| multiples.iter().map(move |multiple| (line, *multiple)));
    pairs
        .filter_map(|(line, multiple)| margin(line, multiple, rotor, options.margin))
        .collect()
}

/// Checks the options that do not depend on a tower.
pub(crate) fn check_options(rotor: &Rotor, options: &CampbellOptions) -> Result<(), CampbellError> {
    let (margin, speeds) = (options.margin, options.speeds);
    if !(margin > 0.0 && margin < 1.0) {
        return Err(CampbellError::Margin { margin });
    }
    if options.multiples.contains(&0) {
        return Err(CampbellError::Multiple);
    }
    if !(2..=MOST_SPEEDS).contains(&speeds) {
        return Err(CampbellError::Speeds { speeds });
    }
    Ok(rotor.validate()?)
}

fn check(
    tower: &Tower,
    solution: &Solution,
    rotor: &Rotor,
    options: &CampbellOptions,
) -> Result<(), CampbellError> {
    check_options(rotor, options)?;
    let heights_m = tower.station_heights_m();
    let is_of_tower = |mode: &Mode| {
        let points = mode.station_shape.iter().map(|point| point.height_m);
        points.eq(heights_m.iter().copied())
    };
    if solution.modes.iter().all(is_of_tower) {
        return Ok(());
    }
    Err(CampbellError::OtherTower)
}

fn tower_line(mode: &Mode, last_rpm: f64) -> FrequencyLine {
    FrequencyLine {
        of: Excited::Tower {
            number: mode.number,
            family: mode.family,
            order: mode.order,
            class: ModeClass::of(mode),
        },
        label: mode.label(),
        points: [0.0, last_rpm].map(|rpm| [rpm, mode.frequency_hz]).to_vec(),
        error_hz: mode.error_hz(),
        lost: None,
    }
}

/// The index of the first bending mode of each plane, if it is in the list and its frequency is not
/// 0: the lowest of the modes with a large share of the motion of the first mode. If several modes
/// share this motion, a small change of the tower can give the name to another of them.
fn first_bending_modes(solution: &Solution) -> Vec<(Family, usize)> {
    let planes = [Family::ForeAft, Family::SideSide].into_iter();
    let names = planes.map(|family| ModeName { family, order: 1 });
    let modes = || {
        solution
            .modes
            .iter()
            .map(|mode| (mode.name(), &mode.shares))
    };
    let first = names.filter_map(|name| {
        let held = Holders::of(name, modes())?.places.into_iter();
        let mut resisted = held.filter(|index| solution.modes[*index].frequency_hz > 0.0);
        Some((name.family, resisted.next()?))
    });
    first.collect()
}
