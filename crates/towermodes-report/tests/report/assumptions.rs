//! What a report says of a tower is true of that tower, one row a kind of input.

use std::path::Path;

use towermodes::{
    CircularFooting, FloatingPlatform, Foundation, FoundationSprings, HalfSpace, Method, Monopile,
    Options, PileFormula, PileTube, Planes, PointMass, Properties, PropertyStation, ReferredMatrix,
    Rna, Shear, SoilProfile, SoilRow, SoilStiffness, StiffnessFoundation, SuctionCaisson,
    TowerDescription, Water, Wires,
};
use towermodes_files::{Input, ReadOptions, read};

use super::{content_by, page_of, pole, section};

/// A tower, how it is solved, what is said of it and what is not.
struct Row {
    name: &'static str,
    description: TowerDescription,
    options: Options,
    reading: &'static str,
    section: &'static str,
    said: &'static [&'static str],
    unsaid: &'static [&'static str],
}

fn row(
    name: &'static str,
    description: TowerDescription,
    said: &'static [&'static str],
    unsaid: &'static [&'static str],
) -> Row {
    Row {
        name,
        description,
        options: Options::default(),
        reading: "",
        section: "assumptions",
        said,
        unsaid,
    }
}

impl Row {
    fn by(self, method: Method) -> Self {
        let options = Options {
            method,
            ..self.options
        };
        Self { options, ..self }
    }

    fn without_rotary_inertia(self) -> Self {
        let options = Options {
            rotary_inertia: false,
            ..self.options
        };
        Self { options, ..self }
    }

    fn of(self, section: &'static str) -> Self {
        Self { section, ..self }
    }

    fn read(self, reading: &'static str) -> Self {
        Self { reading, ..self }
    }
}

#[test]
fn what_is_said_is_true_of_the_tower() {
    let mut wrong = Vec::new();
    for row in rows() {
        let mut content = content_by(row.description, None, row.options);
        content.circumstances.reading = row.reading.to_owned();
        let text = section(&page_of(&content), row.section);
        let lacks = row.said.iter().filter(|said| !text.contains(**said));
        wrong.extend(lacks.map(|said| format!("{}: not said: {said}", row.name)));
        let has = row.unsaid.iter().filter(|unsaid| text.contains(**unsaid));
        wrong.extend(has.map(|unsaid| format!("{}: said: {unsaid}", row.name)));
    }
    assert_eq!(wrong, Vec::<String>::new());
}

fn rows() -> Vec<Row> {
    [beams(), grounds(), afloat(), around(), others()]
        .into_iter()
        .flatten()
        .collect()
}

fn beams() -> Vec<Row> {
    let sheared = |shear| TowerDescription { shear, ..pole() };
    vec![
        row(
            "clamped tube",
            pole(),
            &[
                "a Rayleigh beam",
                "Torsion and axial deformation are included.",
                "The base is clamped",
                "by 5 % at a load factor of 10.",
                "There is no rotor-nacelle assembly.",
                "no soil along the tower, no water along the tower, no guy wires, no point masses",
            ],
            &["table", "BModes", "infinite", "at the tower top"],
        ),
        row(
            "Cowper",
            sheared(Shear::Cowper),
            &["a Timoshenko beam", "Cowper (1966)"],
            &[],
        ),
        row(
            "tube, --no-rotary-inertia",
            pole(),
            &["an Euler-Bernoulli beam", "neglected (--no-rotary-inertia)"],
            &["table"],
        )
        .without_rotary_inertia(),
        row(
            "Timoshenko, --no-rotary-inertia",
            sheared(Shear::Coefficient(0.5)),
            &[
                "with shear deformation but without rotary inertia",
                "shear coefficient is 0.5",
            ],
            &[],
        )
        .without_rotary_inertia(),
        row(
            "tube by bmodes",
            pole(),
            &[
                "an Euler-Bernoulli beam",
                "The element of BModes has no rotary inertia",
            ],
            &["(--no-rotary-inertia)"],
        )
        .by(Method::Bmodes),
        row(
            "Timoshenko by bmodes",
            sheared(Shear::Cowper),
            &[
                "an Euler-Bernoulli beam",
                "rotary inertia and shear stiffness of the input are neglected",
            ],
            &["Cowper"],
        )
        .by(Method::Bmodes),
        row(
            "table without rotary inertia",
            table(0.0),
            &[
                "an Euler-Bernoulli beam",
                "The table of the input has no rotary inertia.",
                "a table: mass and stiffness vary linearly",
                "Axial deformation is included, torsion is not",
            ],
            &["Rayleigh", "tubes", "(--no-rotary-inertia)"],
        ),
        row(
            "table with rotary inertia",
            table(900.0),
            &["a Rayleigh beam", "squared radii of gyration"],
            &["has no rotary inertia"],
        ),
        row(
            "deck of ElastoDyn",
            example("small-turbine/ElastoDyn.dat"),
            &[
                "an Euler-Bernoulli beam",
                "Torsion and axial deformation are not included",
                "rotor-nacelle assembly is one rigid body",
            ],
            &["Rayleigh", "Axial deformation is included"],
        ),
    ]
}

