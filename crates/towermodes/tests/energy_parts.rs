//! The energy of modes by the parts of the tower: against differences of the eigenvalue, which is
//! what the fractions are the derivatives of, and against sums by hand.

use crate::towers;

use towermodes::frame::*;
use towermodes::tower::Tube;
use towermodes::{
    EnergyParts, FloatingPlatform, Foundation, FoundationSprings, Material, Method, Mode, Options,
    Planes, Properties, PropertyStation, Rna, Shear, SoilRow, SoilStiffness, Station,
    TowerDescription,
};
use towermodes_testing::{Close, changed, parts};
use towers::{floater, solved};

/// Every method with its energy by parts, on a mesh of its own that does not depend on the tower.
fn options(method: Method) -> Options {
    Options {
        method,
        segments: (method != Method::Spectral).then_some(24),
        degree: (method == Method::Spectral).then_some(8),
        modes: 8,
        points: 2,
        energy_parts: true,
        ..Options::default()
    }
}

/// A steel tower on a concrete one with everything that has a fraction: springs with inertia, soil,
/// water, added mass, wires, a point mass and an RNA that couples all motions.
fn everything() -> TowerDescription {
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let concrete = Material::from_shear_modulus(2450.0, 3.6e10, 1.5e10);
    let station = |height_m, diameter, wall, material| Station {
        material,
        ..Station::new(height_m, diameter, wall)
    };
    let soil = |height_m, k| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: k,
            y_n_per_m2: 1.2 * k,
            z_n_per_m2: 0.3 * k,
            torsion_n: 2.0 * k,
            rotation_x_n: 20.0 * k,
            rotation_y_n: 20.0 * k,
        },
    };
    TowerDescription {
        materials: vec![steel, concrete],
        stations: vec![
            station(-20.0, 7.0, 0.4, 1),
            station(30.0, 6.0, 0.35, 1),
            station(30.0, 6.0, 0.04, 0),
            station(100.0, 4.0, 0.02, 0),
        ],
        shear: Shear::Cowper,
        rna: Rna {
            mass_kg: 250e3,
            center_m: [-2.0, 0.4, 2.5],
            inertia_kg_m2: towermodes::Inertia {
                xx: 4e7,
                yy: 2.2e7,
                zz: 2.5e7,
                ..Default::default()
            },
        },
        point_masses: vec![parts::point_mass(60.0, 30e3, Default::default())],
        foundation: Foundation::Springs(parts::springs(4e8, 3e10, -5e8, 3e9, 2e10)),
        soil: vec![vec![soil(-20.0, 4e7), soil(0.0, 1e7)]],
        water: Some(parts::water(20.0, Some(0.0), 1025.0, 1.0, true)),
        wires: vec![parts::wires(70.0, 3, 4e5, 40.0)],
        ..TowerDescription::default()
    }
}

/// A change of a tower by a factor of one of its parts, and what the part has of the energy.
struct Part {
    name: &'static str,
    scale: fn(&mut TowerDescription, f64),
    /// The fraction of the strain energy less that of the kinetic energy.
    fraction: fn(&EnergyParts) -> f64,
}

fn scale_moduli(material: &mut Material, factor: f64) {
    material.youngs_modulus_pa *= factor;
    material.shear_modulus_pa *= factor;
}

fn scale_springs(description: &mut TowerDescription, factor: f64) {
    let Foundation::Springs(springs) = &mut description.foundation else {
        panic!("the tower has springs");
    };
    springs.lateral_n_per_m *= factor;
    springs.rocking_n_m *= factor;
    springs.coupling_n *= factor;
    springs.vertical_n_per_m *= factor;
    springs.torsion_n_m *= factor;
}

fn scale_soil(description: &mut TowerDescription, factor: f64) {
    for row in description.soil.iter_mut().flatten() {
        row.stiffness.x_n_per_m2 *= factor;
        row.stiffness.y_n_per_m2 *= factor;
        row.stiffness.z_n_per_m2 *= factor;
        row.stiffness.torsion_n *= factor;
        row.stiffness.rotation_x_n *= factor;
        row.stiffness.rotation_y_n *= factor;
    }
}

