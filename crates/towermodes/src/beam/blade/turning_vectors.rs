//! A rotating blade condensed to the apex of its rotor, and its motion: solutions and products at a
//! frequency, energies, and the curve of its axis.

use super::super::elimination::{Condensed, TurningMatrix, condense_blade, factorize_blade};
use super::super::product::sweep_down;
use super::super::strain::Strain;
use super::super::substitution::{reduce_down, substitute_up};
use super::phasors::{InertiaMatrix, inertia_loads, motions_along};
use super::turning::{BladeFactors, TurningBlade, both, congruent};
use crate::scalar::{Complex, Number};
use crate::space::{transform_force, transform_matrix, transform_motion};
use crate::tower::Plane;

impl TurningBlade {
    /// The blade for the motion of the apex of the rotor, in (axis of the rotor, against the
    /// rotation, radial), at a frequency in the turning frame and a speed, rad/s: D with the
    /// coordinates of the blade eliminated.
    pub fn seen_from_apex(&mut self, frequency: f64, speed: f64) -> Condensed {
        self.seen_with_inertia(frequency, speed, 0.0)
    }

    /// The same for D + a M with this a, rad²/s².
    pub fn seen_with_inertia(&mut self, frequency: f64, speed: f64, added: f64) -> Condensed {
        let mut work = std::mem::take(&mut self.factors);
        let mut a = self.matrix(frequency, speed);
        a.inertia += added;
        let condensed = condense_blade(&self.beam, &a, &mut work.factors);
        self.factors = work;
        self.at_apex(condensed, speed)
    }

    /// The same, with the factors that [`reduce`](Self::reduce) and
    /// [`substitute`](Self::substitute) need.
    pub fn factorize(&self, frequency: f64, speed: f64, work: &mut BladeFactors) -> Condensed {
        self.factorize_with_inertia((frequency, speed), 0.0, work)
    }

    /// The same for D + a M with this a, rad²/s².
    pub fn factorize_with_inertia(
        &self,
        (frequency, speed): (f64, f64),
        added: f64,
        work: &mut BladeFactors,
    ) -> Condensed {
        let mut a = self.matrix(frequency, speed);
        a.inertia += added;
        let condensed = factorize_blade(&self.beam, &a, &mut work.factors);
        self.at_apex(condensed, speed)
    }

