//! Reads a main file of ElastoDyn.

use std::collections::BTreeMap;
use std::ops::Range;

use super::super::machine::lump::hub_inertia_kg_m2;
use super::super::positional::Parameter;
use super::layout::{Placed, parameters};
use super::main_file::{MachineDofs, MainFile, Platform};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::Lines;
use crate::source::Source;

pub(crate) const BLADE_DOFS: [&str; 3] = ["FlapDOF1", "FlapDOF2", "EdgeDOF"];
const TOWER_DOFS: [&str; 4] = ["TwFADOF1", "TwFADOF2", "TwSSDOF1", "TwSSDOF2"];
const PLATFORM_DOFS: [&str; 6] = [
    "PtfmSgDOF",
    "PtfmSwDOF",
    "PtfmHvDOF",
    "PtfmRDOF",
    "PtfmPDOF",
    "PtfmYDOF",
];
pub(crate) const BLADES: [&str; 3] = ["BldFile(1)", "BldFile(2)", "BldFile(3)"];
pub(crate) const PITCH: [&str; 3] = ["BlPitch(1)", "BlPitch(2)", "BlPitch(3)"];
pub(crate) const PRECONE: [&str; 3] = ["PreCone(1)", "PreCone(2)", "PreCone(3)"];
pub(crate) const TIP_MASS: [&str; 3] = ["TipMass(1)", "TipMass(2)", "TipMass(3)"];

/// Reads a main (primary) file of ElastoDyn, from FAST 8 to OpenFAST 5.
///
/// # Errors
/// The first mistake in it.
pub fn read_main_file(source: &Source) -> Result<MainFile, Diagnostic> {
    let lines = parameters(&source.text)?;
    let values = Values { lines };
    let blade_count = values.blade_count()?;
    let file = MainFile {
        header: header(&source.text),
        gravity_m_per_s2: values.optional("Gravity")?,
        blade_dofs: values.flags(BLADE_DOFS)?,
        pitch_dof: values.pitch_dof()?,
        machine_dofs: values.machine_dofs()?,
        tower_dofs: values.flags(TOWER_DOFS)?,
        platform_dofs: values.flags(PLATFORM_DOFS)?,
        blade_pitch_deg: values.of_blades(PITCH, blade_count)?,
        rotor_speed_rpm: values.number("RotSpeed")?,
        blade_count,
        tip_radius_m: values.number("TipRad")?,
        hub_radius_m: values.number("HubRad")?,
        precone_deg: values.of_blades(PRECONE, blade_count)?,
        hub_center_m: values.number("HubCM")?,
        undersling_m: values.of_two_blades("UndSling", blade_count)?,
        delta3_deg: values.of_two_blades("Delta3", blade_count)?,
        overhang_m: values.number("OverHang")?,
        shaft_tilt_deg: values.number("ShftTilt")?,
        nacelle_center_m: values.numbers(["NacCMxn", "NacCMyn", "NacCMzn"])?,
        tower_to_shaft_m: values.number("Twr2Shft")?,
        tower_top_m: values.number("TowerHt")?,
        tower_base_m: values.tower_base_m()?,
        tip_masses_kg: values.of_blades(TIP_MASS, blade_count)?,
        hub_mass_kg: values.number("HubMass")?,
        hub_inertia_kg_m2: values.number("HubIner")?,
        hub_teeter_inertia_kg_m2: values.optional("HubIner_Teeter")?,
        generator_inertia_kg_m2: values.number("GenIner")?,
        gearbox_ratio: values.number("GBRatio")?,
        shaft_n_m_per_rad: values.number("DTTorSpr")?,
        nacelle_mass_kg: values.number("NacMass")?,
        nacelle_yaw_inertia_kg_m2: values.number("NacYIner")?,
        yaw_bearing_mass_kg: values.number("YawBrMass")?,
        platform: values.platform()?,
        blade_nodes: values.blade_nodes()?,
        blade_files: values.blade_files(blade_count)?,
        furling: values.parameter("Furling")?.logical()?,
        tower_nodes: values.parameter("TwrNodes")?.count()?,
        tower_file: values.parameter("TwrFile")?.file()?,
        spans: values.spans(),
    };
    check(&file)?;
    Ok(file)
}

