//! Piles of frames in layers of soil: those of a tower, alone and in groups, mirrored, divided.

use super::derivatives::assert_derivatives_of_solves;
use super::scour::random_site;
use super::{Random, clay, free_tip, ground, ground_of, layer, oc3, sand};
use crate::towers::{self, carried};
use towermodes::frame::*;
use towermodes::tower::Tube;
use towermodes::{
    AxialModel, Change, Foundation, FoundationSprings, GroundLayer, LayerSoil, Material, Method,
    Options, Parameter, PyRow, Rna, Scour, ShearModulus, SoilModel, Station, Tower,
    TowerDescription,
};
use towermodes_testing::{Says, with};

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
        let expected = whole.foundation_head().expect("springs").fore_aft;
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
    description.rna_is_point = true;
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

/// Friction along the piles carries the weight: the forces in long members are those in short ones.
#[test]
fn weight_goes_into_the_soil_along_the_piles() {
    let with_gravity = |parts: usize, gravity_m_per_s2: f64| {
        let mut description = on_four_piles(four_piles(3.0, 0.0, 1.0, parts));
        description.gravity_m_per_s2 = gravity_m_per_s2;
        frequencies(&description)
    };
    let [whole, divided] = [1, 12].map(|parts| with_gravity(parts, 9.81));
    assert_same("divided", &divided, &whole, 1e-9);
    let effect = 1.0 - whole[0] / with_gravity(1, 0.0)[0];
    assert!(effect > 1e-3, "{effect}");
    // The tip is held along the axis, and nothing along the pile: the weight goes down to the tip.
    let mut description = oc3(SoilModel::Kallehave);
    description.gravity_m_per_s2 = 9.81;
    let (own, expected) = (on_members(&description), frequencies(&description));
    assert_same("held at the tip", &frequencies(&own), &expected, 1e-10);
}

#[test]
fn very_stiff_soil_clamps_the_piles_at_its_surface() {
    let mut description = on_four_piles(four_piles(0.0, 0.0, 1.0, 1));
    ground_of(&mut description).scour = Scour::default();
    let mut cut = four_piles(0.0, 0.0, 1.0, 1);
    let tips: Vec<usize> = (0..4).map(|leg| 2 * leg + 1).collect();
    for joint in &tips {
        cut.joints[*joint].position_m[2] = -20.0;
        cut.supports.push(FrameSupport::clamped(*joint));
    }
    // The walls of the piles are linear: they end at the surface with what they have there.
    for member in cut.members.iter_mut().take(4) {
        let MemberKind::Beam { ends, .. } = &mut member.kind else {
            continue;
        };
        let SectionEnds::Tube(ends) = ends else {
            continue;
        };
        let lower = usize::from(ends[1].outer_diameter_m < ends[0].outer_diameter_m);
        let (top, tip) = (
            ends[1 - lower].outer_diameter_m,
            ends[lower].outer_diameter_m,
        );
        ends[lower].outer_diameter_m = top + 2.0 / 40.0 * (tip - top);
    }
    let mut clamped = on_four_piles(cut);
    clamped.ground = None;
    let clamped = frequencies(&clamped);
    let layers = &mut ground_of(&mut description).layers;
    layers
        .iter_mut()
        .for_each(|layer| layer.model = SoilModel::Winkler);
    let mut below = [1e2, 1e6].map(|factor| {
        ground_of(&mut description).factor = factor;
        let found = frequencies(&description);
        let errors = found
            .iter()
            .zip(&clamped)
            .map(|(own, limit)| 1.0 - own / limit);
        errors.collect::<Vec<f64>>()
    });
    let [near, nearest] = &mut below;
    for (near, nearest) in near.iter().zip(nearest) {
        // The piles bend over the fourth root of the softness in the soil.
        assert!((0.0..0.1).contains(near), "{near}");
        assert!(
            (0.0..0.2 * near + 1e-9).contains(nearest),
            "{nearest} after {near}"
        );
    }
}

#[test]
fn soil_factor_scour_and_names_act_on_the_piles_of_a_frame() {
    let description = on_four_piles(four_piles(3.0, 0.0, 1.0, 1));
    let first = |description: &TowerDescription| frequencies(description)[0];
    assert!(description.stands_in_soil());
    let softer = description.with_soil_factor(0.5);
    assert!(first(&softer) < first(&description));
    let mut halved = description.clone();
    let factor = Parameter::parse("ground.factor", &halved).expect("a name");
    factor.set(&mut halved, 0.5);
    assert_eq!(first(&halved), first(&softer));
    let mut scoured = description.clone();
    ground_of(&mut scoured).scour.local_m = 5.0;
    assert!(first(&scoured) < first(&description));
    let rows = description.with_ground_as_soil();
    assert_same(
        "rows",
        &frequencies(&rows),
        &frequencies(&description),
        1e-12,
    );
}

