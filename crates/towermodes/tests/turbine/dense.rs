//! Counts of random turbines against the eigenvalues of dense Hermitian matrices.
//!
//! The matrices are assembled here in other coordinates by other formulas: Hermite cubics relative
//! to the hub, which span the same space as elements of degree 3, and the second order of their
//! motion by hand for blades that only bend. Unknowns: tower, yaw, relative rotation of the rotor,
//! rotation of the generator, and the blade in each of three harmonics.

use nalgebra::{Complex, DMatrix, DVector, Matrix3, RowDVector, Vector3};

use super::{SECTION, blade, straight, tower};
use towermodes::turbine::{Turbine, TurbineDescription, TurbineMesh, TurbineModel};
use towermodes::{BladeSection, Inertia, TowerDescription};
use towermodes_testing::parts;

pub(super) type Real = DMatrix<f64>;
type Hermitian = DMatrix<Complex<f64>>;

pub(super) const TOWER_ELEMENTS: usize = 2;
const BORDERS: [f64; 4] = [0.0, 0.3, 0.65, 1.0];
/// Unknowns of a clamped beam of Hermite cubics: deflection and slope at each node.
const OF_TOWER: usize = 2 * TOWER_ELEMENTS;
const OF_BLADE: usize = 2 * (BORDERS.len() - 1);
/// Places of the unknowns.
const YAW: usize = 2 * OF_TOWER;
const ROLL: usize = YAW + 1;
const GENERATOR: usize = ROLL + 1;
const FIRST_HARMONIC: usize = GENERATOR + 1;
const ALL: usize = FIRST_HARMONIC + 3 * 2 * OF_BLADE;

/// Points and weights on [0, 1], exact to degree 11 (Abramowitz & Stegun, table 25.4).
pub(super) const GAUSS: [(f64, f64); 6] = [
    (0.03376524289842399, 0.08566224618958518),
    (0.16939530676686773, 0.1803807865240693),
    (0.38069040695840156, 0.23395696728634552),
    (0.6193095930415985, 0.23395696728634552),
    (0.8306046932331322, 0.1803807865240693),
    (0.966234757101576, 0.08566224618958518),
];

