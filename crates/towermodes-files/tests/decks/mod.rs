//! Small decks of BModes for tests, and how they are read.
#![allow(dead_code, reason = "each test uses its own part")]

use crate::sources::source;
use towermodes_files::{
    BladeInput, BmodesInput, Diagnostic, InMemory, ReadError, ReadOptions, Source, TowerInput,
    read_bmodes,
};
use towermodes_testing::with;

/// Lines 1 to 48: a tower of 80 m on a clamped base, without what follows the elements.
pub const TOWER: &str = "\
=== main file ===
A small tower

--- General parameters ---
false     Echo        echo
2         beam_type   1: blade, 2: tower
0.        romg:       rotor speed
1.0       romg_mult:  factor
80.0      radius:     height
0.        hub_rad:    rigid base
0.        precone:    cone
0.        bl_thp:     pitch
1         hub_conn:   root
10        modepr:     modes
f         TabDelim    tabs
f         mid_node_tw twist

--- Tip mass ---
2.0e5     tip_mass    kg
-1.5      cm_loc      m
2.5       cm_axial    m
3.0e6     ixx_tip     kg m2
4.0e6     iyy_tip     kg m2
5.0e6     izz_tip     kg m2
1.0e4     ixy_tip     kg m2
-2.0e4    izx_tip     kg m2
3.0e4     iyz_tip     kg m2

--- Sections ---
1         id_mat:     material
'secs.dat' sec_props_file  name

Factors
1.0       sec_mass_mult:   x
1.0       flp_iner_mult:   x
1.0       lag_iner_mult:   x
1.0       flp_stff_mult:   x
1.0       edge_stff_mult:  x
1.0       tor_stff_mult:   x
1.0       axial_stff_mult: x
1.0       cg_offst_mult:   x
1.0       sc_offst_mult:   x
1.0       tc_offst_mult:   x

--- Elements ---
4         nselt:     elements
el_loc()
0.  0.25  0.5  0.75  1.0
";

/// Lines 49 to 51: no support.
pub const ALONE: &str = "
--- Support ---
0         tow_support: none
";

/// Lines 49 to 57: wires at two nodes.
pub const WIRES: &str = "
--- Support ---
1         tow_support: wires
Tension-wires data
2         n_attachments: places
3 4       n_wires: wires
3 5       node_attach: nodes
1.e8 2.e8 wire_stfness: N/m
60. 30.   th_wire: degrees
";

/// Lines 49 to 91: a platform or a monopile as version 3.00 has it.
pub const OFFSHORE: &str = "
--- Support ---
2         tow_support: platform or monopile
10.0      draft        : m
40.0      cm_pform     : m
8.0e6     mass_pform   : kg
i_matrix_pform:
4.0e9   0.   0.
0.   5.0e9   0.
0.   0.   2.0e8
5.0       ref_msl      : m
hydro_M:
7.0e6 0. 0. 0. -4.0e8 0.
0. 7.0e6 0. 4.0e8 0. 0.
0. 0. 2.4e5 0. 0. 0.
0. 4.0e8 0. 3.8e10 0. 0.
-4.0e8 0. 0. 0. 3.8e10 0.
6*0.0
hydro_K:
6*0.
6*0.
0. 0. 3.3e5 0. 0. 0. !REMARK:3.0 1.0
0. 0. 0. 1.0e9 0. 0.
0. 0. 0. 0. 1.0e9 0.
6*0.
mooring_K:
4.0e4 0. 0. 0. -2.8e6 0.
0. 4.0e4 0. 2.8e6 0. 0.
0. 0. 1.2e4 0. 0. 0.
0. 2.8e6 0. 3.1e8 0. 0.
-2.8e6 0. 0. 0. 3.1e8 0.
0. 0. 0. 0. 0. 1.1e7

Distributed added mass
3         n_secs_m_distr: rows
0. 5. 10. : z_distr_m [m]
7000. 6000. 0. : distr_m [kg/m]

Distributed stiffness
2         n_secs_k_distr: rows
0. 6.
2*5.0e7   : distr_k [N/m2]
END
";

/// The section file of the tower: a uniform lower half, a step, a tapered upper half.
pub const SECTIONS: &str = "\
Tower sections
4        n_secs:   rows

