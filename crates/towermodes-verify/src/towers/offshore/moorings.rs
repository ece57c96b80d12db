//! Mooring systems: those of public floaters, and small ones with free points, bodies and rods.

use towermodes::mooring::{
    Attachment, Carrier, LineType, MooringBody, MooringDescription, MooringLine, MooringPoint,
    MooringRod, RodEnd,
};

use super::text::{cells, numbers};

/// A mooring system from tables as text: points as `support | x y z | mass volume` (the last column
/// may be omitted), lines as `type length | point point`, both counted from 1. The support of a
/// point is `fixed`, `vessel`, `free`, `b1` (a body), `A1` or `B1` (an end of a rod).
///
/// # Panics
/// If a table is wrong.
pub fn mooring(
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
        points: cells(points).map(|row| point(&row)).collect(),
        lines: cells(lines).map(|row| line(&row)).collect(),
        ..MooringDescription::default()
    }
}

fn point(row: &[&str]) -> MooringPoint {
    let load = row.get(2).map_or([0.0; 2], |load| numbers(load));
    let index = |text: &str| text.parse::<usize>().expect("a number from 1") - 1;
    let attachment = match row[0].split_at(1) {
        ("f", "ixed") => Attachment::Fixed,
        ("v", "essel") => Attachment::Platform,
        ("f", "ree") => Attachment::Free,
        ("b", body) => Attachment::Body(index(body)),
        ("A", rod) => Attachment::Rod(index(rod), RodEnd::A),
        ("B", rod) => Attachment::Rod(index(rod), RodEnd::B),
        _ => panic!("{row:?}"),
    };
    MooringPoint {
        attachment,
        position_m: numbers(row[1]),
        mass_kg: load[0],
        volume_m3: load[1],
    }
}

fn line(row: &[&str]) -> MooringLine {
    let [kind, length_m] = numbers(row[0]);
    MooringLine {
        line_type: kind as usize - 1,
        length_m,
        points: numbers::<2>(row[1]).map(|end| end as usize - 1),
    }
}

/// OC3-Hywind, from FAST v8 CertTest 24.
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
    mooring(
        320.0,
        9.80665,
        &[LineType::new(0.09, 77.7066, 384.243e6)],
        points,
        lines,
    )
}

/// The OC4 semi-submersible, from FAST v8 CertTest 25.
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
    mooring(
        200.0,
        9.80665,
        &[LineType::new(0.0766, 113.35, 7.536e8)],
        points,
        lines,
    )
}

/// VolturnUS-S, from the model IEA-15-240-RWT-UMaineSemi.
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
    mooring(
        200.0,
        9.81,
        &[LineType::new(0.333, 685.0, 3.27e9)],
        points,
        lines,
    )
}

/// The mooring of VolturnUS-S in windIO: anchors at 837.8 m, fairleads on the axes of the columns.
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
    mooring(depth_m, 9.81, &[chain], points, lines)
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
    mooring(
        200.0,
        9.80665,
        &[LineType::new(0.127, 116.027, 1.5e9)],
        points,
        lines,
    )
}

fn chain() -> LineType {
    LineType::new(0.16, 561.25, 2.304e9)
}

fn rope() -> LineType {
    LineType::new(0.12, 14.0, 6e7)
}

/// Three lines, each with a clump weight of 8 t at a free point.
pub fn clump() -> MooringDescription {
    let points = "
        fixed | 300 519.6152 -150
        free | 100 173.2051 -110 | 8000 1
        vessel | 15 25.9808 -15
        fixed | -600 0 -150
        free | -200 0 -110 | 8000 1
        vessel | -30 0 -15
        fixed | 300 -519.6152 -150
        free | 100 -173.2051 -110 | 8000 1
        vessel | 15 -25.9808 -15";
    let lines = "
        1 405 | 1 2
        1 195 | 2 3
        1 405 | 4 5
        1 195 | 5 6
        1 405 | 7 8
        1 195 | 8 9";
    mooring(150.0, 9.80665, &[chain()], points, lines)
}

/// Each line ends in a free point with two bridles.
pub fn delta() -> MooringDescription {
    let points = "
        fixed | 310 536.9358 -180
        free | 22.5 38.9711 -95
        vessel | -3.3809 7.2505 -75
        vessel | 7.9696 0.6972 -75
        fixed | -620 0 -180
        free | -45 0 -95
        vessel | -4.5886 -6.5532 -75
        vessel | -4.5886 6.5532 -75
        fixed | 310 -536.9358 -180
        free | 22.5 -38.9711 -95
        vessel | 7.9696 -0.6972 -75
        vessel | -3.3809 -7.2505 -75";
    let lines = "
        1 586 | 1 2
        1 46 | 2 3
        1 46 | 2 4
        1 586 | 5 6
        1 46 | 6 7
        1 46 | 6 8
        1 586 | 9 10
        1 46 | 10 11
        1 46 | 10 12";
    mooring(
        180.0,
        9.80665,
        &[LineType::new(0.14, 430.0, 1.8e9)],
        points,
        lines,
    )
}

