//! The mass that a tower carries at a height.

use super::super::attachment::Attachment;
use super::integrals::weight_integrals;
use super::piece::Piece;

/// The mass above each piece and each attachment, summed once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Above {
    /// Mass of the whole tower, kg.
    pub(crate) tower_kg: f64,
    /// Mass of the tower above the top of each piece, kg.
    of_pieces_kg: Vec<f64>,
    /// Mass of each attachment and those above it, kg; one entry more for none.
    of_attachments_kg: Vec<f64>,
}

impl Above {
    pub(crate) fn new(pieces: &[Piece], attachments: &[Attachment]) -> Self {
        let masses = pieces
            .iter()
            .map(|p| weight_integrals(p, p.base_m, p.top_m, p.base_m).0);
        let attached = attachments.iter().map(|attachment| attachment.mass_kg);
        let mut of_pieces_kg = sums_from_the_top(masses);
        let tower_kg = of_pieces_kg.remove(0);
        Self {
            tower_kg,
            of_pieces_kg,
            of_attachments_kg: sums_from_the_top(attached),
        }
    }

    /// The mass above a height (m) of a piece, kg, if `attached` attachments are below the height.
    pub(crate) fn mass_kg(
        &self,
        piece: &Piece,
        index: usize,
        height_m: f64,
        attached: usize,
    ) -> f64 {
        let (own_kg, _) = weight_integrals(piece, height_m, piece.top_m, height_m);
        own_kg + self.of_pieces_kg[index] + self.of_attachments_kg[attached]
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
