//! A uniform rotor on a uniform tower: frequencies of an independent program, which assembles the
//! real matrices of multiblade coordinates with full polynomials and solves them by a dense
//! eigensolver.

use super::{assert_near, frequencies, model, straight, tilted};
use towermodes::turbine::TurbineDescription;

/// Speeds of the columns, rpm.
const SPEEDS: [f64; 4] = [0.0, 6.0, 12.0, 18.0];

/// Nine decimals are given: half a unit of the last one of 0.34 Hz is 1.5e-9, and the other program
/// agrees with itself at other degrees to ten digits.
const TOLERANCE: f64 = 4e-9;

#[track_caller]
fn assert_table(machine: TurbineDescription, is_locked: bool, rows: &[[f64; 4]]) {
    let mut machine = machine;
    machine.generator.is_locked = is_locked;
    let mut model = model(machine);
    for (column, rpm) in SPEEDS.into_iter().enumerate() {
        let exact: Vec<f64> = rows.iter().map(|row| row[column]).collect();
        assert_near(&frequencies(&mut model, 4.0, rpm), &exact, TOLERANCE);
        // As many counts find them, and a free shaft counts as one more.
        let count = model.count(4.0, rpm);
        assert_eq!(count, rows.len() + usize::from(!is_locked));
    }
}

#[test]
fn a_straight_turbine_with_a_locked_generator() {
    let rows = [
        [0.342544997, 0.342539369, 0.342495779, 0.338618789],
        [0.345618076, 0.345035710, 0.343024408, 0.342509653],
        [0.582978269, 0.583084717, 0.522435640, 0.470172316],
        [0.661094233, 0.591373095, 0.583505663, 0.584121254],
        [0.700002992, 0.754936727, 0.784075606, 0.826415824],
        [0.754305201, 0.796683352, 0.917067813, 0.837037498],
        [1.118827203, 1.030027076, 0.932752776, 1.056869832],
        [1.143312510, 1.234449434, 1.338988534, 1.445926787],
        [2.793271967, 2.793381086, 2.793711891, 2.794275781],
        [2.852141598, 2.851960057, 2.851458094, 2.850757074],
        [3.752587400, 3.749553836, 3.741866147, 3.732818830],
    ];
    assert_table(straight(), true, &rows);
}

#[test]
fn a_straight_turbine_with_a_free_generator() {
    let rows = [
        [0.345618076, 0.345033977, 0.342992040, 0.338626664],
        [0.354168232, 0.354159637, 0.354132321, 0.354080984],
        [0.661089305, 0.591343807, 0.522439717, 0.470174852],
        [0.700002992, 0.754936620, 0.784075604, 0.826414132],
        [0.754305201, 0.796682667, 0.917062786, 0.836843595],
        [1.118827203, 1.029956312, 0.932638220, 1.056869678],
        [1.143221013, 1.234419474, 1.338975678, 1.445923002],
        [1.620428583, 1.620927690, 1.622411429, 1.624840003],
        [2.852141598, 2.851793505, 2.850814651, 2.849379704],
        [2.884602383, 2.884851571, 2.885580854, 2.886751203],
        [3.753229651, 3.750181848, 3.742456374, 3.733357883],
    ];
    assert_table(straight(), false, &rows);
}

#[test]
fn a_tilted_and_coned_turbine_with_a_locked_generator() {
    let rows = [
        [0.341844913, 0.341770217, 0.341190062, 0.337669016],
        [0.345192315, 0.344679709, 0.343215031, 0.342354541],
        [0.576748205, 0.575701930, 0.522030529, 0.468572234],
        [0.662612561, 0.594015540, 0.578669919, 0.579409420],
        [0.702305322, 0.765394969, 0.794730130, 0.829520211],
        [0.764459452, 0.797972601, 0.914199861, 0.841569417],
        [1.113428049, 1.026015134, 0.931919368, 1.054964022],
        [1.140157747, 1.230289905, 1.335097056, 1.442806919],
        [2.788346294, 2.788433196, 2.788696813, 2.789147010],
        [2.847100100, 2.846977071, 2.846649790, 2.846237215],
        [3.745704856, 3.743033612, 3.736278985, 3.728418330],
    ];
    assert_table(tilted(), true, &rows);
}

#[test]
fn a_tilted_and_coned_turbine_with_a_free_generator() {
    let rows = [
        [0.345093710, 0.344495110, 0.342422115, 0.338014083],
        [0.353399432, 0.353407388, 0.353423558, 0.353425060],
        [0.662246324, 0.592198918, 0.522482206, 0.468796549],
        [0.701241437, 0.759501268, 0.788766080, 0.827395795],
        [0.758814429, 0.797455175, 0.914104184, 0.837853873],
        [1.113421964, 1.025910432, 0.931772738, 1.054934864],
        [1.140026559, 1.230242610, 1.335074507, 1.442798838],
        [1.617430621, 1.617950237, 1.619496091, 1.622030375],
        [2.846743128, 2.846257706, 2.844919627, 2.843014919],
        [2.877239271, 2.877690000, 2.878968778, 2.880918536],
        [3.757421461, 3.754491739, 3.747062859, 3.738321953],
    ];
    assert_table(tilted(), false, &rows);
}
