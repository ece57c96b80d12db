//! A floater whose members deform: beside the rigid platform of the same masses, in OpenFAST files.

use std::f64::consts::PI;
use std::sync::Arc;

use towermodes::frame::MemberKind;
use towermodes::space::SpatialMatrix;
use towermodes::turbine::TurbineModel;
use towermodes::{
    AddedMassAt, AddedMassTable, Family, Foundation, Inertia, Options, RigidBody, Solution,
    StaticBalance, Tower, TowerDescription, solve,
};
use towermodes_files::{
    InMemory, Input, ReadError, ReadOptions, Source, TowerInput, read_source, write_toml,
};
use towermodes_testing::{Says, with};

use crate::elastodyn::texts::{BLADE, MASSES, TOWER, main_text};
use crate::hydrodyn::texts::{Layout, deck as hydrodyn};
use crate::moorings::texts::MOORDYN_2;
use crate::subdyn::texts::deck as subdyn;

const JOINTS: [[f64; 3]; 11] = [
    [0.0, 0.0, -10.0],
    [15.0, 0.0, -10.0],
    [-7.5, 12.990381, -10.0],
    [-7.5, -12.990381, -10.0],
    [0.0, 0.0, 10.0],
    [15.0, 0.0, 5.0],
    [-7.5, 12.990381, 5.0],
    [-7.5, -12.990381, 5.0],
    [15.0, 0.0, 0.0],
    [-7.5, 12.990381, 0.0],
    [-7.5, -12.990381, 0.0],
];
/// Columns, the outer ones in two parts, then pontoons.
const MEMBERS: [([usize; 2], f64, f64); 10] = [
    ([0, 4], 3.0, 0.03),
    ([1, 8], 4.0, 0.03),
    ([2, 9], 4.0, 0.03),
    ([3, 10], 4.0, 0.03),
    ([8, 5], 4.0, 0.03),
    ([9, 6], 4.0, 0.03),
    ([10, 7], 4.0, 0.03),
    ([0, 1], 1.6, 0.03),
    ([0, 2], 1.6, 0.03),
    ([0, 3], 1.6, 0.03),
];
const DENSITY: f64 = 7850.0;
const PIECE_KG: f64 = 2e4;

fn rows(row: impl Fn(usize) -> String, count: usize) -> String {
    (0..count).map(|i| row(i) + "\n").collect()
}

/// The steel as one rigid body, by the formulas of tubes.
fn steel() -> RigidBody {
    let tube = |&([from, to], diameter_m, wall_m): &([usize; 2], f64, f64)| {
        let (a, b) = (JOINTS[from], JOINTS[to]);
        let along: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
        let length_m = along.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (outer, inner) = (0.5 * diameter_m, 0.5 * diameter_m - wall_m);
        let mass_kg = DENSITY * PI * (outer * outer - inner * inner) * length_m;
        let squares = outer * outer + inner * inner;
        let about_axis = 0.5 * mass_kg * squares;
        let across = mass_kg * (3.0 * squares + length_m * length_m) / 12.0;
        let entry = |i: usize, j: usize| {
            let own = along[i] * along[j] / (length_m * length_m);
            across * f64::from(u8::from(i == j)) + (about_axis - across) * own
        };
        RigidBody {
            mass_kg,
            center_m: std::array::from_fn(|i| 0.5 * (a[i] + b[i])),
            inertia_kg_m2: Inertia {
                xx: entry(0, 0),
                yy: entry(1, 1),
                zz: entry(2, 2),
                xy: -entry(0, 1),
                yz: -entry(1, 2),
                xz: -entry(0, 2),
            },
        }
    };
    RigidBody::combined(&MEMBERS.iter().map(tube).collect::<Vec<_>>())
}

