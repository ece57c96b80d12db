//! Reads a main file of ElastoDyn.

use std::collections::BTreeMap;
use std::ops::Range;

use super::layout::lines_by_key;
use super::lump::hub_inertia_kg_m2;
use super::main_file::{MainFile, Platform};
use super::positional::Parameter;
use crate::diagnostic::Diagnostic;
use crate::records::{Line, Lines};
use crate::source::Source;

const BLADES: [&str; 3] = ["BldFile(1)", "BldFile(2)", "BldFile(3)"];
const PITCH: [&str; 3] = ["BlPitch(1)", "BlPitch(2)", "BlPitch(3)"];
const PRECONE: [&str; 3] = ["PreCone(1)", "PreCone(2)", "PreCone(3)"];
const TIP_MASS: [&str; 3] = ["TipMass(1)", "TipMass(2)", "TipMass(3)"];

/// Reads a main (primary) file of ElastoDyn, from FAST 8 to OpenFAST 5.
///
/// # Errors
/// The first mistake in it.
pub fn read_main_file(source: &Source) -> Result<MainFile, Diagnostic> {
    let values = Values {
        lines: lines_by_key(&source.text)?,
    };
    let mut lines = Lines::new(&source.text);
    let mut header = || {
        lines
            .next()
            .map(|line| line.text.to_owned())
            .unwrap_or_default()
    };
    let header = [header(), header()];
    let blade_count = values.blade_count()?;
    let file = MainFile {
        header,
        gravity_m_per_s2: values.optional("Gravity")?,
        tower_dofs: values.flags(["TwFADOF1", "TwFADOF2", "TwSSDOF1", "TwSSDOF2"])?,
        platform_dofs: values.flags([
            "PtfmSgDOF",
            "PtfmSwDOF",
            "PtfmHvDOF",
            "PtfmRDOF",
            "PtfmPDOF",
            "PtfmYDOF",
        ])?,
        blade_pitch_deg: values.of_blades(PITCH, blade_count, |key| values.pitch(key))?,
        rotor_speed_rpm: values.not_negative("RotSpeed")?,
        blade_count,
        tip_radius_m: values.not_negative("TipRad")?,
        hub_radius_m: values.not_negative("HubRad")?,
        precone_deg: values.of_blades(PRECONE, blade_count, |key| values.angle(key))?,
        hub_center_m: values.number("HubCM")?,
        undersling_m: values.of_two_blades("UndSling", blade_count)?,
        delta3_deg: values.of_two_blades("Delta3", blade_count)?,
        overhang_m: values.number("OverHang")?,
        shaft_tilt_deg: values.angle("ShftTilt")?,
        nacelle_center_m: values.numbers(["NacCMxn", "NacCMyn", "NacCMzn"])?,
        tower_to_shaft_m: values.number("Twr2Shft")?,
        tower_top_m: values.number("TowerHt")?,
        tower_base_m: values.tower_base_m()?,
        tip_masses_kg: values.of_blades(TIP_MASS, blade_count, |key| values.not_negative(key))?,
        hub_mass_kg: values.not_negative("HubMass")?,
        hub_inertia_kg_m2: values.not_negative("HubIner")?,
        hub_teeter_inertia_kg_m2: values.optional("HubIner_Teeter")?,
        generator_inertia_kg_m2: values.not_negative("GenIner")?,
        gearbox_ratio: values.number("GBRatio")?,
        nacelle_mass_kg: values.not_negative("NacMass")?,
        nacelle_yaw_inertia_kg_m2: values.not_negative("NacYIner")?,
        yaw_bearing_mass_kg: values.not_negative("YawBrMass")?,
        platform: values.platform()?,
        blade_nodes: values.blade_nodes()?,
        blade_files: values.blade_files(blade_count)?,
        furling: values.parameter("Furling")?.logical()?,
        tower_nodes: values.parameter("TwrNodes")?.count(1)?,
        tower_file: values.parameter("TwrFile")?.file()?,
        spans: values.spans(),
    };
    check(&file)?;
    Ok(file)
}

