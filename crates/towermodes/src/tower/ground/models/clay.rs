//! The lateral resistance of clay, to which springs are proportional.

use crate::tower::ground::layer_springs::Nature;
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{NoSprings, Values};

/// The nature of springs that are proportional to the resistance of clay.
pub(super) const NATURE: Nature = Nature {
    is_linear: false,
    needs_weight: true,
    depends_on_edition: false,
};

/// Lateral resistance p_u of clay per length, N/m, for two failure mechanisms; the smaller one
/// governs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Resistance {
    /// Failure of a wedge to the surface.
    pub(super) shallow: f64,
    /// Flow around the pile.
    pub(super) deep: f64,
}

impl Resistance {
    /// A value that changes its sign where flow around the pile begins to govern.
    pub(super) fn kink(self, number: usize) -> Option<f64> {
        (number == 0).then_some(self.shallow - self.deep)
    }

    /// The smaller resistance. `min` would hide a missing value.
    pub(super) fn least(self) -> f64 {
        if self.deep < self.shallow {
            self.deep
        } else {
            self.shallow
        }
    }
}

/// The values of clay from which its resistance follows, and the strain of the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Undrained {
    /// Undrained strength S_u at the top and at the bottom of the layer, Pa.
    pub(super) strength_pa: [f64; 2],
    /// ε₅₀.
    pub(super) strain_50: f64,
}

impl Undrained {
    /// From the values of a layer.
    pub(super) fn of(values: &mut Values<'_>) -> Result<Self, NoSprings> {
        let clay = values.clay()?;
        let (strength, strain) = (clay.undrained_strength_pa, clay.strain_at_half_strength);
        let (key, value) = ("strain_at_half_strength", "the strain at half the strength");
        Ok(Self {
            strength_pa: values.needed(
                "undrained_strength",
                "the undrained shear strength",
                strength,
            )?,
            strain_50: values.needed(key, value, strain)?,
        })
    }
}

/// Clay with the resistance of Matlock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Matlock {
    pub(super) clay: Undrained,
    /// The factor J.
    factor: f64,
}

impl Matlock {
    /// From the values of a layer.
    pub(super) fn of(values: &mut Values<'_>) -> Result<Self, NoSprings> {
        let clay = Undrained::of(values)?;
        let value = "the factor J (0.5 for soft, 0.25 for stiff clay)";
        let given = values.clay()?.strength_factor;
        let factor = values.needed("strength_factor", value, given)?;
        Ok(Self { clay, factor })
    }

    /// p_u = min((3 S_u + σ′_v) D + J S_u z, 9 S_u D).
    ///
    /// Source: Matlock, *Correlations for design of laterally loaded piles in soft clay*, OTC 1204
    /// (1970); API RP 2GEO.
    pub(super) fn resistance(&self, spot: &Spot<'_>) -> Resistance {
        let (strength_pa, diameter_m) = (spot.between(self.clay.strength_pa), spot.diameter_m());
        Resistance {
            shallow: (3.0 * strength_pa + spot.effective_stress_pa()) * diameter_m
                + self.factor * strength_pa * spot.depth_m(),
            deep: 9.0 * strength_pa * diameter_m,
        }
    }
}
