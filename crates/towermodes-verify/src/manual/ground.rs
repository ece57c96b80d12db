//! Monopiles in layers of soil.

use towermodes::{ApiEdition, Method};
use towermodes::{
    Clay, Family, Foundation, FoundationSprings, Ground, GroundLayer, LayerSoil, Material, Rna,
    Rock, Sand, Shear, ShearModulus, SoilModel, Station, TowerDescription,
};

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "ground",
    title: "Monopiles in soil by layers",
    introduction: "The 5 MW tower with a point mass of 350 t on a monopile of 6 m × 60 mm, 36 m deep (60 m for PISA Cowden), whose springs follow from layers of soil. The reference is an independent program: Timoshenko beams with polynomials of degree 9, with the formula of the soil evaluated at every integration point.",
};

const SURFACE_M: f64 = -20.0;

pub(super) fn cases() -> Vec<Case> {
    let three = |model| {
        [
            (-20.0, -25.0, 33.0),
            (-25.0, -34.0, 35.0),
            (-34.0, -56.0, 38.5),
        ]
        .map(|(top_m, bottom_m, angle_deg)| layer([top_m, bottom_m], sand(angle_deg), model))
    };
    let cases = [
        (
            "sand, API RP 2GEO",
            ApiEdition::Rp2Geo,
            three(SoilModel::Api).to_vec(),
            "0.25376498 1.74694398 4.6435679",
        ),
        (
            "sand, API RP 2A",
            ApiEdition::Rp2A,
            three(SoilModel::Api).to_vec(),
            "0.25306066 1.73652611 4.6213664",
        ),
        (
            "sand, Kallehave",
            ApiEdition::Rp2Geo,
            three(SoilModel::Kallehave).to_vec(),
            "0.2595107 1.83734401 4.8491774",
        ),
        (
            "sand, Sørensen",
            ApiEdition::Rp2Geo,
            three(SoilModel::Sorensen).to_vec(),
            "0.24874303 1.66820793 4.4444331",
        ),
        (
            "normally consolidated clay, API",
            ApiEdition::Rp2Geo,
            vec![clay([0.0, 1e5], 0.01, SoilModel::Api)],
            "0.22496924 1.37292952 3.8291157",
        ),
        (
            "stiff clay, Reese",
            ApiEdition::Rp2Geo,
            vec![clay([1e5, 2e5], 0.005, SoilModel::ReeseStiffClay)],
            "0.25832503 1.8174237 4.796032",
        ),
        (
            "stiff clay, PISA, constant G₀, L/D = 10",
            ApiEdition::Rp2Geo,
            vec![pisa(SoilModel::PisaCowden, -90.0, given([6e7, 6e7]))],
            "0.26895151 1.99274494 5.0025146",
        ),
        (
            "soft clay, PISA",
            ApiEdition::Rp2Geo,
            vec![pisa(SoilModel::PisaBothkennar, -60.0, given([3e6, 1.2e7]))],
            "0.24848476 1.66534803 4.4080203",
        ),
        (
            "sand, PISA, G₀ by the void ratio",
            ApiEdition::Rp2Geo,
            vec![dunkirk()],
            "0.2649494 1.92936064 5.0737792",
        ),
        (
            "sand over weak rock",
            ApiEdition::Rp2Geo,
            over_rock().to_vec(),
            "0.2548566 1.76078074 4.6663919",
        ),
    ];
    cases
        .map(|(name, edition, layers, values)| case(name, edition, layers, values))
        .to_vec()
}

fn case(name: &str, edition: ApiEdition, layers: Vec<GroundLayer>, values: &str) -> Case {
    let is_deep = layers
        .iter()
        .any(|layer| layer.model == SoilModel::PisaCowden);
    let tip_m = if is_deep { -80.0 } else { -56.0 };
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: "finite elements of degree 9 with the formula at every point",
        subject: Subject::tower(tower(tip_m, edition, layers)),
        remark: "",
        unit: Unit::HZ,
        digits: Digits::Computed,
        expected: Expected::series(Family::ForeAft, values),
        runs: vec![
            // The lines in place of curved springs change no frequency by more than 1e-8.
            Run::spectral().allowing(1e-8),
            Run::extrapolated(Method::RmjeExact, 240, 1e-6),
        ],
    }
}

fn tower(tip_m: f64, edition: ApiEdition, layers: Vec<GroundLayer>) -> TowerDescription {
    TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(tip_m, 6.0, 0.06),
            Station::new(10.0, 6.0, 0.06),
            Station::new(10.0, 6.0, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        rna: Rna::point(350e3),
        shear: Shear::Coefficient(0.5),
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: 0.0,
            rocking_n_m: 0.0,
            ..FoundationSprings::RIGID
        }),
        ground: Some(Ground {
            edition,
            ..Ground::new(SURFACE_M, layers)
        }),
        ..TowerDescription::default()
    }
}

fn layer(ends_m: [f64; 2], soil: LayerSoil, model: SoilModel) -> GroundLayer {
    GroundLayer {
        effective_unit_weight_n_per_m3: Some(9e3),
        ..GroundLayer::new(ends_m, soil, model)
    }
}

fn sand(friction_angle_deg: f64) -> LayerSoil {
    LayerSoil::Sand(Sand {
        friction_angle_deg: Some(friction_angle_deg),
        ..Sand::default()
    })
}

fn clay(strength_pa: [f64; 2], strain: f64, model: SoilModel) -> GroundLayer {
    let soil = LayerSoil::Clay(Clay {
        undrained_strength_pa: Some(strength_pa),
        strain_at_half_strength: Some(strain),
        strength_factor: (model == SoilModel::Api).then_some(0.5),
        ..Clay::default()
    });
    layer([SURFACE_M, -60.0], soil, model)
}

fn given(shear_modulus_pa: [f64; 2]) -> ShearModulus {
    ShearModulus::Given { shear_modulus_pa }
}

fn pisa(model: SoilModel, bottom_m: f64, shear_modulus: ShearModulus) -> GroundLayer {
    GroundLayer {
        shear_modulus: Some(shear_modulus),
        ..layer(
            [SURFACE_M, bottom_m],
            LayerSoil::Clay(Clay::default()),
            model,
        )
    }
}

fn dunkirk() -> GroundLayer {
    let soil = LayerSoil::Sand(Sand {
        relative_density: Some(0.75),
        ..Sand::default()
    });
    GroundLayer {
        effective_unit_weight_n_per_m3: Some(1e4),
        shear_modulus: Some(ShearModulus::Hardin {
            void_ratio: 0.628,
            earth_pressure_at_rest: 0.4,
        }),
        ..layer([SURFACE_M, -60.0], soil, SoilModel::PisaDunkirk)
    }
}

/// Sand with φ′ = 35° on rock with E_ir = 100 MPa.
fn over_rock() -> [GroundLayer; 2] {
    let rock = LayerSoil::Rock(Rock {
        youngs_modulus_pa: Some([1e8; 2]),
    });
    [
        layer([SURFACE_M, -40.0], sand(35.0), SoilModel::Api),
        layer([-40.0, -60.0], rock, SoilModel::WeakRock),
    ]
}
