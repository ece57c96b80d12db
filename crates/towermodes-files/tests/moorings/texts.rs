//! Short files, and what they give.

use towermodes::mooring::MooringState;
use towermodes_files::{MooringInput, MooringSite, ReadError, Source, read_map, read_moordyn};
use towermodes_testing::{Close, numbers};

/// OC3-Hywind in MoorDyn 2, as FAST v8 CertTest 24.
pub const MOORDYN_2: &str = "\
--------------------- MoorDyn Input File ------------------------------------
OC3-Hywind
----------------------- LINE TYPES ------------------------------------------
Name     Diam      MassDen      EA     BA/-zeta  EI    Cd      Ca     CdAx   CaAx
(-)       (m)      (kg/m)       (N)    (N-s/-)   (-)   (-)     (-)    (-)    (-)
main     0.09      77.7066   384.243E6  -0.8     0.0   1.6     1.0    0.1    0.0
---------------------- POINTS -----------------------------------------------
ID   Attachment   X        Y        Z       M     V     CdA   CA
(-)     (-)      (m)      (m)      (m)     (kg)  (m^3) (m^2)  (-)
1      Fixed    853.87     0.0    -320.0    0     0      0     0
2      Fixed   -426.94   739.47   -320.0    0     0      0     0
3      Fixed   -426.94  -739.47   -320.0    0     0      0     0
4      Vessel     5.2      0.0     -70.0    0     0      0     0
5      Vessel    -2.6      4.5     -70.0    0     0      0     0
6      Vessel    -2.6     -4.5     -70.0    0     0      0     0
---------------------- LINES ------------------------------------------------
ID   LineType  AttachA   AttachB  UnstrLen  NumSegs   Outputs
(-)     (-)      (-)       (-)      (m)       (-)       (-)
1      main       1         4      902.2       20        -
2      main       2         5      902.2       20        -
3      main       3         6      902.2       20        -
---------------------- OPTIONS ----------------------------------------------
0.001    dtM       - time step to use in mooring integration (s)
3.0e6    kbot      - bottom stiffness (Pa/m)
320.0    WtrDpth   - water depth (m)
1025.0   rhoW      - water density
9.80665  g         - gravity
------------------------ OUTPUTS --------------------------------------------
FairTen1
END
------------------------- need this line --------------------------------------
";

/// The same in MAP++, of which two lines are copies.
pub const MAP: &str = "\
---------------------- LINE DICTIONARY ---------------------------------------
LineType     Diam     MassDenInAir    EA        CB    CIntDamp   Ca   Cdn   Cdt
(-)          (m)      (kg/m)         (N)       (-)     (Pa-s)    (-)  (-)   (-)
Material     0.09      77.7066      384.243E6   0.0     1.0E8    0.6  -1.0  0.05
---------------------- NODE PROPERTIES ---------------------------------------
Node Type       X     Y     Z     M     B     FX    FY    FZ
(-)  (-)       (m)   (m)   (m)   (kg)  (m\u{302}3)  (N)   (N)   (N)
1    fix     853.87   0    depth   0     0     #     #     #
2    Vessel    5.2    0    -70.0   0     0     #     #     #
---------------------- LINE PROPERTIES ---------------------------------------
Line    LineType  UnstrLen    NodeAnch  NodeFair  Flags
(-)      (-)       (m)         (-)       (-)       (-)
1       Material   902.2        1         2        tension_fair tension_anch
---------------------- SOLVER OPTIONS-----------------------------------------
Option
(-)
repeat 240 120
";

/// K11 K22 K33 K44 K55 K66 K15 and Fz of OC3-Hywind, by an independent program.
pub const HYWIND: &str = "41183.24315 41186.10827 11941.82224 310814794.5 310798409.6 11563129.27 -2815574.481 -1607229.954";

/// What a `.fst` file says: 320 m of sea water.
pub const SITE: MooringSite = MooringSite {
    depth_m: Some(320.0),
    water_density_kg_per_m3: Some(1025.0),
    gravity_m_per_s2: Some(9.80665),
};

pub fn source(text: &str) -> Source {
    Source {
        name: "Mooring.dat".to_owned(),
        text: text.to_owned(),
    }
}

pub fn moordyn(text: &str, site: &MooringSite) -> Result<MooringInput, ReadError> {
    read_moordyn(source(text), site)
}

pub fn map(text: &str, site: &MooringSite) -> Result<MooringInput, ReadError> {
    read_map(source(text), site)
}

/// A text in which something is replaced, once.
#[track_caller]
pub fn changed(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from} is not in the file");
    text.replacen(from, to, 1)
}

#[track_caller]
pub fn state(input: Result<MooringInput, ReadError>) -> MooringState {
    let input = input.unwrap_or_else(|error| panic!("{error}"));
    let mooring = input.mooring().unwrap_or_else(|error| panic!("{error}"));
    input
        .at_rest(&mooring)
        .unwrap_or_else(|error| panic!("{error}"))
}

/// Compares K11 K22 K33 K44 K55 K66 K15 and the vertical force with a table of digits.
#[track_caller]
pub fn assert_digits(state: &MooringState, digits: &str, tolerance: f64) {
    let k = &state.load.stiffness;
    let diagonal = (0..6).map(|i| k[i][i]);
    let found = diagonal.chain([k[0][4], state.load.force[2]]);
    for (found, expected) in found.zip(numbers::<8>(digits)) {
        found.close_to(expected, tolerance);
    }
}