/// Whether the members deform, and whether there is water.
fn read(is_flexible: bool, has_water: bool) -> Result<TowerInput, ReadError> {
    let piece = RigidBody {
        mass_kg: PIECE_KG,
        center_m: [0.0, 0.0, 10.0],
        inertia_kg_m2: Inertia {
            xx: 1e5,
            yy: 1e5,
            zz: 1e5,
            ..Inertia::default()
        },
    };
    let body = match is_flexible {
        true => piece,
        false => RigidBody::combined(&[piece, steel()]),
    };
    let Inertia { xx, yy, zz, .. } = body.inertia_kg_m2;
    let values = [body.mass_kg, body.center_m[2], xx, yy, zz].map(|x| format!("{x:e}"));
    let mut changes = vec![("TowerBsHt", "10"), ("PtfmRefzt", "10")];
    let names = [
        "PtfmMass",
        "PtfmCMzt",
        "PtfmRIner",
        "PtfmPIner",
        "PtfmYIner",
    ];
    changes.extend(names.into_iter().zip(values.iter().map(String::as_str)));
    let free = ["Sg", "Sw", "Hv", "R", "P", "Y"].map(|motion| format!("Ptfm{motion}DOF"));
    changes.extend(free.iter().map(|name| (name.as_str(), "True")));
    let point = |i: usize, rest: &str| {
        let [x, y, z] = JOINTS[i];
        format!("{} {x} {y} {z} {rest}", i + 1)
    };
    let member = |i: usize, rest: &str| {
        let ([from, to], diameter_m, _) = MEMBERS[i];
        let section = [1.6, 3.0, 4.0].iter().position(|d| *d == diameter_m);
        let section = section.expect("a section") + 1;
        format!(
            "{} {} {} {section} {section} {rest}",
            i + 1,
            from + 1,
            to + 1
        )
    };
    let section = |i: usize, before: &str| {
        let diameter_m = [1.6, 3.0, 4.0][i];
        format!("{} {before} {diameter_m} 0.03", i + 1)
    };
    let frame = subdyn(&[
        ("NJoints", &rows(|i| point(i, "1 0 0 0 0"), JOINTS.len())),
        ("NReact", ""),
        ("NInterf", "5 1 1 1 1 1 1 1"),
        ("NMembers", &rows(|i| member(i, "1c 0"), MEMBERS.len())),
        (
            "NPropSetsCyl",
            &rows(|i| section(i, "2.1e11 8.08e10 7850"), 3),
        ),
    ]);
    let water = hydrodyn(
        Layout::V41,
        &[
            ("NJoints", &rows(|i| point(i, "1 0"), JOINTS.len())),
            ("NMembers", &rows(|i| member(i, "1 0.5 1 F"), MEMBERS.len())),
            ("NPropSets", &rows(|i| section(i, ""), 3)),
            ("NFillGroups", "3 2 3 4 -7 1025"),
        ],
    );
    let lines = MOORDYN_2
        .replace("5.2      0.0     -70.0", "15 0 -10")
        .replace("-2.6      4.5     -70.0", "-7.5 12.990381 -10")
        .replace("-2.6     -4.5     -70.0", "-7.5 -12.990381 -10")
        .replace("902.2", "915.0");
    let (sub, hydro) = (u8::from(is_flexible), u8::from(has_water));
    let fst = format!(
        "------- OpenFAST INPUT FILE -------\na semisubmersible\n1 CompElast - switch\n\
         {sub} CompSub - switch\n{hydro} CompHydro - switch\n3 CompMooring - switch\n\
         9.81 Gravity - m/s2\n1025 WtrDens - kg/m3\n320 WtrDpth - m\n0 MSL2SWL - m\n\
         \"main.dat\" EDFile - name\n\"sub.dat\" SubFile - name\n\"wet.dat\" HydroFile - name\n\
         \"lines.dat\" MooringFile - name\n"
    );
    let files = [
        ("main.dat", main_text(5, &changes)),
        ("tower.dat", TOWER.to_owned() + MASSES),
        ("parts\\blade.dat", BLADE.to_owned()),
        ("sub.dat", frame),
        ("wet.dat", water),
        ("lines.dat", lines),
    ];
    let files = InMemory {
        files: files.map(|(name, text)| (name.to_owned(), text)).into(),
    };
    let source = Source {
        name: "model.fst".to_owned(),
        text: fst,
    };
    match read_source(source, &files, &ReadOptions::default())? {
        Input::Tower(input) => Ok(*input),
        Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => panic!("no tower"),
    }
}

fn solved(description: TowerDescription) -> Solution {
    let tower = Tower::new(description).unwrap_or_else(|error| panic!("{error}"));
    let solution = solve(&tower, &with!(Options, modes = 10));
    let solution = solution.unwrap_or_else(|error| panic!("{error}"));
    assert!(solution.certificate.complete);
    solution
}

fn given(is_flexible: bool) -> TowerDescription {
    let input = read(is_flexible, true).unwrap_or_else(|error| panic!("{error}"));
    input.description
}

fn flexible(stiffer: f64) -> TowerDescription {
    stiffened(given(true), stiffer)
}

/// With members that are stiffer by a factor.
fn stiffened(mut description: TowerDescription, stiffer: f64) -> TowerDescription {
    let Foundation::Frame(foundation) = &mut description.foundation else {
        panic!("no frame");
    };
    for member in &mut foundation.numbers_mut().members {
        if let MemberKind::Beam { material, .. } = &mut member.kind {
            material.youngs_modulus_pa *= stiffer;
            material.shear_modulus_pa *= stiffer;
        }
    }
    description
}

