//! The text of the main file.

use towermodes::Rna;

use super::error::BmodesWriteError;
use super::lines::{Lines, VALUES_IN_A_LINE};
use super::number::number;
use super::platform::Platform;
use super::sections::name_or;
use super::support::{Ends, Hub, Support};

/// BModes keeps so many characters of a title.
const TITLE_LENGTH: usize = 99;
/// BModes keeps so many characters of a file's name.
const NAME_LENGTH: usize = 200;

/// What the main file says.
pub(super) struct Deck<'a> {
    pub(super) title: &'a str,
    /// In quotes.
    pub(super) sections_file: &'a str,
    pub(super) modes: usize,
    pub(super) tip: &'a Rna,
    pub(super) multiplier: f64,
    pub(super) borders: &'a [f64],
    pub(super) hub: Hub,
    pub(super) ends: Ends,
    pub(super) support: &'a Support,
    /// The nodes of the wires, from 1 at the base.
    pub(super) wire_nodes: &'a [usize],
}

/// The name of a file in quotes that are not in it.
pub(super) fn quoted(name: &str) -> Result<String, BmodesWriteError> {
    let quote = ['\'', '"'].into_iter().find(|quote| !name.contains(*quote));
    let is_short = !name.is_empty() && name.chars().count() <= NAME_LENGTH;
    match quote.filter(|_| is_short && !name.contains(char::is_control)) {
        Some(quote) => Ok(format!("{quote}{name}{quote}")),
        None => Err(BmodesWriteError::FileName { name: name.into() }),
    }
}

impl Deck<'_> {
    pub(super) fn text(&self) -> String {
        let mut lines = Lines::default();
        self.general(&mut lines);
        self.tip(&mut lines);
        self.sections(&mut lines);
        self.elements(&mut lines);
        self.support(&mut lines);
        lines.0
    }

    fn general(&self, lines: &mut Lines) {
        lines.comment(
            "======================   BModes v3.00 Main Input File   ======================",
        );
        let title = name_or(self.title, "Tower");
        lines.comment(&title.chars().take(TITLE_LENGTH).collect::<String>());
        lines.comment("");
        lines.comment(
            "--------- General parameters --------------------------------------------------",
        );
        lines.value(
            "False",
            "Echo",
            "whether the input is repeated in a file .echo",
        );
        lines.value("2", "beam_type", "1: blade, 2: tower (-)");
        lines.number(0.0, "rot_rpm", "rotor speed (rpm)");
        lines.number(1.0, "rpm_mult", "factor of the rotor speed (-)");
        lines.number(
            self.ends.radius_m,
            "radius",
            "height of the tower's top above ground or mean sea level (m)",
        );
        lines.number(
            self.ends.hub_rad_m,
            "hub_rad",
            "height of the tower's rigid base (m)",
        );
        lines.number(0.0, "precone", "coning angle of a blade (deg)");
        lines.number(0.0, "bl_thp", "pitch of a blade (deg)");
        let meaning =
            "base: 1 clamped, 2 free or on springs, 3 held against z and rotation about z (-)";
        lines.value(&(self.hub as usize).to_string(), "hub_conn", meaning);
        lines.value(
            &self.modes.to_string(),
            "modepr",
            "number of modes to print (-)",
        );
        lines.value("f", "TabDelim", "whether tabs separate the results");
        lines.value(
            "f",
            "mid_node_tw",
            "whether the twist at the middles of elements is printed",
        );
        lines.comment("");
    }

    fn tip(&self, lines: &mut Lines) {
        lines.comment(
            "--------- Body on the tower's top ---------------------------------------------",
        );
        let [x, _, z] = self.tip.center_m;
        let inertia = &self.tip.inertia_kg_m2;
        lines.number(self.tip.mass_kg, "tip_mass", "mass (kg)");
        lines.number(
            x,
            "cm_loc",
            "offset of its centre of mass along x, downwind (m)",
        );
        lines.number(
            z,
            "cm_axial",
            "height of its centre of mass above the tower's top (m)",
        );
        let what = "inertia about its own centre of mass";
        lines.number(
            inertia.xx,
            "ixx_tip",
            &format!("{what}: about x, resists side-side rotation (kg-m^2)"),
        );
        lines.number(
            inertia.yy,
            "iyy_tip",
            &format!("{what}: about y, resists fore-aft rotation (kg-m^2)"),
        );
        lines.number(
            inertia.zz,
            "izz_tip",
            &format!("{what}: about z, resists torsion (kg-m^2)"),
        );
        lines.number(inertia.xy, "ixy_tip", &format!("{what}: entry xy (kg-m^2)"));
        lines.number(inertia.xz, "izx_tip", &format!("{what}: entry zx (kg-m^2)"));
        lines.number(inertia.yz, "iyz_tip", &format!("{what}: entry yz (kg-m^2)"));
        lines.comment("");
    }

    fn sections(&self, lines: &mut Lines) {
        lines.comment(
            "--------- Sections ------------------------------------------------------------",
        );
        lines.value("1", "id_mat", "1: isotropic (-)");
        lines.value(self.sections_file, "sec_props_file", "file of the sections");
        lines.comment("");
        lines.comment("Factors of the columns of the sections");
        lines.number(1.0, "sec_mass_mult", "of mass_den (-)");
        lines.number(1.0, "flp_iner_mult", "of flp_iner, fore-aft (-)");
        lines.number(1.0, "lag_iner_mult", "of the inertia side-side (-)");
        lines.number(1.0, "flp_stff_mult", "of flp_stff, fore-aft (-)");
        lines.number(
            self.multiplier,
            "edge_stff_mult",
            "of the bending stiffness side-side (-)",
        );
        lines.number(1.0, "tor_stff_mult", "of tor_stff (-)");
        lines.number(1.0, "axial_stff_mult", "of axial_stff (-)");
        lines.number(1.0, "cg_offst_mult", "of cg_offst (-)");
        lines.number(1.0, "sc_offst_mult", "of sc_offst (-)");
        lines.number(1.0, "tc_offst_mult", "of tc_offst (-)");
        lines.comment("");
    }

    fn elements(&self, lines: &mut Lines) {
        lines.comment(
            "--------- Elements ------------------------------------------------------------",
        );
        let count = self.borders.len() - 1;
        lines.value(&count.to_string(), "nselt", "number of elements (-)");
        lines.comment(
            "Borders of the elements as shares of the tower's length from its base, el_loc():",
        );
        let borders: Vec<String> = self.borders.iter().map(|border| number(*border)).collect();
        for line in borders.chunks(VALUES_IN_A_LINE) {
            lines.comment(&line.join("  "));
        }
        lines.comment("");
    }

    fn support(&self, lines: &mut Lines) {
        lines.comment(
            "--------- Support of the tower ------------------------------------------------",
        );
        let meaning = "0: none, 1: wires, 2: platform, monopile or springs (-)";
        let mut kind = |kind: &str| lines.value(kind, "tow_support", meaning);
        match self.support {
            Support::None => kind("0"),
            Support::Wires(wires) => {
                kind("1");
                lines.comment("Wires, one column for each set");
                let column = |value: fn(&towermodes::Wires) -> String| {
                    wires.iter().map(value).collect::<Vec<_>>().join(" ")
                };
                let nodes: Vec<String> = self.wire_nodes.iter().map(usize::to_string).collect();
                lines.value(
                    &wires.len().to_string(),
                    "n_attachments",
                    "number of sets (-)",
                );
                lines.value(
                    &column(|w| w.count.to_string()),
                    "n_wires",
                    "wires in each set (-)",
                );
                lines.value(
                    &nodes.join(" "),
                    "node_attach",
                    "their nodes, from 1 at the base (-)",
                );
                lines.value(
                    &column(|w| number(w.stiffness_n_per_m)),
                    "wire_stfness",
                    "EA/L of each wire (N/m)",
                );
                lines.value(
                    &column(|w| number(w.angle_deg)),
                    "th_wire",
                    "angle from the horizontal (deg)",
                );
            }
            Support::Offshore(platform) => {
                kind("2");
                self::platform(platform, lines);
            }
        }
        lines.comment("");
        lines.comment(
            "END of Main Input File Data ***************************************************",
        );
    }
}

