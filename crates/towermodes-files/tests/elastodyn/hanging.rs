//! Towers that hang below a floating platform, as those of turbines in a current.

use towermodes::{Foundation, Inertia, Options, RigidBody, Tower, TowerDescription, solve};
use towermodes_files::{InMemory, Input, ReadError, ReadOptions, read_source};
use towermodes_testing::{Says, with};

use super::texts::{BLADE, MASSES, TOWER, main_text, source};
use crate::hydrodyn::texts::{Layout, deck as hydrodyn};
use crate::moorings::texts::MOORDYN_2;

const GRAVITY: f64 = 9.81;
const NO_ROW: &str = "0 0 0 0 0 0\n";

/// The platform, which is not symmetric.
const PLATFORM: RigidBody = RigidBody {
    mass_kg: 4e5,
    center_m: [0.5, -0.3, -6.0],
    inertia_kg_m2: Inertia {
        xx: 3e7,
        yy: 4e7,
        zz: 5e7,
        xy: 1e6,
        yz: -2e6,
        xz: 3e6,
    },
};

/// A model of a platform with the stiffness AddCLin, its tower and its lines.
struct Model<'a> {
    platform: RigidBody,
    added: [[f64; 6]; 6],
    heights: [&'a str; 2],
    tower: String,
    options: ReadOptions,
}

impl Model<'_> {
    fn main(&self) -> String {
        let RigidBody {
            mass_kg,
            center_m: [x, y, z],
            inertia_kg_m2: own,
        } = self.platform;
        let values = [
            ("PtfmMass", mass_kg),
            ("PtfmCMxt", x),
            ("PtfmCMyt", y),
            ("PtfmCMzt", z),
            ("PtfmRIner", own.xx),
            ("PtfmPIner", own.yy),
            ("PtfmYIner", own.zz),
            ("PtfmXYIner", own.xy),
            ("PtfmYZIner", own.yz),
            ("PtfmXZIner", own.xz),
        ];
        let values = values.map(|(name, value)| (name, format!("{value:e}")));
        let [base, top] = self.heights;
        let mut changes = vec![("TowerBsHt", base), ("TowerHt", top)];
        changes.extend(values.iter().map(|(name, value)| (*name, value.as_str())));
        let free = ["Sg", "Sw", "Hv", "R", "P", "Y"].map(|motion| format!("Ptfm{motion}DOF"));
        changes.extend(free.iter().map(|name| (name.as_str(), "True")));
        main_text(5, &changes)
    }

    fn water(&self) -> String {
        let deck = hydrodyn(
            Layout::V41,
            &[
                ("NJoints", "1 2 0 -12 1 0\n2 2 0 6 1 0\n3 -4 3 -9 1 0"),
                ("NMembers", "1 1 2 1 1 1 0.5 1 F\n2 1 3 1 1 1 0.5 1 F"),
                ("NPropSets", "1 8.0 0.1"),
                ("NFillGroups", ""),
            ],
        );
        let rows = self
            .added
            .map(|row| row.map(|x| format!("{x:e}")).join(" "));
        let [first, others @ ..] = &rows;
        let given = format!("{first} AddCLin - matrix\n{}\n", others.join("\n"));
        let zeros = format!("0 0 0 0 0 0 AddCLin - matrix\n{}", NO_ROW.repeat(5));
        assert!(deck.contains(&zeros));
        deck.replace(&zeros, &given)
    }

    fn read(&self, sub: u8) -> Result<Box<towermodes_files::TowerInput>, ReadError> {
        let lines = MOORDYN_2
            .replace("5.2      0.0     -70.0", "15 0 -10")
            .replace("-2.6      4.5     -70.0", "-7.5 12.990381 -10")
            .replace("-2.6     -4.5     -70.0", "-6.5 -11 -8")
            .replace("9.80665", "9.81")
            .replace("902.2", "915.0");
        let fst = format!(
            "------- OpenFAST INPUT FILE -------\na turbine in a current\n1 CompElast - x\n\
             {sub} CompSub - x\n1 CompHydro - x\n3 CompMooring - x\n2 MHK - x\n{GRAVITY} Gravity - g\n\
             1025 WtrDens - rho\n320 WtrDpth - m\n0 MSL2SWL - m\n\"main.dat\" EDFile - name\n\
             \"sub.dat\" SubFile - name\n\"wet.dat\" HydroFile - name\n\"lines.dat\" MooringFile - name\n"
        );
        let files = [
            ("main.dat", self.main()),
            ("tower.dat", self.tower.clone()),
            ("parts\\blade.dat", BLADE.to_owned()),
            ("wet.dat", self.water()),
            ("lines.dat", lines),
        ];
        let files = InMemory {
            files: files.map(|(name, text)| (name.to_owned(), text)).into(),
        };
        match read_source(source("model.fst", fst), &files, &self.options)? {
            Input::Tower(input) => Ok(input),
            Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => panic!("no tower"),
        }
    }

    fn description(&self) -> TowerDescription {
        let input = self.read(0).unwrap_or_else(|error| panic!("{error}"));
        input.description
    }
}

