//! The weight that a tower carries at a height.

use super::Tower;
use super::attachment::Attachment;
use super::integrals::mass_integrals;
use super::piece::Piece;

/// What lies above, summed once.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Above {
    /// Mass of the whole tower, kg.
    pub(super) tower_kg: f64,
    /// Mass of the tower above the top of each piece, kg.
    of_pieces_kg: Vec<f64>,
    /// Mass of each attachment and those above it, kg; one entry more for none.
    of_attachments_kg: Vec<f64>,
}

impl Above {
    pub(super) fn new(pieces: &[Piece], attachments: &[Attachment]) -> Self {
        let masses = pieces
            .iter()
            .map(|p| mass_integrals(p, p.base_m, p.top_m, p.base_m).mass_kg);
        let attached = attachments.iter().map(|attachment| attachment.mass_kg);
        let mut of_pieces_kg = sums_from_the_top(masses);
        let tower_kg = of_pieces_kg.remove(0);
        Self {
            tower_kg,
            of_pieces_kg,
            of_attachments_kg: sums_from_the_top(attached),
        }
    }
}

/// The sum of each value and those after it, and a zero at the end.
fn sums_from_the_top(values: impl DoubleEndedIterator<Item = f64>) -> Vec<f64> {
    let mut sum = 0.0;
    let mut sums = vec![0.0];
    for value in values.rev() {
        sum += value;
        sums.push(sum);
    }
    sums.reverse();
    sums
}

impl Tower {
    /// The compression N by all weights above a height (m) of the tower, N: what sits at the height
    /// itself is above it.
    ///
    /// Water does not press on the wall: it is not a weight, and buoyancy is left out.
    pub fn compression_n(&self, height_m: f64) -> f64 {
        let index = self.piece_index_at(height_m);
        let piece = &self.pieces[index];
        let own = mass_integrals(piece, height_m, piece.top_m, height_m);
        let attached = self.attachments.partition_point(|a| a.height_m < height_m);
        let above = &self.above;
        let mass_kg = own.mass_kg + above.of_pieces_kg[index] + above.of_attachments_kg[attached];
        self.gravity_m_per_s2 * mass_kg
    }

    /// ∫ N dz between two heights (m) of one piece with nothing attached between them, N m.
    ///
    /// A rigid piece that turns by θ lowers all it carries and itself: its potential energy is −½
    /// θ² times this integral.
    pub fn compression_integral_n_m(&self, base_m: f64, top_m: f64) -> f64 {
        let piece = self.piece_at(0.5 * (base_m + top_m));
        let own = mass_integrals(piece, base_m, top_m, base_m);
        self.compression_n(top_m) * (top_m - base_m)
            + self.gravity_m_per_s2 * own.structural_moment_kg_m
    }
}
