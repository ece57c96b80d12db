//! Towers on members and on moored platforms: their pictures, their tables, their motion.

use towermodes::frame::{
    CoatKind, Frame, FrameCoat, FrameDescription, FrameFoundation, FrameJoint, FrameMember,
    FrameSupport, Transition,
};
use towermodes::mooring::{LineType, MooringDescription, MooringLine, MooringPoint};
use towermodes::tower::{MooringLines, Tube};
use towermodes::{
    FloatingPlatform, Foundation, Inertia, Material, ReferredMatrix, RigidBody, TowerDescription,
};
use towermodes_report::figures;

use super::{content, moving, page_of, pole, section};
use crate::pictures::{check, keep, solved};

/// The pole on three legs in 20 m of water, with growth on one.
fn on_legs() -> TowerDescription {
    let pole = pole();
    let base_m = pole.stations[0].height_m;
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let section = Tube {
        outer_diameter_m: 0.5,
        wall_thickness_m: 0.02,
    };
    let points = [
        [8.0, 0.0, -20.0],
        [-4.0, 7.0, -20.0],
        [-4.0, -7.0, -20.0],
        [4.0, 0.0, 0.0],
        [-2.0, 3.5, 0.0],
        [-2.0, -3.5, 0.0],
    ];
    let joints = points
        .iter()
        .enumerate()
        .map(|(k, [x, y, z])| FrameJoint::new((k + 1).to_string(), [*x, *y, base_m + z]));
    let pairs = [[0, 3], [1, 4], [2, 5], [3, 4], [4, 5], [5, 3], [0, 4]];
    let members = pairs.iter().enumerate();
    let members =
        members.map(|(k, pair)| FrameMember::tube(k.to_string(), *pair, [section; 2], steel));
    let mut members: Vec<FrameMember> = members.collect();
    let coat = |kind| FrameCoat {
        range: [0.0, 0.75],
        kind,
    };
    members[0].coats = vec![
        coat(CoatKind::Solid {
            density_kg_per_m3: [1325.0; 2],
            outer_radius_m: [0.3; 2],
            inner_radius_m: [0.25; 2],
        }),
        coat(CoatKind::AddedMass {
            density_kg_per_m3: 1025.0,
            radius_m: [0.3; 2],
            across: [1.0; 2],
            along: [0.0; 2],
        }),
    ];
    let frame = Frame::new(FrameDescription {
        joints: joints.collect(),
        members,
        supports: (0..3).map(FrameSupport::clamped).collect(),
        transition: Some(Transition {
            position_m: [0.0, 0.0, base_m],
            joints: vec![3, 4, 5],
            is_held: false,
        }),
        ..FrameDescription::default()
    });
    let piece = RigidBody {
        mass_kg: 1000.0,
        ..RigidBody::default()
    };
    let foundation = FrameFoundation::new(frame.expect("a frame"), piece).expect("a foundation");
    TowerDescription {
        foundation: Foundation::Frame(Box::new(foundation)),
        ..pole
    }
}

/// The pole on a platform on three chains in 100 m of water.
fn moored() -> TowerDescription {
    let pole = pole();
    let base_m = pole.stations[0].height_m;
    let mut description = MooringDescription {
        depth_m: 100.0,
        line_types: vec![LineType::new(0.1, 50.0, 3e8)],
        ..MooringDescription::default()
    };
    for angle_deg in [0.0_f64, 120.0, 240.0] {
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        let at = |radius_m: f64, z: f64| [radius_m * cos, radius_m * sin, z];
        let anchor = description.points.len();
        description
            .points
            .push(MooringPoint::anchor(at(300.0, -100.0)));
        description
            .points
            .push(MooringPoint::fairlead(at(5.0, -10.0)));
        description.lines.push(MooringLine {
            line_type: 0,
            length_m: 320.0,
            points: [anchor, anchor + 1],
        });
    }
    let mut hydrostatic = ReferredMatrix {
        height_m: base_m - 5.0,
        ..ReferredMatrix::default()
    };
    for (i, value) in [(2, 1e6), (3, 1e9), (4, 1e9)] {
        hydrostatic.matrix[i][i] = value;
    }
    let platform = FloatingPlatform {
        mass_kg: 1e6,
        center_m: [0.0, 0.0, base_m - 20.0],
        inertia_kg_m2: Inertia {
            xx: 1e8,
            yy: 1e8,
            zz: 1e8,
            ..Inertia::default()
        },
        hydrostatic,
        mooring_lines: Some(Box::new(MooringLines {
            description,
            still_water_m: base_m - 5.0,
        })),
        ..FloatingPlatform::default()
    };
    TowerDescription {
        foundation: Foundation::Floating(Box::new(platform)),
        ..pole
    }
}

#[test]
fn pictures_of_what_is_below_are_readable() {
    for (what, description) in [("legs", on_legs()), ("moored", moored())] {
        let tower = towermodes::Tower::new(description.clone()).expect("a tower");
        let solution = solved(&tower, 8);
        let mut drawn = vec![
            figures::tower(&description, &tower),
            figures::shapes(&description, &tower, &solution),
            figures::structure(&description, &tower, &solution),
        ];
        drawn.extend(figures::mooring(&description, &tower));
        drawn.iter().for_each(|figure| check(what, figure));
        keep(what, &drawn);
    }
}

#[test]
fn members_are_tabulated_with_their_masses() {
    let page = page_of(&content(on_legs(), None));
    let input = section(&page, "input");
    // 1325 π (0.3² − 0.25²) times three quarters of 20.396 m.
    for said in ["tube", "marine growth", "1751", "transition piece", "1000"] {
        assert!(input.contains(said), "{said}");
    }
    let assumptions = section(&page, "assumptions");
    assert!(assumptions.contains("change the stiffness of its members"));
    assert!(assumptions.contains("frame of 7 members"));
}

#[test]
fn members_move_with_the_tower() {
    let page = page_of(&content(on_legs(), None));
    let moving = moving(&page);
    let frame = &moving["frame"];
    assert_eq!(frame["joints"].as_array().map(Vec::len), Some(6));
    assert_eq!(frame["members"].as_array().map(Vec::len), Some(7));
    let motion = moving["modes"][0]["frame"].as_array().expect("a motion");
    assert_eq!(motion.len(), 3 * (6 + 3 * 7));
}

#[test]
fn mooring_lines_are_tabulated_and_drawn() {
    let page = page_of(&content(moored(), None));
    let input = section(&page, "input");
    for said in ["Mooring lines at rest in 100 m of water", "from above"] {
        assert!(input.contains(said), "{said}");
    }
    let bodies = moving(&page)["bodies"].as_array().expect("bodies").clone();
    let ropes = bodies.iter().filter(|body| body["form"] == "line");
    let ends = ropes.map(|rope| {
        let points = rope["points"].as_array().expect("points").clone();
        (points[0][2].as_f64(), points[points.len() - 1][2].as_f64())
    });
    let still_m = pole().stations[0].height_m - 5.0;
    let expected = (Some(still_m - 10.0), Some(still_m - 100.0));
    assert_eq!(ends.collect::<Vec<_>>(), vec![expected; 3]);
}
