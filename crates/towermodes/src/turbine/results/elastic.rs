//! The elastic energies of a mode by parts.

use super::super::counts::frequencies::Part;
use super::super::equations::coupled::Split;
use super::super::equations::machine_vectors::Phasors;
use super::super::equations::model::TurbineModel;
use super::energy::{BladeEnergy, TurbineEnergy};
use crate::beam::TurningBlade;
use crate::modes::RigidTower;
use crate::scalar::{Complex, Number};

/// Which of the two sums of forward and backward wave tilts the nacelle, for flap, edge, torsion
/// and axial motion: the sum with deflections as the cosine of the azimuth (up: 1) or the one with
/// the sine.
const COSINE_TILTS: [bool; 4] = [true, false, false, true];

impl TurbineModel {
    /// Twice the elastic energies of a mode.
    pub(super) fn elastic_energy(&mut self, part: Part, vector: &[Complex]) -> TurbineEnergy {
        let blade = self.machine.rotor.body();
        if part.is_some() {
            let blades = blade.strain_energies(vector).map(|collective| BladeEnergy {
                collective,
                ..BladeEnergy::default()
            });
            return TurbineEnergy {
                blades,
                ..TurbineEnergy::default()
            };
        }
        let Split {
            tower,
            joints,
            blades,
            frame,
        } = self.split(vector);
        let [yaw_drive, shaft] = self.machine.springs(joints).map(Complex::norm_squared);
        let base = self.tower.members()[0].base_motion(tower);
        let (of_base, substructure) = self.below.energies(&base, frame);
        let ([fore_aft, side_side, torsion, axial], platform) = self.tower_energy(tower, of_base);
        TurbineEnergy {
            platform,
            substructure,
            tower_fore_aft: fore_aft,
            tower_side_side: side_side,
            tower_torsion: torsion,
            tower_axial: axial,
            yaw_drive,
            shaft,
            blades: by_harmonic(blade, blades, |own| blade.strain_energies(own)),
        }
    }

    /// Energies of the tower in fore-aft bending, side-side bending, torsion and axial motion,
    /// including the energy of a frame below by component of the motion of the base; and of a
    /// floating platform in its six motions.
    ///
    /// Gravity takes energy from the tower; what would be less than nothing is nothing.
    fn tower_energy(&self, x: &[Complex], below: [f64; 6]) -> ([f64; 4], [f64; 6]) {
        let beam = &self.tower.members()[0];
        let mut energies = beam.energies(x);
        let bases = energies.base.iter_mut().zip(below);
        bases.for_each(|(sum, below)| *sum += below);
        let mut held = energies.others;
        let mut platform = [0.0; 6];
        match &self.platform {
            None => held
                .iter_mut()
                .zip(energies.base)
                .for_each(|(sum, base)| *sum += base),
            Some(rigid) => {
                let total = energies.base.iter().sum::<f64>().max(0.0);
                let motions = rigid_motions(rigid, &beam.base_motion(x));
                platform = motions.map(Complex::norm_squared);
                let scale = total / platform.iter().sum::<f64>().max(f64::MIN_POSITIVE);
                platform.iter_mut().for_each(|energy| *energy *= scale);
            }
        }
        let [x, y, z, about_x, about_y, about_z] = held;
        let held = [x + about_y, y + about_x, about_z, z];
        let own = energies.strain.iter().zip(held);
        let mut own = own.map(|(strain, held)| (strain + held).max(0.0));
        (std::array::from_fn(|_| own.next().unwrap_or(0.0)), platform)
    }

    /// The motion of the tower top.
    pub(crate) fn top(&self, tower: &[Complex]) -> Phasors {
        let along = self.tower.members()[0].motions_along(tower, 1);
        along.last().map_or_else(Phasors::default, |(_, top)| *top)
    }
}

/// The motions surge to yaw of a motion of the base: square roots of twice their kinetic energies
/// divided by the square of the frequency.
pub(super) fn rigid_motions(rigid: &RigidTower, base: &Phasors) -> [Complex; 6] {
    let [re, im] = [base.map(|x| x.re), base.map(|x| x.im)].map(|a| rigid.coordinates(&a));
    std::array::from_fn(|i| Complex::new(re[i], im[i]))
}

/// Energies of the blades by motion and harmonic, from the energies of the coordinates of a blade.
fn by_harmonic(
    blade: &TurningBlade,
    blades: &[Complex],
    energies: impl Fn(&[Complex]) -> [f64; 4],
) -> [BladeEnergy; 4] {
    let count = blade.degrees_of_freedom();
    let [collective, forward, backward] = [0, 1, 2].map(|k| &blades[k * count..(k + 1) * count]);
    let root = 0.5_f64.sqrt();
    let mixed = |sign: f64| -> Vec<Complex> {
        let pairs = forward.iter().zip(backward);
        pairs
            .map(|(a, b)| (*a + b.times(sign)).times(root))
            .collect()
    };
    let all = [collective, forward, backward].map(&energies);
    let [cosine, sine] = [mixed(1.0), mixed(-1.0)].map(|own| energies(&own));
    std::array::from_fn(|motion| {
        let waves = [cosine[motion], sine[motion]];
        let [tilt, yaw] = match COSINE_TILTS[motion] {
            true => waves,
            false => [waves[1], waves[0]],
        };
        BladeEnergy {
            collective: all[0][motion],
            forward: all[1][motion],
            backward: all[2][motion],
            tilt,
            yaw,
        }
    })
}
