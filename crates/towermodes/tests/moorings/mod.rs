//! Mooring systems: lines by hand and of MAP++, published stiffness, differences of the force,
//! invariances, refusals, random lines, static balance. The verification manual has more digits.

mod balance;
mod decks;
mod differences;
mod foundation;
mod invariance;
mod masses;
mod places;
mod platforms;
mod random_lines;
mod random_parts;
mod refusals;
mod single_lines;
mod warnings;

use towermodes::{FloatingPlatform, Foundation, TowerDescription};

fn platform_of(description: &mut TowerDescription) -> &mut FloatingPlatform {
    match &mut description.foundation {
        Foundation::Floating(platform) => platform,
        _ => panic!("no platform"),
    }
}
