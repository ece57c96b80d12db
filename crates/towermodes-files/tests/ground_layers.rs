//! `[ground]`: read, written, refused.

use crate::refused;
use crate::sources::source;

use refused::refused_text;
use towermodes::{
    AxialModel, Clay, Foundation, Ground, LayerSoil, PyRow, Rock, Sand, Scour, ShearModulus,
    SoilModel, TowerDescription,
};
use towermodes_files::{
    InMemory, Input, ReadOptions, description_from_toml, read_source, write_toml,
};
use towermodes_testing::{Says, changed, rows, with};

/// A pile in sand over clay.
const PILE: &str = "\
[material]
density = 8500.0
youngs_modulus = 2.1e11
poissons_ratio = 0.3
[tower]
stations = [[-36.0, 6.0, 0.06], [10.0, 6.0, 0.06], [87.6, 3.87, 0.019]]
[ground]
surface = 0.0
submerged = true
model = \"api\"
scour = { local = 3.0 }
[[ground.layer]]
name = \"loose sand\"
type = \"sand\"
top = 0.0
bottom = -14.0
friction_angle = 33.0
effective_unit_weight = 10e3
[[ground.layer]]
type = \"clay\"
top = -14.0
bottom = -40.0
undrained_strength = [8e4, 2e5]
strain_at_half_strength = 0.01
strength_factor = 0.5
effective_unit_weight = 9e3
";

fn described(text: &str) -> TowerDescription {
    description_from_toml(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"))
}

#[test]
fn layers_are_read_with_the_model_of_the_ground() {
    let tower = described(PILE);
    let ground = tower.ground.expect("a ground");
    assert_eq!(ground.surface_m, 0.0);
    assert!(ground.submerged);
    assert_eq!(ground.factor, 1.0);
    assert_eq!(
        ground.scour,
        Scour {
            general_m: 0.0,
            local_m: 3.0
        }
    );
    assert_eq!((ground.axial, ground.pile_diameter_m), (None, None));
    assert_eq!(tower.part_names.ground, ["loose sand", ""]);
    let [sand, clay] = &ground.layers[..] else {
        panic!("{:?}", ground.layers)
    };
    assert_eq!(sand.top_m, 0.0);
    assert_eq!(sand.bottom_m, -14.0);
    assert_eq!(sand.model, SoilModel::Api);
    let expected = LayerSoil::Sand(with!(Sand, friction_angle_deg = Some(33.0)));
    assert_eq!(sand.soil, expected);
    assert_eq!(
        clay.soil,
        LayerSoil::Clay(Clay {
            undrained_strength_pa: Some([8e4, 2e5]),
            strain_at_half_strength: Some(0.01),
            strength_factor: Some(0.5),
            ..Clay::default()
        })
    );
}

#[test]
fn without_a_foundation_the_tip_is_free_and_a_note_says_so() {
    let tower = described(PILE);
    let Foundation::Springs(springs) = &tower.foundation else {
        panic!("{:?}", tower.foundation)
    };
    assert_eq!((springs.lateral_n_per_m, springs.rocking_n_m), (0.0, 0.0));
    assert_eq!(springs.vertical_n_per_m, f64::INFINITY);
    assert_eq!(springs.torsion_n_m, f64::INFINITY);
    let source = source("pile.toml", PILE);
    let input = read_source(source, &InMemory::default(), &ReadOptions::default());
    let Ok(Input::Tower(input)) = input else {
        panic!("{input:?}")
    };
    let notes: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes
            .iter()
            .any(|note| note.contains("there is no [foundation]")),
        "{notes:?}"
    );
    let clamped = described(&format!("{PILE}[foundation]\ntype = \"clamped\"\n"));
    assert_eq!(clamped.foundation, Foundation::Clamped);
}

