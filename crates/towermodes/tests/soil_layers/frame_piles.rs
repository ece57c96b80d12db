//! Piles of frames in layers of soil: those of a tower, alone and in groups, mirrored, divided.

use super::scour::random_site;
use super::{Random, clay, free_tip, ground, ground_of, layer, oc3, sand};
use crate::towers;
use towermodes::frame::*;
use towermodes::tower::Tube;
use towermodes::{
    AxialModel, Foundation, FoundationSprings, GroundLayer, LayerSoil, Material, Method, Options,
    PyRow, RigidBody, Rna, Scour, ShearModulus, SoilModel, Station, Tower, TowerDescription,
};
use towermodes_testing::with;

/// The part of a tower below its third station as a frame of one vertical member for each pair of
/// stations, and the tower above on it.
fn on_members(whole: &TowerDescription) -> TowerDescription {
    let (pile, above) = (&whole.stations[..2], &whole.stations[2..]);
    let tube = |station: &Station| Tube {
        outer_diameter_m: station.outer_diameter_m,
        wall_thickness_m: station.wall_thickness_m,
    };
    let joint = |name: &str, station: &Station| FrameJoint::new(name, [0.0, 0.0, station.height_m]);
    let ends = [tube(&pile[0]), tube(&pile[1])];
    let material = whole.materials[pile[0].material];
    let mut member = FrameMember::tube("pile", [0, 1], ends, material);
    member.shears = false;
    let held = whole.foundation == free_tip();
    let support = FrameSupport {
        fixed: [false, false, true, false, false, true],
        ..FrameSupport::clamped(0)
    };
    let frame = FrameDescription {
        joints: vec![joint("tip", &pile[0]), joint("top", &pile[1])],
        members: vec![member],
        supports: held.then_some(support).into_iter().collect(),
        ..FrameDescription::default()
    };
    TowerDescription {
        stations: above.to_vec(),
        foundation: carried(frame, &[1], [0.0, 0.0, pile[1].height_m]),
        ..whole.clone()
    }
}

fn carried(mut frame: FrameDescription, joints: &[usize], position_m: [f64; 3]) -> Foundation {
    frame.transition = Some(Transition {
        position_m,
        joints: joints.to_vec(),
        is_held: false,
    });
    let frame = Frame::new(frame).expect("a frame");
    let foundation = FrameFoundation::new(frame, RigidBody::default()).expect("a foundation");
    Foundation::Frame(Box::new(foundation))
}

fn frequencies(description: &TowerDescription) -> Vec<f64> {
    let options = with!(Options, modes = 6, method = Method::Spectral);
    let solution = towers::solved(description, &options);
    assert!(solution.certificate.complete);
    let modes = solution.modes.iter();
    modes.map(|mode| mode.extrapolated_hz).collect()
}

fn assert_same(what: &str, own: &[f64], expected: &[f64], tolerance: f64) {
    for (own, expected) in own.iter().zip(expected) {
        let error = (own / expected - 1.0).abs();
        assert!(
            error < tolerance,
            "{what}: {own} Hz for {expected} Hz: {error:e}"
        );
    }
}

/// A layer of soil of which the elastic constants are known.
fn elastic(ends_m: [f64; 2], soil: LayerSoil, model: SoilModel) -> GroundLayer {
    GroundLayer {
        shear_modulus: Some(ShearModulus::Given {
            shear_modulus_pa: [4e7, 9e7],
        }),
        poissons_ratio: Some(0.3),
        ..layer(ends_m, soil, model)
    }
}

