//! Floating turbines in windIO with the dimensions of public reference platforms.

/// The radius on which the columns of the semi-submersible stand, m, and their angles.
const COLUMNS: [(usize, &str); 3] = [(1, "3.14159265"), (2, "1.0471976"), (3, "-1.0471976")];

/// The dimensions of the VolturnUS-S semi-submersible (Allen et al., 2020) as in its public windIO
/// file of version 1: angles in radians, a mast of 10 m with this mass (kg) at its top in place of
/// tower and turbine.
pub fn volturnus(top_kg: f64) -> String {
    let mut joints = "            - {name: main_keel, location: [0.0, 0.0, -20.0]}
            - {name: main_freeboard, location: [0.0, 0.0, 15.0], transition: True}
"
    .to_owned();
    let mut members = "            - name: main_column
              joint1: main_keel
              joint2: main_freeboard
              Ca: 1.0
              outer_shape: {shape: circular, outer_diameter: {grid: [0.0, 1.0], values: [10.0, 10.0]}}
              internal_structure:
                layers: [{name: wall, material: steel, thickness: {grid: [0.0, 1.0], values: [0.05, 0.05]}}]
                bulkhead: {material: steel, thickness: {grid: [0.0, 1.0], values: [0.05, 0.05]}}
              axial_joints: [{name: main_upper, grid: 0.987}, {name: main_lower, grid: 0.1}]
"
    .to_owned();
    let (mut nodes, mut lines) = (String::new(), String::new());
    for (n, angle) in COLUMNS {
        // One joint of the public file has its angle rounded in another way.
        let upper = angle.replace("1.0471976", if n == 2 { "1.0471975" } else { "1.0471976" });
        joints += &format!(
            "            - {{name: col{n}_keel, location: [51.75, {angle}, -20.0], cylindrical: True}}
            - {{name: col{n}_freeboard, location: [51.75, {upper}, 15.0], cylindrical: True}}
            - {{name: anchor{n}, location: [837.8, {angle}, -200.0], cylindrical: True}}
"
        );
        members += &format!(
            "            - name: column{n}
              joint1: col{n}_keel
              joint2: col{n}_freeboard
              Ca: 1.0
              outer_shape: {{shape: circular, outer_diameter: {{grid: [0.0, 1.0], values: [12.5, 12.5]}}}}
              internal_structure:
                layers: [{{name: wall, material: steel, thickness: {{grid: [0.0, 1.0], values: [0.05, 0.05]}}}}]
                bulkhead: {{material: steel, thickness: {{grid: [0.0, 0.05, 0.2, 1.0], values: [0.05, 0.05, 0.05, 0.05]}}}}
                ballasts:
                    - {{variable_flag: False, material: slurry, volume: 169.333333, grid: [0.0, 0.05]}}
                    - {{variable_flag: True, grid: [0.05, 0.2]}}
              axial_joints: [{{name: col{n}_upper, grid: 0.987}}, {{name: col{n}_lower, grid: 0.1}}, {{name: col{n}_fairlead, grid: 0.1714}}]
            - name: upper{n}
              joint1: main_upper
              joint2: col{n}_upper
              Ca: 1.0
              outer_shape: {{shape: circular, outer_diameter: {{grid: [0.0, 1.0], values: [0.91, 0.91]}}}}
              internal_structure:
                layers: [{{name: wall, material: steel, thickness: {{grid: [0.0, 1.0], values: [0.02, 0.02]}}}}]
            - name: lower{n}
              joint1: main_lower
              joint2: col{n}_lower
              Ca: [1.0, 1.0]
              outer_shape: {{shape: circular, outer_diameter: {{grid: [0.0, 1.0], values: [9.6148, 9.6148]}}}}
              internal_structure:
                layers: [{{name: wall, material: steel, thickness: {{grid: [0.0, 1.0], values: [0.04, 0.04]}}}}]
                ballasts: [{{variable_flag: True, grid: [0.0, 1.0]}}]
"
        );
        nodes += &format!(
            "            - {{name: line{n}_anchor, node_type: fixed, joint: anchor{n}}}
            - {{name: line{n}_vessel, node_type: vessel, joint: col{n}_fairlead}}
"
        );
        lines += &format!(
            "            - {{name: line{n}, node1: line{n}_anchor, node2: line{n}_vessel, line_type: main, unstretched_length: 850.0}}\n"
        );
    }
    format!(
        "\
name: VolturnUS-S
components:
    nacelle:
        drivetrain: {{uptilt: 0.0, distance_tt_hub: 2.0, overhang: 5.0}}
        elastic_properties_mb:
            system_mass: {top_kg}
            system_inertia: [0, 0, 0, 0, 0, 0]
            system_center_mass: [0, 0, 0]
    tower:
        outer_shape_bem:
            reference_axis: {{z: {{grid: [0, 1], values: [15.0, 25.0]}}}}
            outer_diameter: {{grid: [0, 1], values: [10.0, 10.0]}}
        internal_structure_2d_fem:
            layers: [{{name: wall, material: steel, thickness: {{grid: [0, 1], values: [0.05, 0.05]}}}}]
    floating_platform:
        transition_piece_mass: 100.e+3
        joints:
{joints}        members:
{members}    mooring:
        nodes:
{nodes}        lines:
{lines}        line_types:
            - {{name: main, diameter: 0.333, type: chain}}
        anchor_types: []
materials:
   - {{name: steel, orth: 0, rho: 7800, E: 200.e+009, nu: 0.3, G: 79.3e+009}}
   - {{name: slurry, orth: 0, rho: 5000., E: 1.0, nu: 0.3, G: 1.0}}
environment: {{gravity: 9.81, water_density: 1025.0, water_depth: 200.0}}
"
    )
}