/// Each kind of soil and each source of the shear modulus comes back number by number.
#[test]
fn every_ground_is_written_and_read_back() {
    let base = described(PILE);
    let ground = base.ground.clone().expect("a ground");
    let soils = [
        LayerSoil::Sand(Sand {
            subgrade_modulus_n_per_m3: Some(2.5e7),
            relative_density: Some(0.6),
            ..Sand::default()
        }),
        LayerSoil::Clay(Clay {
            undrained_strength_pa: Some([1e5; 2]),
            stiffness_factor: Some(30.0),
            ..Clay::default()
        }),
        LayerSoil::Elastic,
        LayerSoil::Rock(Rock {
            youngs_modulus_pa: Some([1e9, 2e9]),
        }),
        LayerSoil::Table(vec![
            PyRow {
                height_m: 0.0,
                displacement_m: 0.01,
                reaction_n_per_m: 1e5,
            },
            PyRow {
                height_m: -14.0,
                displacement_m: 0.02,
                reaction_n_per_m: 3e5,
            },
        ]),
    ];
    let moduli = [
        None,
        Some(ShearModulus::Given {
            shear_modulus_pa: [1e7, 3e7],
        }),
        Some(ShearModulus::Youngs {
            youngs_modulus_pa: [2e7; 2],
        }),
        Some(ShearModulus::WaveVelocity {
            velocity_m_per_s: [100.0, 200.0],
            density_kg_per_m3: 1900.0,
        }),
        Some(ShearModulus::RixStokoe {
            cone_resistance_pa: [1e7; 2],
        }),
        Some(ShearModulus::MayneRix {
            cone_resistance_pa: [1e6, 2e6],
        }),
        Some(ShearModulus::RobertsonCabal {
            cone_resistance_pa: [1e6; 2],
            behaviour_index: 2.1,
            density_kg_per_m3: 1900.0,
        }),
        Some(ShearModulus::Hardin {
            void_ratio: 0.628,
            earth_pressure_at_rest: 0.4,
        }),
        Some(ShearModulus::BlowCount {
            blow_count: [10.0, 30.0],
            density_kg_per_m3: 1900.0,
        }),
    ];
    for soil in soils {
        let has_modulus = !matches!(soil, LayerSoil::Rock(_) | LayerSoil::Table(_));
        let moduli = moduli
            .iter()
            .filter(|modulus| has_modulus || modulus.is_none());
        for modulus in moduli {
            let mut ground = Ground {
                scour: Scour {
                    general_m: 0.5,
                    local_m: 0.25,
                },
                factor: 0.5,
                submerged: false,
                axial: Some(AxialModel::Api),
                edition: towermodes::ApiEdition::Rp2A,
                ..ground.clone()
            };
            let layer = &mut ground.layers[0];
            layer.soil = soil.clone();
            layer.shear_modulus = *modulus;
            layer.model = SoilModel::Dnv;
            layer.poissons_ratio = Some(0.3);
            layer.shaft_friction_pa = Some([0.0, 5e4]);
            layer.end_bearing_pa = Some(5e6);
            layer.factor = 0.7;
            let tower = changed!(base.clone(), ground = Some(ground));
            let (text, notes) = write_toml(&tower);
            assert!(notes.is_empty(), "{notes:?}");
            assert_eq!(described(&text), tower, "{text}");
        }
    }
}

#[test]
fn mistakes_of_a_ground_are_shown_at_their_values() {
    let cases = r#"
        scour = { local = 3.0 } | scour = { local = -3.0 } | 11:19 | local scour is -3 m
        scour = { local = 3.0 } | scour = { general = -1 } | 11:21 | general scour is -1 m
        scour = { local = 3.0 } | scour = 3.0 | 11:9 | scour must be a table, found a number
        friction_angle = 33.0 | phi = 33.0 | 17:1 | is not a key
        bottom = -14.0 | bottom = -13.0 | 21:7 | there is a gap between them
        bottom = -14.0 | bottom = 2.0 | 16:10 | is not below its top
        bottom = -40.0 | bottom = -30.0 | 22:10 | above the tip of the pile
        surface = 0.0 | surface = -50.0 | 8:11 | does not reach into the soil
        [8e4, 2e5] | [8e4, -2e5] | 23:22 | -200000
        [8e4, 2e5] | [8e4] | 23:22 | has 1 value
        [8e4, 2e5] | true | 23:22 | a number, or [top, bottom]
        friction_angle = 33.0 | undrained_strength = 5e4 | 17:1 | is not a key
        type = "clay" | type = "silt" | 20:8 | there is no soil of type `silt`
        model = "api" | model = "pisa" | 10:9 | there is no soil model `pisa`
        submerged = true |  | 7:1 | [ground] has no `submerged`
        "#;
    for [from, to, place, message] in rows(cases) {
        PILE.says(from);
        let text = PILE.replacen(from, to, 1);
        refused_text(&text, place, message, "");
    }
    let text = |from, to| PILE.replacen(from, to, 1);
    let number = text("scour = { local = 3.0 }", "scour = 3.0");
    refused_text(&number, "11:9", "must be a table", "= 3.0 }");
    let phi = text("friction_angle = 33.0", "phi = 33.0");
    refused_text(
        &phi,
        "17:1",
        "is not a key",
        "did you mean `friction_angle`?",
    );
}

