//! Motions of a frame without stiffness, and the joint where they are free.
//!
//! The coordinates of elements have the stiffness 1: what moves without stiffness moves in a hinge,
//! in a support, or in a joint that cables alone hold.

use std::array::from_fn;
use std::f64::consts::TAU;

use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GROUND, INERTIA, KINDS, Link};
use super::error::FrameSolveError;
use super::order::Order;
use super::product::Sweep;
use super::rigid::Motion;
use crate::tower::frame::Frame;

/// A mode below this frequency, Hz, has no stiffness: a hundredth of the frequency of the slowest
/// floater.
const NO_STIFFNESS_HZ: f64 = 2e-5;
/// Number of steps of the inverse iteration to the softest motion.
const STEPS: usize = 4;

/// λ, rad²/s², below which a mode has no stiffness.
pub(super) fn least_lambda() -> f64 {
    (TAU * NO_STIFFNESS_HZ) * (TAU * NO_STIFFNESS_HZ)
}

/// Why a frame is a mechanism, if it is one without the stiffness of its weight: `joints` gives the
/// joint of each node. A node beyond these belongs to what the frame carries.
pub(super) fn mechanism(
    frame: &Frame,
    (equations, order): (&Equations, &Order),
    joints: &[usize],
) -> Option<FrameSolveError> {
    let mut factors = Factors::default();
    let mut at = |lambda: f64| {
        let mut a = [0.0; KINDS];
        (a[INERTIA], a[GROUND], a[ELASTIC]) = (-lambda, 1.0, 1.0);
        equations.factorize(order, (&a, 1.0), &mut factors)
    };
    let modes = at(least_lambda());
    if modes == 0 {
        return None;
    }
    if is_loose(frame) {
        return Some(FrameSolveError::NothingHolds);
    }
    at(-least_lambda());
    let mut inertia = [0.0; KINDS];
    inertia[INERTIA] = 1.0;
    let mut x = vec![0.0; equations.unknowns];
    let (mut out, mut sweep) = (x.clone(), Sweep::default());
    equations.start(&mut x);
    for _ in 0..STEPS {
        equations.solve(order, &mut factors, &mut x);
        let most = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        x.iter_mut().for_each(|x| *x /= most);
        equations.product((&inertia, 0.0), &mut sweep, &x, &mut out);
        std::mem::swap(&mut x, &mut out);
    }
    equations.solve(order, &mut factors, &mut x);
    let moved = |link: &Link| -> Motion {
        let own = link.tip.iter().zip(&x[link.first..]);
        own.fold([0.0; 6], |sum, (column, y)| {
            from_fn(|i| sum[i] + column[i] * y)
        })
    };
    let size = |link: &Link| moved(link).iter().map(|u| u * u).sum::<f64>();
    let free = equations.links.iter().filter(|link| link.own == 0.0);
    let widest = free.max_by(|a, b| size(a).total_cmp(&size(b)));
    let Some(link) = widest.filter(|link| size(link) > 0.0) else {
        return Some(FrameSolveError::TooSoft { modes });
    };
    let joint = joints.get(link.child).copied().unwrap_or(0);
    let largest = moved(link).map(f64::abs).into_iter().enumerate();
    let largest = largest.max_by(|a, b| a.1.total_cmp(&b.1));
    Some(FrameSolveError::Mechanism {
        modes,
        joint: frame.description().joints[joint].name.clone(),
        motion: MOTIONS[largest.map_or(0, |(i, _)| i)],
    })
}

const MOTIONS: [&str; 6] = [
    "along x", "along y", "along z", "about x", "about y", "about z",
];

/// Whether no support has a stiffness.
fn is_loose(frame: &Frame) -> bool {
    let supports = &frame.description().supports;
    !frame.has_soil()
        && supports.iter().all(|support| {
            let resists = support
                .stiffness
                .iter()
                .flatten()
                .any(|entry| *entry != 0.0);
            !resists && !support.fixed.contains(&true)
        })
}
