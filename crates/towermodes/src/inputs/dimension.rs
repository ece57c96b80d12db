//! The physical dimensions of input values.

/// The physical dimension of an input value, by its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A number without unit.
    Pure,
    /// m.
    Length,
    /// Degrees.
    Angle,
    /// kg.
    Mass,
    /// kg m: a static moment, or an inertia per length.
    MassTimesLength,
    /// kg m².
    Inertia,
    /// kg/m.
    MassPerLength,
    /// kg/m³.
    Density,
    /// N: a force, or a coupling of a spring.
    Force,
    /// N m: a moment, or a spring against rotation.
    Moment,
    /// N m²: a bending or torsional stiffness.
    Bending,
    /// N/m: a spring.
    ForcePerLength,
    /// N/m²: a spring per length.
    ForcePerArea,
    /// N/m³: a unit weight, or the growth of a spring with the depth.
    ForcePerVolume,
    /// Pa.
    Pressure,
    /// m/s.
    Velocity,
    /// m/s².
    Acceleration,
    /// Revolutions per minute.
    RotorSpeed,
    /// 1/rad.
    PerAngle,
    /// m³.
    Volume,
    /// An entry of a matrix of stiffness or inertia, whose dimension depends on its row and column.
    OfEntries,
}

impl Dimension {
    /// The dimension of a number with this unit; none for an unknown unit.
    pub fn of_unit(unit: &str) -> Option<Self> {
        Some(match unit {
            "" => Self::Pure,
            "m" => Self::Length,
            "degrees" => Self::Angle,
            "kg" => Self::Mass,
            "kg m" => Self::MassTimesLength,
            "kg m2" => Self::Inertia,
            "kg/m" => Self::MassPerLength,
            "kg/m3" => Self::Density,
            "N" => Self::Force,
            "N m" => Self::Moment,
            "N m2" => Self::Bending,
            "N/m" => Self::ForcePerLength,
            "N/m2" => Self::ForcePerArea,
            "N/m3" => Self::ForcePerVolume,
            "Pa" => Self::Pressure,
            "m/s" => Self::Velocity,
            "m/s2" => Self::Acceleration,
            "rpm" => Self::RotorSpeed,
            "per rad" => Self::PerAngle,
            "m3" => Self::Volume,
            "N/m, N, N m" | "kg, kg m, kg m2" => Self::OfEntries,
            _ => return None,
        })
    }
}
