//! What a foundation by closed form has below the base, for pictures.

use towermodes::Foundation;

/// A rigid body or a pile in the soil below the base.
#[derive(Debug, Clone, Copy)]
pub(super) struct Buried {
    /// Half of its extent in x and y, m.
    pub(super) half_m: [f64; 2],
    /// Depth of its underside below the surface of the soil, m.
    pub(super) depth_m: f64,
    /// Whether its outline is a circle.
    pub(super) is_round: bool,
    /// Whether it is deep: a pile or a caisson, and no footing.
    pub(super) is_deep: bool,
}

/// None for a foundation without dimensions.
pub(super) fn buried(foundation: &Foundation) -> Option<Buried> {
    let footing = |radius_m: f64, depth_m: f64| Buried {
        half_m: [radius_m; 2],
        depth_m,
        is_round: true,
        is_deep: false,
    };
    let pile = |diameter_m: f64, depth_m: f64| Buried {
        is_deep: true,
        ..footing(0.5 * diameter_m, depth_m)
    };
    Some(match foundation {
        Foundation::HalfSpace(of) => footing(of.radius_m, of.embedment_m),
        Foundation::CircularFooting(of) => footing(of.radius_m, of.embedment_m),
        Foundation::RectangularFooting(of) => Buried {
            half_m: [0.5 * of.length_x_m, 0.5 * of.length_y_m],
            depth_m: of.embedment_m,
            is_round: false,
            is_deep: false,
        },
        Foundation::SuctionCaisson(of) => pile(of.diameter_m, of.skirt_length_m),
        Foundation::Monopile(of) => pile(of.tube.diameter_m, of.tube.embedded_length_m),
        Foundation::WinklerPile(of) => pile(of.tube.diameter_m, of.tube.embedded_length_m),
        Foundation::Clamped
        | Foundation::Stiffness(_)
        | Foundation::Springs(_)
        | Foundation::Floating(_) => return None,
    })
}
