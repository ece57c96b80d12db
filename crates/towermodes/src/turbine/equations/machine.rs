//! Nacelle, drivetrain and rotor (the RNA), condensed to the tower top at a frequency and a rotor
//! speed.

use super::super::description::TurbineDescription;
use super::bordered::Bordered;
use super::gyroscopic::Raise;
use crate::beam::{Condensed, TurningBlade, congruent};
use crate::rotor::{Multiblade, RotorFactors};
use crate::scalar::{Complex, Number};
use crate::space::SpatialMatrix;
use crate::tower::{Inertia, RigidBody, Rna, spatial_inertia};

/// Index of the first joint's coordinate after the motion of the nacelle.
const FIRST_JOINT: usize = 6;
/// Index of the rotation about the shaft, and of that about the tower.
pub(super) const ABOUT_SHAFT: usize = 3;
pub(super) const ABOUT_TOWER: usize = 5;

/// The rotor-nacelle assembly (RNA): everything above the tower.
#[derive(Debug, Clone)]
pub(crate) struct Machine {
    pub(crate) rotor: Multiblade<TurningBlade>,
    /// Inertia of the hub for the motion of the apex, in the axes of the shaft.
    pub(crate) hub: SpatialMatrix,
    /// The motion of the apex in the axes of the shaft for that of the nacelle at the tower top.
    pub(super) to_apex: SpatialMatrix,
    /// Inertia of the nacelle for its motion at the tower top.
    pub(crate) nacelle: SpatialMatrix,
    /// Inertia of the yaw bearing.
    pub(crate) bearing: SpatialMatrix,
    pub(crate) yaw: f64,
    pub(crate) shaft: f64,
    pub(super) generator_inertia: f64,
    pub(crate) gear_ratio: f64,
    pub(super) polar_inertia: f64,
    /// Inertia of the RNA as a rigid body for the motion of the tower top.
    pub(crate) rigid: SpatialMatrix,
    /// Inertia of hub and rigid blades about the shaft, kg m².
    pub(crate) rotor_inertia: f64,
}

/// The factors of an RNA at a frequency.
#[derive(Debug, Clone, Default)]
pub(crate) struct MachineFactors {
    pub(crate) rotor: RotorFactors,
    /// The factors at the joint of the shaft, then at the yaw drive.
    pub(crate) joints: [Bordered; 2],
}

impl Machine {
    pub(crate) fn new(turbine: &TurbineDescription, rotor: Multiblade<TurningBlade>) -> Self {
        let hub = &turbine.hub;
        let across = hub.transverse_inertia_kg_m2;
        let inertia = [hub.polar_inertia_kg_m2, across, across];
        let inertia = Inertia::from([inertia[0], inertia[1], inertia[2], 0.0, 0.0, 0.0]);
        let nacelle = &turbine.nacelle;
        let rotor_inertia =
            hub.polar_inertia_kg_m2 + rotor.blades() as f64 * rotor.body().inertia()[3][3];
        let mut own = Self {
            rotor,
            rotor_inertia,
            rigid: SpatialMatrix::default(),
            hub: spatial_inertia(hub.mass_kg, [hub.center_m, 0.0, 0.0], &inertia),
            to_apex: to_apex(turbine),
            nacelle: spatial_inertia(nacelle.mass_kg, nacelle.center_m, &nacelle.inertia_kg_m2),
            bearing: spatial_inertia(turbine.yaw_bearing_mass_kg, [0.0; 3], &Inertia::default()),
            yaw: turbine.yaw_n_m_per_rad,
            shaft: turbine.shaft_n_m_per_rad,
            generator_inertia: turbine.generator.inertia_kg_m2,
            gear_ratio: turbine.generator.gear_ratio,
            polar_inertia: hub.polar_inertia_kg_m2,
        };
        let rna = own.at_rest(turbine);
        own.rigid = spatial_inertia(rna.mass_kg, rna.center_m, &rna.inertia_kg_m2);
        own
    }

