//! Single lines: those of MAP++, and lines by hand.

use super::decks::{at_rest, deck, hywind, oc4_semi, tlp};
use towermodes::mooring::{LineType, MooringDescription};
use towermodes_testing::{Close, numbers, rows};

/// One line from an anchor at the origin of the seabed to a fairlead.
fn one_line(kind: LineType, length_m: f64, anchor: &str, fairlead: &str) -> MooringDescription {
    let points = format!("fixed | {anchor}\nvessel | {fairlead}");
    deck(
        200.0,
        9.80665,
        &[kind],
        &points,
        &format!("1 {length_m} | 1 2"),
    )
}

/// The tension at the fairlead of line 1 in the summaries of MAP++ 1.20, with friction.
#[test]
fn lines_have_the_tension_of_map() {
    let mut iti = deck(
        150.0,
        9.80665,
        &[LineType::new(0.0809, 130.403, 589.0e6)],
        "fixed | 386.92 171.985 -150
        vessel | 20 20 -4
        fixed | 171.985 386.95 -150
        vessel | 20 20 -4",
        "1 473.312 | 1 2
        1 473.312 | 3 4",
    );
    iti.line_types[0].seabed_friction = 1.0;
    let mut hywind = hywind();
    hywind.line_types[0].seabed_friction = 0.001;
    let mut oc4 = oc4_semi();
    oc4.line_types[0].seabed_friction = 1.0;
    // Horizontal, vertical tension, length on the seabed, tension at the anchor. The summary of OC4
    // is that of single precision, and all print three decimals.
    let summaries = "
        hywind | 736939.302 535728.001 134.785 736845.209 | 3e-8
        oc4 | 909408.441 631704.309 242.346 651246.724 | 2e-6
        iti | 95259.486 257299.002 263.640 0 | 3e-8
        iti 2 | 95363.202 257371.155 263.581 0 | 3e-8";
    for [name, digits, tolerance] in rows(summaries) {
        let [horizontal, vertical, on_seabed, anchor] = numbers(digits);
        let tolerance = tolerance.parse().expect("a number");
        let (mooring, line) = match name {
            "hywind" => (&hywind, 0),
            "oc4" => (&oc4, 0),
            "iti" => (&iti, 0),
            _ => (&iti, 1),
        };
        let line = at_rest(mooring).lines[line];
        line.horizontal_n.close_to(horizontal, tolerance);
        line.vertical_n.close_to(vertical, tolerance);
        line.on_seabed_m.within(on_seabed, 5e-4);
        line.tensions_n[0].within(anchor, 2.0 * tolerance * horizontal);
    }
}

/// V = (z − L)EA/L + wL/2 and the pendulum H/x = 1/(ln(V/V_A)/w + L/EA).
#[test]
fn a_vertical_tendon_is_a_spring_and_a_pendulum() {
    let state = at_rest(&tlp());
    let line = &state.lines[0];
    let displaced = 1025.0 * std::f64::consts::FRAC_PI_4 * 0.127 * 0.127;
    let (w, ea, length) = ((116.027 - displaced) * 9.80665, 1.5e9, 151.73);
    let top = (152.11 - length) * ea / length + 0.5 * w * length;
    line.vertical_n.close_to(top, 1e-12);
    line.tensions_n[0].close_to(top - w * length, 1e-12);
    assert_eq!(line.horizontal_n, 0.0);
    let pendulum = 1.0 / ((top / (top - w * length)).ln() / w + length / ea);
    let k = &state.load.stiffness;
    k[0][0].close_to(8.0 * pendulum, 1e-12);
    k[1][1].close_to(8.0 * pendulum, 1e-12);
    k[2][2].close_to(8.0 * ea / length, 1e-12);
}

/// MAP++ takes a span of 1 cm for the vertical tendons of this platform.
#[test]
fn a_nearly_vertical_tendon_has_the_tension_of_map() {
    let mut leaning = tlp();
    leaning.points[1].position_m[0] += 0.01;
    let line = at_rest(&leaning).lines[0];
    line.horizontal_n.within(246.937, 6e-4);
    line.vertical_n.within(3833338.083, 6e-4);
}

/// A line without weight is a spring of EA/L, straight: T/chord across.
#[test]
fn a_line_without_weight_is_a_spring() {
    let kind = LineType {
        mass_kg_per_m: 0.0,
        diameter_m: 0.0,
        ..LineType::new(0.0, 0.0, 1e8)
    };
    let state = at_rest(&one_line(kind, 100.0, "0 0 -150", "60 0 -69"));
    let chord = 60.0_f64.hypot(81.0);
    let tension = 1e8 * (chord / 100.0 - 1.0);
    state.lines[0].tensions_n[1].close_to(tension, 1e-13);
    let k = &state.load.stiffness;
    k[1][1].close_to(tension / chord, 1e-13);
    let (cos, sin) = (60.0 / chord, 81.0 / chord);
    k[0][0].close_to(1e6 * cos * cos + tension / chord * sin * sin, 1e-12);
    k[0][2].close_to((1e6 - tension / chord) * cos * sin, 1e-12);
    let slack = at_rest(&one_line(kind, 101.0, "0 0 -150", "60 0 -69"));
    assert!(slack.lines[0].is_slack && slack.load.force == [0.0; 6]);
}

