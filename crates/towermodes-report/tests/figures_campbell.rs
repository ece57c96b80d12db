//! Diagrams of resonance, convergence and methods: every label inside and beside the others, what
//! is drawn where, and nothing that breaks them.

use crate::pictures;

use pictures::{check, check_labels, input};
use towermodes::{BladeFamily, Family, Method, Options, Solver, solve};
use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{
    Campbell, CampbellOptions, Excited, FrequencyLine, Margin, ModeClass, StiffnessClass, campbell,
};
use towermodes_analysis::study::{
    ColumnSpec, Comparison, Convergence, Fineness, compare, converge,
};
use towermodes_report::figures;
use towermodes_report::svg::{Figure, Look};
use towermodes_testing::{Says, changed, rotor, with};

fn line(of: Excited, label: &str, points: &[[f64; 2]]) -> FrequencyLine {
    FrequencyLine {
        of,
        label: label.to_owned(),
        points: points.to_vec(),
        lost: None,
        error_hz: 0.0,
    }
}

fn tower_line(number: usize, frequency_hz: f64) -> FrequencyLine {
    let (family, order) = (Family::ForeAft, number);
    let of = Excited::Tower {
        number,
        family,
        order,
        class: ModeClass::Tower,
    };
    let label = family.label(order);
    line(of, &label, &[[0.0, frequency_hz], [14.52, frequency_hz]])
}

fn by_hand(lines: Vec<FrequencyLine>, multiples: Vec<usize>) -> Campbell {
    Campbell {
        rotor: rotor(3, 6.9, 12.1),
        margin: 0.05,
        multiples,
        lines,
        margins: Vec::new(),
        known_to_hz: None,
        classes: vec![(Family::ForeAft, StiffnessClass::SoftStiff)],
        first_bending: vec![0],
        not_checked: Vec::new(),
    }
}

fn margin(line: usize, verdict: Verdict) -> Margin {
    Margin {
        line,
        multiple: 3,
        nearest_rpm: 6.9,
        excitation_hz: 0.345,
        natural_hz: 0.3,
        distance: 0.15,
        verdict,
    }
}

/// One field, 52 to 452. 3P is 0.726 Hz at the right end, 14.52 rpm, and the field ends 3 % above;
/// the second mode is higher than what 3P in operation makes worth showing.
#[test]
fn lines_are_where_their_frequencies_are() {
    let lines = vec![tower_line(1, 0.3), tower_line(2, 2.2), tower_line(3, 30.0)];
    let figure = figures::campbell(&by_hand(lines, vec![1, 3]));
    let y = 452.0 - 0.3 / (1.03 * 0.726) * 400.0;
    let svg = figure.to_svg(Look::Inline);
    assert!(svg.contains(&format!(" {y:.2}L")), "{y} in {svg}");
    let description = &figure.description;
    description.says(" 2 modes above the frequency range");
    assert!(says(&figure, "2 modes above the frequency range"));
    assert!(!says(&figure, UPPER));
}

