//! The surface of the soil around a pile: before scour, after general scour, and at the bottom of
//! the hole of local scour.

use towermodes::{Tower, TowerDescription};

/// Ratio of horizontal to vertical of the side of a scour hole: the angle of repose of sand, 30°.
const SLOPE: f64 = 1.732;

/// The surface of soil in layers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Surface {
    /// Height before scour, m.
    pub original_m: f64,
    /// Height after general scour, m.
    pub general_m: f64,
    /// Height of the bottom of the hole of local scour, m.
    pub bottom_m: f64,
}

impl Surface {
    /// The surface of the layers of a description; none without layers.
    pub fn of(description: &TowerDescription) -> Option<Self> {
        let ground = description.ground.as_ref()?;
        Some(Self {
            original_m: ground.surface_m,
            general_m: ground.surface_m - ground.scour.general_m,
            bottom_m: ground.scoured_surface_m(),
        })
    }

    /// The hole around the tower; none without local scour, and if the tower does not extend into
    /// the soil.
    pub fn hole(&self, tower: &Tower) -> Option<Hole> {
        let is_deep = self.bottom_m < self.general_m && tower.base_m() < self.bottom_m;
        is_deep.then_some(Hole {
            top_m: self.general_m,
            bottom_m: self.bottom_m,
        })
    }

    /// The heights to be labelled if there is scour: each with its name, which begins with `bed`
    /// for the first.
    pub fn labelled(&self, tower: &Tower, bed: &str) -> Vec<(f64, String)> {
        let has_general = self.general_m < self.original_m;
        let mut all = Vec::new();
        if has_general {
            all.push((self.original_m, format!("{bed} before scour")));
            all.push((self.general_m, format!("{bed} after general scour")));
        }
        if let Some(hole) = self.hole(tower) {
            if !has_general {
                all.push((self.general_m, bed.to_owned()));
            }
            all.push((hole.bottom_m, "bottom of the scour hole".to_owned()));
        }
        all
    }
}

/// The hole of local scour around a pile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hole {
    /// Height of its rim, m.
    pub top_m: f64,
    /// Height of its bottom, m.
    pub bottom_m: f64,
}

impl Hole {
    /// The distance of the side of the hole from the pile at a height.
    pub fn beside_m(&self, height_m: f64) -> f64 {
        SLOPE * (height_m - self.bottom_m).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use towermodes::{
        Ground, GroundLayer, LayerSoil, Material, Sand, Scour, SoilModel, Station, Tower,
        TowerDescription,
    };

    use super::Surface;

    #[test]
    fn levels_of_general_and_local_scour_are_told_apart() {
        let scoured = |general_m, local_m| {
            let layer = GroundLayer::new(
                [-30.0, -80.0],
                LayerSoil::Sand(Sand::default()),
                SoilModel::Api,
            );
            let ground = Ground {
                scour: Scour { general_m, local_m },
                ..Ground::new(-30.0, vec![layer])
            };
            let tower = TowerDescription {
                materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
                stations: vec![
                    Station::new(-70.0, 6.0, 0.06),
                    Station::new(80.0, 4.0, 0.02),
                ],
                ..TowerDescription::default()
            };
            let description = TowerDescription {
                ground: Some(ground),
                ..tower.clone()
            };
            let tower = Tower::new(tower).expect("a tower");
            let surface = Surface::of(&description).expect("layers");
            let levels = surface.labelled(&tower, "seabed").into_iter();
            levels
                .map(|(height_m, name)| format!("{height_m}: {name}"))
                .collect::<Vec<_>>()
        };
        assert_eq!(scoured(0.0, 0.0), [""; 0]);
        assert_eq!(
            scoured(1.0, 8.0),
            [
                "-30: seabed before scour",
                "-31: seabed after general scour",
                "-39: bottom of the scour hole"
            ]
        );
        assert_eq!(
            scoured(0.0, 8.0),
            ["-30: seabed", "-38: bottom of the scour hole"]
        );
    }
}