#[test]
fn stiff_members_give_the_modes_of_the_rigid_platform() {
    let rigid = solved(given(false));
    let [stiff, real] = [1e5, 1.0].map(|stiffer| solved(flexible(stiffer)));
    has_the_modes_of(&stiff, &rigid);
    let rigid_body = rigid.modes[..6]
        .iter()
        .all(|mode| mode.name().family.is_rigid());
    assert!(rigid_body, "six platform motions");
    let tower = |solution: &Solution| {
        let mut modes = solution.modes.iter();
        let first = modes.find(|mode| mode.name().family == Family::ForeAft);
        first
            .map(|mode| mode.frequency_hz)
            .expect("a mode of the tower")
    };
    // Members that deform are springs in series with the tower; moorings are softer than all.
    let (of_real, of_rigid) = (tower(&real), tower(&rigid));
    assert!(
        (0.3..0.999).contains(&(of_real / of_rigid)),
        "{of_real} {of_rigid}"
    );
    for (a, b) in real.modes[..3].iter().zip(&rigid.modes) {
        let change = a.frequency_hz / b.frequency_hz - 1.0;
        assert!((-0.05..1e-9).contains(&change), "{change:e}");
    }
}

/// What the members deform is less by the factor of their stiffness; under the modes of the tower
/// they are a hundred times as soft.
fn has_the_modes_of(stiff: &Solution, rigid: &Solution) {
    assert_eq!(stiff.modes.len(), rigid.modes.len());
    for (a, b) in stiff.modes.iter().zip(&rigid.modes) {
        let change = a.frequency_hz / b.frequency_hz - 1.0;
        let is_rigid = b.name().family.is_rigid();
        let allowed = if is_rigid { 1e-6 } else { 2e-4 };
        assert!(change.abs() < allowed, "{}: {change:e}", b.frequency_hz);
        assert_eq!(a.name().family, b.name().family, "{}", b.frequency_hz);
    }
}

/// In water whose added mass falls by half up to 3 rad/s, where the tower vibrates.
fn in_waves(mut description: TowerDescription) -> TowerDescription {
    let diagonal = |factor: f64| {
        let mut matrix = SpatialMatrix::default();
        let masses = [2e6, 2e6, 4e6, 4e8, 4e8, 3e8];
        (0..6).for_each(|i| matrix[i][i] = factor * masses[i]);
        matrix
    };
    let platform = description.foundation.floating_mut().expect("it floats");
    platform.added_mass_by_frequency = Some(Arc::new(AddedMassTable {
        zero: diagonal(1.0),
        rows: vec![(0.3, diagonal(0.9)), (3.0, diagonal(0.5))],
        infinite: diagonal(0.6),
    }));
    description
}

#[test]
fn a_turning_rotor_on_stiff_members_is_one_on_a_rigid_platform() {
    let frequencies = |is_flexible: bool| {
        let mut input = read(is_flexible, true).unwrap_or_else(|error| panic!("{error}"));
        let mut description = in_waves(input.description);
        if is_flexible {
            description = stiffened(description, 1e5);
        }
        input.description = description;
        let turbine = input
            .whole_turbine()
            .expect("a turbine")
            .expect("a turbine");
        let mut model = TurbineModel::new(&turbine, &turbine.mesh()).expect("a model");
        model.frequencies(3.0, 6.0).expect("a spectrum").frequencies
    };
    let [stiff, rigid] = [true, false].map(frequencies);
    assert!(
        stiff.len() == rigid.len() && rigid.len() > 6,
        "{}",
        rigid.len()
    );
    for (a, b) in stiff.iter().zip(&rigid) {
        let change = a.lower_hz / b.lower_hz - 1.0;
        assert!(change.abs() < 2e-4, "{}: {change:e}", b.lower_hz);
    }
}

#[test]
fn stiff_members_move_with_the_water_of_their_own_frequency() {
    let solved = |description: TowerDescription, at: AddedMassAt| {
        let tower = Tower::new(in_waves(description)).unwrap_or_else(|error| panic!("{error}"));
        let options = with!(Options, modes = 10, added_mass = at);
        solve(&tower, &options).unwrap_or_else(|error| panic!("{error}"))
    };
    for at in [AddedMassAt::Own, AddedMassAt::Infinite, AddedMassAt::Zero] {
        let [stiff, rigid] = [flexible(1e5), given(false)].map(|of| solved(of, at));
        assert!(stiff.certificate.complete && rigid.certificate.complete);
        has_the_modes_of(&stiff, &rigid);
    }
}

