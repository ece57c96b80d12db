//! All tests of the pictures and reports.

mod any_tower;
mod figures_campbell;
mod figures_design;
mod figures_first_frequencies;
mod figures_sweep;
mod figures_whirl;
mod golden;
mod grounds;
mod pictures;
mod report;
mod terminal;
mod towers;