fn platform(platform: &Platform, lines: &mut Lines) {
    lines.number(
        platform.draft_m,
        "draft",
        "depth of the tower's base below the datum (m)",
    );
    let meaning = "depth of the platform's centre of mass below the datum (m)";
    lines.number(platform.cm_pform_m, "cm_pform", meaning);
    lines.number(platform.mass_kg, "mass_pform", "mass of the platform (kg)");
    lines.comment("Inertia of the platform about its centre of mass (i_matrix_pform, kg-m^2):");
    for row in platform.inertia_kg_m2.tensor() {
        lines.comment(&row.map(|entry| format!("{:>22}", number(entry))).join(" "));
    }
    let meaning = "depth below the datum of the point that the matrices are about (m)";
    lines.number(platform.ref_msl_m, "ref_msl", meaning);
    lines.comment("Mass that moves with the base (hydro_M: kg, kg-m, kg-m^2):");
    lines.matrix(&platform.hydro_mass);
    lines.comment("Hydrostatic stiffness (hydro_K: N/m, N, N-m):");
    lines.matrix(&platform.hydro_stiffness);
    lines.comment("Stiffness of moorings, springs or soil at the base (mooring_K: N/m, N, N-m):");
    lines.matrix(&platform.mooring);
    let tables = [
        (
            "Mass that moves with the tower transversely",
            "m",
            &platform.loads.added_mass,
            "kg/m",
        ),
        (
            "Springs along the tower, the same in x and y",
            "k",
            &platform.loads.stiffness,
            "N/m^2",
        ),
    ];
    for (what, letter, rows, unit) in tables {
        lines.comment("");
        lines.comment(what);
        let name = format!("n_secs_{letter}_distr");
        lines.value(&rows.len().to_string(), &name, "number of heights (-)");
        let column = |value: fn(&(f64, f64)) -> f64| {
            rows.iter()
                .map(|row| number(value(row)))
                .collect::<Vec<String>>()
        };
        lines.list(
            &column(|row| row.0),
            &format!("z_distr_{letter}"),
            "heights above the base (m)",
        );
        lines.list(
            &column(|row| row.1),
            &format!("distr_{letter}"),
            &format!("values there ({unit})"),
        );
    }
}
