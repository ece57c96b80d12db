//! Rectangular members against their integrals by hand, turned and mirrored members, and a frame
//! that carries one.
//!
//! Reference: the formulas of `Morison.f90` (OpenFAST 5): with sides a along x and b along y the
//! added mass per length is ρ π b²/4 CaB along x and ρ π a²/4 CaA along y.

use std::f64::consts::PI;

use towermodes::RigidBody;
use towermodes::frame::{
    FrameDescription, FrameJoint, FrameMember, JointKind, MemberKind, Rectangle, SectionEnds,
};
use towermodes::{Material, space::SpatialMatrix};
use towermodes_files::HydrodynInput;

use super::texts::{Layout, deck, read};

const RHO: f64 = 1025.0;
/// Digits of the integrals.
const EXACT: f64 = 1e-12;
/// Sides, wall.
const BOX: &str = "1 5 3 0.2";
/// CdA CdAMG CdB CdBMG CaA CaAMG CaB CaBMG Cp CpMG AxCd AxCdMG AxCa AxCaMG.
const SIMPLE: &str = "1 1 1 1 0.8 0.9 1.1 1.3 1 1 0 0 0.5 0.6";

#[track_caller]
fn assert_close(found: f64, expected: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= EXACT, "{found}, expected {expected}");
}

/// A file of OpenFAST 4.1 with these rows of rectangular sections; the member's row is
/// `ID J1 J2 P1 P2 MSecGeom MSpinOrient MDivSize MCoefMod PropPot`.
fn text(sections: &str, changes: &[(&str, &str)]) -> String {
    let mut all = vec![("NMembers", "1 1 2 1 1 2 0 0.5 1 F")];
    all.splice(0..0, changes.iter().copied());
    let tables = format!(
        "------- RECTANGLES -------\n{} NPropSetsRec - rows\nMPropSetID PropA PropB PropThck\n(-) (m) (m) (m)\n{sections}\n\
         ------- SIMPLE RECTANGLES -------\nSimplCdA SimplCdAMG SimplCdB SimplCdBMG SimplCaA SimplCaAMG SimplCaB SimplCaBMG \
         SimplCp SimplCpMG SimplAxCd SimplAxCdMG SimplAxCa SimplAxCaMG\n(-)\n{SIMPLE}\n\
         ------- DEPTHS -------\n2 NCoefDpthRec - rows\nDpth DpthCaA DpthCaAMG DpthCaB DpthCaBMG\n(m)\n0 1 1 2 2\n-30 2 2 4 4\n\
         ------- MEMBERS -------\n1 NCoefMembersRec - rows\nMemberID MemberCaA1 MemberCaA2 MemberCaAMG1 MemberCaAMG2 MemberCaB1 \
         MemberCaB2 MemberCaBMG1 MemberCaBMG2\n(-)\n1 0 2 0 0 1 3 0 0\n",
        sections.lines().count()
    );
    deck(Layout::V41, &all)
        .replace("MSecGeom MDivSize", "MSecGeom MSpinOrient MDivSize")
        .replace("------- OUTPUT", &format!("{tables}------- OUTPUT"))
}