fn scale_rna(description: &mut TowerDescription, factor: f64) {
    let rna = &mut description.rna;
    rna.mass_kg *= factor;
    rna.inertia_kg_m2.xx *= factor;
    rna.inertia_kg_m2.yy *= factor;
    rna.inertia_kg_m2.zz *= factor;
}

const STIFF: [Part; 5] = [
    Part {
        name: "steel",
        scale: |d, factor| scale_moduli(&mut d.materials[0], factor),
        fraction: |parts| parts.strain.materials[0],
    },
    Part {
        name: "concrete",
        scale: |d, factor| scale_moduli(&mut d.materials[1], factor),
        fraction: |parts| parts.strain.materials[1],
    },
    Part {
        name: "foundation",
        scale: scale_springs,
        fraction: |parts| parts.strain.foundation,
    },
    Part {
        name: "soil",
        scale: scale_soil,
        fraction: |parts| parts.strain.soil,
    },
    Part {
        name: "wires",
        scale: |d, factor| d.wires[0].stiffness_n_per_m *= factor,
        fraction: |parts| parts.strain.wires,
    },
];

const GRAVITY: Part = Part {
    name: "gravity",
    scale: |d, factor| d.gravity_m_per_s2 *= factor,
    fraction: |parts| parts.strain.gravity,
};

/// These change the compression by self-weight too, so the tower must have none.
const HEAVY: [Part; 4] = [
    Part {
        name: "tower",
        scale: |d, factor| {
            for material in &mut d.materials {
                material.density_kg_per_m3 *= factor;
            }
        },
        fraction: |parts| -parts.kinetic.tower,
    },
    Part {
        name: "rna",
        scale: scale_rna,
        fraction: |parts| -parts.kinetic.rna,
    },
    Part {
        name: "point mass",
        scale: |d, factor| d.point_masses[0].mass_kg *= factor,
        fraction: |parts| -parts.kinetic.point_masses,
    },
    Part {
        name: "water",
        scale: |d, factor| {
            if let Some(water) = &mut d.water {
                water.density_kg_per_m3 *= factor;
            }
        },
        fraction: |parts| -parts.kinetic.water,
    },
];

fn parts(mode: &Mode) -> &EnergyParts {
    mode.energy_parts.as_ref().expect("the parts are requested")
}

/// d(ln λ)/d(ln factor) of each mode by central differences of four solves: O(h⁴).
fn slopes(description: &TowerDescription, options: &Options, part: &Part) -> Vec<f64> {
    let modes = solved(description, options).modes;
    let logarithms = |factor: f64| -> Vec<f64> {
        let mut changed = description.clone();
        (part.scale)(&mut changed, factor);
        let solution = solved(&changed, options);
        let of = |mode: &Mode| {
            let same = solution.modes.iter().find(|other| other.is_same_as(mode));
            same.map_or(f64::NAN, |same| 2.0 * same.frequency_hz.ln())
        };
        modes.iter().map(of).collect()
    };
    let difference = |h: f64| -> Vec<f64> {
        let (above, below) = (logarithms(h.exp()), logarithms((-h).exp()));
        let pairs = above.iter().zip(&below);
        pairs.map(|(a, b)| (a - b) / (2.0 * h)).collect()
    };
    let (wide, narrow) = (difference(0.01), difference(0.005));
    let pairs = wide.iter().zip(&narrow);
    pairs.map(|(w, n)| n + (n - w) / 3.0).collect()
}

fn assert_slopes(description: &TowerDescription, method: Method, part: &Part) {
    let options = options(method);
    let solution = solved(description, &options);
    let slopes = slopes(description, &options, part);
    // The last modes may leave the list when the tower changes.
    for (mode, slope) in solution.modes[..6].iter().zip(slopes) {
        let fraction = (part.fraction)(parts(mode));
        assert!(
            (fraction - slope).abs() < 1e-7,
            "{} of {} by {}: {fraction}, but the slope is {slope}",
            part.name,
            mode.label(),
            method.name()
        );
    }
}

