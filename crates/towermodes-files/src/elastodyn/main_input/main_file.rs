//! The content of a main file of ElastoDyn that a tower needs.

use std::collections::BTreeMap;
use std::ops::Range;

use super::super::tower_input::description::hangs;

/// The content of a main (primary) file of ElastoDyn.
///
/// x is downwind, y lateral, z up; heights are above ground or mean sea level.
#[derive(Debug, Clone, PartialEq)]
pub struct MainFile {
    /// Its two free header lines.
    pub header: [String; 2],
    /// Acceleration of gravity, m/s² (`Gravity`); since OpenFAST 3.0 it is in the `.fst` file.
    pub gravity_m_per_s2: Option<f64>,
    /// Whether the degrees of freedom of the blades are enabled: first and second flapwise
    /// (`FlapDOF1`, `2`), first edgewise (`EdgeDOF`).
    pub blade_dofs: [bool; 3],
    /// Whether the blades rotate in their pitch bearings (`PitchDOF`, since OpenFAST 5.0).
    pub pitch_dof: bool,
    /// The degrees of freedom between tower and blades.
    pub machine_dofs: MachineDofs,
    /// Whether the degrees of freedom of the tower are enabled: first and second fore-aft
    /// (`TwFADOF1`, `2`), first and second side-side (`TwSSDOF1`, `2`).
    pub tower_dofs: [bool; 4],
    /// Whether the degrees of freedom of the platform are enabled: surge, sway, heave, roll, pitch,
    /// yaw (`PtfmSgDOF` to `PtfmYDOF`).
    pub platform_dofs: [bool; 6],
    /// Pitch of each blade at the start, positive towards feather, degrees (`BlPitch`); unused ones
    /// are zero.
    pub blade_pitch_deg: [f64; 3],
    /// Speed of the rotor at the start, rpm (`RotSpeed`).
    pub rotor_speed_rpm: f64,
    /// Number of blades (`NumBl`).
    pub blade_count: usize,
    /// Distance from the rotor's apex to the blades' tips, m (`TipRad`).
    pub tip_radius_m: f64,
    /// Distance from the rotor's apex to the blades' roots, m (`HubRad`).
    pub hub_radius_m: f64,
    /// Angle of each blade from the plane normal to the shaft, positive downwind, degrees
    /// (`PreCone`); unused ones are zero.
    pub precone_deg: [f64; 3],
    /// Distance from the rotor's apex to the hub's centre of mass, positive downwind, m (`HubCM`).
    pub hub_center_m: f64,
    /// Distance from the teeter pin to the rotor's apex for two blades, m (`UndSling`).
    pub undersling_m: f64,
    /// Angle of the teeter pin for two blades, degrees (`Delta3`).
    pub delta3_deg: f64,
    /// Distance along the shaft from the yaw axis to the rotor's apex, or for two blades to the
    /// teeter pin, positive downwind, m (`OverHang`).
    pub overhang_m: f64,
    /// Angle of the shaft from the horizontal, degrees; negative if the upwind end is the higher
    /// one (`ShftTilt`).
    pub shaft_tilt_deg: f64,
    /// Centre of mass of the nacelle from the tower top, m (`NacCMxn`, `NacCMyn`, `NacCMzn`).
    pub nacelle_center_m: [f64; 3],
    /// Height of the shaft above the tower top at the yaw axis, m (`Twr2Shft`).
    pub tower_to_shaft_m: f64,
    /// Height of the tower top, m (`TowerHt`).
    pub tower_top_m: f64,
    /// Height of the base of the flexible tower, m (`TowerBsHt`; in ElastoDyn 1.00 `TwrRBHt` −
    /// `TwrDraft`).
    pub tower_base_m: f64,
    /// Mass at the tip of each blade, kg (`TipMass`); unused ones are zero.
    pub tip_masses_kg: [f64; 3],
    /// Mass of the hub, kg (`HubMass`).
    pub hub_mass_kg: f64,
    /// Inertia of the hub, kg m² (`HubIner`): about the shaft, but for two blades in files before
    /// OpenFAST 4.2 about the teeter axis.
    pub hub_inertia_kg_m2: f64,
    /// Inertia of the hub about the teeter axis, kg m² (`HubIner_Teeter`, since OpenFAST 4.2).
    pub hub_teeter_inertia_kg_m2: Option<f64>,
    /// Inertia of the generator about the high-speed shaft, kg m² (`GenIner`).
    pub generator_inertia_kg_m2: f64,
    /// Gearbox ratio (`GBRatio`).
    pub gearbox_ratio: f64,
    /// Torsional stiffness of the drivetrain referred to the low-speed shaft, N m/rad (`DTTorSpr`).
    pub shaft_n_m_per_rad: f64,
    /// Mass of the nacelle, kg (`NacMass`).
    pub nacelle_mass_kg: f64,
    /// Inertia of the nacelle about the yaw axis, kg m² (`NacYIner`).
    pub nacelle_yaw_inertia_kg_m2: f64,
    /// Mass of the yaw bearing, at the tower top, kg (`YawBrMass`).
    pub yaw_bearing_mass_kg: f64,
    /// The platform.
    pub platform: Platform,
    /// The number of elements of a blade in ElastoDyn (`BldNodes`); not in the files of ElastoDyn
    /// 1.00 and 1.01.
    pub blade_nodes: Option<usize>,
    /// The file of each blade as written, relative to the main file (`BldFile`); as many as there
    /// are blades.
    pub blade_files: Vec<String>,
    /// Whether another file contains a furling model (`Furling`).
    pub furling: bool,
    /// The number of elements of the tower in ElastoDyn (`TwrNodes`).
    pub tower_nodes: usize,
    /// The tower file as written, relative to the main file (`TwrFile`).
    pub tower_file: String,
    /// The place of each value.
    pub(crate) spans: BTreeMap<&'static str, Range<usize>>,
}

