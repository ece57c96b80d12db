//! The description of a tower while it is built from a deck.

use towermodes::TowerDescription;

use super::super::records::deck::Deck;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::Places;

/// The indices of the main file and of the section file among the files of a deck.
pub(super) const MAIN: usize = 0;
pub(super) const SECTIONS: usize = 1;

/// The description of a tower while it is built, with the places of its values.
pub(crate) struct Building {
    pub(crate) description: TowerDescription,
    pub(crate) places: Places,
    pub(crate) ends: Ends,
}

impl Building {
    /// A tower of which only the name and the ends are known.
    pub(crate) fn of(deck: &Deck) -> Result<Self, Diagnostic> {
        let description = TowerDescription {
            name: deck.title.clone(),
            ..TowerDescription::default()
        };
        Ok(Self {
            description,
            places: Places::default(),
            ends: Ends::of(deck)?,
        })
    }
}

/// Heights of a tower's flexible base and its top above ground or sea level, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ends {
    pub(crate) base_m: f64,
    pub(crate) top_m: f64,
}

impl Ends {
    fn of(deck: &Deck) -> Result<Self, Diagnostic> {
        let general = &deck.general;
        let draft = deck.support.offshore.as_ref().map(|block| &block.draft_m);
        let ends = Self {
            base_m: general.root_m.value - draft.map_or(0.0, |draft| draft.value),
            top_m: general.radius_m.value,
        };
        let length_m = ends.top_m - ends.base_m;
        if length_m > 0.0 && length_m.is_finite() {
            return Ok(ends);
        }
        let rule = format!("below the top, radius = {} m", ends.top_m);
        let what = "the base, hub_rad - draft,";
        let kind = DiagnosticKind::out_of_range_in(what, ends.base_m, "m", rule);
        Err(draft.unwrap_or(&general.radius_m).wrong(kind))
    }

    /// The height at a fraction of the flexible length, m; exact at both ends.
    pub(crate) fn at(self, fraction: f64) -> f64 {
        if fraction == 1.0 {
            return self.top_m;
        }
        self.base_m + fraction * (self.top_m - self.base_m)
    }
}