/// The tower from 10 to 40 m below the sea, as good as rigid.
fn hanging() -> Model<'static> {
    let mut added = [[0.0; 6]; 6];
    (added[0][4], added[4][0]) = (2e4, 2e4);
    (added[2][3], added[3][2]) = (-3e5, -3e5);
    (added[5][5], added[3][3], added[4][4]) = (2e7, 6e8, 7e8);
    Model {
        platform: PLATFORM,
        added,
        heights: ["-10", "-40"],
        tower: TOWER
            .replace(" 3 AdjFASt", " 3e7 AdjFASt")
            .replace(" 4 AdjSSSt", " 4e7 AdjSSSt")
            + MASSES,
        options: ReadOptions::default(),
    }
}

fn mirrored(body: &RigidBody) -> RigidBody {
    let ([x, y, z], own) = (body.center_m, body.inertia_kg_m2);
    RigidBody {
        center_m: [x, y, -z],
        inertia_kg_m2: Inertia {
            yz: -own.yz,
            xz: -own.xz,
            ..own
        },
        ..*body
    }
}

/// The tower and what it carries as one body, where they are: its rows by the midpoints of short
/// pieces.
fn above(description: &TowerDescription) -> RigidBody {
    const PIECES: usize = 2000;
    let mut bodies = Vec::new();
    for pair in description.properties.windows(2) {
        let length_m = pair[1].height_m - pair[0].height_m;
        let [from, to] = [&pair[0], &pair[1]].map(|row| row.properties.mass_kg_per_m);
        bodies.extend((0..PIECES).map(|piece| {
            let at = (piece as f64 + 0.5) / PIECES as f64;
            let mass_kg = (from + at * (to - from)) * length_m / PIECES as f64;
            let center_m = [0.0, 0.0, pair[0].height_m + at * length_m];
            with!(RigidBody, mass_kg = mass_kg, center_m = center_m)
        }));
    }
    bodies.extend(description.point_masses.iter().map(|mass| {
        let center_m = [0.0, 0.0, mass.height_m];
        with!(RigidBody, mass_kg = mass.mass_kg, center_m = center_m)
    }));
    let top_m = description.properties.last().expect("rows").height_m;
    let rna = &description.rna;
    let [x, y, z] = rna.center_m;
    bodies.push(RigidBody {
        mass_kg: rna.mass_kg,
        center_m: [x, y, top_m + z],
        inertia_kg_m2: rna.inertia_kg_m2,
    });
    mirrored(&RigidBody::combined(&bodies))
}

fn six(description: TowerDescription) -> Vec<f64> {
    let tower = Tower::new(description).unwrap_or_else(|error| panic!("{error}"));
    let solution = solve(&tower, &with!(Options, modes = 6));
    let solution = solution.unwrap_or_else(|error| panic!("{error}"));
    let modes = solution.modes.iter();
    modes.map(|mode| mode.frequency_hz).collect()
}