sec_loc str_tw tw_iner mass_den flp_iner edge_iner flp_stff edge_stff tor_stff axial_stff cg_offst sc_offst tc_offst
(-) (deg) (deg) (kg/m) (kg-m) (kg-m) (Nm^2) (Nm^2) (Nm^2) (N) (m) (m) (m)
0.0 0. 0. 4000. 20000. 20000. 500.0E9 500.0E9 400.0E9 110.0E9 0. 0. 0.
0.5 0. 0. 4000. 20000. 20000. 500.0E9 500.0E9 400.0E9 110.0E9 0. 0. 0.
0.5 0. 0. 3000. 12000. 12000. 300.0E9 300.0E9 240.0E9  80.0E9 0. 0. 0.
1.0 0. 0. 2000.  4000.  4000. 100.0E9 100.0E9  80.0E9  50.0E9 0. 0. 0.

**Note: text may follow.
";

/// The section file of a blade.
pub const BLADE_SECTIONS: &str = "\
Blade sections
3        n_secs:   rows

sec_loc str_tw tw_iner mass_den flp_iner edge_iner flp_stff edge_stff tor_stff axial_stff cg_offst sc_offst tc_offst
(-) (deg) (deg) (kg/m) (kg-m) (kg-m) (Nm^2) (Nm^2) (Nm^2) (N) (m) (m) (m)
0.0 10. 10. 300. 20. 80. 8.0E9 9.0E9 2.0E9 17.0E9 0.00 0.00 0.0
0.4 10. -20. 200. 10. 70. 4.0E9 7.0E9 1.0E9 12.0E9 0.15 -0.02 0.03
1.0 0. 0. 10. 0.1 0.7 0.2E9 8.0E6 0.2E6 1.2E8 0.20 0.10 0.0
";

/// A main file with other words in place of some of its own, each there once.
#[track_caller]
pub fn with(text: &str, changes: &[(&str, &str)]) -> String {
    let mut text = text.to_owned();
    for (old, new) in changes {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text = text.replace(old, new);
    }
    text
}

/// The tower's main file with its support.
pub fn tower_file(support: &str) -> String {
    format!("{TOWER}{support}")
}

/// The main file of a blade.
pub fn blade_file() -> String {
    let changes = [
        ("2         beam_type", "1         beam_type"),
        ("0.        romg:", "30.       romg:"),
        ("0.        hub_rad:", "2.        hub_rad:"),
        ("2.0e5     tip_mass", "50.       tip_mass"),
        ("3.0e6     ixx", "10.       ixx"),
        ("4.0e6     iyy", "11.       iyy"),
        ("5.0e6     izz", "12.       izz"),
        ("1.0e4     ixy", "0.1       ixy"),
        ("-2.0e4    izx", "-0.2      izx"),
        ("3.0e4     iyz", "0.3       iyz"),
    ];
    with(TOWER, &changes) + "END of file\n"
}

/// What a deck of these two files is.
pub fn read(main: &str, sections: &str, quirks: bool) -> Result<BmodesInput, ReadError> {
    let source = source("tower.bmi", main);
    let files = [("secs.dat".to_owned(), sections.to_owned())].into();
    let options = with!(ReadOptions, bmodes_quirks = quirks);
    read_bmodes(source, &InMemory { files }, &options)
}

/// The tower of a deck.
#[track_caller]
pub fn tower(main: &str, sections: &str, quirks: bool) -> TowerInput {
    match read(main, sections, quirks).expect("a deck") {
        BmodesInput::Tower(tower) => *tower,
        BmodesInput::Blade(_) => panic!("a blade"),
    }
}

/// The blade of a deck.
#[track_caller]
pub fn blade(main: &str, sections: &str, quirks: bool) -> BladeInput {
    match read(main, sections, quirks).expect("a deck") {
        BmodesInput::Blade(blade) => *blade,
        BmodesInput::Tower(_) => panic!("a tower"),
    }
}

/// The mistakes of a deck, and the file they are in.
#[track_caller]
pub fn mistakes(main: &str, sections: &str, quirks: bool) -> (Source, Vec<Diagnostic>) {
    match read(main, sections, quirks).expect_err("no deck") {
        ReadError::Mistakes {
            source_file,
            mistakes,
        } => (*source_file, mistakes),
        ReadError::Unreadable(error) => panic!("{error}"),
    }
}

/// Expects the first mistake on a line of a file, with these words in its message or hint.
#[track_caller]
pub fn refused(main: &str, sections: &str, place: &str, words: &[&str]) {
    let (source, mistakes) = mistakes(main, sections, false);
    let (line, _) = mistakes[0].line_and_column(&source.text);
    let said = mistakes[0].to_string();
    assert_eq!(format!("{}:{line}", source.name), place, "{said}");
    for word in words {
        assert!(said.contains(word), "no `{word}` in: {said}");
    }
}
