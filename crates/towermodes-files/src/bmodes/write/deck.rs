//! The text of the main file: the records of the table of parameters with the values of a tower.

use towermodes::{Rna, Wires};

use super::super::records::parameters as p;
use super::base::{Ends, Hub};
use super::error::BmodesWriteError;
use super::lines::{Lines, VALUES_IN_A_LINE};
use super::number::number;
use super::platform::Platform;
use super::sections::name_or;
use super::support::Support;

/// The number of characters that BModes keeps of a title.
const TITLE_LENGTH: usize = 99;
/// The number of characters that BModes keeps of a file's name.
const NAME_LENGTH: usize = 200;

/// The content of the main file.
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

/// The name of a file in quotes that are not part of it.
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
        lines.comment(&format!("{:=^80}", "   BModes v3.00 Main Input File   "));
        let title = name_or(self.title, "Tower");
        lines.comment(&title.chars().take(TITLE_LENGTH).collect::<String>());
        self.general(&mut lines);
        self.tip(&mut lines);
        self.sections(&mut lines);
        self.elements(&mut lines);
        self.support(&mut lines);
        lines.comment("");
        lines.comment(&format!("{:*<80}", "END of Main Input File Data "));
        lines.0
    }

    fn general(&self, lines: &mut Lines) {
        lines.heading("General parameters");
        let values = [
            "False".into(),
            "2".into(),
            number(0.0),
            number(1.0),
            number(self.ends.radius_m),
            number(self.ends.hub_rad_m),
            number(0.0),
            number(0.0),
            (self.hub as usize).to_string(),
            self.modes.to_string(),
            "f".into(),
            "f".into(),
        ];
        lines.block(p::GENERAL, values);
    }

    fn tip(&self, lines: &mut Lines) {
        lines.heading("Body on the tower top");
        let [x, _, z] = self.tip.center_m;
        let j = &self.tip.inertia_kg_m2;
        lines.block(p::TIP, [self.tip.mass_kg, x].map(number));
        lines.value(&p::CM_AXIAL, &number(z));
        let inertia = [j.xx, j.yy, j.zz, j.xy, j.xz, j.yz];
        lines.block(p::TIP_INERTIA, inertia.map(number));
    }

    fn sections(&self, lines: &mut Lines) {
        lines.heading("Sections");
        lines.value(&p::ID_MAT, "1");
        lines.value(&p::SEC_PROPS_FILE, self.sections_file);
        lines.comment("");
        lines.comment("Factors of the columns of the sections");
        let factor = |parameter| match parameter == &p::EDGE_STFF_MULT {
            true => number(self.multiplier),
            false => number(1.0),
        };
        lines.block(p::FACTORS, p::FACTORS.map(factor));
    }

    fn elements(&self, lines: &mut Lines) {
        lines.heading("Elements");
        lines.value(&p::NSELT, &(self.borders.len() - 1).to_string());
        lines.comment(&format!("{}:", p::EL_LOC.what()));
        let borders: Vec<String> = self.borders.iter().map(|border| number(*border)).collect();
        for line in borders.chunks(VALUES_IN_A_LINE) {
            lines.comment(&line.join("  "));
        }
    }

    fn support(&self, lines: &mut Lines) {
        lines.heading("Support of the tower");
        let kind = match self.support {
            Support::None => "0",
            Support::Wires(_) => "1",
            Support::Offshore(_) => "2",
        };
        lines.value(&p::TOW_SUPPORT, kind);
        match self.support {
            Support::None => {}
            Support::Wires(wires) => self.wires(wires, lines),
            Support::Offshore(platform) => self::platform(platform, lines),
        }
    }

    fn wires(&self, wires: &[Wires], lines: &mut Lines) {
        lines.comment("Guy wires, one column for each set");
        lines.value(&p::N_ATTACHMENTS, &wires.len().to_string());
        let column = |value: fn(&Wires) -> String| {
            let values: Vec<String> = wires.iter().map(value).collect();
            values.join(" ")
        };
        let nodes: Vec<String> = self.wire_nodes.iter().map(usize::to_string).collect();
        let columns = [
            column(|w| w.count.to_string()),
            nodes.join(" "),
            column(|w| number(w.stiffness_n_per_m)),
            column(|w| number(w.angle_deg)),
        ];
        lines.block(p::WIRES, columns);
    }
}

fn platform(platform: &Platform, lines: &mut Lines) {
    let values = [platform.draft_m, platform.cm_pform_m, platform.mass_kg];
    lines.block(p::PLATFORM, values.map(number));
    lines.comment(&format!("{}:", p::I_MATRIX_PFORM.what()));
    for row in platform.inertia_kg_m2.tensor() {
        lines.comment(&row.map(|entry| format!("{:>22}", number(entry))).join(" "));
    }
    lines.value(&p::REF_MSL, &number(platform.ref_msl_m));
    let matrices = [
        &platform.hydro_mass,
        &platform.hydro_stiffness,
        &platform.mooring,
    ];
    for (parameter, matrix) in p::MATRICES.into_iter().zip(matrices) {
        lines.comment(&format!("{}:", parameter.what()));
        lines.matrix(matrix);
    }
    let loads = &platform.loads;
    let added_mass = ("Distributed added mass", p::ADDED_MASS, &loads.added_mass);
    let heading = "Distributed springs along the tower";
    let tables = [added_mass, (heading, p::STIFFNESS, &loads.stiffness)];
    for (heading, [count, heights, values], rows) in tables {
        lines.comment("");
        lines.comment(heading);
        lines.value(count, &rows.len().to_string());
        lines.list(heights, rows.iter().map(|row| row.0));
        lines.list(values, rows.iter().map(|row| row.1));
    }
}
