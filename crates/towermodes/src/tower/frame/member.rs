//! Members: tubes and other beams, cables, rigid links and springs.

use super::super::parts::material::Material;
use super::super::parts::surroundings::SoilStiffness;
use super::super::pieces::planes::Planes;
use super::super::pieces::section::{Section, SectionMasses, Tube};
use super::coat::FrameCoat;
use super::soil::FrameSoil;
use crate::space::SpatialMatrix;

/// A member between two joints.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameMember {
    /// Name in messages and results, for example the number in a file.
    pub name: String,
    /// Its joints, from 0.
    pub joints: [usize; 2],
    /// Beam, cable, rigid link or spring, with its properties.
    pub kind: MemberKind,
    /// Whether shear deformation and rotary inertia are included where it is a beam (Timoshenko);
    /// false: Euler-Bernoulli with rotary inertia.
    pub shears: bool,
    /// Rotation of the section about the axis of the member, degrees.
    pub spin_deg: f64,
    /// Water and growth that move with it, if it is a beam.
    pub coats: Vec<FrameCoat>,
    /// Soil around it, if it is a beam.
    pub soil: Vec<FrameSoil>,
}

impl FrameMember {
    /// A Timoshenko tube whose diameter and wall are linear between its ends.
    pub fn tube(
        name: impl Into<String>,
        joints: [usize; 2],
        ends: [Tube; 2],
        material: Material,
    ) -> Self {
        let kind = MemberKind::Beam {
            ends: SectionEnds::Tube(ends),
            material,
        };
        Self::new(name, joints, kind)
    }

    /// A member of any kind.
    pub fn new(name: impl Into<String>, joints: [usize; 2], kind: MemberKind) -> Self {
        Self {
            name: name.into(),
            joints,
            kind,
            shears: true,
            spin_deg: 0.0,
            coats: Vec::new(),
            soil: Vec::new(),
        }
    }

    /// The section at a fraction of its length (m), with what moves with it; none if it is no beam.
    pub(crate) fn section_at(&self, fraction: f64, length_m: f64) -> Option<Section> {
        let MemberKind::Beam { ends, material } = &self.kind else {
            return None;
        };
        let mut section = ends.at(fraction, material);
        for coat in &self.coats {
            coat.add(fraction, length_m, &mut section.masses);
        }
        Some(section)
    }
}

/// The type of a member, with its properties.
#[derive(Debug, Clone, PartialEq)]
pub enum MemberKind {
    /// A beam.
    Beam {
        /// Its sections at both ends; linear between them.
        ends: SectionEnds,
        /// Its material.
        material: Material,
    },
    /// A straight cable with pretension T₀. Its length without tension is L₀ = L/(1 + T₀/EA), its
    /// stiffness EA/L₀ along and T₀/L across the axis.
    Cable {
        /// Axial stiffness EA, N.
        axial_n: f64,
        /// Mass per length without tension, kg/m.
        mass_kg_per_m: f64,
        /// Pretension T₀, N; 0: only the stiffness along the axis.
        pretension_n: f64,
    },
    /// A rigid link.
    Rigid {
        /// Mass per length, kg/m.
        mass_kg_per_m: f64,
    },
    /// A spring between its joints, which may coincide.
    Spring(Box<FrameSpring>),
}

/// A spring between two joints. It has no mass, and no lever arm: equal and opposite forces act at
/// both joints.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameSpring {
    /// Stiffness for the motion of the second joint relative to the first, N/m, N, N m.
    pub stiffness: SpatialMatrix,
    /// Its axes as rows; none: the axes of the member.
    pub axes: Option<[[f64; 3]; 3]>,
}

/// The sections of a beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SectionEnds {
    /// Circular tubes; diameter and wall are linear.
    Tube([Tube; 2]),
    /// Rectangles; sides and wall are linear.
    Rectangle([Rectangle; 2]),
    /// Section properties; constant.
    Given(GivenSection),
}

/// A hollow or solid rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// Length of the side along the local x axis, m.
    pub side_a_m: f64,
    /// Length of the side along the local y axis, m.
    pub side_b_m: f64,
    /// Wall thickness, m; 0: solid.
    pub wall_thickness_m: f64,
}

/// Section properties in the local axes x, y of the member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GivenSection {
    /// Area A, m².
    pub area_m2: f64,
    /// Shear areas κA in x and y, m².
    pub shear_areas_m2: [f64; 2],
    /// Second moments of area about x and y, m⁴.
    pub second_moments_m4: [f64; 2],
    /// Polar second moment of area, m⁴: times the density the inertia per length about the axis.
    pub polar_m4: f64,
    /// Torsion constant, m⁴.
    pub torsion_m4: f64,
}

impl SectionEnds {
    /// Whether the section is the same along the whole member.
    pub(crate) fn are_equal(&self) -> bool {
        match self {
            Self::Tube([from, to]) => from == to,
            Self::Rectangle([from, to]) => from == to,
            Self::Given(_) => true,
        }
    }

    /// The section at a fraction of the length from the first joint.
    pub(crate) fn at(&self, fraction: f64, material: &Material) -> Section {
        match self {
            Self::Tube([from, to]) => of_tube(&from.blend(to, fraction), material),
            Self::Rectangle([from, to]) => {
                from.blend(to, fraction).given(material).section(material)
            }
            Self::Given(given) => given.section(material),
        }
    }
}

