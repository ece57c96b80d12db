//! The soil around the embedded part of a monopile: elastic, with one shear modulus.

use towermodes::{
    Foundation, FoundationSprings, Ground, GroundLayer, LayerSoil, Place, ShearModulus, SoilModel,
    TowerDescription,
};

use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use crate::number::Rounded;

/// The soil in `environment`, and its place in the file.
#[derive(Debug, Clone)]
pub(crate) struct Soil {
    shear_modulus_pa: f64,
    poissons_ratio: f64,
    spans: [std::ops::Range<usize>; 2],
}

impl Soil {
    /// The soil of a file; none if it does not give both values.
    pub(crate) fn of(environment: Option<&Node>) -> Option<Self> {
        let node = |key: &str| environment.and_then(|environment| environment.get(key));
        let (modulus, ratio) = (node("soil_shear_modulus")?, node("soil_poisson")?);
        Some(Self {
            shear_modulus_pa: modulus.number("soil_shear_modulus").ok()?,
            poissons_ratio: ratio.number("soil_poisson").ok()?,
            spans: [modulus.span.clone(), ratio.span.clone()],
        })
    }

    /// The soil as text, for a note.
    pub(super) fn words(&self) -> String {
        format!(
            "shear modulus {} Pa, Poisson's ratio {}",
            Rounded(self.shear_modulus_pa),
            self.poissons_ratio
        )
    }

    /// Adds the soil, from a mudline (m) downwards, around a tower that extends down to its lowest
    /// station. The tip is free to move horizontally and to rotate.
    pub(crate) fn surround(
        &self,
        mudline_m: f64,
        description: &mut TowerDescription,
        reading: &mut Reading<'_>,
    ) {
        let Some(tip) = description.stations.first() else {
            return;
        };
        for (key, span) in ["shear_modulus", "poissons_ratio"]
            .into_iter()
            .zip(&self.spans)
        {
            reading.remember(Place::GroundLayer { index: 0, key }, span);
        }
        let layer = GroundLayer {
            shear_modulus: Some(ShearModulus::Given {
                shear_modulus_pa: [self.shear_modulus_pa; 2],
            }),
            poissons_ratio: Some(self.poissons_ratio),
            ..GroundLayer::new(
                [mudline_m, tip.height_m],
                LayerSoil::Elastic,
                SoilModel::Winkler,
            )
        };
        description.ground = Some(Ground::new(mudline_m, vec![layer]));
        description.foundation = Foundation::Springs(FoundationSprings {
            lateral_n_per_m: 0.0,
            rocking_n_m: 0.0,
            ..FoundationSprings::RIGID
        });
    }
}
