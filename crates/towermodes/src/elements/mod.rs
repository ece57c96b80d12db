//! Recipes that turn a tower into a chain, one a file.

mod mesh;
mod rmje;
mod rmje_exact;

pub use mesh::{Mesh, Span};

use crate::chain::{DecoupledChains, RigidBody};
use crate::tower::{PointMass, Rna, Shear, Tower};

/// A way to make a chain of a tower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// The element of Nikolić & Šalinić as published, with its misprints corrected: prismatic segments, joints at L/4 and L/2.
    Rmje,
    /// One joint at the elastic centre of each segment, exact section integrals.
    #[default]
    RmjeExact,
}

impl Method {
    /// All methods.
    pub const ALL: [Self; 2] = [Self::RmjeExact, Self::Rmje];

    /// Its name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rmje => "rmje",
            Self::RmjeExact => "rmje-exact",
        }
    }

    /// The leading powers p of its error n⁻ᵖ in bending: 2, but 1 and 2 for the published element of a tower that shears.
    ///
    /// Its sliding joint sits at L/4. Without shear the sliding of a segment is O(n⁻³) and where it happens does not matter; shear
    /// makes it O(n⁻¹), and its place an error of first order.
    pub fn bending_powers(self, shear: Shear) -> &'static [i32] {
        match (self, shear) {
            (Self::Rmje, Shear::Cowper | Shear::Coefficient(_)) => &[1, 2],
            _ => &[2],
        }
    }

    /// The leading powers p of its error n⁻ᵖ in torsion and axially: 2, but 1 and 2 for the published element, whose joint for both sits
    /// at L/4. The two can cancel on usual meshes, so both are needed to know the error.
    pub fn axial_powers(self) -> &'static [i32] {
        match self {
            Self::Rmje => &[1, 2],
            Self::RmjeExact => &[2],
        }
    }

    /// Joints in a segment.
    fn joints(self) -> usize {
        match self {
            Self::Rmje => 2,
            Self::RmjeExact => 1,
        }
    }
}

/// A tower being made into chains.
struct Assembly<'a> {
    chains: &'a mut DecoupledChains,
    rotary_inertia: bool,
}

impl Assembly<'_> {
    /// The share of the sections' own rotary inertia in bending: 1, or 0 for an Euler-Bernoulli beam.
    fn rotary_share(&self) -> f64 {
        f64::from(u8::from(self.rotary_inertia))
    }
}

/// Makes the chains of a tower cut as `mesh` says.
///
/// Without `rotary_inertia` the sections' own rotary inertia is left out of bending (an Euler-Bernoulli beam); torsion and the
/// rotor-nacelle assembly keep theirs.
pub fn assemble(
    tower: &Tower,
    mesh: &Mesh,
    method: Method,
    rotary_inertia: bool,
    chains: &mut DecoupledChains,
) {
    chains.restart(tower.planes_are_equal(), method.joints() * mesh.segments());
    let mut assembly = Assembly {
        chains,
        rotary_inertia,
    };
    let mut masses = tower.point_masses();
    for (piece, borders) in mesh.spans_with_borders() {
        masses = add_masses_up_to(assembly.chains, masses, piece.base_m);
        for border in borders.windows(2) {
            match method {
                Method::Rmje => rmje::add_segment(&mut assembly, piece, border[0], border[1]),
                Method::RmjeExact => {
                    rmje_exact::add_segment(&mut assembly, piece, border[0], border[1]);
                }
            }
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
