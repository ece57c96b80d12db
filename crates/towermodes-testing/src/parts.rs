//! Parts of a tower from their values, in the units and the order of the fields.

use towermodes::{
    AddedMassRow, FoundationSprings, HalfSpace, Inertia, Planes, PointMass, Water, Wires,
};

/// Springs under the base: lateral, N/m; rocking, N m; coupling, N; vertical, N/m; torsion, N m.
pub const fn springs(
    lateral_n_per_m: f64,
    rocking_n_m: f64,
    coupling_n: f64,
    vertical_n_per_m: f64,
    torsion_n_m: f64,
) -> FoundationSprings {
    FoundationSprings {
        lateral_n_per_m,
        rocking_n_m,
        coupling_n,
        vertical_n_per_m,
        torsion_n_m,
    }
}

/// A round footing: radius and embedment, m; shear modulus, Pa; Poisson's ratio.
pub const fn half_space(
    radius_m: f64,
    embedment_m: f64,
    shear_modulus_pa: f64,
    poissons_ratio: f64,
) -> HalfSpace {
    HalfSpace {
        radius_m,
        embedment_m,
        shear_modulus_pa,
        poissons_ratio,
    }
}

/// Guy wires: height, m; count; stiffness of one, N/m; angle to the ground, degrees.
pub const fn wires(height_m: f64, count: usize, stiffness_n_per_m: f64, angle_deg: f64) -> Wires {
    Wires {
        height_m,
        count,
        stiffness_n_per_m,
        angle_deg,
    }
}

/// Still water: level and bed, m; density, kg/m³; coefficient of added mass; inside the tower too.
pub const fn water(
    level_m: f64,
    bed_m: Option<f64>,
    density_kg_per_m3: f64,
    added_mass_coefficient: f64,
    flooded: bool,
) -> Water {
    Water {
        level_m,
        bed_m,
        density_kg_per_m3,
        added_mass_coefficient,
        flooded,
    }
}

/// A row of added mass: height, m; mass per length, kg/m.
pub const fn added_mass_row(height_m: f64, mass_kg_per_m: f64) -> AddedMassRow {
    AddedMassRow {
        height_m,
        mass_kg_per_m,
    }
}

/// A point mass: height, m; mass, kg; inertia, kg m².
pub const fn point_mass(height_m: f64, mass_kg: f64, inertia_kg_m2: Inertia) -> PointMass {
    PointMass {
        height_m,
        mass_kg,
        inertia_kg_m2,
    }
}

/// A value for each bending plane: fore-aft, side-side.
pub const fn planes<T: Copy>(fore_aft: T, side_side: T) -> Planes<T> {
    Planes {
        fore_aft,
        side_side,
    }
}
