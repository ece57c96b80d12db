//! Modes by name in towers whose modes share motions: no row jumps.

use towermodes::{Foundation, HalfSpace, TowerDescription};
use towermodes_files::{SweepModes, SweepResults};
use towermodes_sweep::Base;
use towermodes_testing::{Says, rna, tube, with};

use crate::towers::{names, solved, sweep};

/// The RNA of a soft tower on soil beside its axis in both directions: each mode is fore-aft and
/// side-side.
fn diagonal() -> TowerDescription {
    TowerDescription {
        rna: rna(
            60797.7672878385,
            [-2.3081601903870776, 2.134455263341553, 1.1327627906331306],
            [1857812.07, 1926672.3162498744, 2450530.2387451925],
        ),
        foundation: Foundation::HalfSpace(HalfSpace {
            radius_m: 3.407524943751656,
            embedment_m: 1.8134946910317558,
            shear_modulus_pa: 1.5417479256070977e8,
            poissons_ratio: 0.39976976444280454,
        }),
        ..tube(&[
            (0.0, 2.3471260020305875, 0.010958313450165002),
            (49.53559244020355, 2.4349226576197367, 0.024189505),
        ])
    }
}

/// The NREL 5 MW tower with its RNA, whose side-side bending meets its torsion where the inertia
/// about the vertical axis is 0.629 times that of the drawing.
fn crossing() -> TowerDescription {
    TowerDescription {
        rna: rna(
            350e3,
            [-0.41, 0.0, 1.966427],
            [37634182.0, 24376664.3, 22613929.0],
        ),
        ..tube(&[(0.0, 6.0, 0.0351), (87.6, 3.87, 0.0247)])
    }
}

/// The largest step of a frequency from row to row, as a difference of its logarithm.
fn largest_step(hz: &[f64]) -> f64 {
    let steps = hz.windows(2).map(|pair| (pair[1] / pair[0]).ln().abs());
    steps.fold(0.0, f64::max)
}

#[test]
fn no_row_jumps_where_modes_share_their_motions() {
    let named = [
        "fore-aft 1",
        "side-side 1",
        "torsion 1",
        "fore-aft 2",
        "side-side 2",
    ];
    // The rows, and the step that the change itself makes in the frequency that follows it.
    let cases = [
        (diagonal(), "scale(stations[*].wall)", [1.0, 0.5]),
        (crossing(), "scale(rna.inertia.zz)", [0.9, 0.5]),
    ];
    for (description, change, [from, to]) in cases {
        let results = with!(SweepResults, modes = SweepModes::Named(names(&named)));
        let sweep = sweep(Base::from(description), &[change], &results);
        let rows = 400;
        let at = |row: usize| from + (to - from) * row as f64 / (rows - 1) as f64;
        let values: Vec<f64> = (0..rows).map(at).collect();
        let results = solved(&sweep, &[&values], 1);
        assert!(results.failures.is_empty());
        for (mode, name) in named.iter().enumerate() {
            let hz: Vec<f64> = results.frequencies_hz(mode).collect();
            let step = largest_step(&hz);
            assert!(step < 0.005, "{change}, {name}: {step}");
        }
        for (row, share) in results.share.chunks(named.len()).enumerate() {
            let is_shared = share.iter().any(|share| *share < 0.6);
            let kept = results
                .shared
                .first
                .iter()
                .any(|(first, _)| *first == row as u64);
            assert!(is_shared || !kept, "{change}: {row} {share:?}");
        }
        assert!(results.shared.rows > 0, "{change}");
        let (_, sentence) = &results.shared.first[0];
        sentence.says(" are coupled in modes ");
    }
}