#[test]
fn every_number_of_the_ground_has_the_derivative_of_solves_on_piles_of_a_frame() {
    let mut description = on_four_piles(four_piles(3.0, 0.0, 1.0, 1));
    ground_of(&mut description).scour.general_m = 0.5;
    let changes = [
        "ground.factor",
        "ground.scour.local",
        "ground.layer[0].friction_angle",
        "ground.layer[1].shear_modulus[0]",
        "add(ground.surface,ground.layer[0].top)",
        "add(ground.layer[0].bottom,ground.layer[1].top)",
    ];
    let changes = changes.map(|name| Change::parse(name, &description).expect(name));
    let options = with!(Options, modes = 2);
    assert_derivatives_of_solves(&description, options, &changes);
}

/// The springs along the piles are those of the soil, those under the tips of the foundation.
#[test]
fn the_energy_of_the_soil_is_that_of_its_factor() {
    let description = on_four_piles(four_piles(0.0, 0.0, 1.0, 1));
    let options = with!(
        Options,
        modes = 2,
        method = Method::Spectral,
        energy_parts = true
    );
    let solution = towers::solved(&description, &options);
    let parts = solution.modes[0].energy_parts.as_ref().expect("requested");
    let first = |factor: f64| frequencies(&description.with_soil_factor(factor))[0];
    let slope = (first(1.001) / first(0.999)).ln() / 0.002 * 2.0;
    let strain = &parts.strain;
    // The foundation has the springs under the tips, and the piles themselves.
    assert!(
        strain.soil > 0.01 && strain.soil < slope,
        "{} {slope}",
        strain.soil
    );
    assert!(slope - strain.soil < 0.3 * slope, "{} {slope}", strain.soil);
}

#[test]
fn mistakes_about_piles_of_a_frame_are_refused_or_warned_of() {
    let site = || on_four_piles(four_piles(0.0, 0.0, 1.0, 1));
    let with_frame = |change: &dyn Fn(&mut FrameDescription)| {
        let mut frame = four_piles(0.0, 0.0, 1.0, 1);
        change(&mut frame);
        on_four_piles(frame)
    };
    let refused = |description: TowerDescription| Tower::new(description).expect_err("a mistake");
    let mut high = site();
    let own = ground_of(&mut high);
    (own.surface_m, own.layers[0].top_m, own.layers[0].bottom_m) = (-60.0, -60.0, -62.0);
    own.layers.truncate(1);
    refused(high).says("no member of the substructure");
    let mut shallow = site();
    ground_of(&mut shallow).layers[2].bottom_m = -57.0;
    refused(shallow).says("-57 m");
    let mut sinking = site();
    ground_of(&mut sinking).axial = None;
    refused(sinking).says("the piles have no axial support");
    let mut turning = on_members(&oc3(SoilModel::Api));
    ground_of(&mut turning).axial = Some(AxialModel::Kraft);
    for layer in &mut ground_of(&mut turning).layers {
        layer.shear_modulus = Some(ShearModulus::Given {
            shear_modulus_pa: [4e7, 9e7],
        });
    }
    let Foundation::Frame(below) = &mut turning.foundation else {
        return;
    };
    let mut free = below.frame.description().clone();
    free.supports.clear();
    below.frame = Frame::new(free).expect("a frame");
    refused(turning).says("the single pile has no support against rotation about its axis");
    let mut twice = site();
    ground_of(&mut twice).pile_diameter_m = Some(2.0);
    refused(twice).says("given twice");
    let mut deep = site();
    let own = ground_of(&mut deep);
    (own.surface_m, own.layers[0].top_m) = (20.0, 20.0);
    refused(deep).says("the tower begins at 10 m");
    let square = with_frame(&|frame| {
        let MemberKind::Beam { ends, .. } = &mut frame.members[1].kind else {
            return;
        };
        *ends = SectionEnds::Rectangle(
            [Rectangle {
                side_a_m: 2.0,
                side_b_m: 2.0,
                wall_thickness_m: 0.05,
            }; 2],
        );
    });
    refused(square).says("member pile 1-0 is below the surface");
    let warned = |description: TowerDescription| {
        let tower = Tower::new(description).expect("a tower");
        let texts = tower.warnings().iter().map(ToString::to_string);
        texts.collect::<Vec<String>>().join("\n")
    };
    // The tower stands on the heads of the piles without members between them.
    let rigid = warned(site());
    rigid.begins("the tower begins at z = 10 m, 28 m from the highest joint");
    rigid.says("shear_modulus is a value before scour");
    assert_eq!(rigid.lines().count(), 2, "{rigid}");
    let short = with_frame(&|frame| {
        for joint in &mut frame.joints {
            joint.position_m[2] = joint.position_m[2].max(-22.5);
        }
    });
    warned(short).says("reaches 1 m into the ground, less than its diameter");
    let close = with_frame(&|frame| {
        for joint in &mut frame.joints {
            (0..2).for_each(|i| joint.position_m[i] *= 0.3);
        }
    });
    warned(close).says("diameters apart, less than 3");
    let buried = with_frame(&|frame| {
        frame.members.push(FrameMember {
            name: "mud brace".to_owned(),
            joints: [1, 3],
            ..frame.members[4].clone()
        });
    });
    warned(buried).says("member mud brace is below the surface of the ground, but has no springs");
    let mut near = site();
    let own = ground_of(&mut near);
    (own.surface_m, own.layers[0].top_m) = (-17.99, -17.99);
    warned(near).says("joint 0-0 is at -18 m, close to the surface of the ground at -17.99 m");
}
