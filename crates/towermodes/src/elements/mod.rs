//! Recipes that turn a tower into a chain, one a file.

mod bodies;
mod cardanic;
mod lumped;
mod mesh;
mod method;
mod rmje;
mod rmje_exact;
mod springs;

pub use cardanic::GAUSS_HINGE_POSITION;
pub use mesh::{Mesh, Span};
pub use method::Method;

use crate::chain::{DecoupledChains, RigidBody};
use crate::tower::{Piece, PointMass, Rna, Tower};

/// How a tower is made into a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recipe {
    /// The element.
    pub method: Method,
    /// Whether sections have rotary inertia in bending (false: an Euler-Bernoulli beam); torsion and the rotor-nacelle assembly keep
    /// theirs.
    pub rotary_inertia: bool,
    /// Where the hinges of [`Method::Cardanic`] sit, as a share k of the segment from each end, 0 < k < 1/2.
    pub hinge_position: f64,
}

impl Default for Recipe {
    fn default() -> Self {
        Self {
            method: Method::default(),
            rotary_inertia: true,
            hinge_position: GAUSS_HINGE_POSITION,
        }
    }
}

/// A tower being made into chains.
struct Assembly<'a> {
    chains: &'a mut DecoupledChains,
    recipe: &'a Recipe,
}

impl Assembly<'_> {
    fn add_segment(&mut self, piece: &Piece, base_m: f64, top_m: f64) {
        match self.recipe.method {
            Method::Rmje => rmje::add_segment(self, piece, base_m, top_m),
            Method::RmjeExact => rmje_exact::add_segment(self, piece, base_m, top_m),
            Method::Lumped => lumped::add_segment(self, piece, base_m, top_m),
            Method::Cardanic => {
                let position = self.recipe.hinge_position;
                cardanic::add_prismatic_segment(self, piece, base_m, top_m, position);
            }
            Method::CardanicExact => cardanic::add_exact_segment(self, piece, base_m, top_m),
        }
    }
}

/// Makes the chains of a tower cut as `mesh` says.
pub fn assemble(tower: &Tower, mesh: &Mesh, recipe: &Recipe, chains: &mut DecoupledChains) {
    let joints = recipe.method.joints() * mesh.segments();
    chains.restart(tower.planes_are_equal(), joints);
    let mut assembly = Assembly { chains, recipe };
    let mut masses = tower.point_masses();
    for (piece, borders) in mesh.spans_with_borders() {
        masses = add_masses_up_to(assembly.chains, masses, piece.base_m);
        for border in borders.windows(2) {
            assembly.add_segment(piece, border[0], border[1]);
        }
    }
    add_masses_up_to(assembly.chains, masses, tower.top_m());
    add_rna(assembly.chains, tower.rna(), tower.top_m());
}

/// Adds the point masses that are not above a height (m) to the present body; returns those above.
fn add_masses_up_to<'m>(
    chains: &mut DecoupledChains,
    masses: &'m [PointMass],
    height_m: f64,
) -> &'m [PointMass] {
    let (here, above) = masses.split_at(masses.partition_point(|mass| mass.height_m <= height_m));
    for mass in here {
        chains.add_body(mass.height_m, &RigidBody::point(mass.mass_kg));
    }
    above
}

fn add_rna(chains: &mut DecoupledChains, rna: &Rna, top_m: f64) {
    let inertia = &rna.inertia_kg_m2;
    let body = RigidBody {
        mass_kg: rna.mass_kg,
        first_moment_kg_m: 0.0,
        inertia_xx_kg_m2: inertia.xx,
        inertia_yy_kg_m2: inertia.yy,
        inertia_zz_kg_m2: inertia.zz,
    };
    chains.add_body(top_m + rna.center_m[2], &body);
}
