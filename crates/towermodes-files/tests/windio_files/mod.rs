//! Small turbines in windIO.

/// Tower and monopile of version 2 whose quantities have different grids.
pub const VERSION_2: &str = "\
windIO_version: '2.0'
name: small
components:
    tower:
        outer_shape:
            outer_diameter:
                grid: [0.0, 1.0]
                values: [6.0, 4.0]
        structure:
            outfitting_factor: 1.1
            layers:
              - name: wall
                material: steel
                thickness:
                    grid: [0.0, 0.5, 0.5, 1.0]
                    values: [0.04, 0.04, 0.03, 0.02]
            elastic_properties:
                point_mass: {grid: [0.5, 1.0], mass: [0.0, 700.0]}
        reference_axis:
            x: {grid: [0, 1], values: [0, 0]}
            z:
                grid: [0.0, 0.25, 1.0]
                values: [10, 30.0, 90.0]
    monopile:
        transition_piece_mass: 5e4
        gravity_foundation_mass: 2.e+5
        outer_shape: {outer_diameter: {grid: [0, 1], values: [6, 6]}}
        structure:
            layers:
              - {name: pile, material: steel, thickness: {grid: [0, 1], values: [0.06, 0.06]}}
        reference_axis: {z: {grid: [0, 1], values: [-40, 10]}}
    drivetrain:
        elastic_properties:
            mass: 100000
            inertia: [1.0e5, 2e5, 3e5, 0, 0, 0]
            location: [-1.0, 0.0, 2.0]
materials:
  - name: glue
    orth: 0
    E: oops
  - name: steel
    orth: 0
    rho: 8000
    E: 200e9
    nu: 0.25
";

/// Tower and monopile of version 1 in 20 m of water, with a complete assembly.
pub const VERSION_1: &str = "\
name: older
assembly: {number_of_blades: 3, rotor_orientation: Upwind}
components:
    blade:
        outer_shape_bem:
            chord: {grid: [0, 1], values: [1, 1]}
            reference_axis: &blade_axis
                x: {grid: [0, 1], values: [0, 0]}
                y: {grid: [0, 1], values: [0, 0]}
                z: {grid: [0, 0.3, 1], values: [0, 3, 10]}
        elastic_properties_mb:
            six_x_six:
                reference_axis: *blade_axis
                inertia_matrix:
                    grid: [0.0, 1.0]
                    values:
                      - [10.0, 0, 0, 0, 0, 0, 10.0, 0, 0, 0, 0, 10.0, 0, 0, 0, 1, 0, 0, 1, 0, 2]
                      - [10.0, 0, 0, 0, 0, 0, 10.0, 0, 0, 0, 0, 10.0, 0, 0, 0, 1, 0, 0, 1, 0, 2]
    hub:
        diameter: 2.0
        cone_angle: 0.0
        elastic_properties_mb: {system_mass: 500, system_inertia: [70, 0, 0, 0, 0, 0], system_center_mass: [0, 0, 0]}
    nacelle:
        drivetrain: {uptilt: 0.0, distance_tt_hub: 2.0, overhang: 5.0}
        elastic_properties_mb:
            system_mass: 1000
            yaw_mass: 200
            system_inertia: [40, 50, 60, 0, 0, 0]
            system_center_mass: [0, 0, 1.0]
    tower:
        outer_shape_bem:
            reference_axis:
                z: {grid: [0, 1], values: [10, 90]}
            outer_diameter: {grid: [0, 1], values: [6.0, 4.0]}
        internal_structure_2d_fem:
            layers:
              - name: wall
                material: steel
                thickness: {grid: [0, 1], values: [0.05, 0.02]}
    monopile:
        outer_shape_bem:
            reference_axis:
                z: {grid: [0, 1], values: [-50, 10]}
            outer_diameter: {grid: [0, 1], values: [6.0, 6.0]}
        internal_structure_2d_fem:
            layers:
              - name: wall
                material: steel
                thickness: {grid: [0, 1], values: [0.05, 0.05]}
materials:
  - {name: steel, orth: 0, rho: 8000, E: 2.e+11, G: 8.e+010, nu: 0.25}
environment: {water_depth: 20, soil_shear_modulus: 140.e+6, soil_poisson: 0.4}
";

/// A tower of steel with concrete inside up to half its height.
pub const LAYERED: &str = "\
windIO_version: '2.0'
name: layered
components:
    tower:
        outer_shape: {outer_diameter: {grid: [0, 1], values: [6.0, 4.0]}}
        structure:
            outfitting_factor: 1.05
            layers:
              - name: outside
                material: steel
                thickness:
                    grid: [0.0, 1.0] # steel
                    values: [0.05, 0.05]
              - name: inside
                material: concrete
                thickness:
                    grid: [0.0, 0.5, 1.0] # concrete
                    values: [0.3, 0.0, 0.0]
        reference_axis: {z: {grid: [0, 1], values: [0, 80]}}
materials:
  - {name: steel, orth: 0, rho: 8000, E: 2.e+11, G: 8.e+10, nu: 0.25}
  - {name: concrete, orth: 0, rho: 2500, E: 4.e+10, nu: 0.25}
";

/// A tower that is a table.
pub const TABLE: &str = "\
windIO_version: '2.0'
name: table
components:
    tower:
        outer_shape: {outer_diameter: {grid: [0, 1], values: [6.0, 6.0]}}
        structure:
            elastic_properties:
                stiffness_matrix:
                    grid: [0.0, 0.5, 1.0]
                    K33: [3e10, 2e10, 1.5e10]
                    K44: [6e11, 5e11, 4e11]
                    K55: [5e11, 4e11, 3e11]
                    K66: [3e11, 3e11, 3e11]
                inertia_matrix:
                    grid: [0.0, 1.0]
                    mass: [5000.0, 3000.0]
        reference_axis: {z: {grid: [0, 1], values: [0, 80]}}
";