    fn matrix(&self, frequency: f64, speed: f64) -> TurningMatrix<'_> {
        TurningMatrix {
            inertia: -frequency * frequency,
            spin: speed * speed,
            skew: 2.0 * frequency * speed,
            coriolis: &self.coriolis,
        }
    }

    fn at_apex(&self, mut condensed: Condensed, speed: f64) -> Condensed {
        transform_matrix(&mut condensed.matrix, self.root_m);
        for (row, stretch) in condensed.matrix.iter_mut().zip(&self.stretch) {
            for (entry, stretch) in row.iter_mut().zip(stretch) {
                entry.re += speed * speed * stretch;
            }
        }
        condensed.matrix = congruent(&condensed.matrix, &both(&self.axes));
        condensed
    }

    /// Eliminates the coordinates from the right side of D x = r, which holds what acts on them;
    /// returns the force on the apex.
    pub fn reduce(&self, work: &mut BladeFactors, right: &mut [Complex]) -> [Complex; 6] {
        let at_tip = [Complex::default(); 6];
        let force = reduce_down(&self.beam, &mut work.factors, at_tip, right);
        self.force_at_apex(force)
    }

    /// Finds the coordinates from the motion of the apex, in place of a reduced right side.
    pub fn substitute(&self, work: &mut BladeFactors, apex: &[Complex; 6], own: &mut [Complex]) {
        substitute_up(
            &self.beam,
            &mut work.factors,
            self.motion_of_root(apex),
            own,
        );
    }

    /// The product of dD/ds = 2 i Ω C − 2 s M with a motion x of the apex and the coordinates, in
    /// `out`; returns the force on the apex and xᴴ M x.
    pub fn derivative(
        &self,
        (frequency, speed): (f64, f64),
        (apex, own): (&[Complex; 6], &[Complex]),
        work: &mut BladeFactors,
        out: &mut [Complex],
    ) -> ([Complex; 6], f64) {
        let a = InertiaMatrix {
            inertia: -2.0 * frequency,
            skew: 2.0 * speed,
            coriolis: &self.coriolis,
        };
        let root = self.motion_of_root(apex);
        let (_, mass) = inertia_loads(&self.beam, &a, (root, own), &mut work.loads);
        let ends = ([Complex::default(); 6], [Complex::default(); 6]);
        let force = sweep_down(&self.beam, ends, &work.loads.loads, out);
        (self.force_at_apex(force), mass)
    }

    fn motion_of_root(&self, apex: &[Complex; 6]) -> [Complex; 6] {
        let mut root = std::array::from_fn(|i| {
            let (row, of) = (&self.axes[i % 3], &apex[i / 3 * 3..]);
            row.iter().zip(of).map(|(axis, x)| x.times(*axis)).sum()
        });
        transform_motion(&mut root, self.root_m);
        root
    }

    fn force_at_apex(&self, mut force: [Complex; 6]) -> [Complex; 6] {
        transform_force(&mut force, self.root_m);
        self.out_of_axes(&force)
    }

    /// A motion or a force in the components (along the axis of the rotor, against the rotation,
    /// radial).
    fn out_of_axes(&self, of_blade: &[Complex; 6]) -> [Complex; 6] {
        std::array::from_fn(|i| {
            let of = &of_blade[i / 3 * 3..];
            (0..3).map(|k| of[k].times(self.axes[k][i % 3])).sum()
        })
    }

    /// Radii (m) and translations in (axis of the rotor, against the rotation, radial) along the
    /// blade, this many per element.
    pub fn translations(
        &self,
        (apex, own): (&[Complex; 6], &[Complex]),
        steps: usize,
    ) -> Vec<(f64, [Complex; 3])> {
        let root = self.motion_of_root(apex);
        let along = motions_along(&self.beam, (root, own), steps).into_iter();
        let translation = |(radius_m, motion)| {
            let [x, y, z, ..] = self.out_of_axes(&motion);
            (radius_m, [x, y, z])
        };
        along.map(translation).collect()
    }

    /// Number of its elements.
    pub fn elements(&self) -> usize {
        self.beam.elements()
    }

    /// Twice the elastic energy of coordinates, in flap, edge, torsion and stretch.
    pub fn strain_energies(&self, own: &[Complex]) -> [f64; 4] {
        let mut sum = [0.0; 4];
        let mut strains = vec![Complex::default(); self.beam.coordinates()];
        let points = self.polynomials.len();
        let elements = own.chunks_exact(self.beam.coordinates());
        for (element, own) in elements.enumerate() {
            strains.copy_from_slice(own);
            self.beam.to_strains(element, &mut strains);
            let gauges = &self.gauges[element * points..(element + 1) * points];
            for (gauge, terms) in gauges.iter().zip(&self.polynomials) {
                let [v, w, twist, stretch] = self.strains_at(&strains, |k| terms[k].value);
                let (sin, cos) = gauge.turn;
                let edge = v.times(cos) + w.times(sin);
                let flap = w.times(cos) - v.times(sin);
                let all = [flap, edge, twist, stretch];
                for ((sum, strain), stiffness) in sum.iter_mut().zip(all).zip(gauge.stiffness) {
                    let square = strain.norm_squared();
                    // A strain that the element does not have has an infinite stiffness.
                    *sum += if square == 0.0 {
                        0.0
                    } else {
                        stiffness * square
                    };
                }
            }
        }
        sum
    }

    /// Curvatures in the planes of X and Y, twist and stretch at a point of an element.
    fn strains_at(&self, strains: &[Complex], value: impl Fn(usize) -> f64) -> [Complex; 4] {
        let mut at = [Complex::default(); 4];
        let mut first = 0;
        for deformation in self.beam.deformations() {
            let place = match deformation.strain {
                Strain::Curvature(Plane::ForeAft) => 0,
                Strain::Curvature(Plane::SideSide) => 1,
                Strain::Twist => 2,
                Strain::Stretch => 3,
                Strain::Shear(_) => unreachable!("blades do not shear"),
            };
            let own = &strains[first..first + deformation.count];
            let terms = own.iter().enumerate();
            at[place] = terms.map(|(k, strain)| strain.times(value(k))).sum();
            first += deformation.count;
        }
        at
    }
}