#[test]
fn fractions_of_stiffness_are_the_slopes_of_the_eigenvalue() {
    let heavy = changed!(everything(), gravity_m_per_s2 = 9.81);
    for method in Method::ALL {
        for part in STIFF.iter().chain([&GRAVITY]) {
            assert_slopes(&heavy, method, part);
        }
    }
}

#[test]
fn fractions_of_masses_are_the_slopes_of_the_eigenvalue() {
    for method in Method::ALL {
        for part in &HEAVY {
            assert_slopes(&everything(), method, part);
        }
    }
}

/// Planes that are equal have one mode for both, and uncoupled motions have subsystems of their
/// own.
#[test]
fn uncoupled_motions_have_the_same_fractions() {
    let mut round = everything();
    round.rna.center_m = [0.0; 3];
    round.rna.inertia_kg_m2 = Default::default();
    for row in round.soil.iter_mut().flatten() {
        row.stiffness.y_n_per_m2 = row.stiffness.x_n_per_m2;
    }
    for method in [Method::RmjeExact, Method::Bmodes, Method::Spectral] {
        for part in &STIFF {
            assert_slopes(&round, method, part);
        }
        let modes = solved(&round, &options(method)).modes;
        assert_eq!(parts(&modes[0]), parts(&modes[1]), "both planes");
    }
}

/// A tower on three legs with a brace, on springs and in soil, with growth, filling, water, a mass
/// on a joint and a transition piece.
fn on_frame() -> TowerDescription {
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let tube = |joints| {
        let section = Tube {
            outer_diameter_m: 2.0,
            wall_thickness_m: 0.03,
        };
        let radii = |outer_radius_m, inner_radius_m, density| CoatKind::Solid {
            density_kg_per_m3: [density; 2],
            outer_radius_m: [outer_radius_m; 2],
            inner_radius_m: [inner_radius_m; 2],
        };
        let coat = |kind| FrameCoat {
            range: [0.2, 0.8],
            kind,
        };
        let mut member = FrameMember::tube("leg", joints, [section; 2], steel);
        member.coats = vec![
            coat(radii(1.1, 1.0, 1325.0)),
            coat(radii(0.97, 0.0, 1025.0)),
            coat(CoatKind::AddedMass {
                density_kg_per_m3: 1025.0,
                radius_m: [1.1; 2],
                across: [0.9; 2],
                along: [0.0; 2],
            }),
        ];
        let springs = SoilStiffness {
            x_n_per_m2: 5e6,
            y_n_per_m2: 6e6,
            z_n_per_m2: 1e6,
            ..SoilStiffness::default()
        };
        let row = |fraction| FrameSoilRow {
            fraction,
            stiffness: springs,
        };
        member.soil = vec![FrameSoil {
            rows: vec![row(0.1), row(0.4)],
        }];
        member
    };
    let support = |joint| FrameSupport {
        fixed: [false; 6],
        stiffness: std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 4e7 } else { 0.0 })),
        inertia: std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 3e3 } else { 0.0 })),
        ..FrameSupport::clamped(joint)
    };
    let frame = towers::tripod(tube, support);
    let mut foundation = towers::carried(frame, &[3], [0.5, 0.0, 1.0]);
    frame_of(&mut foundation).platform.mass_kg = 30e3;
    towers::on_foundation(foundation, 3.0)
}

fn frame_of(foundation: &mut Foundation) -> &mut FrameFoundation {
    match foundation {
        Foundation::Frame(frame) => frame,
        other => panic!("{other:?}"),
    }
}

fn numbers_of(description: &mut TowerDescription) -> &mut FrameDescription {
    frame_of(&mut description.foundation).numbers_mut()
}

fn materials_of(description: &mut TowerDescription) -> impl Iterator<Item = &mut Material> {
    let members = numbers_of(description).members.iter_mut();
    members.filter_map(|member| match &mut member.kind {
        MemberKind::Beam { material, .. } => Some(material),
        _ => None,
    })
}

