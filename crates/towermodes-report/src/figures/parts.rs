//! The parts of a tower that are drawn. The drawing and the scene in space are two projections of
//! them.

use towermodes::space::SpatialMatrix;
use towermodes::{
    FloatingPlatform, FoundationSprings, PointMass, Rna, StiffnessFoundation, Support, Tower,
    TowerDescription, Water,
};

use super::outline::outer_diameter_m;
use super::scour::{Hole, Surface};
use super::substructure::Substructure;

/// A platform whose centre is deeper below the base than this multiple of the tower height is not
/// drawn completely.
const DEEPEST: f64 = 4.0;

/// A tower with its RNA, its foundation and its surroundings.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts<'a> {
    /// The description as it was given.
    pub given: &'a TowerDescription,
    /// The same, or with rows of springs in place of soil in layers.
    pub description: &'a TowerDescription,
    /// The tower made from the description.
    pub tower: &'a Tower,
    /// The surface of its soil, if that is given in layers.
    pub surface: Option<Surface>,
}

impl<'a> Parts<'a> {
    /// The parts of a description and its tower.
    pub fn new(description: &'a TowerDescription, tower: &'a Tower) -> Self {
        Self {
            given: description,
            description,
            tower,
            surface: Surface::of(description),
        }
    }

    /// The hole of local scour beside the tower.
    pub fn hole(&self) -> Option<Hole> {
        self.surface?.hole(self.tower)
    }

    /// The heights of the surface of scoured soil with their names; none without scour.
    pub fn scoured_levels(&self) -> Vec<(f64, String)> {
        let bed = match self.description.water {
            Some(_) => "seabed",
            None => "ground",
        };
        let surface = self.surface.iter();
        surface
            .flat_map(|surface| surface.labelled(self.tower, bed))
            .collect()
    }

    /// Radius of the shell at a height, m.
    pub fn radius_m(&self, height_m: f64) -> f64 {
        0.5 * outer_diameter_m(self.tower, height_m)
    }

    /// The RNA, if there is one.
    pub fn rna(&self) -> Option<&'a Rna> {
        Some(self.tower.rna()).filter(|rna| !rna.is_absent())
    }

    /// The point masses, each with the cube root of its ratio to the heaviest.
    pub fn masses(&self) -> impl Iterator<Item = (&'a PointMass, f64)> {
        let masses = &self.description.point_masses;
        let heaviest_kg = masses.iter().map(|mass| mass.mass_kg).fold(0.0, f64::max);
        masses.iter().map(move |mass| match heaviest_kg > 0.0 {
            true => (mass, (mass.mass_kg / heaviest_kg).clamp(0.0, 1.0).cbrt()),
            false => (mass, 1.0),
        })
    }

    /// The springs below the base, unless they hold it or there are none: of two planes of a matrix
    /// the stiffer one, and the terms on its diagonal alone. With those of the soil at a pile tip.
    pub fn springs(&self) -> Option<FoundationSprings> {
        let mut springs = match self.given.foundation.support() {
            Support::Springs(springs) => *springs,
            Support::Stiffness(matrices) => on_diagonal(matrices),
            Support::Clamped | Support::Floating(_) | Support::Form(_) | Support::Frame(_) => {
                return None;
            }
        };
        if let Some(tip) = self.tower.springs_at_tip() {
            springs.lateral_n_per_m += tip.lateral_n_per_m;
            springs.rocking_n_m += tip.rocking_n_m;
            springs.vertical_n_per_m += tip.vertical_n_per_m;
            springs.torsion_n_m += tip.torsion_n_m;
        }
        (!are_rigid(&springs)).then_some(springs)
    }

    /// The platform of a floating tower.
    pub fn platform(&self) -> Option<Platform<'a>> {
        match self.description.foundation.support() {
            Support::Floating(of) => Some(Platform {
                of,
                tower: self.tower,
            }),
            Support::Clamped
            | Support::Springs(_)
            | Support::Stiffness(_)
            | Support::Form(_)
            | Support::Frame(_) => None,
        }
    }

    /// The frame under the tower.
    pub fn substructure(&self) -> Option<Substructure<'a>> {
        let of = self.tower.frame()?;
        Some(Substructure { of })
    }

    /// The lowest height of the bottom-fixed structure, m: of the tower or of the frame under it.
    pub fn foot_m(&self) -> f64 {
        let base_m = self.tower.base_m();
        let low_m = self.substructure().map(|frame| frame.heights_m()[0]);
        low_m.map_or(base_m, |low_m| low_m.min(base_m))
    }

    /// The height of the ground around the tower, m, if there is any: the seabed, the surface of
    /// the soil, or the mudline of the frame under it.
    pub fn ground_m(&self) -> Option<f64> {
        let water = self.description.water;
        let of_frame = || self.substructure()?.ground_m();
        let bed_m = water.map(|water| self.bed_m(&water));
        // Scour lowers the surface of the layers below the bed.
        let layers_m = self.surface.map(|surface| surface.general_m);
        let bed_m = layers_m.or(bed_m).or_else(of_frame);
        let surfaces = self.description.soil.iter().filter_map(|rows| rows.last());
        let surface_m = surfaces.map(|row| row.height_m).reduce(f64::max);
        match (bed_m, surface_m) {
            (Some(bed_m), Some(surface_m)) => Some(bed_m.max(surface_m)),
            (bed_m, surface_m) => bed_m.or(surface_m),
        }
    }

    /// The height of the seabed, m: without a given one the surface of the soil at the base.
    pub fn bed_m(&self, water: &Water) -> f64 {
        water.bed_m.unwrap_or_else(|| {
            let above_base_m = match self.given.foundation.support() {
                Support::Form(form) => form.buried().surface_above_base_m(),
                Support::Clamped
                | Support::Springs(_)
                | Support::Stiffness(_)
                | Support::Floating(_)
                | Support::Frame(_) => 0.0,
            };
            self.tower.base_m() + above_base_m
        })
    }

    /// The height of the water surface, m: around the tower, the frame under it or its floating
    /// platform.
    pub fn water_m(&self) -> Option<f64> {
        let around_m = self.description.water.map(|water| water.level_m);
        let around_m = around_m.or_else(|| self.substructure()?.water_m());
        around_m.or_else(|| self.platform()?.surface_m())
    }

    /// The height at which wires end in the drawing, m: the ground, or the base if that is above a
    /// wire's lower end or if there is no ground.
    pub fn wires_ground_m(&self) -> f64 {
        let heights_m = self.description.wires.iter().map(|wires| wires.height_m);
        let lowest_m = heights_m.fold(f64::INFINITY, f64::min);
        let base_m = self.tower.base_m();
        let ground_m = self.ground_m().filter(|ground_m| *ground_m < lowest_m);
        ground_m.map_or(base_m, |ground_m| ground_m.max(base_m))
    }
}

