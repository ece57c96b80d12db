//! The motions and loads of the joints and bodies of a chain in a mode.

use super::model::Chain;
use super::product;
use crate::subsystem::{Coefficients, Coordinates, JointState};

/// The states of all joints for coordinates `x` at an eigenvalue λ, rad²/s².
pub fn joint_states<const D: usize>(
    chain: &Chain<D>,
    coordinates: &Coordinates<D>,
    lambda: f64,
    x: &[f64],
    states: &mut Vec<JointState>,
) {
    let a = Coefficients::FOUNDATION.minus(lambda, Coefficients::MASS);
    states.clear();
    let mut rest = x;
    product::for_each_body(chain, &a, x, |link, motion, own, load| {
        let (values, above) = rest.split_at(link.moving);
        rest = above;
        let mut squares = [0.0; D];
        let moving = (0..D).filter(|&component| link.root[component] != 0.0);
        for (component, value) in moving.zip(values) {
            squares[component] = value * value;
        }
        let load = coordinates.expand(load);
        states.push(JointState {
            height_m: link.height_m,
            is_base: link.spring == 0.0,
            moves: coordinates.expand_unsigned(&link.root).map(|r| r != 0.0),
            motion: coordinates.expand(motion),
            own: coordinates.expand(own),
            strain: coordinates.expand_unsigned(&squares),
            load: [load[0], load[1], load[2]],
        });
    });
    let mut sum = [0.0; 3];
    for state in states.iter_mut().rev() {
        for (sum, load) in sum.iter_mut().zip(&mut state.load) {
            *sum += *load;
            *load = *sum;
        }
    }
}