/// The edition of API is noted where it is not given and matters.
#[test]
fn the_edition_is_noted_where_it_matters() {
    let notes = |text: &str| {
        let source = source("pile.toml", text);
        let input = read_source(source, &InMemory::default(), &ReadOptions::default());
        let Ok(Input::Tower(input)) = input else {
            panic!("{input:?}")
        };
        input
            .notes
            .iter()
            .any(|note| note.to_string().contains("RP 2GEO"))
    };
    assert!(notes(PILE));
    let model = "model = \"api\"";
    assert!(!notes(&PILE.replacen(
        model,
        "model = \"api\"\nedition = \"rp-2a\"",
        1
    )));
    let angle = "friction_angle = 33.0";
    assert!(!notes(&PILE.replacen(angle, "subgrade_modulus = 2e7", 1)));
}

fn read_pile(text: &str) -> towermodes_files::TowerInput {
    let source = source("pile.toml", text);
    let input = read_source(source, &InMemory::default(), &ReadOptions::default());
    match input {
        Ok(Input::Tower(input)) => *input,
        other => panic!("{other:?}"),
    }
}

/// The note names axial springs only where there are such, and an edition for nothing is noted.
#[test]
fn the_note_on_the_edition_says_what_depends_on_it() {
    let said = |text: &str| {
        let notes = read_pile(text).notes;
        let notes = notes.iter().map(ToString::to_string);
        let notes = notes.filter(|note| note.contains("edition"));
        notes.collect::<Vec<_>>().join("\n")
    };
    let plain = said(PILE);
    plain.says("the modulus of sand follows API RP 2GEO");
    assert!(!plain.contains("axial"), "{plain}");
    let edition = "model = \"api\"\nedition = \"rp-2geo\"";
    let named = PILE.replacen("model = \"api\"", edition, 1);
    assert_eq!(said(&named), "");
    let given = named.replacen("friction_angle = 33.0", "subgrade_modulus = 2e7", 1);
    said(&given).says("edition has no effect");
}

/// Values that the models of a layer do not use are at their lines, and that sand is above the
/// water is said where the table of the edition does not know it.
#[test]
fn keys_without_effect_are_named_at_their_lines() {
    let said = |text: &str| {
        let input = read_pile(text);
        let tower = input.tower().expect("a tower");
        let own = tower.warnings().iter();
        let own = own.filter(|warning| warning.to_string().contains("no effect"));
        let line = |warning: &towermodes::Warning| {
            let (_, line) = input.line_of(warning.place()?)?;
            text.lines().nth(line - 1)
        };
        let own = own.map(|warning| (warning.to_string(), line(warning).unwrap_or_default()));
        own.map(|(said, line)| (said, line.to_owned()))
            .collect::<Vec<_>>()
    };
    assert_eq!(said(PILE), []);
    let angle = "friction_angle = 33.0";
    let keys = r#"
        relative_density = 0.6 | the models of this layer do not use it
        shear_modulus = 4e7 | the models of this layer do not use it
        poissons_ratio = 0.3 | the models of this layer do not use it
        shaft_friction = 5e4 | only axial = "api" in [ground] uses it
        end_bearing = 5e6 | only axial = "api" in [ground] uses it
        "#;
    for [line, why] in rows(keys) {
        let found = said(&PILE.replacen(angle, &format!("{angle}\n{line}"), 1));
        let [(sentence, at)] = &found[..] else {
            panic!("{line}: {found:?}")
        };
        assert!(sentence.contains(why) && at == line, "{line}: {found:?}");
    }
    let dry = PILE.replacen("submerged = true", "submerged = false", 1);
    let of_water = |text: &str| {
        let all = said(text);
        all.into_iter().any(|(said, at)| {
            said.contains("no effect on the modulus of this sand") && at.starts_with("submerged")
        })
    };
    assert!(of_water(&dry) && !of_water(PILE));
    let model = "model = \"api\"";
    let old = format!("{model}\nedition = \"rp-2a\"");
    assert!(!of_water(&dry.replacen(model, &old, 1)));
}

/// A model of the whole ground that is none for a layer is wrong at its own line.
#[test]
fn a_common_model_is_refused_at_its_line() {
    let text = PILE.replacen("model = \"api\"", "model = \"pisa-cowden\"", 1);
    let error = read_pile(&text)
        .tower()
        .expect_err("no model of sand")
        .to_string();
    let line = text.lines().position(|line| line.starts_with("model = "));
    let place = format!("pile.toml:{}:", line.expect("a line") + 1);
    assert!(error.starts_with(&place), "{error}");
}
