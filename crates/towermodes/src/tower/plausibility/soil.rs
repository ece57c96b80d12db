//! Soil around the tower: its stiffness, absolute and relative to the tower.

use super::Given;
use super::usual::{Usual, check_worst};
use crate::tower::Warning;
use crate::tower::{Ineffective, Quantity, Site};
use crate::tower::{Piece, Place, Plane, SoilRow, SoilStiffness, Tower};

/// The stiffest row of a layer is at least as stiff as very soft clay, and at most as stiff as
/// rock.
const STIFFEST_ROW: [f64; 2] = [5e4, 1e12];
/// The stiffest spring of a table as a fraction of that of layers on the same pile: soft clay above
/// dense sand has more; values in kN instead of N have a thousandth.
const BESIDE_LAYERS: f64 = 1.0 / 300.0;
const PLANES: Usual = Usual::new(Quantity::SoilPlaneRatio, 0.1, 10.0);
/// Lowest embedded length of a tower that is supported by soil, as a fraction of the length over
/// which it bends in the soil.
const WINKLER: Usual = Usual::at_least(Quantity::WinklerLengths, 0.5);
/// If the rocking spring of the base is at least this many times EI/H, the base supports the tower
/// without soil.
const HOLDS: f64 = 5.0;

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    let before = warnings.len();
    for (layer, rows) in given.soil.iter().enumerate() {
        of_layer((layer, rows), stiffest_row(tower), warnings);
    }
    let is_odd = warnings.len() > before;
    if given.soil.is_empty() && given.ground.is_none() {
        return;
    }
    let surrounds = |piece: &Piece| piece.environment.soil.is_some();
    if tower.base().is_clamped() && tower.pieces().iter().any(surrounds) {
        warnings.push(Warning::SoilAndClamp);
    }
    if !is_odd {
        holds(tower, given.ground.is_some(), warnings);
    }
}

/// The usual range of the stiffest row of a table: beside soil in layers it is at least as stiff as
/// a small fraction of their stiffest spring.
fn stiffest_row(tower: &Tower) -> Usual {
    let layers = tower.springs_of_soil().into_iter();
    let stiffest = layers.map(|springs| springs.lateral_n_per_m2);
    let stiffest = stiffest.fold(0.0, f64::max);
    let [least, most] = STIFFEST_ROW;
    Usual::new(
        Quantity::SoilSpring,
        least.max(BESIDE_LAYERS * stiffest),
        most,
    )
}

fn of_layer((layer, rows): (usize, &[SoilRow]), usual: Usual, warnings: &mut Vec<Warning>) {
    let at = |row, key| Site::at(Place::Soil { layer, row, key });
    if rows
        .iter()
        .all(|row| row.stiffness == SoilStiffness::default())
    {
        let (site, what) = (at(0, "rows"), Ineffective::SoilOfZeros);
        warnings.push(Warning::NoEffect { site, what });
        return;
    }
    let transverse = rows.iter().enumerate().map(|(index, row)| {
        let springs = row.stiffness.transverse();
        (index, row, springs.fore_aft, springs.side_side)
    });
    let larger = transverse
        .clone()
        .map(|(index, row, x, y)| (index, row, x.max(y)));
    let stiffest = larger.max_by(|(.., a), (.., b)| a.total_cmp(b));
    // A layer may have only springs along or about the axis.
    if let Some((index, row, spring)) = stiffest.filter(|(.., spring)| *spring > 0.0) {
        usual.check(spring, at(index, "x").high(row.height_m), warnings);
    }
    let both = transverse.filter(|(_, _, x, y)| *x > 0.0 && *y > 0.0);
    let ratios = both.map(|(index, row, x, y)| (PLANES, y / x, at(index, "y").high(row.height_m)));
    check_worst(ratios, warnings);
}

/// Whether soil without other supports can support the tower.
fn holds(tower: &Tower, is_in_layers: bool, warnings: &mut Vec<Warning>) {
    let base = tower.base();
    let section = tower.pieces()[0].section_at(tower.base_m());
    let planes = [(Plane::ForeAft, 0, 4), (Plane::SideSide, 1, 3)];
    let lengths = planes
        .into_iter()
        .filter_map(|(plane, translation, rotation)| {
            let bending = section.bending_n_m2.of(plane);
            let rocking = base.stiffness[rotation][rotation] * tower.height_m() / bending;
            let is_held = !base.moves[translation] || !base.moves[rotation] || rocking > HOLDS;
            if is_held || base.floats {
                return None;
            }
            winkler_lengths(tower, plane)
        });
    if let Some(least) = lengths.min_by(f64::total_cmp) {
        let (layer, row, key) = (0, 0, "x");
        let site = Site::at(match is_in_layers {
            true => Place::Ground { key: "layer" },
            false => Place::Soil { layer, row, key },
        });
        WINKLER.check(least, site, warnings);
    }
}

/// The embedded length divided by (4EI/k)^¼ with the mean spring; none without soil springs in this
/// plane.
fn winkler_lengths(tower: &Tower, plane: Plane) -> Option<f64> {
    let in_soil = tower.pieces().iter().filter_map(|piece| {
        let [low, high] = piece
            .environment
            .soil?
            .map(|soil| soil.transverse().of(plane));
        let length_m = piece.length_m();
        let middle_m = piece.base_m + 0.5 * length_m;
        let bending = piece.section_at(middle_m).bending_n_m2.of(plane);
        Some((length_m, 0.5 * (low + high) * length_m, bending))
    });
    let zero = (0.0, 0.0, 0.0);
    let (length_m, spring, bending) = in_soil.fold(zero, |(l, k, e): (f64, f64, f64), part| {
        (l + part.0, k + part.1, e.max(part.2))
    });
    if spring == 0.0 {
        return None;
    }
    let mean = spring / length_m;
    Some(length_m / (4.0 * bending / mean).powf(0.25))
}