/// A rigid tower that hangs is a part of its platform, but for its weight: the same masses in a
/// platform with a short light tower on top have the same six motions.
#[test]
fn a_rigid_tower_that_hangs_moves_as_a_part_of_its_platform() {
    let hangs = hanging();
    let description = hangs.description();
    let carried = above(&description);
    assert!(carried.mass_kg > 0.1 * PLATFORM.mass_kg && carried.center_m[2] < -20.0);
    // Its weight has no stiffness below the platform.
    let mut added = hangs.added;
    for i in [3, 4] {
        added[i][i] += carried.mass_kg * GRAVITY * carried.center_m[2];
    }
    let stands = Model {
        platform: RigidBody::combined(&[PLATFORM, carried]),
        added,
        heights: ["1", "2"],
        tower: TOWER.replace(" 2 AdjTwMa", " 1e-9 AdjTwMa"),
        options: ReadOptions {
            without_rna: true,
            ..ReadOptions::default()
        },
    };
    let (found, expected) = (six(description), six(stands.description()));
    for (found, expected) in found.iter().zip(&expected) {
        let error = (found / expected - 1.0).abs();
        assert!(
            error < 1e-7,
            "{found} Hz, expected {expected} Hz: {error:e}"
        );
    }
}

/// The notes say what has no stiffness, and a heavier platform is stiffer by its weight.
#[test]
fn the_weight_of_the_platform_is_a_part_of_its_stiffness() {
    let mut model = hanging();
    let input = model.read(0).unwrap_or_else(|error| panic!("{error}"));
    let said: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
    for part in [
        "the platform above a hanging tower has the stiffness of its weight",
        "MHK is 2, so the turbine is in water",
    ] {
        assert!(said.iter().any(|note| note.contains(part)), "{said:?}");
    }
    let roll = |description: &TowerDescription| match &description.foundation {
        Foundation::Floating(platform) => platform.hydrostatic.matrix[3][3],
        other => panic!("{other:?}"),
    };
    let with_weight = roll(&input.description);
    model.platform.mass_kg *= 2.0;
    let weight = roll(&model.description()) - with_weight;
    let expected = PLATFORM.mass_kg * GRAVITY * 6.0;
    assert!((weight / expected - 1.0).abs() < 1e-9, "{weight:e}");
}

#[test]
fn a_tower_that_hangs_below_a_substructure_is_refused() {
    let error = hanging().read(1).expect_err("a substructure");
    error.says("a tower that hangs below a substructure of SubDyn is not solved");
}

/// The couplings of a matrix that was computed from lines have any signs.
#[test]
fn moorings_computed_from_lines_have_no_warning_about_their_couplings() {
    let about = |description: TowerDescription| {
        let tower = Tower::new(description).expect("a tower");
        let warnings = tower.warnings().iter().map(ToString::to_string);
        let about = warnings.filter(|warning| warning.contains("mooring stiffness"));
        about.collect::<Vec<String>>()
    };
    let mut description = hanging().description();
    assert!(description.mooring_is_computed);
    let Foundation::Floating(platform) = &mut description.foundation else {
        panic!("a platform");
    };
    // As those of lines on one side: the same sign, with equal planes.
    let matrix = &mut platform.mooring.matrix;
    matrix[1][1] = matrix[0][0];
    matrix[4][4] = matrix[3][3];
    let coupling = 0.05 * (matrix[0][0] * matrix[4][4]).sqrt();
    for (i, j) in [(0, 4), (1, 3)] {
        (matrix[i][j], matrix[j][i]) = (coupling, coupling);
    }
    assert_eq!(about(description.clone()), [""; 0]);
    description.mooring_is_computed = false;
    let found = about(description.clone());
    assert!(
        found[0].contains("has the same sign in the coupling"),
        "{found:?}"
    );
    // Where the planes differ much the signs may be equal.
    let Foundation::Floating(platform) = &mut description.foundation else {
        panic!("a platform");
    };
    platform.mooring.matrix[1][1] *= 0.1;
    let found = about(description);
    assert!(
        !found.iter().any(|found| found.contains("same sign")),
        "{found:?}"
    );
}
