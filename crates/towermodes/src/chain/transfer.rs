//! Transfer of a vector from one chain of a tower to another chain by its internal forces.

use super::model::Chain;
use crate::subsystem::InternalForces;

/// The internal forces of a vector: y/√(1/k) = k q in each joint.
pub fn internal_forces<const D: usize>(chain: &Chain<D>, x: &[f64], forces: &mut InternalForces) {
    forces.clear();
    let mut rest = x;
    for link in &chain.links {
        let (own, above) = rest.split_at(link.moving);
        rest = above;
        if link.spring == 0.0 {
            // The units of a moving base do not depend on the mesh.
            forces.base.extend_from_slice(own);
            continue;
        }
        let mut coordinates = own.iter();
        for_components!(D, component, {
            if link.root[component] != 0.0
                && let Some(x) = coordinates.next()
            {
                forces.push(component, link.height_m, x / link.root[component]);
            }
        });
    }
}

/// The vector with these internal forces, which may jump at some heights (m, rising).
pub fn with_internal_forces<const D: usize>(
    chain: &Chain<D>,
    forces: &InternalForces,
    jumps_m: &[f64],
    out: &mut [f64],
) {
    let mut readers: [_; D] = forces.readers(jumps_m);
    let mut rest = out;
    for link in &chain.links {
        let (own, above) = rest.split_at_mut(link.moving);
        rest = above;
        if link.spring == 0.0 {
            match own.len() == forces.base.len() {
                true => own.copy_from_slice(&forces.base),
                // The base moves in other directions.
                false => own.fill(0.0),
            }
            continue;
        }
        link.set_scaled(own, |component| readers[component].force(link.height_m));
    }
}
