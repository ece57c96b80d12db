//! Members in the still water of a tower: added mass, marine growth, water inside.

use super::super::parts::surroundings::Water;
use super::axes::{difference, norm};
use super::coat::{CoatKind, FrameCoat};
use super::description::FrameDescription;
use super::member::{FrameMember, MemberKind, SectionEnds};
use crate::inputs::{Input, Inputs, Limit};

/// Marine growth and flooded members of the frame in the water of a tower.
///
/// All tubes in the water get the added mass of [`Water`], unless they have coats of their own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MembersInWater {
    /// The members, from 0, that have water inside up to its level.
    pub flooded: Vec<usize>,
    /// Marine growth by height.
    pub growth: Vec<MarineGrowth>,
}

/// Marine growth on all tubes between two heights; it makes them thicker for the added mass.
#[derive(Debug, Clone, Copy, PartialEq, Inputs)]
pub struct MarineGrowth {
    /// Where it ends, m.
    #[input(Input::height("top", "the upper end of the growth"))]
    pub top_m: f64,
    /// Where it begins, m.
    #[input(Input::height("bottom", "the lower end of the growth"))]
    pub bottom_m: f64,
    /// Thickness, m.
    #[input(Input::new("thickness", " m", Limit::NotNegative, "the thickness of the growth")
        .usual([0.0, 0.5], "it is mostly 0.05 to 0.15 m"))]
    pub thickness_m: f64,
    /// Density, kg/m³.
    #[input(Input::new("density", " kg/m3", Limit::NotNegative, "the density of the growth")
        .or(MarineGrowth::USUAL_KG_PER_M3)
        .usual([900.0, 2000.0], "growth has about 1100 to 1400; the unit is kg/m3"))]
    pub density_kg_per_m3: f64,
}

impl MarineGrowth {
    /// Density where none is known, kg/m³: that of hard growth (DNV-RP-C205, 2010).
    pub const USUAL_KG_PER_M3: f64 = 1325.0;
}

/// Part of a member between two fractions of its length.
type Range = [f64; 2];

impl MembersInWater {
    /// Adds water and growth to the members that have no coats yet.
    pub(super) fn put_on(&self, frame: &mut FrameDescription, water: &Water) {
        let joints = std::mem::take(&mut frame.joints);
        for (index, member) in frame.members.iter_mut().enumerate() {
            let ends_m = member.joints.map(|joint| joints[joint].position_m);
            if member.coats.is_empty() && norm(difference(ends_m[1], ends_m[0])) > 0.0 {
                let is_flooded = self.flooded.contains(&index);
                let heights_m = ends_m.map(|end| end[2]);
                member.coats = self.coats(member, heights_m, is_flooded, water);
            }
        }
        frame.joints = joints;
    }

    fn coats(
        &self,
        member: &FrameMember,
        heights_m: [f64; 2],
        is_flooded: bool,
        water: &Water,
    ) -> Vec<FrameCoat> {
        let MemberKind::Beam { ends, .. } = &member.kind else {
            return Vec::new();
        };
        let SectionEnds::Tube(tubes) = ends else {
            return Vec::new();
        };
        let outer = tubes.map(|tube| 0.5 * tube.outer_diameter_m);
        let inner = tubes.map(|tube| 0.5 * tube.outer_diameter_m - tube.wall_thickness_m);
        let bed_m = water.bed_m.unwrap_or(f64::NEG_INFINITY);
        let mut coats = Vec::new();
        for range in self.parts(heights_m, [bed_m, water.level_m]) {
            let growth: Vec<&MarineGrowth> = self.growth_at(middle_m(heights_m, range)).collect();
            let thickness_m: f64 = growth.iter().map(|growth| growth.thickness_m).sum();
            let radius_m = at(outer, range).map(|radius| radius + thickness_m);
            // Displaced water also carries weight along members without added mass.
            let kind = CoatKind::AddedMass {
                density_kg_per_m3: water.density_kg_per_m3,
                radius_m,
                across: [water.added_mass_coefficient; 2],
                along: [0.0; 2],
            };
            coats.push(FrameCoat { range, kind });
            let mut below_m = at(outer, range);
            for growth in growth {
                let above_m = below_m.map(|radius| radius + growth.thickness_m);
                coats.push(solid(range, growth.density_kg_per_m3, above_m, below_m));
                below_m = above_m;
            }
        }
        if is_flooded && let Some(range) = within(heights_m, [f64::NEG_INFINITY, water.level_m]) {
            let full = at(inner, range);
            coats.push(solid(range, water.density_kg_per_m3, full, [0.0; 2]));
        }
        coats
    }

    fn growth_at(&self, height_m: f64) -> impl Iterator<Item = &MarineGrowth> {
        let here = move |growth: &&MarineGrowth| {
            growth.bottom_m < height_m && height_m < growth.top_m && growth.thickness_m > 0.0
        };
        self.growth.iter().filter(here)
    }

    /// The parts of a member between two heights, divided where growth begins and ends.
    fn parts(&self, heights_m: [f64; 2], between_m: [f64; 2]) -> Vec<Range> {
        let Some([from, to]) = within(heights_m, between_m) else {
            return Vec::new();
        };
        let [low, high] = heights_m;
        let fraction = |height_m: f64| (height_m - low) / (high - low);
        let borders = self.growth.iter().flat_map(|g| [g.bottom_m, g.top_m]);
        let inside = borders.map(fraction).filter(|at| *at > from && *at < to);
        let mut cuts: Vec<f64> = inside.chain([from, to]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }
}

/// The part of a member whose ends are at two heights (m) between two other heights (m).
fn within([low_m, high_m]: [f64; 2], [bottom_m, top_m]: [f64; 2]) -> Option<Range> {
    if low_m == high_m {
        return (bottom_m < low_m && low_m <= top_m).then_some([0.0, 1.0]);
    }
    let at = |height_m: f64| ((height_m - low_m) / (high_m - low_m)).clamp(0.0, 1.0);
    let ends = [at(bottom_m), at(top_m)];
    let range = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    (range[0] < range[1]).then_some(range)
}

fn at([first, last]: [f64; 2], range: Range) -> [f64; 2] {
    range.map(|s| first + s * (last - first))
}

fn middle_m(heights_m: [f64; 2], [from, to]: Range) -> f64 {
    heights_m[0] + 0.5 * (from + to) * (heights_m[1] - heights_m[0])
}

fn solid(range: Range, density: f64, outer_radius_m: [f64; 2], inner: [f64; 2]) -> FrameCoat {
    let kind = CoatKind::Solid {
        density_kg_per_m3: [density; 2],
        outer_radius_m,
        inner_radius_m: inner,
    };
    FrameCoat { range, kind }
}
