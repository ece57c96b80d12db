//! The memory of a solve.

use super::errors::tracking::{Ladder, Levels};
use super::on_mesh::cut::{Cut, LastCut};
use super::on_mesh::guesses::Guesses;
use super::on_mesh::model::Model;
use super::on_mesh::naming::Naming;
use super::on_mesh::spectrum::{ModeKey, Spectrum};
use super::results::frequencies::{Estimated, Frequencies};
use crate::elements::Mesh;

/// Memory that is reused from solve to solve.
#[derive(Debug, Default)]
pub(crate) struct Workspace {
    pub(super) model: Model,
    pub(super) spectrum: Spectrum,
    pub(super) naming: Naming,
    pub(super) errors: ErrorWorkspace,
    pub(super) frequencies: Frequencies,
    pub(super) cut: LastCut,
    /// The modes of a similar tower, from which solves for frequencies alone start.
    pub(super) base: Option<Guesses>,
    /// The last cut of the spectral method.
    pub(super) spectral_cut: Option<Cut>,
}

/// The memory of error estimates.
#[derive(Debug, Default)]
pub(super) struct ErrorWorkspace {
    pub(super) guesses: Guesses,
    pub(super) ladder: Ladder<Mesh>,
    pub(super) levels: Levels,
    pub(super) keys: Vec<ModeKey>,
    pub(super) modes: Vec<Estimated>,
    pub(super) irregular: Vec<usize>,
}