/// A table of two equal rows that cannot twist.
fn table(rotary_inertia_kg_m: f64) -> TowerDescription {
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 2000.0,
            rotary_inertia_kg_m: Planes::both(rotary_inertia_kg_m),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(1e11),
            torsion_n_m2: f64::INFINITY,
            axial_n: 5e10,
            shear_n: None,
        },
    };
    TowerDescription {
        properties: vec![row(0.0), row(80.0)],
        ..TowerDescription::default()
    }
}

fn example(name: &str) -> TowerDescription {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    match read(&examples.join(name), &ReadOptions::default()) {
        Ok(Input::Tower(tower)) => tower.description,
        _ => panic!("{name} is no tower"),
    }
}

fn on(foundation: Foundation) -> TowerDescription {
    TowerDescription {
        foundation,
        ..pole()
    }
}

fn grounds() -> Vec<Row> {
    let springs = FoundationSprings {
        lateral_n_per_m: 1e9,
        rocking_n_m: 1e11,
        ..FoundationSprings::RIGID
    };
    let mut matrices = StiffnessFoundation::default();
    for i in 0..6 {
        matrices.stiffness[i][i] = [1e9, 1e9, f64::INFINITY, 1e11, 1e11, f64::INFINITY][i];
        matrices.inertia[i][i] = 1e5;
    }
    let without_inertia = StiffnessFoundation {
        inertia: [[0.0; 6]; 6],
        ..matrices
    };
    let footing = HalfSpace {
        radius_m: 9.0,
        embedment_m: 0.0,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.3,
    };
    let stratum = CircularFooting {
        radius_m: 9.0,
        embedment_m: 2.0,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.3,
        stratum_thickness_m: 20.0,
        lower_shear_modulus_pa: f64::INFINITY,
        is_coupled: true,
    };
    let caisson = SuctionCaisson {
        diameter_m: 10.0,
        skirt_length_m: 9.0,
        soil_profile: SoilProfile::Linear,
        soil_youngs_modulus_pa: 3e7,
        soil_poissons_ratio: 0.3,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    };
    let pile = Monopile {
        tube: PileTube {
            diameter_m: 7.0,
            wall_thickness_m: 0.08,
            embedded_length_m: 60.0,
            youngs_modulus_pa: 2.1e11,
        },
        formula: PileFormula::Randolph,
        soil_profile: SoilProfile::Linear,
        soil_youngs_modulus_pa: 3e7,
        soil_poissons_ratio: 0.3,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    };
    vec![
        row(
            "springs",
            on(Foundation::Springs(springs)),
            &[
                "linear springs",
                "Fixed degrees of freedom: z, rotation about z.",
                "more so on a softer foundation",
            ],
            &["clamped", "inertia of the foundation"],
        ),
        row(
            "springs that are all rigid",
            on(Foundation::Springs(FoundationSprings::RIGID)),
            &["clamped: every spring of the foundation is rigid"],
            &["linear springs"],
        ),
        row(
            "stiffness matrix with inertia",
            on(Foundation::Stiffness(Box::new(matrices))),
            &[
                "linear springs",
                "Fixed degrees of freedom: z, rotation about z.",
                "The inertia of the foundation moves with the base",
            ],
            &["clamped"],
        ),
        row(
            "stiffness matrix without inertia",
            on(Foundation::Stiffness(Box::new(without_inertia))),
            &["linear springs"],
            &["inertia of the foundation"],
        ),
        row(
            "half-space",
            on(Foundation::HalfSpace(footing)),
            &["elastic half-space"],
            &["clamped"],
        ),
        row(
            "circular footing",
            on(Foundation::CircularFooting(Box::new(stratum))),
            &[
                "elastic stratum over rock",
                "static, coupled springs (DNV-OS-J101, Appendix G)",
            ],
            &["clamped", "half-space"],
        ),
        row(
            "suction caisson",
            on(Foundation::SuctionCaisson(Box::new(caisson))),
            &[
                "the lid of a rigid suction caisson",
                "Jalbi, Shadlou & Bhattacharya (2018)",
                "Fixed degrees of freedom: z, rotation about z.",
            ],
            &["clamped"],
        ),
        row(
            "monopile",
            on(Foundation::Monopile(Box::new(pile))),
            &[
                "the head of a monopile",
                "Randolph (1981)",
                "Fixed degrees of freedom: z, rotation about z.",
            ],
            &["clamped"],
        ),
    ]
}