/// Sites with each model of springs.
fn sites() -> Vec<(String, TowerDescription)> {
    let mut sites = Vec::new();
    let clayey = || LayerSoil::Clay(clay());
    let rows = [(-28.0, 3e5), (-40.0, 8e5), (-60.0, 1e6)];
    let rows = rows.map(|(height_m, reaction_n_per_m)| PyRow {
        height_m,
        displacement_m: 0.01,
        reaction_n_per_m,
    });
    for (above, below) in [
        (SoilModel::Kallehave, SoilModel::Api),
        (SoilModel::Sorensen, SoilModel::Dnv),
        (SoilModel::PisaDunkirk, SoilModel::PisaCowden),
        (SoilModel::PisaDunkirk, SoilModel::PisaBothkennar),
        (SoilModel::Vesic, SoilModel::Winkler),
        (SoilModel::Api, SoilModel::ReeseStiffClay),
        (SoilModel::Api, SoilModel::Table),
    ] {
        let mut description = oc3(SoilModel::Api);
        let top = match sand(-20.0, -28.0, 34.0, above).soil {
            LayerSoil::Sand(mut own) => {
                own.relative_density = Some(0.6);
                LayerSoil::Sand(own)
            }
            other => other,
        };
        let bottom = match below {
            SoilModel::Table => LayerSoil::Table(rows.to_vec()),
            _ => clayey(),
        };
        let layers = vec![
            elastic([-20.0, -28.0], top, above),
            elastic([-28.0, -60.0], bottom, below),
        ];
        description.ground = Some(ground(layers));
        sites.push((format!("{above:?} {below:?}"), description));
    }
    for axial in [
        AxialModel::Api,
        AxialModel::Kraft,
        AxialModel::RandolphWroth,
    ] {
        let mut description = oc3(SoilModel::Kallehave);
        let scour = Scour {
            general_m: 0.7,
            local_m: 3.0,
        };
        let own = ground_of(&mut description);
        (own.axial, own.scour) = (Some(axial), scour);
        for layer in &mut own.layers {
            layer.shaft_friction_pa = Some([6e4, 9e4]);
            layer.end_bearing_pa = Some(6e6);
            layer.shear_modulus = Some(ShearModulus::RixStokoe {
                cone_resistance_pa: [1e7, 2e7],
            });
            layer.poissons_ratio = Some(0.25);
        }
        own.factor = 1.3;
        let torsion_n_m = match axial.resists_torsion() {
            true => 0.0,
            false => f64::INFINITY,
        };
        description.foundation = Foundation::Springs(FoundationSprings {
            lateral_n_per_m: 0.0,
            rocking_n_m: 0.0,
            vertical_n_per_m: 0.0,
            torsion_n_m,
            ..FoundationSprings::RIGID
        });
        if axial.resists_torsion() {
            sites.push((format!("{axial:?}"), description));
        }
    }
    sites
}

#[test]
fn a_pile_of_a_frame_is_that_of_a_tower() {
    for (name, description) in sites() {
        let own = frequencies(&on_members(&description));
        assert_same(&name, &own, &frequencies(&description), 1e-10);
    }
    let mut random = Random(8);
    for site in 0..12 {
        let description = random_site(&mut random);
        let own = frequencies(&on_members(&description));
        let what = format!("site {site}");
        assert_same(&what, &own, &frequencies(&description), 1e-10);
    }
}

/// The flexible head of the pile: by the equations of a frame and by integration along a tower.
#[test]
fn the_head_of_a_pile_has_the_static_stiffness_of_that_of_a_tower() {
    for (name, mut description) in sites() {
        if let Some(own) = &mut description.ground {
            own.scour = Scour::default();
        }
        description.stations[1].height_m = -20.0;
        description.stations[2].height_m = -20.0;
        let whole = Tower::new(description.clone()).expect("a tower");
        let expected = whole.pile_head().expect("springs");
        let of_frame = on_members(&description);
        let frame = of_frame.foundation.frame().expect("a frame");
        let ground = description.ground.as_ref().expect("ground");
        let mut below = frame.frame.description().in_ground(ground).expect("piles");
        below.transition = None;
        let frame = Frame::new(below).expect("a frame");
        let k = static_stiffness(&frame, 1).expect("stiffness");
        for (own, expected) in [
            (k[0][0], expected.lateral_n_per_m),
            (k[1][1], expected.lateral_n_per_m),
            (k[0][4], expected.coupling_n),
            (k[1][3], -expected.coupling_n),
            (k[4][4], expected.rocking_n_m),
        ] {
            let error = (own / expected - 1.0).abs();
            assert!(error < 1e-7, "{name}: {own} for {expected}: {error:e}");
        }
    }
}