fn on_diagonal(foundation: &StiffnessFoundation) -> FoundationSprings {
    let k = &foundation.stiffness;
    FoundationSprings {
        lateral_n_per_m: k[0][0].max(k[1][1]),
        rocking_n_m: k[3][3].max(k[4][4]),
        coupling_n: 0.0,
        vertical_n_per_m: k[2][2],
        torsion_n_m: k[5][5],
    }
}

fn are_rigid(springs: &FoundationSprings) -> bool {
    let values = [
        springs.lateral_n_per_m,
        springs.rocking_n_m,
        springs.vertical_n_per_m,
        springs.torsion_n_m,
    ];
    values.iter().all(|value| value.is_infinite())
}

/// A floating platform with the tower on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Platform<'a> {
    /// The given platform.
    pub of: &'a FloatingPlatform,
    tower: &'a Tower,
}

impl Platform<'_> {
    /// The lowest height of the drawn platform, m.
    pub fn keel_m(&self) -> f64 {
        let (base_m, height_m) = (self.tower.base_m(), self.tower.height_m());
        let below = |depth_m: f64| depth_m.clamp(0.1 * height_m, DEEPEST * height_m);
        let of_center = below(base_m - self.of.center_m[2]);
        let mut depth_m = of_center + (0.25 * of_center).min(0.2 * height_m);
        if let Some(surface_m) = self.surface_m() {
            depth_m = depth_m.max(below(base_m - surface_m + 0.1 * height_m));
        }
        base_m - depth_m
    }

    /// The drawn water level, m: the reference height of the hydrostatic stiffness.
    pub fn surface_m(&self) -> Option<f64> {
        let has_buoyancy = self.of.hydrostatic.matrix != SpatialMatrix::default();
        has_buoyancy.then_some(self.of.hydrostatic.height_m)
    }

    /// Whether there are moorings.
    pub fn is_moored(&self) -> bool {
        self.of.mooring.matrix != SpatialMatrix::default() || self.of.mooring_lines.is_some()
    }
}

/// Nacelle, hub and blade roots from the side, in any unit of length: x from the tower axis,
/// heights from the tower top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RnaForm {
    /// Upwind end of the nacelle.
    pub front: f64,
    /// Downwind end of the nacelle.
    pub back: f64,
    /// Its height.
    pub height: f64,
    /// Length of the hub upwind of the nacelle.
    pub nose_length: f64,
    /// Half the height of the hub.
    pub nose_radius: f64,
    /// Position of the blades.
    pub blades_at: f64,
}

impl RnaForm {
    /// The unit of length of the form, in radii of the tower top.
    pub const UNITS: f64 = 1.4;

    /// The form for a unit of length. The nacelle is twice as high as the centre of mass is above
    /// the top, but at least 1.3 units and at most `most`.
    pub fn new(unit: f64, center_above: f64, most: f64) -> Self {
        let front = -1.7 * unit;
        let height = (2.0 * center_above).clamp(1.3 * unit, most.max(1.3 * unit));
        Self {
            front,
            back: 2.1 * unit,
            height,
            nose_length: 0.9 * unit,
            nose_radius: 0.42 * height,
            blades_at: front - 0.35 * unit,
        }
    }
}