fn input(sections: &str, changes: &[(&str, &str)]) -> HydrodynInput {
    read(&text(sections, changes)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_box_has_the_added_mass_of_each_direction() {
    let input = input(BOX, &[]);
    let added = input.strip_added_mass();
    // 30 m are in the water; its end counts as a circle of its area, with 0.6.
    assert_close(added[0][0], RHO * 1.1 * PI * 9.0 / 4.0 * 30.0);
    assert_close(added[1][1], RHO * 0.8 * PI * 25.0 / 4.0 * 30.0);
    assert_close(
        added[2][2],
        0.6 * RHO * 2.0 / 3.0 * 15.0_f64.powf(1.5) / PI.sqrt(),
    );
    let filling = input.filling();
    let mass = 1000.0 * 4.6 * 2.6 * 25.0;
    assert_close(filling.mass_kg, mass);
    assert_close(filling.center_m[2], -17.5);
    let inertia = filling.inertia_kg_m2;
    assert_close(inertia.xx, mass * (2.6 * 2.6 + 625.0) / 12.0);
    assert_close(inertia.yy, mass * (4.6 * 4.6 + 625.0) / 12.0);
    assert_close(inertia.zz, mass * (4.6 * 4.6 + 2.6 * 2.6) / 12.0);
}

#[test]
fn spin_turns_the_section() {
    let added = |spin: &str| {
        let row = format!("1 1 2 1 1 2 {spin} 0.5 1 F");
        input(BOX, &[("NMembers", &row)]).strip_added_mass()
    };
    let [own, turned, half] = ["0", "90", "30"].map(added);
    assert_close(turned[0][0], own[1][1]);
    assert_close(turned[1][1], own[0][0]);
    // x cos² 30° + y sin² 30°, and their difference sin 30° cos 30° between the axes.
    assert_close(half[0][0], 0.75 * own[0][0] + 0.25 * own[1][1]);
    assert_close(half[0][1], 0.1875_f64.sqrt() * (own[0][0] - own[1][1]));
}

#[test]
fn coefficients_are_those_of_the_model_of_the_member() {
    let added = |model: u8| {
        let row = format!("1 1 2 1 1 2 0 0.5 {model} F");
        input(BOX, &[("NMembers", &row)]).strip_added_mass()
    };
    // By depth CaB rises from 2 at 0 m to 4 at -30 m, by member from 1 at −30 m to 3 at 10 m.
    let per_ca = RHO * PI * 9.0 / 4.0;
    assert_close(added(2)[0][0], per_ca * 3.0 * 30.0);
    assert_close(added(3)[0][0], per_ca * (1.0 + 0.75) * 30.0);
    assert_close(added(3)[1][1], RHO * PI * 25.0 / 4.0 * 0.75 * 30.0);
}

#[test]
fn growth_is_around_the_box() {
    let input = input(BOX, &[("NMGDepths", "0 0.1 1100\n-20 0.1 1100")]);
    let ring = 5.2 * 3.2 - 15.0;
    assert_close(input.growth().mass_kg, 1100.0 * ring * 20.0);
    let added = input.strip_added_mass();
    let along_x = 1.3 * 3.2 * 3.2 * 20.0 + 1.1 * 9.0 * 10.0;
    assert_close(added[0][0], RHO * PI / 4.0 * along_x);
}

#[test]
fn a_pyramid_has_added_mass_along_its_axis() {
    // Squares of 6 m at −30 m and 2 m at 10 m: ½ (2 s s') s = s² |s'|, from s = 6 to 3 at the
    // level.
    let row = [("NMembers", "1 1 2 1 2 2 0 0.5 1 F")];
    let input = input("1 6 6 0\n2 2 2 0", &row);
    let of_end = 0.6 * 2.0 / 3.0 * 36.0_f64.powf(1.5) / PI.sqrt();
    let of_side = 0.5 * (216.0 - 27.0) / 3.0;
    assert_close(input.strip_added_mass()[2][2], RHO * (of_end + of_side));
}

#[test]
fn an_inclined_box_floats_on_a_rectangle() {
    // 3-4-5 in the plane of x and z, cos φ = 0.8: side a is along y, side b/cos φ along x.
    let changes = [
        ("NJoints", "1 -9 0 -12 1 0\n2 9 0 12 1 0"),
        ("NFillGroups", ""),
    ];
    let platform = input(BOX, &changes).platform(&RigidBody::default(), 9.8);
    let stiffness = platform.platform.hydrostatic.matrix;
    let (along, across) = (3.0 / 0.8, 5.0);
    assert_close(stiffness[2][2], RHO * 9.8 * along * across);
    let buoyancy = -15.0 * 15.0 * 6.0;
    let second = |of: f64, other: f64| other * of.powi(3) / 12.0;
    assert_close(
        stiffness[3][3],
        RHO * 9.8 * (second(across, along) + buoyancy),
    );
    assert_close(
        stiffness[4][4],
        RHO * 9.8 * (second(along, across) + buoyancy),
    );
}

/// An inclined box with its filling and the stiffness of its water plane; joints as rows.
fn whole(joints: &str, spin: f64) -> [SpatialMatrix; 2] {
    let row = format!("1 1 2 1 1 2 {spin} 0.5 1 F");
    let input = input(BOX, &[("NJoints", joints), ("NMembers", &row)]);
    let platform = input.platform(&RigidBody::default(), 9.8).platform;
    [input.strip_added_mass(), platform.hydrostatic.matrix]
}

#[track_caller]
fn assert_same(found: &SpatialMatrix, expected: &SpatialMatrix) {
    let size = expected
        .iter()
        .flatten()
        .fold(0.0_f64, |a, x| a.max(x.abs()));
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!(
            (found - expected).abs() <= EXACT * size,
            "{found}, expected {expected}"
        );
    }
}

/// R A Rᵀ for the motions and the rotations, with signs of a mirror for both.
fn seen(matrix: &SpatialMatrix, rotation: &[[f64; 3]; 3], of_rotations: f64) -> SpatialMatrix {
    let full = |i: usize, j: usize| match (i / 3, j / 3) {
        (0, 0) => rotation[i][j],
        (1, 1) => of_rotations * rotation[i - 3][j - 3],
        _ => 0.0,
    };
    let entry = |i: usize, j: usize| {
        let pairs = (0..6).flat_map(|k| (0..6).map(move |l| (k, l)));
        pairs
            .map(|(k, l)| full(i, k) * matrix[k][l] * full(j, l))
            .sum()
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

#[test]
fn a_turned_or_mirrored_box_has_the_turned_or_mirrored_matrices() {
    let ends = [[-2.0, 3.0, -25.0], [7.0, 9.0, 8.0]];
    let joints = |of: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let row = |(id, end): (usize, &[f64; 3])| {
            let [x, y, z] = of(*end);
            format!("{id} {x} {y} {z} 1 0")
        };
        let rows: Vec<String> = [1, 2].into_iter().zip(&ends).map(row).collect();
        rows.join("\n")
    };
    let own = whole(&joints(&|end| end), 25.0);
    let (sin, cos) = 0.7_f64.sin_cos();
    let turn = [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]];
    let turned = whole(
        &joints(&|[x, y, z]| [cos * x - sin * y, sin * x + cos * y, z]),
        25.0,
    );
    // Rotations are mirrored as axial vectors, and the section turns the other way.
    let mirror = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
    let mirrored = whole(&joints(&|[x, y, z]| [x, -y, z]), -25.0);
    for (i, own) in own.iter().enumerate() {
        assert_same(&turned[i], &seen(own, &turn, 1.0));
        assert_same(&mirrored[i], &seen(own, &mirror, -1.0));
    }
}

#[test]
fn a_frame_carries_the_water_of_a_box() {
    let input = input(BOX, &[("NMGDepths", "0 0.1 1100\n-40 0.1 1100")]);
    let joint = |name: &str, z_m: f64| FrameJoint {
        name: name.to_owned(),
        position_m: [0.0, 0.0, z_m],
        kind: JointKind::Cantilever,
    };
    let section = Rectangle {
        side_a_m: 5.0,
        side_b_m: 3.0,
        wall_thickness_m: 0.2,
    };
    let kind = MemberKind::Beam {
        ends: SectionEnds::Rectangle([section; 2]),
        material: Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10),
    };
    let mut frame = FrameDescription {
        joints: vec![joint("1", -30.0), joint("2", 10.0)],
        members: vec![FrameMember::new("1", [0, 1], kind)],
        ..FrameDescription::default()
    };
    let notes = input.put_on_frame(&mut frame);
    assert!(frame.members[0].coats.is_empty());
    let said = notes
        .iter()
        .any(|note| note.message.contains("are rectangular"));
    assert!(said, "{notes:?}");
    let moving = |i: usize| {
        let riders = frame.riders.iter().map(|rider| rider.inertia[i][i]);
        let on_joints = frame.added_masses.iter().map(|(_, matrix)| matrix[i][i]);
        let masses = frame.masses.iter().map(|(_, body)| body.mass_kg);
        riders.chain(on_joints).chain(masses).sum::<f64>()
    };
    let solid_kg = input.growth().mass_kg + input.filling().mass_kg;
    for i in 0..3 {
        assert_close(moving(i), input.strip_added_mass()[i][i] + solid_kg);
    }
    // The turning inertia of the solids is that about the axis.
    let turning: f64 = frame.riders.iter().map(|rider| rider.inertia[5][5]).sum();
    let of_water = input.strip_added_mass()[5][5];
    let ring = |a: f64, b: f64| a * b * (a * a + b * b) / 12.0;
    let growth = 1100.0 * (ring(5.2, 3.2) - ring(5.0, 3.0)) * 30.0;
    assert_close(turning, of_water + growth + 1000.0 * ring(4.6, 2.6) * 25.0);
}