fn afloat() -> Vec<Row> {
    let matrix = |diagonal: [f64; 6]| {
        let mut matrix = [[0.0; 6]; 6];
        (0..6).for_each(|i| matrix[i][i] = diagonal[i]);
        ReferredMatrix {
            matrix,
            height_m: 0.0,
        }
    };
    let mut platform = FloatingPlatform {
        mass_kg: 1e7,
        center_m: [0.0, 0.0, -30.0],
        added_mass: matrix([1e7, 1e7, 1e6, 1e10, 1e10, 0.0]),
        hydrostatic: matrix([0.0, 0.0, 1e6, 1e10, 1e10, 0.0]),
        mooring: matrix([1e5, 1e5, 0.0, 0.0, 0.0, 1e8]),
        ..FloatingPlatform::default()
    };
    platform.inertia_kg_m2.xx = 1e10;
    platform.inertia_kg_m2.yy = 1e10;
    platform.inertia_kg_m2.zz = 1e9;
    let with = |gravity_m_per_s2| TowerDescription {
        gravity_m_per_s2,
        ..on(Foundation::Floating(Box::new(platform)))
    };
    let dry = FloatingPlatform {
        added_mass: matrix([0.0; 6]),
        ..platform
    };
    let platform_alone = on(Foundation::Floating(Box::new(dry)));
    vec![
        row(
            "floating with gravity",
            with(9.81),
            &[
                "Gravity is included as linear geometric stiffness, g = 9.81",
                "it determines roll and pitch",
                "with constant added mass, hydrostatic stiffness, linear moorings",
                "no water along the tower",
            ],
            &[
                "no water,",
                "lowers the bending frequencies",
                "has no constant",
            ],
        ),
        row(
            "floating without gravity",
            with(0.0),
            &["(g = 0). It determines roll and pitch of a floating tower"],
            &["would lower"],
        ),
        row(
            "floating without added mass",
            platform_alone,
            &[
                "The input has no constant added mass.",
                "radiation damping is neglected",
            ],
            &["frequency dependence"],
        ),
        row(
            "weights of the hydrostatic stiffness",
            with(9.81),
            &["Hydrostatic stiffness as given; the gravity terms of all masses are added to it"],
            &["without gravity terms"],
        )
        .of("input"),
        row(
            "no weights of the hydrostatic stiffness",
            with(0.0),
            &["Hydrostatic stiffness as given, without gravity terms"],
            &["are added to it"],
        )
        .of("input"),
        row(
            "names afloat",
            with(9.81),
            &["named after the largest rigid-body motion"],
            &["A mode is named after"],
        )
        .of("frequencies"),
        row(
            "names ashore",
            pole(),
            &["A mode is named after the motion with the largest mean of both fractions."],
            &["Surge"],
        )
        .of("frequencies"),
    ]
}

