//! The parts of a windIO file that are read; all else, such as the tables of airfoils, is skipped.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::yaml::Node;

/// The file.
#[derive(Debug, Default)]
pub(super) struct Outline {
    pub(super) version: Option<Node>,
    pub(super) name: Option<Node>,
    pub(super) assembly: Option<Node>,
    pub(super) components: Option<Components>,
    pub(super) materials: Option<Node>,
    pub(super) environment: Option<Node>,
    pub(super) control: Option<Node>,
    /// Keys that are not read.
    pub(super) unknown: Vec<String>,
}

/// The parts of the turbine.
#[derive(Debug, Default)]
pub(super) struct Components {
    pub(super) tower: Option<Node>,
    pub(super) monopile: Option<Node>,
    pub(super) jacket: Option<IgnoredAny>,
    pub(super) floating_platform: Option<IgnoredAny>,
    pub(super) mooring: Option<IgnoredAny>,
    /// The whole rotor-nacelle assembly, in the first files of version 1.
    pub(super) rna: Option<Node>,
    pub(super) hub: Option<Node>,
    /// Version 1.
    pub(super) nacelle: Option<Node>,
    /// Version 2.
    pub(super) drivetrain: Option<Node>,
    /// Version 2.
    pub(super) yaw: Option<Node>,
    pub(super) blade: Option<Blade>,
    /// Keys that are not read.
    pub(super) unknown: Vec<String>,
}

/// The parts of a blade that give its mass and its chords.
#[derive(Debug, Default, Deserialize)]
pub(super) struct Blade {
    /// Version 2.
    reference_axis: Option<Node>,
    /// Version 1.
    outer_shape_bem: Option<BladeShape>,
    /// Version 2.
    outer_shape: Option<BladeShape>,
    /// Version 2.
    structure: Option<BladeStructure>,
    /// Version 1.
    elastic_properties_mb: Option<BladeTables>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeShape {
    reference_axis: Option<Node>,
    chord: Option<Node>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeStructure {
    elastic_properties: Option<BladeMatrices>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeTables {
    six_x_six: Option<BladeMatrices>,
}

#[derive(Debug, Default, Deserialize)]
struct BladeMatrices {
    inertia_matrix: Option<Node>,
    /// Version 1.
    stiff_matrix: Option<Node>,
    /// Version 2.
    stiffness_matrix: Option<Node>,
}

impl Blade {
    pub(super) fn axis(&self) -> Option<&Node> {
        let shape = self.outer_shape_bem.as_ref();
        let older = shape.and_then(|shape| shape.reference_axis.as_ref());
        self.reference_axis.as_ref().or(older)
    }

    /// The chords along the blade.
    pub(super) fn chord(&self) -> Option<&Node> {
        let shapes = [&self.outer_shape, &self.outer_shape_bem];
        let mut chords = shapes.into_iter().flatten().map(|shape| &shape.chord);
        chords.find_map(Option::as_ref)
    }

    /// Mass and inertia along the blade.
    pub(super) fn inertia_matrix(&self) -> Option<&Node> {
        self.matrices()
            .and_then(|matrices| matrices.inertia_matrix.as_ref())
    }

    /// Stiffness along the blade.
    pub(super) fn stiffness_matrix(&self) -> Option<&Node> {
        let matrices = self.matrices()?;
        let newer = matrices.stiffness_matrix.as_ref();
        newer.or(matrices.stiff_matrix.as_ref())
    }

    fn matrices(&self) -> Option<&BladeMatrices> {
        let newer = self.structure.as_ref().map(|s| &s.elastic_properties);
        let older = self.elastic_properties_mb.as_ref().map(|e| &e.six_x_six);
        newer.or(older).and_then(Option::as_ref)
    }
}

/// The two generations of the format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    /// 1.x: `outer_shape_bem`, angles in radians.
    One,
    /// 2.x: `outer_shape`, angles in degrees.
    Two,
}

impl Version {
    /// An angle of the file in radians.
    pub(super) fn radians(self, angle: f64) -> f64 {
        match self {
            Self::One => angle,
            Self::Two => angle.to_radians(),
        }
    }
}

impl Outline {
    /// Its version, or that of its keys if it is not given.
    pub(super) fn version(&self, text: &str) -> Version {
        let said = self.version.as_ref().map(|node| node.name(text));
        match said.and_then(|version| version.trim().chars().next()) {
            Some('1') => Version::One,
            Some('2'..='9') => Version::Two,
            _ if self.has_old_keys() => Version::One,
            _ => Version::Two,
        }
    }

    fn has_old_keys(&self) -> bool {
        let Some(components) = &self.components else {
            return false;
        };
        let parts = [&components.tower, &components.monopile];
        let old = ["outer_shape_bem", "internal_structure_2d_fem"];
        let mut parts = parts.into_iter().flatten();
        parts.any(|part| old.iter().any(|key| part.get(key).is_some()))
            || components.nacelle.is_some()
    }
}