/// What OpenFAST checks of several values together (`ValidatePrimaryData`, `Coeff`).
fn check(file: &MainFile) -> Result<(), Diagnostic> {
    let wrong = |key, message: String, hint: &str| {
        Err(Diagnostic::new(file.place(key), message).with_hint(hint))
    };
    let (tip, hub) = (file.tip_radius_m, file.hub_radius_m);
    if tip <= hub {
        let message = format!("TipRad is {tip} m and HubRad {hub} m");
        return wrong(
            "TipRad",
            message,
            "the tip must be further from the apex than the root",
        );
    }
    let (top, base) = (file.tower_top_m, file.tower_base_m);
    if top <= base && !file.tower_hangs() {
        let message = format!("TowerHt is {top} m and TowerBsHt {base} m");
        let hint = "the top must be above the base; only the tower of a floating turbine in a current hangs, with TowerHt below 0";
        return wrong("TowerHt", message, hint);
    }
    if !(file.tower_length_m() * file.blade_length_m()).is_finite() {
        let message = format!("the tower is {} m long", file.tower_length_m());
        return wrong("TowerHt", message, "heights are in m");
    }
    let [x, y, _] = file.nacelle_center_m;
    let least = file.nacelle_mass_kg * (x * x + y * y);
    let inertia = file.nacelle_yaw_inertia_kg_m2;
    if inertia < least {
        let message = format!("NacYIner is {inertia} kg m2");
        let hint = format!(
            "about the yaw axis it is at least NacMass (NacCMxn^2 + NacCMyn^2) = {least} kg m2"
        );
        return wrong("NacYIner", message, &hint);
    }
    let (about_shaft, about_teeter_axis) = hub_inertia_kg_m2(file);
    if about_shaft < 0.0 || about_teeter_axis < 0.0 {
        let key = match file.hub_teeter_inertia_kg_m2 {
            Some(_) => "HubIner_Teeter",
            None => "HubIner",
        };
        let arm_m = file.undersling_m - file.hub_center_m;
        let least = file.hub_mass_kg * arm_m * arm_m;
        let message = format!(
            "{key} is too small for a hub of HubMass {} kg",
            file.hub_mass_kg
        );
        let hint = format!(
            "about the teeter axis it is at least HubMass (UndSling - HubCM)^2 = {least} kg m2"
        );
        return wrong(key, message, &hint);
    }
    Ok(())
}

/// The parameters by name.
struct Values<'a> {
    lines: BTreeMap<&'static str, Line<'a>>,
}

