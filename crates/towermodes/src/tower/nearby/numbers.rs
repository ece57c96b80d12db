//! The values that define a checked tower, in one list, so that derivatives can be taken with
//! respect to them.

use super::super::attachment::Attachment;
use super::super::model::Tower;
use super::super::parts::properties::Properties;
use super::super::parts::surroundings::SoilStiffness;
use super::super::pieces::piece::{Piece, Profile};
use super::super::pieces::shear::Shear;
use super::neighbour::Neighbour;
use crate::space::SpatialMatrix;

/// Index of a value in the list.
pub(crate) type Place = usize;

/// The indices of the values of a tower.
///
/// In front are the numbers of the base, then those of the attachments, then those of the pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Places {
    attachments: usize,
    pieces: usize,
}

/// Number of entries of a matrix.
const MATRIX: usize = 36;
/// Number of values of the base, of an attachment, of a piece.
const OF_BASE: usize = 3 + 2 * MATRIX;
const OF_ATTACHMENT: usize = 3 + 2 * MATRIX;
const OF_PIECE: usize = 1 + OF_PROFILE + OF_SOIL + 4;
const OF_PROFILE: usize = 20;
const OF_SOIL: usize = 2 * SoilStiffness::SPRINGS;
const OF_SLIVER: usize = SoilStiffness::SPRINGS + 1;

impl Places {
    /// The indices for a tower.
    pub(crate) fn of(tower: &Tower) -> Self {
        Self {
            attachments: tower.attachments.len(),
            pieces: tower.pieces.len(),
        }
    }

    /// Number of values.
    pub(crate) fn count(self) -> usize {
        self.sliver(self.pieces + 1)
    }

    /// The soil and the water just beyond a border between pieces: the springs and a mass.
    pub(crate) fn sliver(self, border: usize) -> Place {
        self.piece(self.pieces) + border * OF_SLIVER
    }

    /// Gravity, m/s².
    pub(crate) const GRAVITY: Place = 0;
    /// The overturning moment of the base, kg m.
    pub(crate) const BASE_OVERTURNING: Place = 1;
    /// The height of the base, m.
    pub(crate) const BASE_HEIGHT: Place = 2;
    /// The stiffness of the base, row by row.
    pub(crate) const BASE_STIFFNESS: Place = 3;
    /// The inertia of the base, row by row.
    pub(crate) const BASE_INERTIA: Place = 3 + MATRIX;

    /// The height of an attachment, m; after it its mass, its overturning moment, and its inertia
    /// and stiffness, row by row.
    pub(crate) fn attachment(self, index: usize) -> Place {
        OF_BASE + index * OF_ATTACHMENT
    }

    /// The height of the upper end of a piece, m.
    pub(crate) fn piece(self, index: usize) -> Place {
        OF_BASE + self.attachments * OF_ATTACHMENT + index * OF_PIECE
    }

    /// The profile of a piece: of a tube diameter and wall at both ends, E, G, density, κ; of a
    /// table mass, three squared radii of gyration, bending stiffnesses, GJ, EA and shear
    /// stiffnesses at both ends.
    pub(crate) fn profile(self, piece: usize) -> Place {
        self.piece(piece) + 1
    }

    /// The soil springs of a piece: all at the lower end, then all at the upper end.
    pub(crate) fn soil(self, piece: usize) -> Place {
        self.profile(piece) + OF_PROFILE
    }

    /// The water of a piece: added mass of tables at both ends, then per square of the outer and of
    /// the inner diameter.
    pub(crate) fn water(self, piece: usize) -> Place {
        self.soil(piece) + OF_SOIL
    }

    /// The height of a border between pieces, 0 for the base.
    pub(crate) fn border(self, border: usize) -> Place {
        match border.checked_sub(1) {
            None => Self::BASE_HEIGHT,
            Some(piece) => self.piece(piece),
        }
    }
}

impl Tower {
    /// Writes the numbers of the tower at their [`Places`].
    pub(crate) fn write_numbers(&self, numbers: &mut Vec<f64>) {
        numbers.clear();
        let base = &self.base;
        numbers.extend([self.gravity_m_per_s2, base.overturning_kg_m, self.base_m()]);
        write_matrix(&base.stiffness, numbers);
        write_matrix(&base.inertia, numbers);
        self.attachments.iter().for_each(|a| a.write(numbers));
        self.pieces.iter().for_each(|piece| piece.write(numbers));
        numbers.resize(Places::of(self).count(), 0.0);
    }
}

impl Neighbour {
    /// Writes the numbers of the tower at their [`Places`].
    pub(crate) fn write_numbers(&self, numbers: &mut Vec<f64>) {
        self.tower.write_numbers(numbers);
        let places = Places::of(&self.tower);
        for sliver in &self.slivers {
            let first = places.sliver(sliver.border);
            let own = numbers[first..].iter_mut().zip(sliver.springs_and_mass);
            own.for_each(|(sum, value)| *sum += value);
        }
    }
}

fn write_matrix(matrix: &SpatialMatrix, numbers: &mut Vec<f64>) {
    numbers.extend(matrix.iter().flatten());
}

impl Attachment {
    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.extend([self.height_m, self.mass_kg, self.overturning_kg_m]);
        write_matrix(&self.inertia, numbers);
        write_matrix(&self.stiffness, numbers);
    }
}

impl Piece {
    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.push(self.top_m);
        let profile = numbers.len();
        match &self.profile {
            Profile::Tube {
                base,
                top,
                material,
                shear,
            } => numbers.extend([
                base.outer_diameter_m,
                base.wall_thickness_m,
                top.outer_diameter_m,
                top.wall_thickness_m,
                material.youngs_modulus_pa,
                material.shear_modulus_pa,
                material.density_kg_per_m3,
                match shear {
                    Shear::Coefficient(kappa) => *kappa,
                    Shear::Rigid | Shear::Cowper => 0.0,
                },
            ]),
            Profile::Table { base, top } => {
                numbers.extend(base.numbers());
                numbers.extend(top.numbers());
            }
        }
        numbers.resize(profile + OF_PROFILE, 0.0);
        let environment = &self.environment;
        for soil in environment.soil.unwrap_or_default() {
            numbers.extend(soil.values());
        }
        numbers.extend(environment.added_kg_per_m.unwrap_or_default());
        numbers.extend([environment.outside_kg_per_m3, environment.inside_kg_per_m3]);
    }
}

impl Properties {
    /// What is linear between two rows: mass, squared radii of gyration, stiffnesses.
    pub(crate) fn numbers(&self) -> [f64; 10] {
        let (rotary, mass) = (self.rotary_inertia_kg_m, self.mass_kg_per_m);
        let [a, b, c, d, e, f] = self.stiffnesses();
        [
            mass,
            rotary.fore_aft / mass,
            rotary.side_side / mass,
            self.polar_inertia_kg_m / mass,
            a,
            b,
            c,
            d,
            e,
            f,
        ]
    }
}
