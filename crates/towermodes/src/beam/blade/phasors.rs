//! Products of a beam's inertia and Coriolis matrices with motions in phasors, and the motion along
//! a beam.

use super::super::legendre::Legendre;
use super::super::model::{Beam, rigid_motion};
use super::super::product::sweep_up;
use crate::scalar::{Complex, Number, Scalar};

/// The matrix a M + i c C, with the inertia M and skew matrices C of the elements, if they have
/// them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct InertiaMatrix<'a> {
    pub(crate) inertia: f64,
    pub(crate) skew: f64,
    pub(crate) coriolis: &'a [f64],
}

/// The forces on the elements, and working memory.
#[derive(Debug, Clone, Default)]
pub(crate) struct Loads {
    pub(crate) loads: Vec<Complex>,
    motion: Vec<Complex>,
}

/// The forces on the elements for a motion x of the base and their coordinates, in `memory`;
/// returns the motion of the top and xᴴ M x.
pub(crate) fn inertia_loads(
    beam: &Beam<6>,
    a: &InertiaMatrix<'_>,
    (base, own): ([Complex; 6], &[Complex]),
    memory: &mut Loads,
) -> ([Complex; 6], f64) {
    let (rows, mut mass) = (beam.rows(), 0.0);
    let Loads { loads, motion: x } = memory;
    x.resize(rows, Complex::default());
    loads.clear();
    let top = sweep_up(beam, base, own, |element, motion, own| {
        x[..6].copy_from_slice(motion);
        x[6..].copy_from_slice(own);
        let of_element = |all: &[f64], row: usize| {
            let from = (element * rows + row) * rows;
            let row = all[from..from + rows].iter().zip(x.iter());
            row.map(|(entry, x)| x.times(*entry)).sum::<Complex>()
        };
        for (row, own) in x.iter().enumerate() {
            let inertia = of_element(&beam.matrices[0], row);
            mass += (own.conj() * inertia).re;
            let mut load = inertia.times(a.inertia);
            if !a.coriolis.is_empty() {
                let turned = of_element(a.coriolis, row);
                load += Complex::new(-a.skew * turned.im, a.skew * turned.re);
            }
            loads.push(load);
        }
    });
    (top, mass)
}

/// Heights and motions at equal steps, `steps` per element, from the base to the top.
pub(crate) fn motions_along(
    beam: &Beam<6>,
    (base, own): ([Complex; 6], &[Complex]),
    steps: usize,
) -> Vec<(f64, [Complex; 6])> {
    let mut all = Vec::with_capacity(beam.elements() * steps + 1);
    let mut strains = vec![Complex::default(); beam.coordinates()];
    let top = sweep_up(beam, base, own, |element, motion, own| {
        strains.copy_from_slice(own);
        beam.to_strains(element, &mut strains);
        let (base_m, length_m) = beam.ends[element];
        for step in 0..steps {
            let fraction = step as f64 / steps as f64;
            let motion = motion_at(beam, (motion, &strains), length_m, fraction);
            all.push((base_m + fraction * length_m, motion));
        }
    });
    let end_m = beam
        .ends
        .last()
        .map_or(0.0, |(base_m, length_m)| base_m + length_m);
    all.push((end_m, top));
    all
}

/// The motion at a fraction of an element for the motion of its base and its strain coefficients.
fn motion_at(
    beam: &Beam<6>,
    (base, strains): (&[Complex; 6], &[Complex]),
    length_m: f64,
    fraction: f64,
) -> [Complex; 6] {
    let rigid = rigid_motion::<6>(fraction * length_m);
    let half = 0.5 * length_m;
    std::array::from_fn(|component| {
        let moved = base.iter().zip(&rigid[component]);
        let mut sum: Complex = moved.map(|(base, lever)| base.times(*lever)).sum();
        let mut strains = strains.iter();
        for deformation in beam.deformations() {
            let times = deformation.integrals[component];
            let sign = f64::from(times.signum());
            let own = strains.by_ref().take(deformation.count);
            for (strain, term) in own.zip(Legendre::at(2.0 * fraction - 1.0)) {
                sum += strain.times(match times.abs() {
                    0 => 0.0,
                    1 => sign * half * term.first,
                    _ => sign * half * half * term.second,
                });
            }
        }
        sum
    })
}
