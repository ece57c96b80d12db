//! A beam as a branch of links: each element is one.

use super::model::{Beam, rigid_motion};
use crate::subsystem::{Branch, BranchLink};

impl<const D: usize> Beam<D> {
    /// The elements as links, and what is attached to the base; D is 6.
    pub(super) fn branch(&self) -> Branch {
        let size = self.rows() * self.rows();
        let of_element = |matrices: &Vec<f64>, element: usize| {
            let own = matrices.get(element * size..(element + 1) * size);
            own.map(<[f64]>::to_vec).unwrap_or_default()
        };
        let link = |element: usize| {
            let mut tips = self.tip_rows(element);
            BranchLink {
                transfer: rigid_motion(self.length_m(element)),
                tips: std::array::from_fn(|_| tips.next().unwrap_or_default().to_vec()),
                matrices: std::array::from_fn(|kind| of_element(&self.matrices[kind], element)),
                body: [[[0.0; 6]; 6]; 3],
            }
        };
        let mut branch = Branch {
            links: (0..self.elements()).map(link).collect(),
            ..Branch::default()
        };
        if let Some(base) = &self.base {
            branch.units = std::array::from_fn(|i| base.unit[i]);
            for (out, matrix) in branch.base.iter_mut().zip(&base.matrices) {
                *out = std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j]));
            }
        }
        branch
    }
}