    /// The dynamic stiffness of the RNA at the tower top, at a frequency w and a rotor speed Ω,
    /// rad/s, with its generator locked or free: K + i w G − w² M with all other coordinates
    /// eliminated, without harmonics of the blades that do not move the hub.
    pub(super) fn seen_from_top(
        &mut self,
        (w, speed): (f64, f64),
        raise: Raise,
        is_locked: bool,
    ) -> Condensed {
        let of_blade = |own: f64| raise.inertia_of_blade(own, speed);
        let rotor = self.rotor.seen_with_inertia(w, speed, of_blade);
        let inertia = raise.inertia(w) - w * w;
        let mut own = rotor;
        // The change of the gyroscopic forces of hub and generator.
        let across = raise.by_change * self.spin(speed).abs();
        for component in [4, 5] {
            own.matrix[component][component] += Complex::real(across);
        }
        self.carry(own, (inertia, w * self.spin(speed)), is_locked)
            .0
    }

    /// As above, with its factors.
    pub(crate) fn factorize(
        &self,
        (w, speed): (f64, f64),
        is_locked: bool,
        factors: &mut MachineFactors,
    ) -> Condensed {
        let rotor = self.rotor.factorize(w, speed, &mut factors.rotor);
        let gyroscopic = w * self.spin(speed);
        let (own, joints) = self.carry(rotor, (-w * w, gyroscopic), is_locked);
        factors.joints = joints;
        own
    }

    /// Adds the parts between rotor and tower top, with a coefficient of the inertia, −w² in H(w),
    /// and the gyroscopic entry of hub and generator.
    fn carry(
        &self,
        mut own: Condensed,
        (inertia, gyroscopic): (f64, f64),
        is_locked: bool,
    ) -> (Condensed, [Bordered; 2]) {
        add_inertia(&mut own, inertia, &self.hub);
        own.matrix[4][5] += Complex::new(0.0, gyroscopic);
        own.matrix[5][4] -= Complex::new(0.0, gyroscopic);
        let shaft = self.turn_shaft(inertia, is_locked, &mut own);
        own.matrix = congruent(&own.matrix, &self.to_apex);
        add_inertia(&mut own, inertia, &self.nacelle);
        let yaw = self.turn_yaw(&mut own);
        add_inertia(&mut own, inertia, &self.bearing);
        (own, [shaft, yaw])
    }

    /// The angular momentum of hub and generator about the shaft, N m s.
    pub(super) fn spin(&self, speed: f64) -> f64 {
        speed * (self.polar_inertia + self.gear_ratio * self.generator_inertia)
    }

    /// Inertia of the generator referred to the low-speed shaft, kg m².
    pub(crate) fn generator_at_shaft(&self) -> f64 {
        self.gear_ratio * self.gear_ratio * self.generator_inertia
    }

    /// Whether the shaft has torsional flexibility.
    pub(crate) fn twists(&self) -> bool {
        !self.shaft.is_infinite()
    }

    /// Adds shaft and generator: the rotor turns by θ + g + d about the shaft, with the rotation θ
    /// of the nacelle, g of the generator at the slow end and the twist d.
    ///
    /// Twice the energies are k d² and J (q g′ + θ′)². With the twist as coordinate a stiffness of
    /// any size costs no digits.
    fn turn_shaft(&self, inertia: f64, is_locked: bool, own: &mut Condensed) -> Bordered {
        let inertia = inertia * self.generator_inertia;
        let mut all = Bordered::of(&own.matrix);
        if !is_locked {
            let generator = all.border(ABOUT_SHAFT);
            all.add(generator, generator, self.gear_ratio.powi(2) * inertia);
            all.add_both(ABOUT_SHAFT, generator, self.gear_ratio * inertia);
        }
        if self.twists() {
            let twist = all.border(ABOUT_SHAFT);
            if !is_locked {
                // The inertia of the generator does not rotate with the twist.
                all.add_both(FIRST_JOINT, twist, -self.gear_ratio * inertia);
            }
            all.add(twist, twist, self.shaft);
        }
        all.add(ABOUT_SHAFT, ABOUT_SHAFT, inertia);
        all.condense(own);
        all
    }