/// Multiplies the density of the coats that are of a kind.
fn scale_coats(description: &mut TowerDescription, is_own: fn(&CoatKind) -> bool, factor: f64) {
    let members = numbers_of(description).members.iter_mut();
    let coats = members.flat_map(|member| &mut member.coats);
    for coat in coats.filter(|coat| is_own(&coat.kind)) {
        match &mut coat.kind {
            CoatKind::Solid {
                density_kg_per_m3, ..
            } => density_kg_per_m3
                .iter_mut()
                .for_each(|density| *density *= factor),
            CoatKind::AddedMass {
                density_kg_per_m3, ..
            } => *density_kg_per_m3 *= factor,
        }
    }
}

fn has_hole(kind: &CoatKind) -> bool {
    matches!(kind, CoatKind::Solid { inner_radius_m, .. } if inner_radius_m[0] > 0.0)
}

fn is_full(kind: &CoatKind) -> bool {
    matches!(kind, CoatKind::Solid { inner_radius_m, .. } if inner_radius_m[0] == 0.0)
}

fn scale_supports(
    description: &mut TowerDescription,
    matrix: fn(&mut FrameSupport) -> &mut [[f64; 6]; 6],
    factor: f64,
) {
    for support in &mut numbers_of(description).supports {
        let entries = matrix(support).iter_mut().flatten();
        entries.for_each(|entry| *entry *= factor);
    }
}

/// Parts of a tower on a frame: stiffness, then masses.
const OF_FRAME: [Part; 8] = [
    Part {
        name: "members",
        scale: |d, factor| materials_of(d).for_each(|material| scale_moduli(material, factor)),
        fraction: |parts| parts.strain.substructure,
    },
    Part {
        name: "supports",
        scale: |d, factor| scale_supports(d, |support| &mut support.stiffness, factor),
        fraction: |parts| parts.strain.foundation,
    },
    Part {
        name: "soil along members",
        scale: |d, factor| {
            let members = numbers_of(d).members.iter_mut();
            for row in members
                .flat_map(|m| &mut m.soil)
                .flat_map(|soil| &mut soil.rows)
            {
                row.stiffness.x_n_per_m2 *= factor;
                row.stiffness.y_n_per_m2 *= factor;
                row.stiffness.z_n_per_m2 *= factor;
            }
        },
        fraction: |parts| parts.strain.soil,
    },
    Part {
        name: "mass of members and on joints",
        scale: |d, factor| {
            materials_of(d).for_each(|material| material.density_kg_per_m3 *= factor);
            numbers_of(d).masses[0].1.mass_kg *= factor;
        },
        fraction: |parts| -parts.kinetic.substructure,
    },
    Part {
        name: "growth",
        scale: |d, factor| scale_coats(d, has_hole, factor),
        fraction: |parts| -parts.kinetic.growth,
    },
    Part {
        name: "filling",
        scale: |d, factor| scale_coats(d, is_full, factor),
        fraction: |parts| -parts.kinetic.filling,
    },
    Part {
        name: "added mass",
        scale: |d, factor| scale_coats(d, |kind| !has_hole(kind) && !is_full(kind), factor),
        fraction: |parts| -parts.kinetic.water,
    },
    Part {
        name: "transition piece and soil at the supports",
        scale: |d, factor| {
            frame_of(&mut d.foundation).platform.mass_kg *= factor;
            scale_supports(d, |support| &mut support.inertia, factor);
        },
        fraction: |parts| -parts.kinetic.foundation,
    },
];

#[test]
fn fractions_of_a_frame_are_the_slopes_of_the_eigenvalue() {
    for method in [Method::RmjeExact, Method::Spectral] {
        for part in OF_FRAME.iter().chain([&STIFF[0]]) {
            assert_slopes(&on_frame(), method, part);
        }
    }
}