/// Numbers in (0, 1) that follow from a seed.
pub(super) struct Numbers(pub(super) u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        let Self(state) = self;
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// A tower and a machine on it, none of whose numbers is special.
pub(super) fn random(seed: u64) -> (TowerDescription, TurbineDescription) {
    let mut n = Numbers(seed);
    for _ in 0..10 {
        n.next();
    }
    let mut tower = tower();
    let bending = parts::planes(n.between(1e11, 4e11), n.between(1e11, 4e11));
    for station in &mut tower.properties {
        station.properties.bending_n_m2 = bending;
        station.properties.torsion_n_m2 = f64::INFINITY;
    }
    let mut machine = straight();
    let inertia = [(); 6].map(|()| n.between(0.5, 1.0));
    let [x, y, z, xy, xz, yz] = inertia;
    machine.nacelle.inertia_kg_m2 =
        Inertia::from([2e5 * x, 9e5 * y, 9e5 * z, 3e4 * xy, -3e4 * xz, 2e4 * yz]);
    machine.nacelle.center_m = [n.between(-1.0, 2.0), n.between(-0.5, 0.5), 1.5];
    machine.yaw_n_m_per_rad = n.between(3e8, 3e9);
    machine.overhang_m = n.between(-6.0, 6.0);
    machine.tilt_rad = n.between(-0.2, 0.2);
    machine.cone_rad = n.between(-0.2, 0.2);
    machine.hub.center_m = n.between(-0.5, 0.5);
    machine.shaft_n_m_per_rad = n.between(1e8, 1e9);
    machine.generator.gear_ratio = n.between(1.0, 3.0);
    machine.generator.is_locked = seed.is_multiple_of(2);
    let root = BladeSection {
        mass_kg_per_m: n.between(150.0, 400.0),
        flap_n_m2: n.between(1e9, 4e9),
        edge_n_m2: n.between(3e9, 9e9),
        ..SECTION
    };
    machine.blade = blade(root);
    machine.blade.borders = BORDERS.to_vec();
    machine.blade.pitch_rad = n.between(-0.5, 1.5);
    machine.blade.sections[1].mass_kg_per_m *= n.between(0.2, 1.0);
    machine.blade.sections[1].flap_n_m2 *= n.between(0.2, 1.0);
    machine.blade.sections[1].edge_n_m2 *= n.between(0.2, 1.0);
    (tower, machine)
}

/// Deflection, slope and curvature at a fraction of an element for (w₀, w₀′, w₁, w₁′).
pub(super) fn hermite(s: f64, l: f64) -> [[f64; 4]; 3] {
    let (s2, s3) = (s * s, s * s * s);
    [
        [
            1.0 - 3.0 * s2 + 2.0 * s3,
            l * (s - 2.0 * s2 + s3),
            3.0 * s2 - 2.0 * s3,
            l * (s3 - s2),
        ],
        [
            (6.0 * s2 - 6.0 * s) / l,
            1.0 - 4.0 * s + 3.0 * s2,
            (6.0 * s - 6.0 * s2) / l,
            3.0 * s2 - 2.0 * s,
        ],
        [
            (12.0 * s - 6.0) / (l * l),
            (6.0 * s - 4.0) / l,
            (6.0 - 12.0 * s) / (l * l),
            (6.0 * s - 2.0) / l,
        ],
    ]
}

/// Calls `visit` at the points of a clamped beam with fraction of the length, weight in m, and the
/// rows of deflection, slope and curvature for its unknowns.
fn along(borders: &[f64], length_m: f64, mut visit: impl FnMut(f64, f64, [RowDVector<f64>; 3])) {
    let unknowns = 2 * (borders.len() - 1);
    for (element, border) in borders.windows(2).enumerate() {
        let own_m = (border[1] - border[0]) * length_m;
        for (s, weight) in GAUSS {
            let rows = hermite(s, own_m).map(|values| {
                let mut row = RowDVector::zeros(unknowns);
                for (k, value) in values.into_iter().enumerate() {
                    // The root is held.
                    if let Some(place) = (2 * element + k).checked_sub(2) {
                        row[place] = value;
                    }
                }
                row
            });
            let expected = border[0] + s * (border[1] - border[0]);
            visit(expected, weight * own_m, rows);
        }
    }
}

fn cross(v: Vector3<f64>) -> Matrix3<f64> {
    v.cross_matrix()
}

/// The matrices of a turbine: stiffness, mass, and those of one blade.
pub(super) struct Dense {
    /// Real parts that depend on nothing: K and M without the blades.
    stiffness: Real,
    mass: Real,
    /// Rotation of the rotor across the shaft, rows for θ₂ and θ₃, and the spin per speed.
    across: [RowDVector<f64>; 2],
    spin: f64,
    /// The motion of the hub in the axes of the shaft.
    hub: Real,
    /// Kₑ, M, C and K_g − S of a blade for the hub's motion and its own unknowns.
    blade: [Real; 4],
    /// Unknowns that exist.
    existing: Vec<usize>,
}

impl Dense {
    fn of(tower: &TowerDescription, machine: &TurbineDescription) -> Self {
        let nothing = Real::zeros(0, 0);
        Self::on([nothing.clone(), nothing], tower, machine)
    }

    /// On something with this stiffness and mass, whose first six unknowns are the motion of the
    /// tower's foot: the last unknowns of the whole.
    pub(super) fn on(
        below: [Real; 2],
        tower: &TowerDescription,
        machine: &TurbineDescription,
    ) -> Self {
        let size = ALL + below[0].nrows();
        let [mut stiffness, mut mass] = below.map(|below| {
            let mut all = Real::zeros(size, size);
            let own = (below.nrows(), below.nrows());
            all.view_mut((ALL, ALL), own).copy_from(&below);
            all
        });
        let top = add_tower(tower, &mut stiffness, &mut mass);
        let mut nacelle = top;
        nacelle[(5, YAW)] = 1.0;
        stiffness[(YAW, YAW)] += machine.yaw_n_m_per_rad;
        let body = &machine.nacelle;
        let own = body_inertia(body.mass_kg, body.center_m, body.inertia_kg_m2.tensor());
        mass += nacelle.transpose() * own * &nacelle;
        let mut hub = to_apex(machine) * nacelle;
        let generator_row = hub.row(3).into_owned();
        hub[(3, ROLL)] += 1.0;
        let of_hub = &machine.hub;
        let (polar, transverse) = (of_hub.polar_inertia_kg_m2, of_hub.transverse_inertia_kg_m2);
        let tensor = [
            [polar, 0.0, 0.0],
            [0.0, transverse, 0.0],
            [0.0, 0.0, transverse],
        ];
        let own = body_inertia(of_hub.mass_kg, [of_hub.center_m, 0.0, 0.0], tensor);
        mass += hub.transpose() * own * &hub;
        let generator = &machine.generator;
        let mut turned = generator_row;
        turned[GENERATOR] += generator.gear_ratio;
        mass += generator.inertia_kg_m2 * turned.transpose() * turned;
        let mut twist = RowDVector::zeros(size);
        (twist[ROLL], twist[GENERATOR]) = (1.0, -1.0);
        stiffness += machine.shaft_n_m_per_rad * twist.transpose() * twist;
        let exists = |place: &usize| !(generator.is_locked && *place == GENERATOR);
        Self {
            stiffness,
            mass,
            across: [hub.row(4).into_owned(), hub.row(5).into_owned()],
            spin: polar + generator.gear_ratio * generator.inertia_kg_m2,
            hub,
            blade: blade_matrices(machine),
            existing: (0..size).filter(exists).collect(),
        }
    }

    /// The number of negative eigenvalues of H.
    pub(super) fn count(&self, w: f64, speed: f64) -> usize {
        let real = &self.stiffness - w * w * &self.mass;
        let mut all = real.map(|entry| Complex::new(entry, 0.0));
        let [second, third] = &self.across;
        let spun = second.transpose() * third - third.transpose() * second;
        all += spun.map(|entry| Complex::new(0.0, w * speed * self.spin * entry));
        for (place, turn) in [(0, 0.0), (1, 1.0), (2, -1.0)] {
            let s = w - turn * speed;
            let [elastic, mass, coriolis, spin] = &self.blade;
            let real = elastic + speed * speed * spin - s * s * mass;
            let own = real.zip_map(coriolis, |re, c| Complex::new(re, 2.0 * s * speed * c));
            let map = self.harmonic(place, turn);
            all += map.adjoint() * own * map;
        }
        let existing = all
            .select_rows(&self.existing)
            .select_columns(&self.existing);
        let eigenvalues = existing.symmetric_eigenvalues();
        eigenvalues.iter().filter(|value| **value < 0.0).count()
    }

    /// What a blade feels in a harmonic: √3 times the phasor of the hub's motion, and its unknowns.
    fn harmonic(&self, place: usize, turn: f64) -> Hermitian {
        let mut projection = Hermitian::zeros(6, 6);
        for first in [0, 3] {
            if turn == 0.0 {
                projection[(first, first)] = Complex::new(1.0, 0.0);
                continue;
            }
            let (a, b) = (first + 1, first + 2);
            projection[(a, a)] = Complex::new(0.5, 0.0);
            projection[(b, b)] = Complex::new(0.5, 0.0);
            projection[(a, b)] = Complex::new(0.0, 0.5 * turn);
            projection[(b, a)] = Complex::new(0.0, -0.5 * turn);
        }
        let hub = self
            .hub
            .map(|entry| Complex::new(3_f64.sqrt() * entry, 0.0));
        let mut map = Hermitian::zeros(6 + 2 * OF_BLADE, hub.ncols());
        map.rows_mut(0, 6).copy_from(&(projection * hub));
        for k in 0..2 * OF_BLADE {
            let own = FIRST_HARMONIC + place * 2 * OF_BLADE + k;
            map[(6 + k, own)] = Complex::new(1.0, 0.0);
        }
        map
    }
}

/// Adds a tower, which moves with its foot if that has unknowns; returns the motion of its top.
fn add_tower(tower: &TowerDescription, stiffness: &mut Real, mass: &mut Real) -> Real {
    let size = mass.nrows();
    let rigid = |z: f64| {
        let mut motion = Real::zeros(6, size);
        if size > ALL {
            let lever = -cross(z * Vector3::z());
            motion
                .view_mut((0, ALL), (6, 6))
                .copy_from(&Real::identity(6, 6));
            motion.view_mut((0, ALL + 3), (3, 3)).copy_from(&lever);
        }
        motion
    };
    let properties = &tower.properties[0].properties;
    let bending = properties.bending_n_m2;
    let borders: Vec<f64> = (0..=TOWER_ELEMENTS)
        .map(|k| k as f64 / TOWER_ELEMENTS as f64)
        .collect();
    for (plane, flexure) in [bending.fore_aft, bending.side_side]
        .into_iter()
        .enumerate()
    {
        let first = plane * OF_TOWER;
        along(&borders, 80.0, |s, weight, [deflection, _, curvature]| {
            let rigid = rigid(80.0 * s);
            let mut deflects = rigid.row(plane).into_owned();
            let mut own = deflects.columns_mut(first, OF_TOWER);
            own += deflection;
            let mut k = stiffness.view_mut((first, first), (OF_TOWER, OF_TOWER));
            k += weight * flexure * curvature.transpose() * curvature;
            *mass += weight * properties.mass_kg_per_m * deflects.transpose() * deflects;
            // Both planes pass here: half of what does not bend.
            for (component, density) in [
                (2, properties.mass_kg_per_m),
                (5, properties.polar_inertia_kg_m),
            ] {
                let moved = rigid.row(component).into_owned();
                *mass += 0.5 * weight * density * moved.transpose() * moved;
            }
        });
    }
    let mut top = rigid(80.0);
    top[(0, OF_TOWER - 2)] += 1.0;
    top[(4, OF_TOWER - 1)] += 1.0;
    top[(1, 2 * OF_TOWER - 2)] += 1.0;
    top[(3, 2 * OF_TOWER - 1)] -= 1.0;
    top
}

pub(super) fn body_inertia(mass: f64, center: [f64; 3], tensor: [[f64; 3]; 3]) -> Real {
    let mut motion = Real::zeros(3, 6);
    motion
        .view_mut((0, 0), (3, 3))
        .copy_from(&Matrix3::identity());
    let lever = -cross(Vector3::from(center));
    motion.view_mut((0, 3), (3, 3)).copy_from(&lever);
    let mut inertia = mass * motion.transpose() * motion;
    let mut own = inertia.view_mut((3, 3), (3, 3));
    own += Matrix3::from_fn(|i, j| tensor[i][j]);
    inertia
}

fn to_apex(machine: &TurbineDescription) -> Real {
    let (sin, cos) = machine.tilt_rad.sin_cos();
    let along = Vector3::new(cos, 0.0, sin);
    let turn = Matrix3::from_rows(&[
        along.transpose(),
        Vector3::y().transpose(),
        Vector3::new(-sin, 0.0, cos).transpose(),
    ]);
    let apex = Vector3::z() * machine.tower_to_shaft_m + along * machine.overhang_m;
    let mut matrix = Real::zeros(6, 6);
    matrix.view_mut((0, 0), (3, 3)).copy_from(&turn);
    matrix.view_mut((3, 3), (3, 3)).copy_from(&turn);
    let lever = -(turn * cross(apex));
    matrix.view_mut((0, 3), (3, 3)).copy_from(&lever);
    matrix
}

/// Kₑ, M, C and K_g − S for the hub's motion, flap and edge, in (axis, against the rotation,
/// radial): d₁ = u + θ × x₀ + w e_f + v e_y, and the steady force f = ρ cos B in the plane.
fn blade_matrices(machine: &TurbineDescription) -> [Real; 4] {
    let size = 6 + 2 * OF_BLADE;
    let [mut elastic, mut mass, mut coriolis, mut spin] = [(); 4].map(|()| Real::zeros(size, size));
    let description = &machine.blade;
    let (root_m, tip_m) = (description.hub_radius_m, description.tip_radius_m);
    let length_m = tip_m - root_m;
    let [inner, outer] = [&description.sections[0], &description.sections[1]];
    let mix = |value: fn(&BladeSection) -> f64, s: f64| value(inner) * (1.0 - s) + value(outer) * s;
    let density = |s: f64| mix(|section| section.mass_kg_per_m, s);
    let (sin, cos) = machine.cone_rad.sin_cos();
    let flap = Vector3::new(cos, 0.0, -sin);
    let span = Vector3::new(sin, 0.0, cos);
    let axis = cross(Vector3::x());
    let (sin_pitch, cos_pitch) = description.pitch_rad.sin_cos();
    along(
        &BORDERS,
        length_m,
        |s, weight, [deflection, slope, curvature]| {
            let dm = weight * density(s);
            let radius_m = root_m + s * length_m;
            let place = radius_m * span;
            let mut motion = Real::zeros(3, size);
            motion
                .view_mut((0, 0), (3, 3))
                .copy_from(&Matrix3::identity());
            motion.view_mut((0, 3), (3, 3)).copy_from(&-cross(place));
            motion
                .view_mut((0, 6), (3, OF_BLADE))
                .copy_from(&(flap * &deflection));
            let edge = Vector3::y() * &deflection;
            motion
                .view_mut((0, 6 + OF_BLADE), (3, OF_BLADE))
                .copy_from(&edge);
            mass += dm * motion.transpose() * &motion;
            coriolis += dm * motion.transpose() * axis * &motion;
            let across = Matrix3::from_diagonal(&Vector3::new(0.0, 1.0, 1.0));
            spin -= dm * motion.transpose() * across * &motion;
            let force = radius_m * cos * Vector3::z();
            let turned = Matrix3::identity() * force.dot(&place)
                - 0.5 * (force * place.transpose() + place * force.transpose());
            let mut of_rotation = spin.view_mut((3, 3), (3, 3));
            of_rotation += dm * turned;
            for (first, direction) in [(6, flap), (6 + OF_BLADE, Vector3::y())] {
                let block = -dm * direction.cross(&force) * &deflection;
                let mut right = spin.view_mut((3, first), (3, OF_BLADE));
                right += &block;
                let mut left = spin.view_mut((first, 3), (OF_BLADE, 3));
                left += block.transpose();
                // Tension by what is outside.
                let outside = GAUSS.map(|(t, weight)| {
                    let at = s + t * (1.0 - s);
                    weight * (1.0 - s) * length_m * density(at) * (root_m + at * length_m)
                });
                let tension = cos * cos * outside.iter().sum::<f64>();
                let mut own = spin.view_mut((first, first), (OF_BLADE, OF_BLADE));
                own += weight * tension * slope.transpose() * &slope;
            }
            let row = |w: f64, v: f64| {
                let mut row = RowDVector::zeros(size);
                row.columns_mut(6, OF_BLADE).copy_from(&(w * &curvature));
                row.columns_mut(6 + OF_BLADE, OF_BLADE)
                    .copy_from(&(v * &curvature));
                row
            };
            let (in_flap, in_edge) = (row(cos_pitch, -sin_pitch), row(sin_pitch, cos_pitch));
            let flexure = |value: fn(&BladeSection) -> f64| weight * mix(value, s);
            elastic += flexure(|b| b.flap_n_m2) * in_flap.transpose() * in_flap;
            elastic += flexure(|b| b.edge_n_m2) * in_edge.transpose() * in_edge;
        },
    );
    [elastic, mass, coriolis, spin]
}

/// Random frequencies up to 12 Hz and speeds in both directions, up to those where the stiffness is
/// indefinite: no count is wrong.
#[test]
fn counts_are_those_of_dense_matrices() {
    let mesh = TurbineMesh {
        tower_elements: TOWER_ELEMENTS,
        tower_degree: 3,
        blade_degree: 3,
    };
    let mut indefinite = 0;
    for seed in 1..=10 {
        let (tower, machine) = random(seed);
        let dense = Dense::of(&tower, &machine);
        let turbine = Turbine::new(tower, machine).expect("a turbine");
        let mut model = TurbineModel::new(&turbine, &mesh).expect("a model");
        let mut n = Numbers(1000 + seed);
        for _ in 0..100 {
            let (w, rpm) = (n.between(0.01, 75.0), n.between(-134.0, 134.0));
            let speed = super::rad_per_s(rpm);
            let counted = model.count(w / std::f64::consts::TAU, rpm);
            let expected = dense.count(w, speed);
            assert_eq!(counted, expected, "turbine {seed}: {w} and {speed} rad/s");
            indefinite += usize::from(model.negative_stiffness(rpm) > 0);
        }
    }
    // Both theorems are tested.
    assert!((100..900).contains(&indefinite), "{indefinite}");
}

#[test]
fn hermite_cubics_are_one_where_they_should_be() {
    let ends = [hermite(0.0, 2.0), hermite(1.0, 2.0)];
    let values = DVector::from_iterator(
        4,
        [ends[0][0][0], ends[0][1][1], ends[1][0][2], ends[1][1][3]],
    );
    assert!((values - DVector::from_element(4, 1.0)).norm() < 1e-15);
}
