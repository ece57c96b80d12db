//! From any format to any format: what is written is read back as the tower that it was, and what
//! is lost is said.

mod bmodes_deck;
mod chains;
mod comparison;
mod elastodyn_tower;
mod formats;
mod losses;
mod openfast_rules;
mod toml_and_windio;
pub mod towers;
