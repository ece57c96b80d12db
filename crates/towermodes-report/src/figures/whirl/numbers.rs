//! The figure of the modes of a turbine with rotating rotor, as text and as a table.

use towermodes::tower::Rpm;
use towermodes::turbine::Complex;
use towermodes::turbine::{Turbine, TurbineMode, TurbineModes};

use crate::number::{four_digits, short};
use crate::svg::DataTable;
use crate::wording::counted;

/// The largest number of modes in the description.
const MOST_NAMED: usize = 6;

/// "14 modes of the turbine at 12.1 rpm".
pub(super) fn title(turbine: &Turbine, modes: &TurbineModes) -> String {
    let count = counted(modes.modes.len(), "mode");
    let title = format!("{count} of the turbine at {} rpm", speed(modes));
    match turbine.tower().name() {
        "" => title,
        name => format!("{title}: {name}"),
    }
}

/// The rotor speed, rpm.
fn speed(modes: &TurbineModes) -> Rpm {
    Rpm(modes.rotor_speed_rpm)
}

/// The figure as text.
pub(super) fn description(modes: &TurbineModes) -> String {
    let named = modes.modes.iter().take(MOST_NAMED);
    let named = named.map(|mode| {
        let frequency = four_digits(mode.frequency.frequency_hz);
        format!("{} at {frequency} Hz", mode.label())
    });
    let mut named: Vec<String> = named.collect();
    match modes.modes.len().saturating_sub(MOST_NAMED) {
        0 => {}
        more => named.push(format!("and {more} more")),
    }
    let named = match named.is_empty() {
        true => "none".to_owned(),
        false => named.join(", "),
    };
    format!(
        "Tower and rotor at the largest deflection of each mode and a quarter of a period later, seen from the side and from downwind, in the fixed frame: {named}."
    )
}

/// The largest deflections of each mode: tower top, and tips of the blades by harmonic.
pub(super) fn table(modes: &TurbineModes) -> DataTable {
    let header = [
        "mode",
        "frequency (Hz)",
        "tower top x",
        "tower top y",
        "out-of-plane tip deflection: collective",
        "forward",
        "backward",
        "in-plane tip deflection: collective",
        "forward",
        "backward",
    ];
    DataTable::new(header, modes.modes.iter().map(row))
}

fn row(mode: &TurbineMode) -> Vec<String> {
    let none = [Complex::default(); 3];
    let top = mode.shape.tower.last();
    let top = top.map_or(none, |section| [0, 1, 2].map(|i| section.motion[i]));
    let tip = mode.shape.blades.last();
    let tip = tip.map_or([none; 4], |section| section.harmonics);
    let along = [0, 1, 2].map(|harmonic: usize| tip[harmonic][0]);
    let across = [0, 1, 2].map(|harmonic: usize| tip[harmonic][1]);
    let sizes = [top[0], top[1]].into_iter().chain(along).chain(across);
    let name = [mode.label(), four_digits(mode.frequency.frequency_hz)];
    name.into_iter().chain(sizes.map(size)).collect()
}

/// The absolute value of an amplitude; zero if it is far below the largest, which is 1.
fn size(amplitude: Complex) -> String {
    let size = amplitude.re.hypot(amplitude.im);
    short(if size < 5e-4 { 0.0 } else { size }, 3)
}
