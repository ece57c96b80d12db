//! Mooring systems from tables of text, and those of public floaters.

use towermodes::mooring::{
    Attachment, LineType, Mooring, MooringDescription, MooringLine, MooringPoint, MooringState,
    Pose, RodEnd,
};
use towermodes_testing::{number, numbers, rows};

/// Points as `what holds it | x y z | mass volume`, lines as `type length | point point`, both
/// counted from 1.
pub fn deck(
    depth_m: f64,
    gravity_m_per_s2: f64,
    line_types: &[LineType],
    points: &str,
    lines: &str,
) -> MooringDescription {
    MooringDescription {
        depth_m,
        gravity_m_per_s2,
        line_types: line_types.to_vec(),
        points: rows(points)
            .map(|[holder, at, load]| point(holder, at, load))
            .collect(),
        lines: rows(lines).map(|[kind, ends]| line(kind, ends)).collect(),
        ..MooringDescription::default()
    }
}

fn point(holder: &str, at: &str, load: &str) -> MooringPoint {
    let [mass_kg, volume_m3] = if load.is_empty() {
        [0.0; 2]
    } else {
        numbers(load)
    };
    let attachment = match holder.split_at(1) {
        ("f", "ixed") => Attachment::Fixed,
        ("v", "essel") => Attachment::Platform,
        ("f", "ree") => Attachment::Free,
        ("b", body) => Attachment::Body(number::<usize>(body) - 1),
        ("A", rod) => Attachment::Rod(number::<usize>(rod) - 1, RodEnd::A),
        ("B", rod) => Attachment::Rod(number::<usize>(rod) - 1, RodEnd::B),
        _ => panic!("{holder}"),
    };
    MooringPoint {
        attachment,
        position_m: numbers(at),
        mass_kg,
        volume_m3,
    }
}

fn line(kind: &str, ends: &str) -> MooringLine {
    let [kind, length_m] = numbers(kind);
    MooringLine {
        line_type: kind as usize - 1,
        length_m,
        points: numbers::<2>(ends).map(|end| end as usize - 1),
    }
}

/// The state at the reference pose.
pub fn at_rest(description: &MooringDescription) -> MooringState {
    let mooring = Mooring::new(description.clone()).expect("a valid mooring");
    mooring.at(&Pose::default()).expect("an equilibrium")
}

/// FAST v8 CertTest 24.
pub fn hywind() -> MooringDescription {
    let points = "
        fixed | 853.87 0 -320
        fixed | -426.94 739.47 -320
        fixed | -426.94 -739.47 -320
        vessel | 5.2 0 -70
        vessel | -2.6 4.5 -70
        vessel | -2.6 -4.5 -70";
    let lines = "
        1 902.2 | 1 4
        1 902.2 | 2 5
        1 902.2 | 3 6";
    deck(
        320.0,
        9.80665,
        &[LineType::new(0.09, 77.7066, 384.243e6)],
        points,
        lines,
    )
}

/// FAST v8 CertTest 25.
pub fn oc4_semi() -> MooringDescription {
    let points = "
        fixed | 418.8 725.383 -200
        fixed | -837.6 0 -200
        fixed | 418.8 -725.383 -200
        vessel | 20.434 35.393 -14
        vessel | -40.868 0 -14
        vessel | 20.434 -35.393 -14";
    let lines = "
        1 835.35 | 1 4
        1 835.35 | 2 5
        1 835.35 | 3 6";
    deck(
        200.0,
        9.80665,
        &[LineType::new(0.0766, 113.35, 7.536e8)],
        points,
        lines,
    )
}

/// IEA-15-240-RWT-UMaineSemi.
pub fn volturnus() -> MooringDescription {
    let points = "
        fixed | -837.6 0 -200
        fixed | 418.8 725.383 -200
        fixed | 418.8 -725.383 -200
        vessel | -58 0 -14
        vessel | 29 50.229 -14
        vessel | 29 -50.229 -14";
    let lines = "
        1 850 | 1 4
        1 850 | 2 5
        1 850 | 3 6";
    deck(
        200.0,
        9.81,
        &[LineType::new(0.333, 685.0, 3.27e9)],
        points,
        lines,
    )
}

/// The same platform in windIO: anchors at 837.8 m, fairleads on the axes of the columns.
pub fn volturnus_windio(chain: LineType) -> MooringDescription {
    let mut mooring = volturnus();
    mooring.line_types = vec![chain];
    for (index, point) in mooring.points.iter_mut().enumerate() {
        let (radius, z) = if index < 3 {
            (837.8, -200.0)
        } else {
            (51.75, -14.001)
        };
        let (sin, cos) = [180.0_f64, 60.0, -60.0][index % 3].to_radians().sin_cos();
        point.position_m = [radius * cos, radius * sin, z];
    }
    mooring
}

/// IEA-22-280-RWT-Semi: its anchors are at 200 m.
pub fn iea_22(depth_m: f64, axial_stiffness_n: f64) -> MooringDescription {
    let points = "
        fixed | -837.8 0 -200
        fixed | 418.9 725.5561 -200
        fixed | 418.9 -725.5561 -200
        vessel | -65 0 -18.144
        vessel | 32.5 56.2917 -18.144
        vessel | 32.5 -56.2917 -18.144";
    let lines = "
        1 837 | 1 4
        1 837 | 2 5
        1 837 | 3 6";
    let chain = LineType::new(0.405, 1007.4375, axial_stiffness_n);
    deck(depth_m, 9.81, &[chain], points, lines)
}

/// The MIT/NREL TLP of the tests of OpenFAST: eight vertical tendons.
pub fn tlp() -> MooringDescription {
    let points = "
        fixed | 27 0 -200
        vessel | 27 0 -47.89
        fixed | 0 27 -200
        vessel | 0 27 -47.89
        fixed | -27 0 -200
        vessel | -27 0 -47.89
        fixed | 0 -27 -200
        vessel | 0 -27 -47.89";
    let lines = "
        1 151.73 | 1 2
        1 151.73 | 1 2
        1 151.73 | 3 4
        1 151.73 | 3 4
        1 151.73 | 5 6
        1 151.73 | 5 6
        1 151.73 | 7 8
        1 151.73 | 7 8";
    deck(
        200.0,
        9.80665,
        &[LineType::new(0.127, 116.027, 1.5e9)],
        points,
        lines,
    )
}
