//! What a tower carries, as rigid bodies on its axis: point masses, the machine. The same for chains and for beams.

use crate::chain::RigidBody;
use crate::tower::{PointMass, Tower};

/// Tells `add` the masses, sorted by height, that are not above a height (m); returns those above.
pub(crate) fn masses_up_to(
    height_m: f64,
    masses: &[PointMass],
    mut add: impl FnMut(f64, &RigidBody),
) -> &[PointMass] {
    let (here, above) = masses.split_at(masses.partition_point(|mass| mass.height_m <= height_m));
    for mass in here {
        add(mass.height_m, &RigidBody::point(mass.mass_kg));
    }
    above
}

/// Tells `add` the rotor-nacelle assembly, about its centre of mass.
pub(crate) fn machine(tower: &Tower, mut add: impl FnMut(f64, &RigidBody)) {
    let rna = tower.rna();
    let inertia = &rna.inertia_kg_m2;
    let body = RigidBody {
        mass_kg: rna.mass_kg,
        first_moment_kg_m: 0.0,
        inertia_xx_kg_m2: inertia.xx,
        inertia_yy_kg_m2: inertia.yy,
        inertia_zz_kg_m2: inertia.zz,
    };
    add(tower.top_m() + rna.center_m[2], &body);
}