/// A length as SVG has it: to hundredths, without zeros at its end.
fn written(length: f64) -> String {
    let text = format!("{length:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

const UPPER: &str = "upper panel: higher modes at another scale";

/// With 9P the second mode, 2.2 Hz, is worth showing, and has a field of its own: 130 high, of
/// three labels. 9P is 2.178 Hz at the right end; the list of that field ends at 1.06 times 2.2 Hz.
/// The lower field, 196 to 536, is the one of the test above.
#[test]
fn high_modes_do_not_squeeze_the_first() {
    let lines = vec![tower_line(1, 0.3), tower_line(2, 2.2), tower_line(3, 30.0)];
    let figure = figures::campbell(&by_hand(lines, vec![1, 3, 6, 9]));
    let split = 1.03 * 0.726;
    let first = 536.0 - 0.3 / split * 340.0;
    let second = 182.0 - (2.2 - split) / (1.06 * 2.2 - split) * 130.0;
    let svg = figure.to_svg(Look::Inline);
    for y in [first, second] {
        assert!(svg.contains(&format!(" {}L", written(y))), "{y} in {svg}");
    }
    assert!(says(&figure, UPPER) && says(&figure, "1 mode above the frequency range"));
    check_labels("two fields", &figure);
}

/// Around 3P, 0.345 to 0.605 Hz in operation, frequencies f with |3P/f − 1| < 5 % are from 3P/1.05
/// to 3P/0.95.
#[test]
fn ribbons_are_as_wide_as_the_margin() {
    let figure = figures::campbell(&by_hand(vec![tower_line(1, 0.3)], vec![1, 3]));
    let svg = figure.to_svg(Look::Inline);
    let ribbons = svg
        .lines()
        .filter(|line| line.contains("f-too-near") && line.contains(" d="));
    let ribbons: Vec<&str> = ribbons.collect();
    assert_eq!(ribbons.len(), 2, "{svg}");
    let y = |hz: f64| format!(" {}", written(452.0 - hz / (1.03 * 0.726) * 400.0));
    for hz in [0.345 / 0.95, 0.605 / 0.95, 0.605 / 1.05, 0.345 / 1.05] {
        let holds = ribbons[1].contains(&y(hz));
        assert!(holds, "{hz}: {} in {}", y(hz), ribbons[1]);
    }
    assert!(says(&figure, "within 5 % of 1P or 3P in operation"));
    assert!(says(&figure, "within 10 %"));
}

/// Between 1P at 12.1 rpm and 3P at 6.9 rpm; a rotor whose highest speed is three times its lowest
/// has no such window.
#[test]
fn the_window_of_soft_stiff_towers_is_named() {
    let mut campbell = by_hand(vec![tower_line(1, 0.3)], vec![1, 3]);
    let figure = figures::campbell(&campbell);
    assert!(
        says(&figure, "soft-stiff")
            && says(
                &figure,
                "soft-stiff with 5 % margin kept: 0.2123 to 0.3286 Hz"
            )
    );
    campbell.rotor.lowest_rpm = 4.0;
    let figure = figures::campbell(&campbell);
    assert!(
        !figure
            .labels()
            .iter()
            .any(|label| label.text.contains("soft-stiff"))
    );
}

/// 1P and the passing of the blades are thick and dark, all others thin.
#[test]
fn the_strong_excitations_are_stressed() {
    let figure = figures::campbell(&by_hand(vec![tower_line(1, 0.3)], vec![1, 3, 6, 9]));
    let svg = figure.to_svg(Look::Inline);
    let rays = |width: &str| {
        let stroke = format!("stroke-width=\"{width}\"");
        // One of them is in the legend.
        svg.lines().filter(|line| line.contains(&stroke)).count() - 1
    };
    assert_eq!((rays("2.4"), rays("0.9") >= 2), (2, true), "{svg}");
}

fn says(figure: &Figure, text: &str) -> bool {
    figure.labels().iter().any(|label| label.text == text)
}

/// 3P is 0.726 Hz at the right end, 14.52 rpm: what it passes there is in the picture, and what is
/// warned of or fails above it too.
#[test]
fn whatever_is_judged_is_in_the_picture() {
    let lines = [0.3, 0.7, 1.5, 2.2, 9.0].into_iter().zip(1..);
    let lines = lines.map(|(hz, number)| tower_line(number, hz)).collect();
    let mut campbell = by_hand(lines, vec![1, 3]);
    let figure = figures::campbell(&campbell);
    assert!(says(&figure, "2nd fore-aft: 0.7000 Hz"));
    assert!(says(&figure, "3 modes above the frequency range"));
    let at = |line: usize, natural_hz, verdict| changed!(margin(line, verdict), natural_hz);
    campbell.margins = vec![at(2, 1.5, Verdict::Warn), at(3, 2.2, Verdict::Fail)];
    let figure = figures::campbell(&campbell);
    assert!(says(&figure, "4th fore-aft: 2.200 Hz"));
    assert!(says(&figure, "1 mode above the frequency range"));
    // 9 Hz are more than 6 times 0.726 Hz: the rest would be a strip at the foot.
    campbell.margins.push(at(4, 9.0, Verdict::Fail));
    let figure = figures::campbell(&campbell);
    assert!(says(&figure, "1 mode above the frequency range, 1 FAIL"));
    check_labels("a mode far above", &figure);
}

#[test]
fn modes_without_a_frequency_are_counted() {
    let figure = figures::campbell(&by_hand(
        vec![tower_line(1, 0.0), tower_line(2, 0.3)],
        vec![3],
    ));
    assert!(says(&figure, "1 mode at 0 Hz"));
    let description = &figure.description;
    description.says("Not shown: 1 mode at 0 Hz.");
}

/// A mark is a pair of a line and a ray, both drawn.
#[test]
fn many_excitations_are_drawn_and_more_are_counted() {
    let rays = |last: usize| {
        let mut campbell = by_hand(vec![tower_line(1, 0.3)], (1..=last).collect());
        let multiple = last;
        campbell.margins = vec![changed!(margin(0, Verdict::Warn), multiple)];
        let figure = figures::campbell(&campbell);
        check_labels(&format!("{last} excitations"), &figure);
        figure
    };
    // A triangle of the legend and one in the field.
    let triangles = |figure: &Figure| {
        let svg = figure.to_svg(Look::Inline);
        svg.matches("class=\"f-warn\"").count()
    };
    let thirty = rays(30);
    thirty.description.says("the excitations 1P to 30P.");
    assert!(says(&thirty, "30P") && says(&thirty, "1P") && says(&thirty, "3P"));
    let labelled = thirty
        .labels()
        .iter()
        .filter(|label| label.text.ends_with('P'));
    let missing = 30 - labelled.count();
    assert!(says(
        &thirty,
        &format!("{missing} excitations without label")
    ));
    assert_eq!(triangles(&thirty), 2);
    let many = rays(140);
    many.description.says("the excitations 1P to 100P.");
    many.description.says("Not shown: 40 more excitations.");
    let text = "nP: other multiples of the rotor speed; 40 more are not shown";
    assert!(says(&many, text));
    assert_eq!(triangles(&many), 1);
}

#[test]
fn marks_at_one_place_are_apart_and_counted() {
    let mut campbell = by_hand(vec![tower_line(1, 0.3), tower_line(2, 0.5)], vec![1, 3]);
    let number = "number above a mark: coinciding marks";
    campbell.margins = vec![margin(0, Verdict::Fail), margin(0, Verdict::Warn)];
    let figure = figures::campbell(&campbell);
    assert!(!says(&figure, number));
    campbell.margins.push(margin(0, Verdict::Fail));
    let figure = figures::campbell(&campbell);
    assert!(says(&figure, "2") && says(&figure, number));
    check_labels("two crosses and a triangle", &figure);
}

#[test]
fn pairs_that_fail_are_marked_and_said() {
    let mut campbell = by_hand(vec![tower_line(1, 0.3), tower_line(2, 0.5)], vec![1, 3]);
    let says = |campbell: &Campbell, text: &str| {
        let figure = figures::campbell(campbell);
        figure.labels().iter().any(|label| label.text == text)
    };
    campbell.margins = vec![margin(0, Verdict::Pass)];
    assert!(!says(&campbell, "margin not met: FAIL") && !says(&campbell, "WARN"));
    campbell.margins = vec![margin(0, Verdict::Fail), margin(1, Verdict::Warn)];
    assert!(says(&campbell, "margin not met: FAIL") && says(&campbell, "WARN"));
    let description = figures::campbell(&campbell).description;
    description.says("FAIL: 3P with 1st fore-aft bending (+15.0 % at 6.9 rpm).");
    description.says("1 warning for 3P: 2nd fore-aft bending (+15.0 % at 6.9 rpm).");
}

#[test]
fn modes_of_one_frequency_have_one_label_and_others_are_told_apart() {
    for (hz, said) in [
        ([0.242_48, 0.242_51], "0.2425 Hz"),
        ([0.242_34, 0.242_51], "0.2423, 0.2425 Hz"),
    ] {
        let mut second = tower_line(2, hz[1]);
        second.label = "1st side-side bending".to_owned();
        let figure = figures::campbell(&by_hand(vec![tower_line(1, hz[0]), second], vec![3]));
        assert!(
            says(&figure, &format!("1st fore-aft, 1st side-side: {said}")),
            "{said}"
        );
    }
    let lines = vec![tower_line(1, 0.2421), tower_line(2, 0.2424)];
    let figure = figures::campbell(&by_hand(lines, vec![3]));
    assert!(says(&figure, "1st fore-aft: 0.2421 Hz") && says(&figure, "2nd fore-aft: 0.2424 Hz"));
}

#[test]
fn diagrams_of_the_examples_are_readable() {
    let rotors = [
        (6.9, 12.1, 3),
        (33.0, 33.0, 2),
        (0.0, 0.4, 3),
        (40.0, 80.0, 1),
    ];
    for name in [
        "nrel-5mw.toml",
        "floating.toml",
        "reference-tower.toml",
        "small-turbine/ElastoDyn.dat",
    ] {
        let (input, tower) = input(name);
        let solution = solve(&tower, &Options::default()).expect("its modes");
        for (lowest_rpm, highest_rpm, blades) in rotors {
            let rotor = rotor(blades, lowest_rpm, highest_rpm);
            let options = with!(CampbellOptions, speeds = 3);
            let blade = input.blade.as_ref();
            let campbell = campbell(&tower, &solution, blade, &rotor, &options);
            let mut campbell = campbell.expect("a diagram");
            for multiples in [campbell.multiples.clone(), vec![1], (1..=100).collect()] {
                let case = format!("{name}, {rotor:?}, {} multiples", multiples.len());
                campbell.multiples = multiples;
                check(&case, &figures::campbell(&campbell));
            }
        }
    }
}

#[test]
fn no_diagram_breaks_its_picture() {
    let blade = Excited::Blade {
        family: BladeFamily::Flap,
        order: 1,
    };
    let of_blade = |points: &[[f64; 2]]| vec![line(blade, "blade 1st flap", points)];
    let many: Vec<FrequencyLine> = (1..=80).map(|n| tower_line(n, 0.001 * n as f64)).collect();
    let cases = [
        ("nothing", by_hand(vec![], vec![])),
        ("no multiple", by_hand(vec![tower_line(1, 0.3)], vec![])),
        ("all at zero", by_hand(vec![tower_line(1, 0.0)], vec![1, 3])),
        ("many", by_hand(many, (1..=100).collect())),
        ("no points", by_hand(of_blade(&[]), vec![3])),
        ("no number", by_hand(of_blade(&[[0.0, f64::NAN]]), vec![3])),
        (
            "infinite",
            by_hand(vec![tower_line(1, f64::INFINITY)], vec![usize::MAX]),
        ),
    ];
    for (case, mut campbell) in cases {
        check_labels(case, &figures::campbell(&campbell));
        campbell.rotor.highest_rpm = 0.0;
        campbell.rotor.lowest_rpm = 0.0;
        check_labels(case, &figures::campbell(&campbell));
    }
}

/// A row for each speed; a tower's mode is the same at all, a blade's only known at its points; 3P
/// at 6 and 12 rpm is 0.3 and 0.6 Hz.
#[test]
fn the_numbers_of_a_diagram_are_its_lines() {
    let of_blade = Excited::Blade {
        family: BladeFamily::Flap,
        order: 1,
    };
    let blade = line(of_blade, "blade 1st flap", &[[0.0, 0.7], [14.4, 0.9]]);
    let mut diagram = by_hand(vec![tower_line(1, 0.5), blade], vec![3]);
    diagram.rotor.lowest_rpm = 6.0;
    diagram.rotor.highest_rpm = 12.0;
    let tower = format!("{} (Hz)", diagram.lines[0].label);
    let table = figures::campbell(&diagram).table;
    let head = [
        "rotor speed (rpm)",
        &tower,
        "blade 1st flap (Hz)",
        "3P (Hz)",
    ];
    assert_eq!(table.header, head);
    let expected = [
        ["0", "0.5000", "0.7000", "0.0000"],
        ["6", "0.5000", "", "0.3000"],
        ["12", "0.5000", "", "0.6000"],
        ["14.4", "0.5000", "0.9000", "0.7200"],
    ];
    assert_eq!(table.rows, expected);
}

fn convergence(name: &str, method: Method, fineness: &[Fineness], modes: usize) -> Convergence {
    let options = with!(Options, method, modes);
    let (_, tower) = input(name);
    converge(&tower, fineness, &mut Solver::new(options.clone()), |_| ()).expect("solvable")
}

#[test]
fn convergence_is_readable() {
    let segments = [10, 20, 40, 80].map(Fineness::Segments);
    let degrees = [4, 6, 8, 10].map(Fineness::Degree);
    for name in ["nrel-5mw.toml", "reference-tower.toml", "floating.toml"] {
        for (method, fineness) in [
            (Method::RmjeExact, &segments[..]),
            (Method::CardanicExact, &segments),
            (Method::Rmje, &segments[..1]),
            (Method::Spectral, &degrees),
        ] {
            for modes in [2, 16] {
                let case = format!("{name}, {}, {modes} modes", method.name());
                let figure = figures::convergence(&convergence(name, method, fineness, modes));
                check(&case, &figure);
                let svg = figure.to_svg(Look::Inline);
                let says = svg.contains(" more modes</text>");
                assert_eq!(says, figure.description.contains("not shown"), "{case}");
                let is_known =
                    name == "nrel-5mw.toml" && method == Method::RmjeExact && modes == 16;
                assert!(!is_known || svg.contains(">2 more modes<"), "{case}");
            }
        }
    }
}

/// Two levels, one mode: errors 4e-2 and 1e-2 at 10 and 20 segments. The axis is 10⁻² to 10⁻¹ over
/// 18 to 474.
#[test]
fn errors_are_where_they_belong() {
    let segments = [10, 20].map(Fineness::Segments);
    let mut study = convergence("nrel-5mw.toml", Method::RmjeExact, &segments, 1);
    for (level, error) in study.levels.iter_mut().zip([4e-2, -1e-2]) {
        level.errors = vec![Some(error)];
        level.orders = vec![Some(2.0)];
    }
    let figure = figures::convergence(&study);
    let svg = figure.to_svg(Look::Inline);
    let y = 474.0 - 4.0_f64.log10() * (474.0 - 18.0);
    assert!(svg.contains(&format!(" {y:.2}L")), "{y} in {svg}");
    svg.says_all("1st side-side bending, order 2.00 & n⁻²");
    assert_eq!(figure.table.rows[1][3], "-1.0e-2");
}

#[test]
fn no_convergence_breaks_its_picture() {
    let segments = [10, 20].map(Fineness::Segments);
    let mut study = convergence("nrel-5mw.toml", Method::RmjeExact, &segments, 3);
    for error in [None, Some(0.0), Some(f64::NAN), Some(f64::INFINITY)] {
        for level in &mut study.levels {
            level.errors = vec![error; 3];
            level.orders = vec![None; 3];
        }
        check_labels(&format!("{error:?}"), &figures::convergence(&study));
    }
    study.levels.clear();
    check_labels("no levels", &figures::convergence(&study));
    study.modes.clear();
    check_labels("no modes", &figures::convergence(&study));
}

fn comparison(name: &str, modes: usize) -> Comparison {
    let (_, tower) = input(name);
    let column = |method| ColumnSpec {
        method,
        segments: (method != Method::Spectral).then_some(20),
    };
    let options = with!(Options, modes);
    compare(
        &tower,
        &Method::ALL.map(column),
        &mut Solver::new(options.clone()),
        |_, _| (),
    )
    .expect("solvable")
}

/// Of 60 modes 14 lines and 40 rows of dots are drawn.
#[test]
fn modes_that_are_not_drawn_are_counted_in_the_picture() {
    let segments = [40, 80].map(Fineness::Segments);
    let study = convergence("nrel-5mw.toml", Method::RmjeExact, &segments, 60);
    let figure = figures::convergence(&study);
    assert!(says(&figure, "46 more modes"));
    check("60 modes converge", &figure);
    let figure = figures::error(&comparison("nrel-5mw.toml", 60));
    assert!(says(&figure, "20 more modes"));
    check("60 modes differ", &figure);
}

#[test]
fn differences_are_readable() {
    for name in ["nrel-5mw.toml", "reference-tower.toml", "floating.toml"] {
        for modes in [1, 4, 8, 50] {
            let figure = figures::error(&comparison(name, modes));
            check(&format!("{name}, {modes} modes"), &figure);
        }
    }
}

/// Every method is in the legend except the reference solution.
#[test]
fn methods_are_named_and_rounding_is_at_the_foot() {
    let mut study = comparison("nrel-5mw.toml", 3);
    let has = |study: &Comparison, text: &str| {
        let figure = figures::error(study);
        figure.labels().iter().any(|label| label.text == text)
    };
    assert!(has(&study, "rmje-exact (20 segments)") && has(&study, "bmodes (20 elements)"));
    let degree = study.columns[6].degree.expect("of the reference solution");
    assert!(!has(&study, &format!("spectral (degree {degree})")));
    assert!(!has(&study, "< 10⁻¹²"));
    study.columns[0].frequencies_hz[1] = Some(study.modes[1].frequency_hz);
    study.columns[0].relative_differences[1] = Some(0.0);
    study.columns[0].frequencies_hz[2] = None;
    study.columns[0].relative_differences[2] = None;
    assert!(has(&study, "< 10⁻¹²"));
    let figure = figures::error(&study);
    assert_eq!(figure.table.rows[1][2], "0");
    assert_eq!(figure.table.rows[2][2], "");
    study
        .columns
        .retain(|column| column.method == Method::Spectral);
    check_labels("the beam alone", &figures::error(&study));
    study.columns.clear();
    check_labels("no method", &figures::error(&study));
    study.modes.clear();
    check_labels("no modes", &figures::error(&study));
}