/// Two submerged buoys with three tethers and a chain to the platform each.
pub fn buoys() -> MooringDescription {
    let points = "
        vessel | 20 3 -15
        vessel | -20 3 -15
        fixed | 90 80 -150
        b1 | 0 2 -2
        fixed | 20.718 -40 -150
        b1 | -1.7321 -1 -2
        fixed | 159.282 -40 -150
        b1 | 1.7321 -1 -2
        b1 | 0 0 2.5
        fixed | -90 80 -150
        b2 | 0 2 -2
        fixed | -159.282 -40 -150
        b2 | -1.7321 -1 -2
        fixed | -20.718 -40 -150
        b2 | 1.7321 -1 -2
        b2 | 0 0 2.5";
    let lines = "
        1 115 | 3 4
        1 115 | 5 6
        1 115 | 7 8
        2 90 | 9 1
        1 115 | 10 11
        1 115 | 12 13
        1 115 | 14 15
        2 90 | 16 2";
    let types = [rope(), LineType::new(0.08, 140.0, 6e8)];
    let mut buoys = mooring(150.0, 9.80665, &types, points, lines);
    buoys.bodies = [90.0, -90.0].map(buoy).to_vec();
    buoys
}

fn buoy(x_m: f64) -> MooringBody {
    MooringBody {
        carrier: Carrier::Free,
        position_m: [x_m, 0.0, -60.0],
        angles_rad: [0.0; 3],
        mass_kg: 40e3,
        center_m: [0.1, 0.0, -0.5],
        inertia_kg_m2: [4e4, 4e4, 3e4],
        volume_m3: 60.0,
    }
}

/// A body and a rod that are fixed to the platform; lines end there.
pub fn coupled() -> MooringDescription {
    let points = "
        fixed | 500 300 -150
        fixed | -550 0 -150
        fixed | 500 -300 -150
        b1 | 25 8 -12
        b1 | -25 0 -12
        B1 | 0 0 0";
    let lines = "
        1 580 | 1 4
        1 545 | 2 5
        1 580 | 3 6";
    let mut coupled = mooring(150.0, 9.80665, &[chain()], points, lines);
    coupled.bodies = vec![MooringBody {
        carrier: Carrier::Platform,
        position_m: [1.0, 0.0, -5.0],
        angles_rad: [0.0; 3],
        mass_kg: 200e3,
        center_m: [0.5, 0.0, -8.0],
        inertia_kg_m2: [1e6; 3],
        volume_m3: 250.0,
    }];
    coupled.rods = vec![MooringRod {
        carrier: Carrier::Platform,
        ends_m: [[20.0, -6.0, -5.0], [27.0, -9.0, -17.0]],
        diameter_m: 1.2,
        mass_kg_per_m: 900.0,
    }];
    coupled
}

/// A free rod between a chain and a rope, and two plain chains.
pub fn rod() -> MooringDescription {
    let points = "
        fixed | 500 0 -150
        vessel | 30 0 -10
        fixed | -300 500 -150
        vessel | -20 20 -10
        fixed | -300 -500 -150
        vessel | -20 -20 -10
        A1 | 0 0 0
        B1 | 0 0 0";
    let lines = "
        1 390 | 1 7
        2 75 | 8 2
        1 585 | 3 4
        1 585 | 5 6";
    let mut rod = mooring(150.0, 9.80665, &[chain(), rope()], points, lines);
    rod.rods = vec![MooringRod {
        carrier: Carrier::Free,
        ends_m: [[140.0, 0.0, -110.0], [100.0, 0.0, -60.0]],
        diameter_m: 1.5,
        mass_kg_per_m: 1000.0,
    }];
    rod
}

/// Ropes lighter than water between anchors and fairleads at nearly the same height.
pub fn buoyant() -> MooringDescription {
    let points = "
        fixed | 150 259.8076 -40
        vessel | 15 25.9808 -15
        fixed | -300 0 -40
        vessel | -30 0 -15
        fixed | 150 -259.8076 -40
        vessel | 15 -25.9808 -15";
    let lines = "
        1 266 | 1 2
        1 266 | 3 4
        1 266 | 5 6";
    mooring(
        200.0,
        9.80665,
        &[LineType::new(0.2, 22.0, 4e7)],
        points,
        lines,
    )
}