fn around() -> Vec<Row> {
    let soil = |height_m| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: 2.5e6,
            y_n_per_m2: 2.5e6,
            ..SoilStiffness::default()
        },
    };
    let soil = TowerDescription {
        soil: vec![vec![soil(0.0), soil(10.0)]],
        ..pole()
    };
    let water = TowerDescription {
        water: Some(Water {
            level_m: 15.0,
            bed_m: None,
            density_kg_per_m3: 1025.0,
            added_mass_coefficient: 1.0,
            flooded: false,
        }),
        ..pole()
    };
    let wires = TowerDescription {
        wires: vec![Wires {
            height_m: 60.0,
            count: 3,
            stiffness_n_per_m: 7.5e4,
            angle_deg: 45.0,
        }],
        ..pole()
    };
    vec![
        row("soil", soil, &["Winkler"], &["no soil"]),
        row("water", water, &["Still water"], &["no water"]),
        row(
            "wires",
            wires,
            &["Guy wires are linear springs"],
            &["no guy wires"],
        ),
    ]
}

fn others() -> Vec<Row> {
    let at = |height_m| PointMass {
        height_m,
        mass_kg: 350e3,
        ..PointMass::default()
    };
    let topped = TowerDescription {
        point_masses: vec![at(40.0), at(80.0)],
        ..pole()
    };
    let rna = TowerDescription {
        rna: Rna::point(350e3),
        ..pole()
    };
    let sheared = TowerDescription {
        shear: Shear::Cowper,
        ..pole()
    };
    vec![
        row(
            "mass at the top",
            topped,
            &["There is no rotor-nacelle assembly. A mass of 350 t is at the tower top."],
            &["no point masses"],
        ),
        row(
            "rna",
            rna,
            &["The rotor-nacelle assembly is one rigid body"],
            &["There is no rotor-nacelle assembly"],
        ),
        row(
            "--no-rna",
            pole(),
            &["There is no rotor-nacelle assembly (--no-rna)."],
            &[],
        )
        .read("--no-rna"),
        row(
            "spectral",
            pole(),
            &["from one polynomial degree, or from one element length, to the next"],
            &["by comparison with those with"],
        )
        .by(Method::Spectral)
        .of("frequencies"),
        row(
            "segments",
            pole(),
            &["by comparison with those with 50 and 25 segments"],
            &["polynomial degree"],
        )
        .of("frequencies"),
        row(
            "bmodes beside it",
            pole(),
            &["The differences of bmodes", "lacks rotary inertia, which"],
            &[],
        )
        .of("methods"),
        row(
            "bmodes beside shear",
            sheared,
            &["lacks rotary inertia and shear deformation, which"],
            &[],
        )
        .of("methods"),
        row(
            "bmodes alike",
            pole(),
            &["decrease with more segments"],
            &["The differences of bmodes"],
        )
        .without_rotary_inertia()
        .of("methods"),
        row(
            "width of tubes",
            pole(),
            &["Height and diameter are to the same scale"],
            &["nominal", "has no diameter"],
        )
        .of("animation"),
        row(
            "width of tables",
            table(0.0),
            &["the input has no diameter"],
            &["Height and diameter"],
        )
        .of("animation"),
    ]
}
