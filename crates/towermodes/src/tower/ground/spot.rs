//! A point of a pile in a layer of soil.

use super::pile::Pile;

/// A point on the axis of a pile, in one of the layers of its ground.
#[derive(Debug, Clone, Copy)]
pub(in crate::tower) struct Spot<'p> {
    pub(super) pile: &'p Pile<'p>,
    /// Index of the layer.
    pub(super) index: usize,
    /// Height in the datum of the stations, m.
    pub(super) height_m: f64,
}

impl Spot<'_> {
    /// Depth below the bottom of the hole of local scour, m.
    pub(super) fn depth_m(&self) -> f64 {
        self.pile.depth_m(self.height_m)
    }

    /// Outer diameter D of the pile, m.
    pub(super) fn diameter_m(&self) -> f64 {
        self.pile.diameter_m(self.height_m)
    }

    /// The value at this point, interpolated between the top and the bottom of the layer.
    pub(super) fn between(&self, [top, bottom]: [f64; 2]) -> f64 {
        let (_, share) = self.pile.layer(self.index, self.height_m);
        top + share * (bottom - top)
    }

    /// The depth at which undisturbed soil has the same effective stress, m.
    pub(super) fn overburden_depth_m(&self) -> f64 {
        self.pile.overburden_depth_m(self.height_m)
    }

    /// Vertical effective stress with scour, Pa.
    pub(super) fn effective_stress_pa(&self) -> f64 {
        self.pile.effective_stress_pa(self.height_m)
    }

    /// The mean undrained strength of the clay above, Pa.
    pub(super) fn mean_strength_pa(&self) -> f64 {
        self.pile.mean_strength_pa(self.index, self.height_m)
    }

    /// Depth below the surface of the rock to which the layer belongs, m.
    pub(super) fn depth_in_rock_m(&self) -> f64 {
        self.pile.rock_surface_m(self.index) - self.height_m
    }

    /// Bending stiffness of the pile, N m².
    pub(super) fn bending_n_m2(&self) -> f64 {
        self.pile.bending_n_m2(self.height_m)
    }
}
