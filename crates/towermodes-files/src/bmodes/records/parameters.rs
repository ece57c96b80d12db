//! The parameters of a deck in the order of its records: the only table that is used for reading,
//! writing, names and messages.
//!
//! Names: the sample files of BModes 3.00 (NREL, 2008) and the decks that other programs write.

use crate::records::{Line, MAX_COUNT};

/// A parameter of a deck.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parameter {
    /// Its name in the sample files of BModes.
    pub(crate) name: &'static str,
    /// Its meaning, for messages and for the comments of written decks.
    meaning: &'static str,
    /// Its unit; empty for none.
    unit: &'static str,
    pub(crate) kind: Kind,
    /// Other names that decks give it.
    aliases: &'static [&'static str],
}

/// The type of a parameter and the range of its values.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Kind {
    /// True or false, read as 1 or 0.
    Flag,
    /// A whole number.
    Whole(Rule),
    /// A number.
    Number(Rule),
    /// The name of a file.
    File,
}

/// A range of values.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rule {
    pub(super) is_met: fn(f64) -> bool,
    /// The range as text.
    pub(super) words: &'static str,
}

/// The largest count and the longest list.
const MOST: f64 = MAX_COUNT as f64;
/// BModes allows two places for guy wires; no tower has more than this number.
const MOST_ATTACHMENTS: f64 = 100.0;

const ANY: Kind = number(|_| true, "a number");
const POSITIVE: Kind = number(|value| value > 0.0, "positive");
const NOT_NEGATIVE: Kind = number(|value| value >= 0.0, "non-negative");
const ROWS: Kind = whole(
    |value| (0.0..=MOST).contains(&value),
    "at least 0 and at most 100000",
);

const fn number(is_met: fn(f64) -> bool, words: &'static str) -> Kind {
    Kind::Number(Rule { is_met, words })
}

const fn whole(is_met: fn(f64) -> bool, words: &'static str) -> Kind {
    Kind::Whole(Rule { is_met, words })
}

impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Parameter {
    /// Its name in messages.
    pub(crate) fn what(&self) -> String {
        let gap = if self.unit.is_empty() { "" } else { ", " };
        format!("{} ({}{gap}{})", self.name, self.meaning, self.unit)
    }

    /// Its comment in written decks.
    pub(crate) fn comment(&self) -> String {
        match self.unit {
            "" => self.meaning.to_owned(),
            unit => format!("{} ({unit})", self.meaning),
        }
    }

    fn is_called(&self, name: &str) -> bool {
        let mut names = self.aliases.iter().chain([&self.name]);
        names.any(|known| known.eq_ignore_ascii_case(name))
    }

    /// The other parameter whose name is on a line, if the name is unambiguous.
    pub(super) fn mistaken_for(&self, label: &str) -> Option<&'static Parameter> {
        let name = plain(label);
        (!self.is_called(name))
            .then(|| Self::called(name))
            .flatten()
    }

    /// The parameter with a name, ignoring colons and brackets around it.
    pub(crate) fn called(label: &str) -> Option<&'static Parameter> {
        let name = plain(label);
        ALL.iter()
            .copied()
            .find(|parameter| parameter.is_called(name))
    }

    /// The parameter whose name follows the first value of a line.
    pub(super) fn after_value(line: Line<'_>) -> Option<&'static Parameter> {
        Self::called(line.tokens().nth(1)?.text)
    }

    /// The parameter whose name follows the numbers of a line.
    pub(super) fn after_numbers(line: Line<'_>) -> Option<&'static Parameter> {
        Self::called(line.tokens().find(|token| !token.is_number())?.text)
    }
}

/// A name without the colons and brackets around it.
fn plain(label: &str) -> &str {
    label.trim_matches(|c: char| !c.is_alphanumeric() && c != '_')
}

/// The table: a constant for each parameter, and all of them in [`ALL`].
macro_rules! parameters {
    ($($id:ident: $name:literal, $meaning:literal, $unit:literal, $kind:expr $(, [$($alias:literal),+])?;)+) => {
        $(pub(crate) const $id: Parameter = Parameter {
            name: $name,
            meaning: $meaning,
            unit: $unit,
            kind: $kind,
            aliases: &[$($($alias),+)?],
        };)+

        /// All parameters of a deck.
        const ALL: &[&Parameter] = &[$(&$id),+];
    };
}

parameters! {
    ECHO: "Echo", "whether the input is repeated in a file .echo", "", Kind::Flag;
    BEAM_TYPE: "beam_type", "1: blade, 2: tower", "", whole(|v| (1.0..=2.0).contains(&v), "1 (a blade) or 2 (a tower)");
    ROT_RPM: "rot_rpm", "rotor speed", "rpm", NOT_NEGATIVE, ["romg"];
    RPM_MULT: "rpm_mult", "factor of the rotor speed", "", NOT_NEGATIVE, ["romg_mult"];
    RADIUS: "radius", "rotor radius, or height of the tower top", "m", POSITIVE;
    HUB_RAD: "hub_rad", "hub radius, or height of the tower's rigid base", "m", NOT_NEGATIVE, ["rroot"];
    PRECONE: "precone", "coning angle of a blade", "degrees", ANY, ["btp"];
    BL_THP: "bl_thp", "pitch of a blade", "degrees", ANY;
    HUB_CONN: "hub_conn", "root or base: 1 clamped, 2 free or on springs, 3 held axially and in torsion", "", whole(|v| (1.0..=3.0).contains(&v), "1, 2 or 3");
    MODEPR: "modepr", "number of modes to print", "", whole(|v| (1.0..=1e9).contains(&v), "at least 1");
    TAB_DELIM: "TabDelim", "whether tabs separate the results", "", Kind::Flag;
    MID_NODE_TW: "mid_node_tw", "whether the twist at mid-nodes is printed", "", Kind::Flag;
    TIP_MASS: "tip_mass", "tip or tower-top mass", "kg", NOT_NEGATIVE;
    CM_LOC: "cm_loc", "lateral (downwind) offset of the tip mass", "m", ANY;
    CM_AXIAL: "cm_axial", "axial (upward) offset of the tip mass", "m", ANY;
    IXX_TIP: "ixx_tip", "inertia of the tip mass about its x axis, side-side rotation", "kg m2", NOT_NEGATIVE;
    IYY_TIP: "iyy_tip", "inertia of the tip mass about its y axis, fore-aft rotation", "kg m2", NOT_NEGATIVE;
    IZZ_TIP: "izz_tip", "inertia of the tip mass about its z axis, torsion", "kg m2", NOT_NEGATIVE;
    IXY_TIP: "ixy_tip", "entry xy of the inertia of the tip mass", "kg m2", ANY;
    IZX_TIP: "izx_tip", "entry zx of the inertia of the tip mass", "kg m2", ANY;
    IYZ_TIP: "iyz_tip", "entry yz of the inertia of the tip mass", "kg m2", ANY;
    ID_MAT: "id_mat", "type of material, 1: isotropic", "", whole(|v| v == 1.0, "1");
    SEC_PROPS_FILE: "sec_props_file", "name of the section file", "", Kind::File;
    SEC_MASS_MULT: "sec_mass_mult", "factor of mass_den", "", POSITIVE;
    FLP_INER_MULT: "flp_iner_mult", "factor of flp_iner", "", NOT_NEGATIVE;
    LAG_INER_MULT: "lag_iner_mult", "factor of edge_iner", "", NOT_NEGATIVE, ["edge_iner_mult"];
    FLP_STFF_MULT: "flp_stff_mult", "factor of flp_stff, fore-aft", "", POSITIVE;
    EDGE_STFF_MULT: "edge_stff_mult", "factor of edge_stff, side-side", "", POSITIVE, ["lag_stff_mult"];
    TOR_STFF_MULT: "tor_stff_mult", "factor of tor_stff", "", POSITIVE;
    AXIAL_STFF_MULT: "axial_stff_mult", "factor of axial_stff", "", POSITIVE;
    CG_OFFST_MULT: "cg_offst_mult", "factor of cg_offst", "", ANY;
    SC_OFFST_MULT: "sc_offst_mult", "factor of sc_offst", "", ANY;
    TC_OFFST_MULT: "tc_offst_mult", "factor of tc_offst", "", ANY;
    NSELT: "nselt", "number of elements", "", whole(|v| (1.0..=MOST).contains(&v), "at least 1 and at most 100000");
    EL_LOC: "el_loc", "element borders as fractions of the length, from root to tip", "", ANY;
    TOW_SUPPORT: "tow_support", "tower support, 0: none, 1: guy wires, 2: platform, monopile or springs", "", whole(|v| (0.0..=2.0).contains(&v), "0, 1 or 2");
    N_ATTACHMENTS: "n_attachments", "number of sets of guy wires", "", whole(|v| (0.0..=MOST_ATTACHMENTS).contains(&v), "at least 0 and at most 100");
    N_WIRES: "n_wires", "number of wires in each set", "", whole(|v| (3.0..=1e6).contains(&v), "at least three, to hold the tower in every direction, and at most 1000000");
    NODE_ATTACH: "node_attach", "node of each set, 1 at the base", "", whole(|v| v >= 2.0, "at least 2, the first node above the base, and at most nselt + 1, the top");
    WIRE_STFNESS: "wire_stfness", "EA/L of each wire", "N/m", POSITIVE, ["wire_stiffness"];
    TH_WIRE: "th_wire", "angle of the wires from the horizontal", "degrees", number(|v| (0.0..=90.0).contains(&v), "from 0 to 90");
    DRAFT: "draft", "depth of the tower's base below mean sea level", "m", ANY;
    CM_PFORM: "cm_pform", "depth of the platform's centre of mass below mean sea level", "m", ANY;
    MASS_PFORM: "mass_pform", "mass of the platform", "kg", NOT_NEGATIVE;
    I_MATRIX_PFORM: "i_matrix_pform", "inertia of the platform about its centre of mass", "kg m2", ANY;
    REF_MSL: "ref_msl", "depth of the matrices' reference point below mean sea level", "m", ANY;
    HYDRO_M: "hydro_M", "added mass at the base", "kg, kg m, kg m2", ANY;
    HYDRO_K: "hydro_K", "hydrostatic stiffness at the base", "N/m, N, N m", ANY;
    MOORING_K: "mooring_K", "stiffness of moorings, springs or soil at the base", "N/m, N, N m", ANY;
    N_SECS_M_DISTR: "n_secs_m_distr", "number of heights with distributed added mass", "", ROWS;
    Z_DISTR_M: "z_distr_m", "heights above the flexible base", "m", ANY;
    DISTR_M: "distr_m", "added mass per length", "kg/m", NOT_NEGATIVE;
    N_SECS_K_DISTR: "n_secs_k_distr", "number of heights with distributed stiffness", "", ROWS;
    Z_DISTR_K: "z_distr_k", "heights above the flexible base", "m", ANY;
    DISTR_K: "distr_k", "stiffness per length, equal in x and y", "N/m2", NOT_NEGATIVE;
    N_SECS: "n_secs", "number of rows of the section file", "", whole(|v| (2.0..=MOST).contains(&v), "at least 2 and at most 100000");
}

/// The records of the general parameters.
pub(crate) const GENERAL: [&Parameter; 12] = [
    &ECHO,
    &BEAM_TYPE,
    &ROT_RPM,
    &RPM_MULT,
    &RADIUS,
    &HUB_RAD,
    &PRECONE,
    &BL_THP,
    &HUB_CONN,
    &MODEPR,
    &TAB_DELIM,
    &MID_NODE_TW,
];
/// The records of the tip mass that come first in every version.
pub(crate) const TIP: [&Parameter; 2] = [&TIP_MASS, &CM_LOC];
/// The records of the inertia of the tip mass; before them BModes 3.00 has [`CM_AXIAL`].
pub(crate) const TIP_INERTIA: [&Parameter; 6] =
    [&IXX_TIP, &IYY_TIP, &IZZ_TIP, &IXY_TIP, &IZX_TIP, &IYZ_TIP];
/// The records of the factors of the section file's columns.
pub(crate) const FACTORS: [&Parameter; 10] = [
    &SEC_MASS_MULT,
    &FLP_INER_MULT,
    &LAG_INER_MULT,
    &FLP_STFF_MULT,
    &EDGE_STFF_MULT,
    &TOR_STFF_MULT,
    &AXIAL_STFF_MULT,
    &CG_OFFST_MULT,
    &SC_OFFST_MULT,
    &TC_OFFST_MULT,
];
/// The records of guy wires, a value for each set, after [`N_ATTACHMENTS`].
pub(crate) const WIRES: [&Parameter; 4] = [&N_WIRES, &NODE_ATTACH, &WIRE_STFNESS, &TH_WIRE];
/// The records at the beginning of the offshore block, before [`I_MATRIX_PFORM`].
pub(crate) const PLATFORM: [&Parameter; 3] = [&DRAFT, &CM_PFORM, &MASS_PFORM];
/// The 6x6 matrices of the offshore block, after [`REF_MSL`].
pub(crate) const MATRICES: [&Parameter; 3] = [&HYDRO_M, &HYDRO_K, &MOORING_K];
/// A table over the height: the records of its number of rows, its heights and its values.
pub(crate) type Table = [&'static Parameter; 3];
/// The table of distributed added mass.
pub(crate) const ADDED_MASS: Table = [&N_SECS_M_DISTR, &Z_DISTR_M, &DISTR_M];
/// The table of distributed stiffness.
pub(crate) const STIFFNESS: Table = [&N_SECS_K_DISTR, &Z_DISTR_K, &DISTR_K];

/// A column of the section file, in the order of [`COLUMNS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    Location,
    Twist,
    InertiaTwist,
    Mass,
    FlapInertia,
    EdgeInertia,
    Flap,
    Edge,
    Torsion,
    Axial,
    CenterOfMass,
    ShearCenter,
    TensionCenter,
}

impl Column {
    /// Its name in the section file.
    pub(crate) fn name(self) -> &'static str {
        COLUMNS[self as usize].0
    }
}

/// The columns of the section file with their units.
pub(crate) const COLUMNS: [(&str, &str); 13] = [
    ("sec_loc", "(-)"),
    ("str_tw", "(deg)"),
    ("tw_iner", "(deg)"),
    ("mass_den", "(kg/m)"),
    ("flp_iner", "(kg-m)"),
    ("edge_iner", "(kg-m)"),
    ("flp_stff", "(Nm^2)"),
    ("edge_stff", "(Nm^2)"),
    ("tor_stff", "(Nm^2)"),
    ("axial_stff", "(N)"),
    ("cg_offst", "(m)"),
    ("sc_offst", "(m)"),
    ("tc_offst", "(m)"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_compared_loosely() {
        assert_eq!(RADIUS.mistaken_for("Radius:"), None);
        assert_eq!(ROT_RPM.mistaken_for("romg:"), None);
        assert_eq!(RADIUS.mistaken_for("hub_rad:"), Some(&HUB_RAD));
        assert_eq!(RADIUS.mistaken_for("rroot"), Some(&HUB_RAD));
        assert_eq!(RADIUS.mistaken_for("height"), None);
        assert_eq!(RADIUS.mistaken_for(":"), None);
    }
}
