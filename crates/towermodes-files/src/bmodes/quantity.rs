//! The quantities of a deck by the names that its lines carry.
//!
//! Names: the sample files of BModes 3.00 (NREL, 2008) and the decks that other programs write.

/// A quantity of a deck: its names and what it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Quantity {
    /// Its name in the sample files of BModes.
    pub(super) name: &'static str,
    /// What it is, with its unit.
    meaning: &'static str,
    /// What else lines call it.
    aliases: &'static [&'static str],
}

const fn named(name: &'static str, meaning: &'static str) -> Quantity {
    also(name, meaning, &[])
}

const fn also(
    name: &'static str,
    meaning: &'static str,
    aliases: &'static [&'static str],
) -> Quantity {
    Quantity {
        name,
        meaning,
        aliases,
    }
}

impl Quantity {
    /// How messages call it.
    pub(super) fn what(&self) -> String {
        format!("{} ({})", self.name, self.meaning)
    }

    fn is_called(&self, name: &str) -> bool {
        self.name.eq_ignore_ascii_case(name)
            || self
                .aliases
                .iter()
                .any(|alias| alias.eq_ignore_ascii_case(name))
    }

    /// The other quantity whose name a line carries, if it is clearly one.
    pub(super) fn mistaken_for(&self, label: &str) -> Option<&'static Quantity> {
        let name = plain(label);
        let is_meant = self.is_called(name);
        (!is_meant).then(|| Self::called(name)).flatten()
    }

    /// The quantity of a name, whatever stands around it.
    pub(super) fn called(label: &str) -> Option<&'static Quantity> {
        let name = plain(label);
        ALL.into_iter().find(|quantity| quantity.is_called(name))
    }
}

/// A name without the colons and brackets around it.
fn plain(label: &str) -> &str {
    label.trim_matches(|c: char| !c.is_alphanumeric() && c != '_')
}

pub(super) const ECHO: Quantity = named("Echo", "whether to echo the input, true or false");
pub(super) const BEAM_TYPE: Quantity = named("beam_type", "1 for a blade, 2 for a tower");
pub(super) const ROT_RPM: Quantity = also("rot_rpm", "rotor speed, rpm", &["romg"]);
pub(super) const RPM_MULT: Quantity = also("rpm_mult", "factor of the rotor speed", &["romg_mult"]);
pub(super) const RADIUS: Quantity =
    named("radius", "radius of the rotor or height of the tower, m");
pub(super) const HUB_RAD: Quantity = also(
    "hub_rad",
    "radius of the hub or height of the tower's rigid base, m",
    &["rroot"],
);
pub(super) const PRECONE: Quantity = also("precone", "coning angle, degrees", &["btp"]);
pub(super) const BL_THP: Quantity = named("bl_thp", "pitch of the blade, degrees");
pub(super) const HUB_CONN: Quantity = named("hub_conn", "how the root is held, 1, 2 or 3");
pub(super) const MODEPR: Quantity = named("modepr", "number of modes to print");
pub(super) const TAB_DELIM: Quantity = named("TabDelim", "whether tabs separate results");
pub(super) const MID_NODE_TW: Quantity =
    named("mid_node_tw", "whether the twist at mid-nodes is printed");
pub(super) const TIP_MASS: Quantity = named("tip_mass", "tip or tower-top mass, kg");
pub(super) const CM_LOC: Quantity = named("cm_loc", "lateral offset of the tip mass, m");
pub(super) const CM_AXIAL: Quantity = named("cm_axial", "axial offset of the tip mass, m");
pub(super) const TIP_INERTIA: [Quantity; 6] = [
    named("ixx_tip", "inertia of the tip mass about its x axis, kg m2"),
    named("iyy_tip", "inertia of the tip mass about its y axis, kg m2"),
    named("izz_tip", "inertia of the tip mass about its z axis, kg m2"),
    named("ixy_tip", "entry xy of the tip mass's inertia, kg m2"),
    named("izx_tip", "entry zx of the tip mass's inertia, kg m2"),
    named("iyz_tip", "entry yz of the tip mass's inertia, kg m2"),
];
pub(super) const ID_MAT: Quantity = named("id_mat", "type of material, 1");
pub(super) const SEC_PROPS_FILE: Quantity = named("sec_props_file", "name of the section file");
pub(super) const SEC_MASS_MULT: Quantity = named("sec_mass_mult", "factor of the mass per length");
pub(super) const FLP_INER_MULT: Quantity = named("flp_iner_mult", "factor of flp_iner");
pub(super) const LAG_INER_MULT: Quantity =
    also("lag_iner_mult", "factor of edge_iner", &["edge_iner_mult"]);