impl<'a> Values<'a> {
    fn parameter(&self, key: &'static str) -> Result<Parameter<'a>, Diagnostic> {
        match self.lines.get(key) {
            Some(line) => Parameter::of(line, key, meaning(key)),
            None => Err(Diagnostic::new(0..0, format!("the file has no {key}"))),
        }
    }

    fn number(&self, key: &'static str) -> Result<f64, Diagnostic> {
        self.parameter(key)?.number()
    }

    fn not_negative(&self, key: &'static str) -> Result<f64, Diagnostic> {
        self.parameter(key)?.not_negative()
    }

    /// An angle of less than a right one, degrees.
    fn angle(&self, key: &'static str) -> Result<f64, Diagnostic> {
        let right = "it must be between -90 and 90 degrees";
        self.parameter(key)?
            .number_if(|angle| angle.abs() < 90.0, right)
    }

    /// An angle of no more than half a turn, degrees.
    fn pitch(&self, key: &'static str) -> Result<f64, Diagnostic> {
        let right = "it must be from -180 to 180 degrees";
        self.parameter(key)?
            .number_if(|angle| angle.abs() <= 180.0, right)
    }

    /// A number that some layouts do not have.
    fn optional(&self, key: &'static str) -> Result<Option<f64>, Diagnostic> {
        let line = self.lines.get(key);
        line.map(|line| Parameter::of(line, key, meaning(key))?.not_negative())
            .transpose()
    }

    fn numbers<const N: usize>(&self, keys: [&'static str; N]) -> Result<[f64; N], Diagnostic> {
        let mut values = [0.0; N];
        for (value, key) in values.iter_mut().zip(keys) {
            *value = self.number(key)?;
        }
        Ok(values)
    }

    fn flags<const N: usize>(&self, keys: [&'static str; N]) -> Result<[bool; N], Diagnostic> {
        let mut values = [false; N];
        for (value, key) in values.iter_mut().zip(keys) {
            *value = self.parameter(key)?.logical()?;
        }
        Ok(values)
    }

    fn blade_count(&self) -> Result<usize, Diagnostic> {
        let parameter = self.parameter("NumBl")?;
        let count = parameter.count(1)?;
        if count <= 3 {
            return Ok(count);
        }
        Err(parameter.wrong(&format!("is {count}"), "ElastoDyn has at most 3 blades"))
    }

    /// A value of each blade; those of blades that are not there are not looked at.
    fn of_blades(
        &self,
        keys: [&'static str; 3],
        count: usize,
        read: impl Fn(&'static str) -> Result<f64, Diagnostic>,
    ) -> Result<[f64; 3], Diagnostic> {
        let mut values = [0.0; 3];
        for (value, key) in values.iter_mut().zip(keys).take(count) {
            *value = read(key)?;
        }
        Ok(values)
    }

    /// A value that only a rotor of two blades has.
    fn of_two_blades(&self, key: &'static str, count: usize) -> Result<f64, Diagnostic> {
        match (key, count) {
            ("Delta3", 2) => self.angle(key),
            (_, 2) => self.number(key),
            _ => Ok(0.0),
        }
    }

    /// Height of the flexible tower's base, m: of the name it has since ElastoDyn 1.01, or of the
    /// two it had before.
    fn tower_base_m(&self) -> Result<f64, Diagnostic> {
        if self.lines.contains_key("TwrRBHt") {
            return Ok(self.number("TwrRBHt")? - self.number("TwrDraft")?);
        }
        self.number("TowerBsHt")
    }

    fn blade_nodes(&self) -> Result<Option<usize>, Diagnostic> {
        match self.lines.contains_key("BldNodes") {
            true => self.parameter("BldNodes")?.count(1).map(Some),
            false => Ok(None),
        }
    }

    fn blade_files(&self, count: usize) -> Result<Vec<String>, Diagnostic> {
        let keys = BLADES.into_iter().take(count);
        keys.map(|key| self.parameter(key)?.file()).collect()
    }

    fn platform(&self) -> Result<Platform, Diagnostic> {
        let or_zero = |key: &'static str| match self.lines.contains_key(key) {
            true => self.number(key),
            false => Ok(0.0),
        };
        let [xy, yz, xz] = ["PtfmXYIner", "PtfmYZIner", "PtfmXZIner"].map(or_zero);
        let [x, y] = ["PtfmRefxt", "PtfmRefyt"].map(or_zero);
        let [roll, pitch, yaw] =
            ["PtfmRIner", "PtfmPIner", "PtfmYIner"].map(|key| self.not_negative(key));
        Ok(Platform {
            mass_kg: self.not_negative("PtfmMass")?,
            inertia_kg_m2: [roll?, pitch?, yaw?],
            products_kg_m2: [xy?, yz?, xz?],
            center_m: self.numbers(["PtfmCMxt", "PtfmCMyt", "PtfmCMzt"])?,
            reference_m: [x?, y?, self.reference_z_m()?],
        })
    }

    /// Height of the platform's reference point, m: downwards in ElastoDyn 1.00.
    fn reference_z_m(&self) -> Result<f64, Diagnostic> {
        if self.lines.contains_key("PtfmRef") {
            return Ok(0.0 - self.number("PtfmRef")?);
        }
        self.number("PtfmRefzt")
    }

    /// Where each value stands.
    fn spans(&self) -> BTreeMap<&'static str, Range<usize>> {
        let spans = self.lines.iter().map(|(key, line)| {
            let value = line.first().map_or(line.span(), |token| token.span);
            (*key, value)
        });
        spans.collect()
    }
}

/// What a parameter is, for messages.
fn meaning(key: &str) -> &'static str {
    match key {
        "Gravity" => "acceleration of gravity, m/s2",
        "NumBl" => "number of blades",
        "BldNodes" => "number of blade elements",
        "TwrNodes" => "number of tower elements",
        "TwrFile" => "name of the tower file",
        "Furling" => "flag",
        "RotSpeed" => "speed of the rotor, rpm",
        "Delta3" | "ShftTilt" => "angle, degrees",
        "GBRatio" => "gearbox ratio",
        _ if key.ends_with("DOF") || key.ends_with("DOF1") || key.ends_with("DOF2") => "flag",
        _ if key.starts_with("PreCone") || key.starts_with("BlPitch") => "angle, degrees",
        _ if key.starts_with("BldFile") => "name of a blade file",
        _ if key.contains("Iner") => "inertia, kg m2",
        _ if key.contains("Mass") => "mass, kg",
        _ => "a length, m",
    }
}
