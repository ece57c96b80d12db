//! Mode shapes in characters: each dot against the exact shapes of a cantilever, names, pairs,
//! widths.

use std::f64::consts::{PI, TAU};
use std::sync::OnceLock;

use towermodes::{
    FloatingPlatform, Foundation, Inertia, Mode, Options, ReferredMatrix, Rna, Solution, Station,
    Tower, TowerDescription, solve,
};
use towermodes_report::terminal::shapes;
use towermodes_testing::{Says, changed, stations, tube, with};

/// Characters of a diagram, and from one to the next.
const COLUMNS: usize = 16;
const PITCH: usize = 18;

/// So slender that it is the beam of the textbooks.
fn pole() -> TowerDescription {
    tube(&[(0.0, 1.0, 0.01), (100.0, 1.0, 0.01)])
}

fn solved(description: TowerDescription, modes: usize) -> (Tower, Solution) {
    let tower = Tower::new(description).expect("a valid tower");
    let options = with!(Options, modes, rotary_inertia = false);
    let solution = solve(&tower, &options).expect("solved");
    (tower, solution)
}

fn picture(description: TowerDescription, modes: usize) -> String {
    let (tower, solution) = solved(description, modes);
    shapes(&tower, &solution, 100)
}

/// Characters to the left of the diagrams: those of the axis, and a space.
fn left(text: &str) -> usize {
    let axis = text.chars().position(|c| c == '┤');
    axis.expect("an axis") + 2
}

/// The dots of a diagram as (right, down).
fn dots(text: &str, panel: usize) -> Vec<(usize, usize)> {
    let bits = [
        (0, 0),
        (0, 1),
        (0, 2),
        (1, 0),
        (1, 1),
        (1, 2),
        (0, 3),
        (1, 3),
    ];
    let mut dots = Vec::new();
    for (row, line) in text.lines().take(13).enumerate() {
        let cells = line.chars().skip(left(text) + panel * PITCH).take(COLUMNS);
        for (column, cell) in cells.enumerate() {
            let pattern = (cell as u32).saturating_sub(0x2800);
            let set = bits.iter().enumerate();
            let set = set.filter(|(bit, _)| pattern >> bit & 1 == 1);
            dots.extend(set.map(|(_, (x, y))| (2 * column + x, 4 * row + y)));
        }
    }
    dots
}

/// The shape of a cantilever, cosh βz − cos βz − σ (sinh βz − sin βz), 1 at its end (Blevins,
/// *Formulas for Natural Frequency and Mode Shape*, 1979, table 8-1).
fn cantilever(mode: usize, share: f64) -> f64 {
    let (beta, sigma) = [
        (1.875_104_07, 0.734_095_514),
        (4.694_091_13, 1.018_467_319),
        (7.854_757_44, 0.999_224_497),
    ][mode];
    let shape = |x: f64| x.cosh() - x.cos() - sigma * (x.sinh() - x.sin());
    shape(beta * share) / shape(beta)
}

#[test]
fn dots_lie_on_the_shapes_of_a_cantilever() {
    let text = picture(pole(), 6);
    for mode in 0..3 {
        let dots = dots(&text, mode);
        let exact = |y: f64| 15.0 + 15.0 * cantilever(mode, 1.0 - y / 51.0);
        for y in 0..52_usize {
            // In every fourth row there is the undeformed axis too.
            let is_axis = |x: usize| x == 15 && y % 4 == 1;
            let here = exact(y as f64);
            let in_row = dots.iter().filter(|(_, row)| *row == y);
            let nearest = in_row.clone().map(|(x, _)| (*x as f64 - here).abs());
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            // A dot is at the nearest place: half a dot away, and a hundredth for curves between
            // samples.
            assert!(nearest <= 0.51, "mode {mode}, row {y}: {nearest}\n{text}");
            // Steep lines have more dots in a row, but none beyond the middle to the next row.
            let above = exact(y.saturating_sub(1) as f64);
            let below = exact((y + 1).min(51) as f64);
            let reach = 0.5 * (above - here).abs().max((below - here).abs()) + 1.01;
            for (x, _) in in_row.filter(|(x, _)| !is_axis(*x)) {
                let distance = (*x as f64 - here).abs();
                let holds = distance <= reach;
                assert!(holds, "mode {mode}, row {y}: {distance}\n{text}");
            }
        }
    }
}