/// The two free lines at the beginning.
fn header(text: &str) -> [String; 2] {
    let mut lines = Lines::new(text);
    [(); 2].map(|()| {
        lines
            .next()
            .map_or_else(String::new, |line| line.text.to_owned())
    })
}

/// The checks of OpenFAST on several values together (`ValidatePrimaryData`, `Coeff`).
fn check(file: &MainFile) -> Result<(), Diagnostic> {
    let range = |name, value, unit, rule: String| {
        let kind = DiagnosticKind::out_of_range_in(name, value, unit, rule);
        Diagnostic::new(file.place(name), kind)
    };
    let (tip, hub) = (file.tip_radius_m, file.hub_radius_m);
    if tip <= hub {
        let rule = format!("greater than HubRad, {hub} m");
        return Err(range("TipRad", tip, "m", rule));
    }
    let (top, base) = (file.tower_top_m, file.tower_base_m);
    if top <= base && !file.tower_hangs() {
        let rule = format!("above TowerBsHt, {base} m");
        let hint = "only the tower of a floating turbine in a current hangs, with TowerHt below 0";
        return Err(range("TowerHt", top, "m", rule).with_hint(hint));
    }
    if !(file.tower_length_m() * file.blade_length_m()).is_finite() {
        let what = format!("the tower length, {} m,", file.tower_length_m());
        let kind = DiagnosticKind::Overflow { what };
        return Err(Diagnostic::new(file.place("TowerHt"), kind).with_hint("heights are in m"));
    }
    check_nacelle(file)?;
    check_hub(file)
}

/// Checks that the inertia of the nacelle about the yaw axis is at least that of its mass at its
/// offset.
fn check_nacelle(file: &MainFile) -> Result<(), Diagnostic> {
    let [x, y, _] = file.nacelle_center_m;
    let least = file.nacelle_mass_kg * (x * x + y * y);
    let (name, inertia) = ("NacYIner", file.nacelle_yaw_inertia_kg_m2);
    if inertia < least {
        let rule = format!("at least NacMass (NacCMxn^2 + NacCMyn^2) = {least} kg m2");
        let kind = DiagnosticKind::out_of_range_in(name, inertia, "kg m2", rule);
        return Err(Diagnostic::new(file.place(name), kind));
    }
    Ok(())
}

/// Checks that the inertia of the hub about the teeter axis is at least that of its mass at its
/// offset.
fn check_hub(file: &MainFile) -> Result<(), Diagnostic> {
    let (about_shaft, about_teeter_axis) = hub_inertia_kg_m2(file);
    if about_shaft >= 0.0 && about_teeter_axis >= 0.0 {
        return Ok(());
    }
    let (name, value) = match file.hub_teeter_inertia_kg_m2 {
        Some(inertia) => ("HubIner_Teeter", inertia),
        None => ("HubIner", file.hub_inertia_kg_m2),
    };
    let arm_m = file.undersling_m - file.hub_center_m;
    let least = file.hub_mass_kg * arm_m * arm_m;
    let rule =
        format!("at least HubMass (UndSling - HubCM)^2 = {least} kg m2 about the teeter axis");
    let kind = DiagnosticKind::out_of_range_in(name, value, "kg m2", rule);
    Err(Diagnostic::new(file.place(name), kind))
}

/// The parameters by name.
struct Values<'a> {
    lines: BTreeMap<&'static str, Placed<'a>>,
}