pub(super) const FLP_STFF_MULT: Quantity = named("flp_stff_mult", "factor of flp_stff");
pub(super) const EDGE_STFF_MULT: Quantity =
    also("edge_stff_mult", "factor of edge_stff", &["lag_stff_mult"]);
pub(super) const TOR_STFF_MULT: Quantity = named("tor_stff_mult", "factor of tor_stff");
pub(super) const AXIAL_STFF_MULT: Quantity = named("axial_stff_mult", "factor of axial_stff");
pub(super) const CG_OFFST_MULT: Quantity = named("cg_offst_mult", "factor of cg_offst");
pub(super) const SC_OFFST_MULT: Quantity = named("sc_offst_mult", "factor of sc_offst");
pub(super) const TC_OFFST_MULT: Quantity = named("tc_offst_mult", "factor of tc_offst");
pub(super) const NSELT: Quantity = named("nselt", "number of elements");
pub(super) const EL_LOC: Quantity = named("el_loc", "borders of the elements, 0 to 1");
pub(super) const TOW_SUPPORT: Quantity = named("tow_support", "what supports the tower, 0, 1 or 2");
pub(super) const N_ATTACHMENTS: Quantity =
    named("n_attachments", "number of places where wires are attached");
pub(super) const N_WIRES: Quantity = named("n_wires", "number of wires at each place");
pub(super) const NODE_ATTACH: Quantity = named("node_attach", "node of each place, 1 at the base");
pub(super) const WIRE_STFNESS: Quantity = also(
    "wire_stfness",
    "stiffness of a wire, N/m",
    &["wire_stiffness"],
);
pub(super) const TH_WIRE: Quantity = named("th_wire", "angle of the wires, degrees");
pub(super) const DRAFT: Quantity = named("draft", "depth of the tower's base below sea level, m");
pub(super) const CM_PFORM: Quantity = named(
    "cm_pform",
    "depth of the platform's centre of mass below sea level, m",
);
pub(super) const MASS_PFORM: Quantity = named("mass_pform", "mass of the platform, kg");
pub(super) const I_MATRIX_PFORM: Quantity =
    named("i_matrix_pform", "inertia of the platform, kg m2");
pub(super) const REF_MSL: Quantity = named(
    "ref_msl",
    "depth of the matrices' reference point below sea level, m",
);
pub(super) const HYDRO_M: Quantity = named("hydro_M", "added mass of the platform");
pub(super) const HYDRO_K: Quantity = named("hydro_K", "hydrostatic stiffness of the platform");
pub(super) const MOORING_K: Quantity = named("mooring_K", "stiffness of the moorings");
pub(super) const N_SECS_M_DISTR: Quantity =
    named("n_secs_m_distr", "number of rows of distributed added mass");
pub(super) const Z_DISTR_M: Quantity = named("z_distr_m", "heights above the flexible base, m");
pub(super) const DISTR_M: Quantity = named("distr_m", "added mass per length, kg/m");
pub(super) const N_SECS_K_DISTR: Quantity =
    named("n_secs_k_distr", "number of rows of distributed stiffness");
pub(super) const Z_DISTR_K: Quantity = named("z_distr_k", "heights above the flexible base, m");
pub(super) const DISTR_K: Quantity = named("distr_k", "stiffness per length, N/m2");
pub(super) const N_SECS: Quantity = named("n_secs", "number of rows of the section file");

/// All that a line may be called.
const ALL: [&Quantity; 56] = [
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
    &TIP_MASS,
    &CM_LOC,
    &CM_AXIAL,
    &TIP_INERTIA[0],
    &TIP_INERTIA[1],
    &TIP_INERTIA[2],
    &TIP_INERTIA[3],
    &TIP_INERTIA[4],
    &TIP_INERTIA[5],
    &ID_MAT,
    &SEC_PROPS_FILE,
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
    &NSELT,
    &EL_LOC,
    &TOW_SUPPORT,
    &N_ATTACHMENTS,
    &N_WIRES,
    &NODE_ATTACH,
    &WIRE_STFNESS,
    &TH_WIRE,
    &DRAFT,
    &CM_PFORM,
    &MASS_PFORM,
    &I_MATRIX_PFORM,
    &REF_MSL,
    &HYDRO_M,
    &HYDRO_K,
    &MOORING_K,
    &N_SECS_M_DISTR,
    &Z_DISTR_M,
    &DISTR_M,
    &N_SECS_K_DISTR,
    &Z_DISTR_K,
    &DISTR_K,
    &N_SECS,
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