    /// Adds the yaw rotation of the nacelle on the tower.
    fn turn_yaw(&self, own: &mut Condensed) -> Bordered {
        let mut all = Bordered::of(&own.matrix);
        if self.yaws() {
            let yaw = all.border(ABOUT_TOWER);
            all.add(yaw, yaw, self.yaw);
        }
        all.condense(own);
        all
    }

    /// Whether the nacelle has a yaw rotation on the tower.
    pub(crate) fn yaws(&self) -> bool {
        !self.yaw.is_infinite()
    }

    /// The RNA as a rigid body without rotation, for its weight and the checks of the tower.
    pub(crate) fn at_rest(&self, turbine: &TurbineDescription) -> Rna {
        let (sin, cos) = turbine.tilt_rad.sin_cos();
        let apex = [
            turbine.overhang_m * cos,
            0.0,
            turbine.tower_to_shaft_m + turbine.overhang_m * sin,
        ];
        let along = |distance_m: f64| [apex[0] + distance_m * cos, 0.0, apex[2] + distance_m * sin];
        let body = |mass_kg: f64, center_m: f64, polar: f64, across: f64| RigidBody {
            mass_kg,
            center_m: along(center_m),
            inertia_kg_m2: about_shaft(polar, across, (sin, cos)),
        };
        let hub = &turbine.hub;
        let (polar, across) = (hub.polar_inertia_kg_m2, hub.transverse_inertia_kg_m2);
        let (count, blade) = (self.rotor.blades() as f64, self.rotor.body().inertia());
        let mass_kg = blade[0][0];
        // m [c]ₓ holds the centre of the blade; over all blades only its part along the shaft
        // remains.
        let center_m = blade[1][5] / mass_kg;
        let mean = 0.5 * (blade[4][4] + blade[5][5]) - mass_kg * center_m * center_m;
        let blades = body(count * mass_kg, center_m, count * blade[3][3], count * mean);
        let all = RigidBody::combined(&[
            turbine.nacelle,
            RigidBody::point(turbine.yaw_bearing_mass_kg, [0.0; 3]),
            body(hub.mass_kg, hub.center_m, polar, across),
            blades,
        ]);
        Rna {
            mass_kg: all.mass_kg,
            center_m: all.center_m,
            inertia_kg_m2: all.inertia_kg_m2,
        }
    }
}

/// The motion of the apex in the axes of the shaft for that of the tower top: u + θ × r, turned.
fn to_apex(turbine: &TurbineDescription) -> SpatialMatrix {
    let (sin, cos) = turbine.tilt_rad.sin_cos();
    let shaft = [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]];
    let x = turbine.overhang_m * cos;
    let z = turbine.tower_to_shaft_m + turbine.overhang_m * sin;
    // −[r]ₓ of the apex r = (x, 0, z).
    let lever = [[0.0, z, 0.0], [-z, 0.0, x], [0.0, -x, 0.0]];
    let mut matrix = [[0.0; 6]; 6];
    for i in 0..3 {
        for j in 0..3 {
            matrix[i][j] = shaft[i][j];
            matrix[3 + i][3 + j] = shaft[i][j];
            matrix[i][3 + j] = (0..3).map(|k| shaft[i][k] * lever[k][j]).sum();
        }
    }
    matrix
}

/// The inertia of a body that is axisymmetric about a tilted shaft.
fn about_shaft(polar: f64, across: f64, (sin, cos): (f64, f64)) -> Inertia {
    let more = polar - across;
    Inertia {
        xx: across + more * cos * cos,
        yy: across,
        zz: across + more * sin * sin,
        xy: 0.0,
        xz: more * sin * cos,
        yz: 0.0,
    }
}

/// Adds a M.
fn add_inertia(own: &mut Condensed, a: f64, inertia: &SpatialMatrix) {
    let entries = own.matrix.as_flattened_mut().iter_mut();
    for (entry, inertia) in entries.zip(inertia.as_flattened()) {
        entry.re += a * inertia;
    }
}