/// Four piles, battered or not, with a brace, below a rigid transition piece; turned by an angle
/// and mirrored.
fn four_piles(batter_m: f64, angle: f64, mirror: f64, parts: usize) -> FrameDescription {
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let (sin, cos) = angle.sin_cos();
    let turned = |[x, y, z]: [f64; 3]| {
        let y = mirror * y;
        [cos * x - sin * y, sin * x + cos * y, z]
    };
    let tube = |outer_diameter_m, wall_thickness_m| Tube {
        outer_diameter_m,
        wall_thickness_m,
    };
    let mut frame = FrameDescription::default();
    let corners = [(1.0, 1.0), (-1.0, 1.2), (-1.0, -1.0), (0.9, -1.0)];
    for (leg, (a, b)) in corners.into_iter().enumerate() {
        let (top, tip) = ([6.0 * a, 6.0 * b, -18.0], 6.0 + batter_m);
        let tip = [tip * a, tip * b, -58.0];
        let first = frame.joints.len();
        for k in 0..=parts {
            let s = k as f64 / parts as f64;
            let at = std::array::from_fn(|i| top[i] + s * (tip[i] - top[i]));
            frame
                .joints
                .push(FrameJoint::new(format!("{leg}-{k}"), turned(at)));
        }
        for k in 0..parts {
            let at = |s: f64| tube(2.4 - 0.4 * s, 0.05);
            let ends = [k, k + 1].map(|k| at(k as f64 / parts as f64));
            let name = format!("pile {leg}-{k}");
            let mut joints = [first + k, first + k + 1];
            let mut ends = ends;
            // Some piles are given from below.
            if leg % 2 == 1 {
                joints.reverse();
                ends.reverse();
            }
            frame
                .members
                .push(FrameMember::tube(name, joints, ends, steel));
        }
    }
    let brace = [tube(0.8, 0.02); 2];
    let joints = [0, parts + 1];
    frame
        .members
        .push(FrameMember::tube("brace", joints, brace, steel));
    frame
}

fn on_four_piles(frame: FrameDescription) -> TowerDescription {
    let heads = [0, 1, 2, 3].map(|leg| leg * frame.joints.len() / 4);
    let mut description = oc3(SoilModel::Kallehave);
    let own = ground_of(&mut description);
    own.axial = Some(AxialModel::RandolphWroth);
    own.scour.local_m = 1.5;
    for layer in &mut own.layers {
        layer.shear_modulus = Some(ShearModulus::Given {
            shear_modulus_pa: [4e7, 9e7],
        });
        layer.poissons_ratio = Some(0.25);
    }
    own.layers[2].bottom_m = -70.0;
    description.stations.drain(..2);
    // A body that no rotation changes.
    description.rna = Rna::point(350e3);
    description.foundation = carried(frame, &heads, [0.0, 0.0, 10.0]);
    description
}

#[test]
fn piles_that_are_turned_mirrored_and_divided_give_the_same_frequencies() {
    for batter_m in [0.0, 6.0] {
        let of = |angle: f64, mirror: f64, parts: usize| {
            frequencies(&on_four_piles(four_piles(batter_m, angle, mirror, parts)))
        };
        let plain = of(0.0, 1.0, 1);
        assert_same("turned", &of(0.7, 1.0, 1), &plain, 1e-11);
        assert_same("mirrored", &of(0.0, -1.0, 1), &plain, 1e-11);
        assert_same("divided", &of(0.3, 1.0, 3), &plain, 1e-9);
    }
}