/// A line longer than span and height lies loosely: H = 0, and a lift of 1 m lifts w/(1 + V/EA).
#[test]
fn a_slack_line_hangs_straight_down() {
    let kind = LineType::new(0.1, 100.0, 5e8);
    let state = at_rest(&one_line(kind, 600.0, "0 0 -200", "300 0 -20"));
    let w = (100.0 - 1025.0 * std::f64::consts::FRAC_PI_4 * 0.01) * 9.80665;
    // z = V/w + V²/(2 EA w).
    let top = 5e8 * ((1.0 + 2.0 * 180.0 * w / 5e8_f64).sqrt() - 1.0);
    let line = &state.lines[0];
    assert!(line.is_slack && line.horizontal_n == 0.0);
    line.vertical_n.close_to(top, 1e-11);
    line.on_seabed_m.close_to(600.0 - top / w, 1e-12);
    let k = &state.load.stiffness;
    k[2][2].close_to(w / (1.0 + top / 5e8), 1e-11);
    assert_eq!((k[0][0], k[1][1], k[0][2]), (0.0, 0.0, 0.0));
}

/// Irvine 1981: a line of nearly infinite stiffness is the catenary y = a cosh(x/a).
#[test]
fn a_stiff_line_is_a_catenary() {
    let kind = LineType::new(0.0, 100.0, 1e19);
    let (w, a) = (980.665, 150.0_f64);
    // Two points of it, the lower one beyond the lowest.
    let (x_1, x_2) = (-40.0 / a, 210.0 / a);
    let length = a * (x_2.sinh() - x_1.sinh());
    let rise = a * (x_2.cosh() - x_1.cosh());
    let fairlead = format!("250 0 {}", -180.0 + rise);
    let state = at_rest(&one_line(kind, length, "0 0 -180", &fairlead));
    let line = &state.lines[0];
    line.horizontal_n.close_to(w * a, 1e-10);
    line.vertical_n.close_to(w * a * x_2.sinh(), 1e-10);
    assert_eq!(line.on_seabed_m, 0.0);
}

/// The same line from its other end, and turned around its anchor.
#[test]
fn the_order_of_the_ends_does_not_matter() {
    let mut oc4 = oc4_semi();
    oc4.line_types[0].seabed_friction = 0.7;
    let mut reversed = oc4.clone();
    for line in &mut reversed.lines {
        line.points.reverse();
    }
    let (a, b) = (at_rest(&oc4), at_rest(&reversed));
    assert_eq!(a.load, b.load);
    assert_eq!(a.lines[0].tensions_n[0], b.lines[0].tensions_n[1]);
}

/// Friction is no force with a potential: the stiffness leaves it out, at the tension with it.
#[test]
fn the_stiffness_is_symmetric_with_friction() {
    let mut rough = oc4_semi();
    rough.line_types[0].seabed_friction = 1.0;
    let (smooth, rough) = (at_rest(&oc4_semi()), at_rest(&rough));
    let [k, expected] = [&rough.load.stiffness, &smooth.load.stiffness];
    assert_eq!(k[0][4], k[4][0]);
    for i in 0..6 {
        k[i][i].close_to(expected[i][i], 5e-3);
    }
    // The anchor feels less by C_B w L_B.
    let line = &rough.lines[0];
    assert!(line.tensions_n[0] < 0.72 * line.horizontal_n);
}

/// A line that sags to the seabed between two points above it is two lines from there.
#[test]
fn a_line_that_touches_the_seabed_is_two_lines() {
    let chain = LineType::new(0.1, 100.0, 5e8);
    let whole = at_rest(&one_line(chain, 370.0, "0 0 -150", "250 0 -60"));
    let line = &whole.lines[0];
    assert!(
        line.on_seabed_m > 10.0 && line.horizontal_n > 0.0,
        "{line:?}"
    );
    line.extreme_z_m.close_to(-200.0, 1e-14);
    let w = (100.0 - 1025.0 * std::f64::consts::FRAC_PI_4 * 0.01) * 9.80665;
    let lower_n = -line.forces_n[0][2];
    // Each part from its end to the middle of what lies: hanging length, stretched span.
    let half = |vertical_n: f64, height_m: f64| {
        let (h, ea) = (line.horizontal_n, 5e8);
        let laid = 0.5 * line.on_seabed_m;
        let span = laid + h / w * (vertical_n / h).asinh() + h * (laid + vertical_n / w) / ea;
        let part = one_line(
            chain,
            laid + vertical_n / w,
            "0 0 -200",
            &format!("{span} 0 {}", height_m - 200.0),
        );
        let part = at_rest(&part).lines[0];
        part.horizontal_n.close_to(h, 1e-9);
        part.vertical_n.close_to(vertical_n, 1e-9);
        span
    };
    let spans = half(line.vertical_n, 140.0) + half(lower_n, 50.0);
    spans.close_to(250.0, 1e-12);
}

/// A line lighter than water is a heavy one upside down.
#[test]
fn a_line_lighter_than_water_is_a_heavy_one_upside_down() {
    let displaced = 1025.0 * std::f64::consts::FRAC_PI_4 * 0.01;
    let heavy = LineType::new(0.1, displaced + 5.0, 5e8);
    let light = LineType::new(0.1, displaced - 5.0, 5e8);
    // It sags by more than it rises, but is far from the seabed.
    let below = at_rest(&one_line(heavy, 130.0, "0 0 -80", "100 30 -60"));
    let above = at_rest(&one_line(light, 130.0, "0 0 -60", "100 30 -80"));
    let sign = |i: usize| if i == 2 { -1.0 } else { 1.0 };
    for i in 0..3 {
        above.load.force[i].close_to(sign(i) * below.load.force[i], 1e-13);
        for j in 0..3 {
            let expected = sign(i) * sign(j) * below.load.stiffness[i][j];
            above.load.stiffness[i][j].close_to(expected, 1e-12);
        }
    }
}
