//! The shape of a mode, from its vector.

use std::f64::consts::TAU;
use std::ops::Range;

use super::super::counts::frequencies::Part;
use super::super::equations::coupled::Split;
use super::super::equations::machine_vectors::JOINTS;
use super::super::equations::model::TurbineModel;
use super::elastic::rigid_motions;
use super::shape::{BladeDeflection, TowerMotion, TurbineShape};
use crate::rotor::Reactionless;
use crate::scalar::{Complex, Number, Scalar};

/// Least number of points along the tower, and along a blade.
const POINTS: usize = 20;
/// Azimuths at which the largest deflection of a blade is sought.
const AZIMUTHS: u32 = 72;

/// A shape, the places of the strains in the vector, and square roots of other energies.
type Shaped = (TurbineShape, [Range<usize>; 2], Vec<Complex>);

impl TurbineModel {
    pub(crate) fn shape(&self, part: Part, w: f64, vector: &[Complex]) -> Shaped {
        let mut shaped = match part {
            None => self.coupled_shape(w, vector),
            Some(wave) => self.shape_on_still_hub(wave, vector),
        };
        normalize(&mut shaped.0);
        shaped
    }

    fn coupled_shape(&self, w: f64, vector: &[Complex]) -> Shaped {
        let Split {
            tower: of_tower,
            joints,
            blades,
            frame,
        } = self.split(vector);
        let beam = &self.tower.members()[0];
        let top = self.top(of_tower);
        let apex = self.machine.apex_motion(&top, joints);
        let rotor = &self.machine.rotor;
        let blade = rotor.body();
        let (count, steps) = (blade.degrees_of_freedom(), per_element(blade.elements()));
        // Coordinates are those of a blade times the square root of the number of blades.
        let each = 1.0 / (rotor.blades() as f64).sqrt();
        let along = [0, 1, 2].map(|harmonic| {
            let own = &blades[harmonic * count..(harmonic + 1) * count];
            blade.translations((&rotor.felt(harmonic, &apex), own), steps)
        });
        let deflection = |k: usize| {
            let at = |harmonic: usize| along[harmonic][k].1.map(|x: Complex| x.times(each));
            BladeDeflection {
                radius_m: along[0][k].0,
                harmonics: [at(0), at(1), at(2), [Complex::default(); 3]],
                waves: 0,
            }
        };
        let motions = beam
            .motions_along(of_tower, per_element(self.elements()))
            .into_iter();
        let shape = TurbineShape {
            tower: motions
                .map(|(height_m, motion)| TowerMotion { height_m, motion })
                .collect(),
            apex: self.machine.nacelle_at_apex(&top, joints),
            blades: (0..along[0].len()).map(deflection).collect(),
        };
        let first = of_tower.len() + JOINTS;
        let tower = self.base_coordinates()..of_tower.len();
        let mut springs = self.machine.springs(joints).to_vec();
        if let Some(rigid) = &self.platform {
            let motions = rigid_motions(rigid, &beam.base_motion(of_tower));
            springs.extend(motions.map(|x| x.times(w)));
        }
        springs.extend(self.below.strains(frame));
        (shape, [tower, first..first + blades.len()], springs)
    }

    fn shape_on_still_hub(&self, wave: Reactionless, vector: &[Complex]) -> Shaped {
        let blade = self.machine.rotor.body();
        let still = [Complex::default(); 6];
        let along = blade.translations((&still, vector), per_element(blade.elements()));
        let waves = match wave {
            Reactionless::Forward(waves) | Reactionless::Alternating(waves) => waves as isize,
            Reactionless::Backward(waves) => -(waves as isize),
        };
        let blades = along.into_iter().map(|(radius_m, motion)| {
            let none = [Complex::default(); 3];
            BladeDeflection {
                radius_m,
                harmonics: [none, none, none, motion],
                waves,
            }
        });
        let shape = TurbineShape {
            tower: Vec::new(),
            apex: still,
            blades: blades.collect(),
        };
        (shape, [0..0, 0..vector.len()], Vec::new())
    }

    fn elements(&self) -> usize {
        self.tower.members()[0].elements()
    }

    fn base_coordinates(&self) -> usize {
        self.tower.members()[0].base_coordinates()
    }
}

fn per_element(elements: usize) -> usize {
    POINTS.div_ceil(elements.max(1))
}

/// Scales so that the largest translation is 1 and real.
fn normalize(shape: &mut TurbineShape) {
    let mut largest = Complex::real(1.0);
    let mut size = 0.0;
    for point in translations(shape) {
        let of_point: f64 = point.iter().map(|x| x.norm_squared()).sum();
        if of_point > size {
            size = of_point;
            let larger = |a: Complex, b: Complex| match b.norm_squared() > a.norm_squared() {
                true => b,
                false => a,
            };
            let first = point.into_iter().fold(point[0], larger);
            // The phase of the largest component, and the magnitude of the whole shape.
            largest = first.times((of_point / first.norm_squared()).sqrt());
        }
    }
    if size == 0.0 {
        return;
    }
    let inverse = largest.conj().over(largest.norm_squared());
    let tower = shape.tower.iter_mut().flat_map(|point| &mut point.motion);
    let blades = shape
        .blades
        .iter_mut()
        .flat_map(|point| point.harmonics.as_flattened_mut());
    let all = tower.chain(&mut shape.apex).chain(blades);
    all.for_each(|entry| *entry = *entry * inverse);
}

/// Translations of the tower, and of the blades at a few azimuths.
fn translations(shape: &TurbineShape) -> Vec<[Complex; 3]> {
    let tower = shape
        .tower
        .iter()
        .map(|point| [point.motion[0], point.motion[1], point.motion[2]]);
    let azimuths = (0..AZIMUTHS).map(|k| TAU * f64::from(k) / f64::from(AZIMUTHS));
    let tip = shape.blades.last();
    let blades = azimuths.filter_map(|azimuth| Some(tip?.at(azimuth)));
    tower.chain(blades).collect()
}