/// The degrees of freedom between tower and blades that are enabled in a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MachineDofs {
    /// Teeter of a rotor of two blades (`TeetDOF`).
    pub teeter: bool,
    /// Torsion of the shaft (`DrTrDOF`).
    pub shaft: bool,
    /// Rotation of the generator; if disabled, the generator rotates at constant speed (`GenDOF`).
    pub generator: bool,
    /// Yaw of the nacelle (`YawDOF`).
    pub yaw: bool,
}

/// The rigid platform under a tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Platform {
    /// Mass, kg (`PtfmMass`).
    pub mass_kg: f64,
    /// Inertia about its centre of mass for roll, pitch and yaw, kg m² (`PtfmRIner`, `PtfmPIner`,
    /// `PtfmYIner`).
    pub inertia_kg_m2: [f64; 3],
    /// Entries xy, yz, xz of its inertia tensor, kg m² (`PtfmXYIner`, `PtfmYZIner`, `PtfmXZIner`);
    /// zero if the file does not contain them.
    pub products_kg_m2: [f64; 3],
    /// Its centre of mass, m (`PtfmCMxt`, `PtfmCMyt`, `PtfmCMzt`).
    pub center_m: [f64; 3],
    /// The reference point of its motion, m (`PtfmRefxt`, `PtfmRefyt`, `PtfmRefzt`; in ElastoDyn
    /// 1.00 z is −`PtfmRef`); x and y are zero if the file does not contain them.
    pub reference_m: [f64; 3],
}

impl MainFile {
    /// The byte range of a parameter's value in the file, by a name such as `TowerHt` or
    /// `BldFile(1)`.
    pub fn span(&self, key: &str) -> Option<Range<usize>> {
        self.spans.get(key).cloned()
    }

    /// The byte range of the value of a parameter that every layout has.
    pub(crate) fn place(&self, key: &str) -> Range<usize> {
        self.span(key).unwrap_or(0..0)
    }

    /// Length of a blade, m: `TipRad` − `HubRad`.
    pub fn blade_length_m(&self) -> f64 {
        self.tip_radius_m - self.hub_radius_m
    }

    /// Length of the flexible tower, m: |`TowerHt` − `TowerBsHt`|.
    pub fn tower_length_m(&self) -> f64 {
        (self.tower_top_m - self.tower_base_m).abs()
    }

    /// Whether the tower hangs, as in floating turbines in a current: its top is below its base and
    /// below sea level.
    pub fn tower_hangs(&self) -> bool {
        hangs(self.tower_base_m, self.tower_top_m)
    }
}
