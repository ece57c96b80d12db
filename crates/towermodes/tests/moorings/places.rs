//! Places along lines: their length, their ends, their lowest height, and direction at an end.

use super::decks::deck;
use towermodes::mooring::{LineType, Mooring, Pose};

/// Lines of chain that hang, lie on the seabed or rise at both ends, slack ones, a buoyant rope.
const POINTS: &str = "
    fixed  | -800 0 -300
    vessel | -5 0 -70
    fixed  | 0 700 -300
    vessel | 0 5 -70
    fixed  | 300 -40 -280
    vessel | 4 -3 -60
    fixed  | 20 0 -300
    fixed  | 400 100 -300
    vessel | 6 2 -60
";
const LINES: &str = "
    1 850 | 1 2
    1 735 | 4 3
    1 520 | 5 6
    1 300 | 7 6
    2 470 | 8 9
";

#[test]
fn places_follow_the_line() {
    let types = [
        LineType::new(0.09, 77.7, 384e6),
        LineType::new(0.2, 20.0, 5e6),
    ];
    let description = deck(300.0, 9.81, &types, POINTS, LINES);
    let mooring = Mooring::new(description).expect("lines");
    let state = mooring.at(&Pose::default()).expect("a state");
    let all = mooring.places_m(&state, 2000);
    for ((places, line), own) in all
        .iter()
        .zip(&state.lines)
        .zip(&mooring.description().lines)
    {
        for (end, place) in own.points.iter().zip([places.first(), places.last()]) {
            let off = place.expect("an end").iter().zip(&state.points_m[*end]);
            off.for_each(|(a, b)| assert!((a - b).abs() < 1e-9));
        }
        let step = |pair: &[[f64; 3]]| {
            let squares = (0..3).map(|i| (pair[1][i] - pair[0][i]).powi(2));
            squares.sum::<f64>().sqrt()
        };
        let length_m: f64 = places.windows(2).map(step).sum();
        // A slack line has loops on the seabed that are not drawn.
        let kind = &mooring.description().line_types[own.line_type];
        let most = own.length_m
            * (1.0 + line.tensions_n[0].max(line.tensions_n[1]) / kind.axial_stiffness_n);
        assert!(length_m < most * (1.0 + 1e-6), "{length_m} {most}");
        if !line.is_slack {
            assert!(length_m > own.length_m * (1.0 - 1e-6), "{length_m}");
            let [near, next] = [places[0], places[1]];
            let force = line.forces_n[0];
            let cosine: f64 = (0..3).map(|i| force[i] * (next[i] - near[i])).sum::<f64>()
                / (step(&[near, next]) * line.tensions_n[0]);
            assert!(cosine > 1.0 - 1e-5, "{cosine}");
        }
        let heights_m = places.iter().map(|place| place[2]);
        let lowest_m = heights_m.clone().fold(f64::INFINITY, f64::min);
        let highest_m = heights_m.fold(f64::NEG_INFINITY, f64::max);
        let nearest = (lowest_m - line.extreme_z_m)
            .abs()
            .min((highest_m - line.extreme_z_m).abs());
        assert!(
            nearest < 1e-2,
            "{lowest_m} {highest_m} {}",
            line.extreme_z_m
        );
    }
}