#[test]
fn weights_buoyancy_and_lines_balance_as_those_of_the_rigid_platform() {
    let at_equilibrium = |mut description: TowerDescription| {
        let platform = description.foundation.floating_mut().expect("it floats");
        platform.at_equilibrium = true;
        Tower::new(description).unwrap_or_else(|error| panic!("{error}"))
    };
    let balance = |tower: &Tower| tower.static_balance().expect("it floats under gravity");
    let [a, b] = [true, false].map(|is| Tower::new(given(is)).unwrap_or_else(|e| panic!("{e}")));
    let [a, b] = [&a, &b].map(balance);
    let size = b.weight_n();
    let forces = |of: &StaticBalance| {
        let [x, y, z] = of.residual_force_n;
        [of.weight_n(), of.buoyancy_n, of.lines_n, x, y, z]
    };
    for (a, b) in forces(&a).into_iter().zip(forces(&b)) {
        // The mass of ElastoDyn has seven digits in the text.
        assert!((a - b).abs() < 1e-7 * size, "{a} {b} N");
    }
    let [stiff, rigid] = [flexible(1e5), given(false)].map(at_equilibrium);
    let heave_m = |tower: &Tower| balance(tower).equilibrium.expect("it is held").heave_m;
    let (a, b) = (heave_m(&stiff), heave_m(&rigid));
    assert!(b.abs() > 0.01 && (a / b - 1.0).abs() < 1e-6, "{a} {b} m");
    let [stiff, rigid] = [&stiff, &rigid].map(|tower| {
        solve(tower, &with!(Options, modes = 10)).unwrap_or_else(|error| panic!("{error}"))
    });
    has_the_modes_of(&stiff, &rigid);
}

#[test]
fn a_tower_file_has_the_whole_floater() {
    let description = given(true);
    let (text, notes) = write_toml(&description);
    assert!(notes.is_empty(), "{notes:?}");
    let source = Source {
        name: "floater.toml".to_owned(),
        text,
    };
    let read = read_source(source, &InMemory::default(), &ReadOptions::default());
    let Input::Tower(read) = read.unwrap_or_else(|error| panic!("{error}")) else {
        panic!("no tower");
    };
    let [own, again] = [description, read.description].map(solved);
    for (a, b) in own.modes.iter().zip(&again.modes) {
        let change = a.frequency_hz / b.frequency_hz - 1.0;
        assert!(change.abs() < 1e-12, "{}: {change:e}", a.frequency_hz);
    }
}

#[test]
fn a_floater_needs_water_that_carries_it() {
    let dry = read(true, false).map(|_| ()).expect_err("dry").to_string();
    dry.says_all("model.fst & the substructure of SubDyn has no support & CompHydro");
    let mut description = given(true);
    if let Foundation::Frame(foundation) = &mut description.foundation {
        foundation.restoring = Some(towermodes::frame::Restoring::default());
    }
    let loose = Tower::new(description)
        .map(|_| ())
        .expect_err("nothing holds");
    loose
        .to_string()
        .says_all("gravity & hydrostatic stiffness");
}

/// The rigid platform is the weight of the members: another mass or another centre is a slip.
#[test]
fn another_mass_than_that_of_the_members_is_doubted() {
    let doubts = |change: fn(&mut towermodes::FloatingPlatform)| {
        let mut description = given(true);
        let Foundation::Frame(foundation) = &mut description.foundation else {
            panic!("no frame");
        };
        change(&mut foundation.restoring.as_mut().expect("afloat").platform);
        let tower = Tower::new(description).unwrap_or_else(|error| panic!("{error}"));
        let said = tower.warnings().iter().map(ToString::to_string);
        said.filter(|text| text.starts_with("[foundation] describes a floating platform of"))
            .count()
    };
    assert_eq!(doubts(|_| ()), 0);
    assert_eq!(doubts(|platform| platform.center_m[2] += 0.5), 0);
    assert_eq!(doubts(|platform| platform.center_m[2] += 3.0), 1);
    assert_eq!(doubts(|platform| platform.mass_kg *= 1.3), 1);
}

/// Buoyancy is gravity too: without gravity nothing holds a floater.
#[test]
fn a_floater_has_gravity() {
    let text = write_toml(&given(false)).0;
    let source = || Source {
        name: "floater.toml".to_owned(),
        text: text.clone(),
    };
    let options = with!(ReadOptions, without_gravity = true);
    let refused = read_source(source(), &InMemory::default(), &options).map(|_| ());
    let refused = refused.expect_err("without gravity").to_string();
    refused.says("a floating tower needs gravity");
}
