//! A linear piece of a tower: one material, diameter and wall linear in height.

use super::description::{Shear, Station};
use super::material::Material;
use super::section::Tube;

/// The tower between two heights over which diameter and wall are linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Height of the lower end, m.
    pub base_m: f64,
    /// Height of the upper end, m.
    pub top_m: f64,
    /// The tube at the lower end.
    pub base_tube: Tube,
    /// The tube at the upper end.
    pub top_tube: Tube,
    /// The material; its density includes the outfitting factor.
    pub material: Material,
    /// The shear model.
    pub shear: Shear,
}

impl Piece {
    /// Length, m.
    pub fn length_m(&self) -> f64 {
        self.top_m - self.base_m
    }

    /// The tube at a height (m) inside the piece.
    #[inline]
    pub fn tube_at(&self, height_m: f64) -> Tube {
        let s = (height_m - self.base_m) / self.length_m();
        let blend = |a: f64, b: f64| a + s * (b - a);
        let (a, b) = (&self.base_tube, &self.top_tube);
        Tube {
            outer_diameter_m: blend(a.outer_diameter_m, b.outer_diameter_m),
            wall_thickness_m: blend(a.wall_thickness_m, b.wall_thickness_m),
        }
    }

    /// The section's stiffnesses and masses per length at a height (m).
    #[inline]
    pub fn section_at(&self, height_m: f64) -> Section {
        Section::of_tube(&self.tube_at(height_m), &self.material, self.shear)
    }

    /// The same piece between two heights (m) inside it.
    pub fn part(&self, base_m: f64, top_m: f64) -> Self {
        Self {
            base_m,
            top_m,
            base_tube: self.tube_at(base_m),
            top_tube: self.tube_at(top_m),
            ..*self
        }
    }

    /// The piece that reaches over both, if `upper` goes on in one line from this piece.
    fn joined(&self, upper: &Self) -> Option<Self> {
        let whole = Self {
            top_m: upper.top_m,
            top_tube: upper.top_tube,
            ..*self
        };
        let line = whole.tube_at(self.top_m);
        // The tolerance lets a row be split in two by hand with full digits, and nothing else.
        let on_line = |value: f64, line: f64| (value - line).abs() <= 1e-12 * value;
        let straight = [&self.top_tube, &upper.base_tube].iter().all(|tube| {
            on_line(tube.outer_diameter_m, line.outer_diameter_m)
                && on_line(tube.wall_thickness_m, line.wall_thickness_m)
        });
        (straight && self.material == upper.material).then_some(whole)
    }
}

/// The fewest linear pieces that stations make: a station on the line of its neighbours separates nothing.
pub(super) fn pieces_of(
    stations: &[Station],
    materials: &[Material],
    outfitting_factor: f64,
    shear: Shear,
) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::with_capacity(stations.len());
    let tube = |s: &Station| Tube {
        outer_diameter_m: s.outer_diameter_m,
        wall_thickness_m: s.wall_thickness_m,
    };
    for pair in stations.windows(2) {
        let (below, above) = (&pair[0], &pair[1]);
        if above.height_m == below.height_m {
            continue;
        }
        let mut material = materials[below.material];
        material.density_kg_per_m3 *= outfitting_factor;
        let piece = Piece {
            base_m: below.height_m,
            top_m: above.height_m,
            base_tube: tube(below),
            top_tube: tube(above),
            material,
            shear,
        };
        match pieces.last().and_then(|last| last.joined(&piece)) {
            Some(whole) => *pieces.last_mut().expect("joined to it") = whole,
            None => pieces.push(piece),
        }
    }
    pieces
}

/// What a beam feels of a section: stiffnesses and masses per length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Mass per length ρA, kg/m.
    pub mass_kg_per_m: f64,
    /// Rotary inertia per length about a diameter ρI, kg m.
    pub rotary_inertia_kg_m: f64,
    /// Bending stiffness EI, N m².
    pub bending_n_m2: f64,
    /// Torsional stiffness GJ = 2GI, N m².
    pub torsion_n_m2: f64,
    /// Axial stiffness EA, N.
    pub axial_n: f64,
    /// Shear flexibility 1/(κGA), 1/N; zero for a beam without shear deformation.
    pub shear_flexibility_per_n: f64,
}

impl Section {
    /// The section of a tube.
    #[inline]
    pub fn of_tube(tube: &Tube, material: &Material, shear: Shear) -> Self {
        let (area, second_moment) = (tube.area_m2(), tube.second_moment_of_area_m4());
        let shear_flexibility = |kappa: f64| 1.0 / (kappa * material.shear_modulus_pa * area);
        Self {
            mass_kg_per_m: material.density_kg_per_m3 * area,
            rotary_inertia_kg_m: material.density_kg_per_m3 * second_moment,
            bending_n_m2: material.youngs_modulus_pa * second_moment,
            torsion_n_m2: material.shear_modulus_pa * 2.0 * second_moment,
            axial_n: material.youngs_modulus_pa * area,
            shear_flexibility_per_n: match shear {
                Shear::Rigid => 0.0,
                Shear::Cowper => {
                    shear_flexibility(tube.cowper_shear_coefficient(material.poissons_ratio()))
                }
                Shear::Coefficient(kappa) => shear_flexibility(kappa),
            },
        }
    }
}