/// The section of a tube, with the shear coefficient of Steinboeck, Kugi & Mang (2013):
/// κ = 6(1+ν)²(1+q)² / ((1+q)²(7+14ν+8ν²) + 4q(5+10ν+4ν²)) with q = (dᵢ/d)².
fn of_tube(tube: &Tube, material: &Material) -> Section {
    let ratio = tube.inner_diameter_m() / tube.outer_diameter_m;
    let (q, nu) = (ratio * ratio, material.poissons_ratio());
    let square = (1.0 + q) * (1.0 + q);
    let kappa = 6.0 * (1.0 + nu) * (1.0 + nu) * square
        / (square * (7.0 + 14.0 * nu + 8.0 * nu * nu)
            + 4.0 * q * (5.0 + 10.0 * nu + 4.0 * nu * nu));
    let (area, second) = (tube.area_m2(), tube.second_moment_of_area_m4());
    let given = GivenSection {
        area_m2: area,
        shear_areas_m2: [kappa * area; 2],
        second_moments_m4: [second; 2],
        polar_m4: 2.0 * second,
        torsion_m4: 2.0 * second,
    };
    given.section(material)
}

impl Rectangle {
    fn blend(&self, to: &Self, fraction: f64) -> Self {
        let blend = |a: f64, b: f64| a + fraction * (b - a);
        Self {
            side_a_m: blend(self.side_a_m, to.side_a_m),
            side_b_m: blend(self.side_b_m, to.side_b_m),
            wall_thickness_m: blend(self.wall_thickness_m, to.wall_thickness_m),
        }
    }

    /// Sides of the hole, m.
    fn hole_m(&self) -> [f64; 2] {
        match self.wall_thickness_m {
            0.0 => [0.0; 2],
            t => [self.side_a_m - 2.0 * t, self.side_b_m - 2.0 * t],
        }
    }

    /// Area of the section, m².
    pub fn area_m2(&self) -> f64 {
        let [inner_a, inner_b] = self.hole_m();
        self.side_a_m * self.side_b_m - inner_a * inner_b
    }

    /// Second moments of area about the local x and y axes, m⁴.
    pub fn second_moments_m4(&self) -> [f64; 2] {
        let (a, b, [inner_a, inner_b]) = (self.side_a_m, self.side_b_m, self.hole_m());
        [
            (a * b.powi(3) - inner_a * inner_b.powi(3)) / 12.0,
            (b * a.powi(3) - inner_b * inner_a.powi(3)) / 12.0,
        ]
    }

    /// Its section properties: torsion by Bredt's formula for a thin wall, or that of Roark (1954)
    /// for a solid section; shear areas by Cowper (1966).
    pub(crate) fn given(&self, material: &Material) -> GivenSection {
        let (a, b, t) = (self.side_a_m, self.side_b_m, self.wall_thickness_m);
        let area = self.area_m2();
        let [about_x, about_y] = self.second_moments_m4();
        let torsion = match t {
            0.0 => solid_torsion_m4(a, b),
            _ => 2.0 * t * (a - t).powi(2) * (b - t).powi(2) / (a + b - 2.0 * t),
        };
        let nu = material.poissons_ratio();
        GivenSection {
            area_m2: area,
            shear_areas_m2: [area * self.cowper(a, b, nu), area * self.cowper(b, a, nu)],
            second_moments_m4: [about_x, about_y],
            polar_m4: about_x + about_y,
            torsion_m4: torsion,
        }
    }

    /// Cowper's coefficient for shear along the side `along`: 10(1+ν)/(12+11ν) of a solid
    /// rectangle, and that of a thin-walled box with m = b/h.
    fn cowper(&self, along: f64, across: f64, nu: f64) -> f64 {
        if self.wall_thickness_m == 0.0 {
            return 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
        }
        // Equal walls: m = b/h, n = b/h for walls of one thickness.
        let m = across / along;
        let n = m;
        10.0 * (1.0 + nu) * (1.0 + 3.0 * m).powi(2)
            / ((12.0 + 72.0 * m + 150.0 * m * m + 90.0 * m.powi(3))
                + nu * (11.0 + 66.0 * m + 135.0 * m * m + 90.0 * m.powi(3))
                + 10.0 * n * n * ((3.0 + nu) * m + 3.0 * m * m))
    }
}

/// Torsion constant of a solid rectangle, m⁴; Roark (1954), table of torsion.
fn solid_torsion_m4(a: f64, b: f64) -> f64 {
    let (long, short) = (0.5 * a.max(b), 0.5 * a.min(b));
    let ratio = short / long;
    long * short.powi(3) * (16.0 / 3.0 - 3.36 * ratio * (1.0 - ratio.powi(4) / 12.0))
}

impl GivenSection {
    fn section(&self, material: &Material) -> Section {
        let (e, g) = (material.youngs_modulus_pa, material.shear_modulus_pa);
        let density = material.density_kg_per_m3;
        let [about_x, about_y] = self.second_moments_m4;
        let [shear_x, shear_y] = self.shear_areas_m2;
        // Fore-aft is bending in the plane of x and the axis: about y.
        let planes = |fore_aft, side_side| Planes {
            fore_aft,
            side_side,
        };
        Section {
            masses: SectionMasses {
                mass_kg_per_m: density * self.area_m2,
                water_kg_per_m: 0.0,
                rotary_inertia_kg_m: planes(density * about_y, density * about_x),
                polar_inertia_kg_m: density * self.polar_m4,
            },
            bending_n_m2: planes(e * about_y, e * about_x),
            torsion_n_m2: g * self.torsion_m4,
            axial_n: e * self.area_m2,
            shear_flexibility_per_n: planes(1.0 / (g * shear_x), 1.0 / (g * shear_y)),
            soil: SoilStiffness::default(),
        }
    }
}
