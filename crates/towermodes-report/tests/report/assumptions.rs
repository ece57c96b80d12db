//! What a report says of a tower is true of that tower, one row a kind of input.

use std::path::Path;

use towermodes::{
    CircularFooting, FloatingPlatform, Foundation, FoundationSprings, Method, Monopile, Options,
    PileFormula, PileTube, Planes, PointMass, Properties, PropertyStation, ReferredMatrix, Rna,
    Shear, SoilProfile, SoilRow, SoilStiffness, StiffnessFoundation, SuctionCaisson,
    TowerDescription,
};
use towermodes_files::{Input, ReadOptions, read};
use towermodes_testing::{changed, parts, with, words};

use super::{content_by, page_of, pole, section};

/// A tower, how it is solved, what is said of it and what is not.
struct Row {
    name: &'static str,
    description: TowerDescription,
    options: Options,
    reading: &'static str,
    section: &'static str,
    said: Vec<&'static str>,
    unsaid: Vec<&'static str>,
}

fn row(name: &'static str, description: TowerDescription) -> Row {
    Row {
        name,
        description,
        options: Options::default(),
        reading: "",
        section: "assumptions",
        said: Vec::new(),
        unsaid: Vec::new(),
    }
}

impl Row {
    fn says(mut self, said: &'static str) -> Self {
        self.said.extend(words(said));
        self
    }

    fn omits(mut self, unsaid: &'static str) -> Self {
        self.unsaid.extend(words(unsaid));
        self
    }

    fn by(mut self, method: Method) -> Self {
        self.options.method = method;
        self
    }

    fn without_rotary_inertia(mut self) -> Self {
        self.options.rotary_inertia = false;
        self
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
        row("clamped tube", pole())
            .says("a Rayleigh beam & Torsion and axial deformation are included.")
            .says("The base is clamped & by 5 % at a load factor of 10.")
            .says("There is no rotor-nacelle assembly.")
            .says(
                "no soil along the tower, no water along the tower, no guy wires, no point masses",
            )
            .omits("table & BModes & infinite & at the tower top"),
        row("Cowper", sheared(Shear::Cowper)).says("a Timoshenko beam & Cowper (1966)"),
        row("tube, --no-rotary-inertia", pole())
            .says("an Euler-Bernoulli beam & neglected (--no-rotary-inertia)")
            .omits("table")
            .without_rotary_inertia(),
        row(
            "Timoshenko, --no-rotary-inertia",
            sheared(Shear::Coefficient(0.5)),
        )
        .says("with shear deformation but without rotary inertia")
        .says("shear coefficient is 0.5")
        .without_rotary_inertia(),
        row("tube by bmodes", pole())
            .says("an Euler-Bernoulli beam & The element of BModes has no rotary inertia")
            .omits("(--no-rotary-inertia)")
            .by(Method::Bmodes),
        row("Timoshenko by bmodes", sheared(Shear::Cowper))
            .says("an Euler-Bernoulli beam")
            .says("rotary inertia and shear stiffness of the input are neglected")
            .omits("Cowper")
            .by(Method::Bmodes),
        row("table without rotary inertia", table(0.0))
            .says("an Euler-Bernoulli beam")
            .says("The table of the input has no rotary inertia.")
            .says("a table: mass and stiffness vary linearly")
            .says("Axial deformation is included, torsion is not")
            .omits("Rayleigh & tubes & (--no-rotary-inertia)"),
        row("table with rotary inertia", table(900.0))
            .says("a Rayleigh beam & squared radii of gyration")
            .omits("has no rotary inertia"),
        row("deck of ElastoDyn", example("small-turbine/ElastoDyn.dat"))
            .says("an Euler-Bernoulli beam")
            .says("Torsion and axial deformation are not included")
            .says("rotor-nacelle assembly is one rigid body")
            .omits("Rayleigh & Axial deformation is included"),
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
    with!(TowerDescription, properties = vec![row(0.0), row(80.0)])
}

fn example(name: &str) -> TowerDescription {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    match read(&examples.join(name), &ReadOptions::default()) {
        Ok(Input::Tower(tower)) => tower.description,
        _ => panic!("{name} is no tower"),
    }
}

fn on(foundation: Foundation) -> TowerDescription {
    changed!(pole(), foundation)
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
    let without_inertia = changed!(matrices, inertia = [[0.0; 6]; 6]);
    let footing = parts::half_space(9.0, 0.0, 5e7, 0.3);
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
        row("springs", on(Foundation::Springs(springs)))
            .says("linear springs & Fixed degrees of freedom: z, rotation about z.")
            .says("more so on a softer foundation")
            .omits("clamped & inertia of the foundation"),
        row(
            "springs that are all rigid",
            on(Foundation::Springs(FoundationSprings::RIGID)),
        )
        .says("clamped: every spring of the foundation is rigid")
        .omits("linear springs"),
        row(
            "stiffness matrix with inertia",
            on(Foundation::Stiffness(Box::new(matrices))),
        )
        .says("linear springs & Fixed degrees of freedom: z, rotation about z.")
        .says("The inertia of the foundation moves with the base")
        .omits("clamped"),
        row(
            "stiffness matrix without inertia",
            on(Foundation::Stiffness(Box::new(without_inertia))),
        )
        .says("linear springs")
        .omits("inertia of the foundation"),
        row("half-space", on(Foundation::HalfSpace(footing)))
            .says("elastic half-space")
            .omits("clamped"),
        row(
            "circular footing",
            on(Foundation::CircularFooting(Box::new(stratum))),
        )
        .says("elastic stratum over rock")
        .says("static, coupled springs (DNV-OS-J101, Appendix G)")
        .omits("clamped & half-space"),
        row(
            "suction caisson",
            on(Foundation::SuctionCaisson(Box::new(caisson))),
        )
        .says("the lid of a rigid suction caisson")
        .says("Jalbi, Shadlou & Bhattacharya (2018)")
        .says("Fixed degrees of freedom: z, rotation about z.")
        .omits("clamped"),
        row("monopile", on(Foundation::Monopile(Box::new(pile))))
            .says("the head of a monopile & Randolph (1981)")
            .says("Fixed degrees of freedom: z, rotation about z.")
            .omits("clamped"),
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
        ..on(Foundation::Floating(Box::new(platform.clone())))
    };
    let dry = changed!(platform.clone(), added_mass = matrix([0.0; 6]));
    let platform_alone = on(Foundation::Floating(Box::new(dry)));
    vec![
        row("floating with gravity", with(9.81))
            .says("Gravity is included as linear geometric stiffness, g = 9.81")
            .says("gravity determines roll and pitch")
            .says("with constant added mass, hydrostatic stiffness, linear moorings")
            .says("no water along the tower")
            .omits("no water, & lowers the bending frequencies & has no constant"),
        row("floating without gravity", with(0.0))
            .says("(g = 0). It determines roll and pitch of a floating tower")
            .omits("would lower"),
        row("floating without added mass", platform_alone)
            .says("The input has no constant added mass. & radiation damping is neglected")
            .omits("frequency dependence"),
        row("weights of the hydrostatic stiffness", with(9.81))
            .says("Hydrostatic stiffness as given; the gravity terms of all masses are added to it")
            .omits("without gravity terms")
            .of("input"),
        row("no weights of the hydrostatic stiffness", with(0.0))
            .says("Hydrostatic stiffness as given, without gravity terms")
            .omits("are added to it")
            .of("input"),
        row("names afloat", with(9.81))
            .says("Surge, sway, heave, roll, pitch and yaw are motions of the whole tower")
            .omits("mean of both fractions")
            .of("frequencies"),
        row("names ashore", pole())
            .says("A mode is named after the motion with the largest arrears")
            .omits("Surge")
            .of("frequencies"),
    ]
}