#[test]
fn equal_planes_are_drawn_once_and_named() {
    let text = picture(pole(), 6);
    assert_eq!(text.matches("1st fore-aft and").count(), 1, "{text}");
    assert_eq!(text.matches("side-side").count(), 3);
    // 13 of the diagrams, three of each name, one of frequencies.
    assert_eq!(text.lines().count(), 17);
    // β² √(EI/m)/(2π L²) with I = π/64 (1 − 0.98⁴) m⁴ and m = 8500 π/4 (1 − 0.98²) kg/m.
    let inertia_m4 = PI / 64.0 * (1.0 - 0.98_f64.powi(4));
    let mass_kg_per_m = 8500.0 * PI / 4.0 * (1.0 - 0.98_f64.powi(2));
    let stiffness = (2.1e11 * inertia_m4 / mass_kg_per_m).sqrt();
    let hz = 1.875_104_07_f64.powi(2) * stiffness / (TAU * 1e4);
    text.says(&format!(" {hz:.5} Hz"));
}

#[test]
fn different_planes_are_drawn_each() {
    let inertia_kg_m2 = with!(Inertia, xx = 1e5);
    let uneven = changed!(pole(), rna = changed!(Rna::point(1000.0), inertia_kg_m2));
    let text = picture(uneven, 4);
    assert!(!text.contains(" and"), "{text}");
    assert!(text.contains("1st fore-aft") && text.contains("1st side-side"));
}

#[test]
fn torsion_is_a_rotation_and_says_so() {
    let stub = TowerDescription {
        stations: vec![Station::new(-5.0, 3.0, 0.03), Station::new(5.0, 3.0, 0.03)],
        ..pole()
    };
    let text = picture(stub, 4);
    text.says_all("1st torsion & rotation about z");
    text.begins(" 5.0 m ┤");
    text.says("\u{2212}5.0   ┤");
    // sin(π/2 s), the shape of a shaft held at one end, at its middle: 15 + 15/√2.
    let panel = text
        .lines()
        .nth(13)
        .and_then(|line| line.find("torsion"))
        .map_or(0, |at| (at - left(&text)) / PITCH);
    let middle = dots(&text, panel);
    let holds = middle.contains(&(26, 25)) || middle.contains(&(25, 25));
    assert!(holds, "{text}");
}

/// An RNA beside the tower in y, so slow in yaw that fore-aft bending and torsion move together;
/// side-side bending does not.
#[test]
fn a_coupled_mode_shows_the_motions_it_has() {
    let beside = TowerDescription {
        stations: stations(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)]),
        rna: Rna {
            center_m: [0.0, 6.0, 0.0],
            inertia_kg_m2: with!(Inertia, xx = 3.5e8, yy = 3.5e8, zz = 6.9e8),
            ..Rna::point(350e3)
        },
        ..pole()
    };
    let (tower, solution) = solved(beside, 6);
    let coupled = |mode: &Mode| mode.is_coupled();
    assert!(solution.modes.iter().any(coupled), "nothing is coupled");
    let text = shapes(&tower, &solution, 100);
    text.says_all("x line, rotation & z dots");
    assert!(!text.contains("y dots"), "{text}");
}

#[test]
fn no_picture_is_wider_than_the_terminal() {
    for width in 0..=210 {
        let text = floating(width);
        let widest = text.lines().map(|line| line.chars().count()).max();
        assert!(widest.unwrap_or(0) <= width, "{width}:\n{text}");
        assert_eq!(text.is_empty(), width < 30, "{width}");
    }
    floating(100).says("surge and sway");
}

/// A floating tower, solved once.
fn floating(width: usize) -> String {
    static SOLVED: OnceLock<(Tower, Solution)> = OnceLock::new();
    let (tower, solution) = SOLVED.get_or_init(|| {
        let diagonal = |value: f64| ReferredMatrix {
            matrix: std::array::from_fn(|i| {
                std::array::from_fn(|j| if i == j { value } else { 0.0 })
            }),
            height_m: 0.0,
        };
        let platform = FloatingPlatform {
            mass_kg: 1e7,
            inertia_kg_m2: with!(Inertia, xx = 1e10, yy = 1e10, zz = 1e10),
            hydrostatic: diagonal(1e6),
            mooring: diagonal(1e8),
            ..FloatingPlatform::default()
        };
        let description = TowerDescription {
            foundation: Foundation::Floating(Box::new(platform)),
            ..pole()
        };
        solved(description, 12)
    });
    shapes(tower, solution, width)
}