impl<'a> Values<'a> {
    fn parameter(&self, name: &'static str) -> Result<Parameter<'a>, Diagnostic> {
        let missing = || Diagnostic::new(0..0, DiagnosticKind::missing_key("the file", name));
        let (record, line) = self.lines.get(name).ok_or_else(missing)?;
        Parameter::of(line, record)
    }

    fn number(&self, name: &'static str) -> Result<f64, Diagnostic> {
        self.parameter(name)?.number()
    }

    /// A number that some layouts do not have.
    fn optional(&self, name: &'static str) -> Result<Option<f64>, Diagnostic> {
        let is_there = self.lines.contains_key(name);
        is_there.then(|| self.number(name)).transpose()
    }

    fn numbers<const N: usize>(&self, names: [&'static str; N]) -> Result<[f64; N], Diagnostic> {
        each(names, |name| self.number(name))
    }

    fn flags<const N: usize>(&self, names: [&'static str; N]) -> Result<[bool; N], Diagnostic> {
        each(names, |name| self.parameter(name)?.logical())
    }

    fn pitch_dof(&self) -> Result<bool, Diagnostic> {
        match self.lines.contains_key("PitchDOF") {
            true => self.parameter("PitchDOF")?.logical(),
            false => Ok(false),
        }
    }

    fn machine_dofs(&self) -> Result<MachineDofs, Diagnostic> {
        let names = ["TeetDOF", "DrTrDOF", "GenDOF", "YawDOF"];
        let [teeter, shaft, generator, yaw] = self.flags(names)?;
        Ok(MachineDofs {
            teeter,
            shaft,
            generator,
            yaw,
        })
    }

    fn blade_count(&self) -> Result<usize, Diagnostic> {
        let parameter = self.parameter("NumBl")?;
        let count = parameter.count()?;
        if count <= 3 {
            return Ok(count);
        }
        Err(parameter.out_of_range(count as f64, "at most 3 in ElastoDyn"))
    }

    /// A number for each blade; those of blades that do not exist are not read.
    fn of_blades(&self, names: [&'static str; 3], count: usize) -> Result<[f64; 3], Diagnostic> {
        let mut values = [0.0; 3];
        for (value, name) in values.iter_mut().zip(names).take(count) {
            *value = self.number(name)?;
        }
        Ok(values)
    }

    /// A number that applies only to a rotor of two blades.
    fn of_two_blades(&self, name: &'static str, count: usize) -> Result<f64, Diagnostic> {
        match count {
            2 => self.number(name),
            _ => Ok(0.0),
        }
    }

    /// Height of the flexible tower's base, m: `TowerBsHt` since ElastoDyn 1.01, two other
    /// parameters before.
    fn tower_base_m(&self) -> Result<f64, Diagnostic> {
        if self.lines.contains_key("TwrRBHt") {
            return Ok(self.number("TwrRBHt")? - self.number("TwrDraft")?);
        }
        self.number("TowerBsHt")
    }

    fn blade_nodes(&self) -> Result<Option<usize>, Diagnostic> {
        match self.lines.contains_key("BldNodes") {
            true => self.parameter("BldNodes")?.count().map(Some),
            false => Ok(None),
        }
    }

    fn blade_files(&self, count: usize) -> Result<Vec<String>, Diagnostic> {
        let names = BLADES.into_iter().take(count);
        names.map(|name| self.parameter(name)?.file()).collect()
    }

    fn platform(&self) -> Result<Platform, Diagnostic> {
        let or_zero = |name: &'static str| Ok(self.optional(name)?.unwrap_or(0.0));
        let products_kg_m2 = each(["PtfmXYIner", "PtfmYZIner", "PtfmXZIner"], or_zero)?;
        let [x, y] = each(["PtfmRefxt", "PtfmRefyt"], or_zero)?;
        Ok(Platform {
            mass_kg: self.number("PtfmMass")?,
            inertia_kg_m2: self.numbers(["PtfmRIner", "PtfmPIner", "PtfmYIner"])?,
            products_kg_m2,
            center_m: self.numbers(["PtfmCMxt", "PtfmCMyt", "PtfmCMzt"])?,
            reference_m: [x, y, self.reference_z_m()?],
        })
    }

    /// Height of the platform's reference point, m; in ElastoDyn 1.00 it is positive downwards.
    fn reference_z_m(&self) -> Result<f64, Diagnostic> {
        if self.lines.contains_key("PtfmRef") {
            return Ok(0.0 - self.number("PtfmRef")?);
        }
        self.number("PtfmRefzt")
    }

    /// The place of each value.
    fn spans(&self) -> BTreeMap<&'static str, Range<usize>> {
        let spans = self.lines.iter().map(|(name, (_, line))| {
            let value = line.first().map_or(line.span(), |token| token.span);
            (*name, value)
        });
        spans.collect()
    }
}

/// The values of several names.
fn each<T, const N: usize>(
    names: [&'static str; N],
    read: impl Fn(&'static str) -> Result<T, Diagnostic>,
) -> Result<[T; N], Diagnostic> {
    let values: Result<Vec<T>, Diagnostic> = names.into_iter().map(read).collect();
    let missing = || Diagnostic::new(0..0, DiagnosticKind::missing_key("the file", names[0]));
    values?.try_into().map_err(|_| missing())
}