/// Moorings and added mass of a floater have fractions of their own.
#[test]
fn fractions_of_a_platform_are_the_slopes_of_the_eigenvalue() {
    fn of(description: &mut TowerDescription) -> &mut FloatingPlatform {
        match &mut description.foundation {
            Foundation::Floating(platform) => platform,
            other => panic!("{other:?}"),
        }
    }
    fn times(matrix: &mut [[f64; 6]; 6], factor: f64) {
        matrix
            .iter_mut()
            .flatten()
            .for_each(|entry| *entry *= factor);
    }
    let platform = [
        Part {
            name: "moorings",
            scale: |d, factor| times(&mut of(d).mooring.matrix, factor),
            fraction: |parts| parts.strain.moorings,
        },
        Part {
            name: "water plane and buoyancy",
            // A tenth of the change, because buoyancy has several times the energy of the mode.
            scale: |d, factor| times(&mut of(d).hydrostatic.matrix, factor.powf(0.1)),
            fraction: |parts| 0.1 * parts.strain.foundation,
        },
        Part {
            name: "added mass",
            scale: |d, factor| times(&mut of(d).added_mass.matrix, factor),
            fraction: |parts| -parts.kinetic.water,
        },
    ];
    for part in &platform {
        assert_slopes(&floater(), Method::Spectral, part);
    }
}

#[test]
fn fractions_sum_to_one() {
    for method in Method::ALL {
        for description in [everything(), floater(), on_frame()] {
            for mode in &solved(&description, &options(method)).modes {
                let EnergyParts { strain, kinetic } = parts(mode);
                let sum = strain.tower()
                    + strain.substructure
                    + strain.foundation
                    + strain.moorings
                    + strain.soil
                    + strain.wires
                    + strain.gravity;
                let is_free = mode.frequency_hz == 0.0;
                sum.within(if is_free { 0.0 } else { 1.0 }, 1e-12);
                let sum = kinetic.tower
                    + kinetic.rna
                    + kinetic.point_masses
                    + kinetic.substructure
                    + kinetic.growth
                    + kinetic.filling
                    + kinetic.water
                    + kinetic.foundation;
                assert!((sum - 1.0).abs() < 1e-12, "{sum}");
            }
        }
    }
}

#[test]
fn nothing_is_computed_without_a_request() {
    let options = changed!(options(Method::default()), energy_parts = false);
    let modes = solved(&everything(), &options).modes;
    assert!(modes.iter().all(|mode| mode.energy_parts.is_none()));
}

/// A rigid column of 50 m and 1000 kg/m under a point mass on a rocking spring.
fn rigid_column() -> TowerDescription {
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 1000.0,
            rotary_inertia_kg_m: Planes::default(),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(1e22),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    };
    TowerDescription {
        properties: vec![row(0.0), row(50.0)],
        rna: Rna::point(100e3),
        rna_is_point: true,
        foundation: Foundation::Springs(changed!(FoundationSprings::RIGID, rocking_n_m = 2e9)),
        ..TowerDescription::default()
    }
}

/// What a rigid column that turns about its base has of the energy is in no way a matter of modes.
#[test]
fn a_rigid_column_has_the_fractions_of_its_springs_and_masses() {
    let close = |got: f64, expected: f64| assert!((got - expected).abs() < 1e-9, "{got}");
    for method in Method::ALL {
        let options = changed!(options(method), modes = 1);
        let first =
            |description: &TowerDescription| parts(&solved(description, &options).modes[0]).clone();
        let alone = first(&rigid_column());
        close(alone.strain.foundation, 1.0);
        close(alone.strain.tower(), 0.0);
        // m h²/3 of the column, M h² on top.
        let column = 50e3 / 3.0 / (50e3 / 3.0 + 100e3);
        close(alone.kinetic.tower, column);
        close(alone.kinetic.rna, 1.0 - column);

        // Wires at the height h hold with k h², and have k h²/(k h² + k_rocking).
        let wires = parts::wires(40.0, 4, 1e6, 0.0);
        let held = first(&changed!(rigid_column(), wires = vec![wires]));
        let of_wires = 2e6 * 40.0 * 40.0;
        close(held.strain.wires, of_wires / (of_wires + 2e9));

        // Under gravity the weights W h turn over, and the sum is less than the spring alone.
        let heavy = first(&changed!(rigid_column(), gravity_m_per_s2 = 10.0));
        let overturning = 10.0 * (100e3 * 50.0 + 50e3 * 25.0);
        close(heavy.strain.gravity, -overturning / (2e9 - overturning));
        close(heavy.strain.foundation, 2e9 / (2e9 - overturning));
    }
}
