//! The table of the summary: the first modes and those with a warning, each with the excitation
//! that determines its verdict.

use towermodes::tower::Rpm;
use towermodes::turbine::{TurbineModeName, TurbinePart};
use towermodes::{Family, Mode, Solution};
use towermodes_analysis::resonance::{Campbell, Excited, FrequencyLine, Margin};
use towermodes_analysis::whirl::CoupledCampbell;

use super::super::table::{Cell, Table};
use super::resonance::distance;
use crate::number::{NOTHING, four_digits};

/// The first mode of each family, and the lowest of all.
pub(super) fn first(solution: &Solution) -> Vec<&Mode> {
    let families = [
        Family::Surge,
        Family::Sway,
        Family::Heave,
        Family::Roll,
        Family::Pitch,
        Family::Yaw,
        Family::ForeAft,
        Family::SideSide,
        Family::Torsion,
    ];
    let first = families
        .into_iter()
        .filter_map(|family| solution.mode(family, 1));
    let mut first: Vec<&Mode> = first.collect();
    if let Some(lowest) = solution.modes.first()
        && !first.iter().any(|mode| mode.number == lowest.number)
    {
        first.push(lowest);
    }
    first.sort_by_key(|mode| mode.number);
    first
}

/// The first modes of a tower without verdicts.
pub(super) fn without_verdicts(first: &[&Mode], caption: &str) -> Table {
    let mut table = Table::new(caption, ["mode", "#f (Hz)", "#period (s)"]);
    for mode in first {
        table.push([
            mode.label(),
            hz(mode.frequency_hz),
            period(mode.frequency_hz),
        ]);
    }
    table
}

/// The first modes of tower and drivetrain of a turbine without verdicts and the second bending
/// modes of its tower, at the highest operating speed; at standstill if that is unknown.
pub(super) fn of_unjudged_turbine(coupled: &CoupledCampbell) -> Table {
    let (rpm, place) = match coupled.campbell.speeds_are_known() {
        true => {
            let rpm = coupled.campbell.rotor.highest_rpm;
            (rpm, format!("at {} rpm", Rpm(rpm)))
        }
        false => (0.0, "at standstill".to_owned()),
    };
    let caption = format!("First modes of the turbine {place}");
    let mut table = Table::new(caption, ["mode", "#f (Hz)", "#period (s)"]);
    let is_shown = |name: &&TurbineModeName| is_first(**name) || is_second_bending(**name);
    for name in coupled.names.iter().filter(is_shown) {
        if let Some(point) = coupled.at_rpm(*name, rpm) {
            let own_hz = point.frequency.frequency_hz;
            table.push([name.to_string(), hz(own_hz), period(own_hz)]);
        }
    }
    table
}

/// The first modes of a diagram and those that do not pass, each with its worst verdict and the
/// corresponding excitation. `is_first` selects the first modes.
pub(super) fn of_diagram(
    campbell: &Campbell,
    caption: &str,
    is_first: impl Fn(&FrequencyLine) -> bool,
) -> Table {
    let columns = [
        "mode",
        "verdict",
        "nearest excitation",
        "#distance (%)",
        "#f (Hz)",
        "#period (s)",
    ];
    let mut table = Table::new(caption, columns);
    for line in campbell.lines_by_mode().iter().map(|lines| lines[0]) {
        let decisive = campbell.decisive(line);
        let objects = decisive.is_some_and(|margin| margin.verdict.is_objection());
        if objects || is_first(line) {
            table.push(row(campbell, line, decisive));
        }
    }
    table
}

/// Whether a mode of a turbine is the first of a part other than the blades.
pub(super) fn is_first_of_turbine(line: &FrequencyLine) -> bool {
    match line.of {
        Excited::Turbine { name, .. } => is_first(name),
        Excited::Tower { .. } | Excited::Blade { .. } => false,
    }
}

fn is_first(name: TurbineModeName) -> bool {
    name.order == 1 && !matches!(name.part, TurbinePart::Blades(..))
}

fn is_second_bending(name: TurbineModeName) -> bool {
    let bends = [TurbinePart::TowerForeAft, TurbinePart::TowerSideSide];
    name.order == 2 && bends.contains(&name.part)
}

fn row(campbell: &Campbell, line: &FrequencyLine, decisive: Option<&Margin>) -> Vec<Cell> {
    let Some(margin) = decisive else {
        let own_hz = line.points.last().map_or(0.0, |[_, hz]| *hz);
        let nothing = || Cell::from(NOTHING);
        return vec![
            line.label.clone().into(),
            nothing(),
            nothing(),
            nothing(),
            hz(own_hz).into(),
            period(own_hz).into(),
        ];
    };
    let rpm = four_digits(margin.nearest_rpm);
    vec![
        line.label.clone().into(),
        margin.verdict.into(),
        format!("{}P at {rpm} rpm", margin.multiple).into(),
        distance(campbell, margin).into(),
        hz(margin.natural_hz).into(),
        period(margin.natural_hz).into(),
    ]
}

fn hz(hz: f64) -> String {
    match hz > 0.0 {
        true => four_digits(hz),
        false => "0 (free motion)".to_owned(),
    }
}

fn period(hz: f64) -> String {
    match hz > 0.0 {
        true => four_digits(1.0 / hz),
        false => NOTHING.to_owned(),
    }
}