fn around() -> Vec<Row> {
    let soil = |height_m| SoilRow {
        height_m,
        stiffness: with!(SoilStiffness, x_n_per_m2 = 2.5e6, y_n_per_m2 = 2.5e6),
    };
    let soil = changed!(pole(), soil = vec![vec![soil(0.0), soil(10.0)]]);
    let water = TowerDescription {
        water: Some(parts::water(15.0, None, 1025.0, 1.0, false)),
        ..pole()
    };
    let wires = changed!(pole(), wires = vec![parts::wires(60.0, 3, 7.5e4, 45.0)]);
    vec![
        row("soil", soil).says("Winkler").omits("no soil"),
        row("water", water).says("Still water").omits("no water"),
        row("wires", wires)
            .says("Guy wires are linear springs")
            .omits("no guy wires"),
    ]
}

fn others() -> Vec<Row> {
    let at = |height_m| with!(PointMass, height_m, mass_kg = 350e3);
    let topped = changed!(pole(), point_masses = vec![at(40.0), at(80.0)]);
    let rna = changed!(pole(), rna = Rna::point(350e3));
    let sheared = changed!(pole(), shear = Shear::Cowper);
    vec![
        row("mass at the top", topped)
            .says("There is no rotor-nacelle assembly. A mass of 350 t is at the tower top.")
            .omits("no point masses"),
        row("rna", rna)
            .says("The rotor-nacelle assembly is one rigid body")
            .omits("There is no rotor-nacelle assembly"),
        row("--no-rna", pole())
            .says("There is no rotor-nacelle assembly (--no-rna).")
            .read("--no-rna"),
        row("spectral", pole())
            .says("from one polynomial degree, or from one element length, to the next")
            .omits("by comparison with the frequencies for")
            .by(Method::Spectral)
            .of("frequencies"),
        row("segments", pole())
            .says("by comparison with the frequencies for 50 and 25 segments")
            .omits("polynomial degree")
            .of("frequencies"),
        row("bmodes beside it", pole())
            .says("The differences of bmodes & lacks rotary inertia, which")
            .of("methods"),
        row("bmodes beside shear", sheared)
            .says("lacks rotary inertia and shear deformation, which")
            .of("methods"),
        row("bmodes alike", pole())
            .says("decrease with more segments")
            .omits("The differences of bmodes")
            .without_rotary_inertia()
            .of("methods"),
        row("width of tubes", pole())
            .says("Height and diameter are to the same scale")
            .omits("nominal & has no diameter")
            .of("animation"),
        row("width of tables", table(0.0))
            .says("the input has no diameter")
            .omits("Height and diameter")
            .of("animation"),
    ]
}
