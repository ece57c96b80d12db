//! Turbines of offshore models: towers and rotor-nacelle assemblies as in their models for
//! `OpenFAST`, on the structures below them.

use towermodes::frame::{Frame, FrameDescription, FrameFoundation};
use towermodes::{
    FloatingPlatform, Foundation, Inertia, Planes, Properties, PropertyStation, RigidBody, Rna,
    TowerDescription,
};

use super::floaters::{hywind_platform, oc4_semi_platform, volturnus_platform};
use super::jacket::{jacket, transition_piece};
use super::monopiles::{iea_15_monopile, oc3_monopile};

/// A tower with only bending flexibility, from rows of height (m), kg/m, N m².
fn tower(name: &str, rows: &[[f64; 3]], rna: Rna, gravity_m_per_s2: f64) -> TowerDescription {
    let station = |[height_m, mass_kg_per_m, bending_n_m2]: &[f64; 3]| PropertyStation {
        height_m: *height_m,
        properties: Properties {
            mass_kg_per_m: *mass_kg_per_m,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(*bending_n_m2),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    };
    TowerDescription {
        name: name.into(),
        properties: rows.iter().map(station).collect(),
        rna,
        gravity_m_per_s2,
        ..TowerDescription::default()
    }
}

/// A rotor-nacelle assembly from its mass, centre, moments of inertia xx, yy, zz and product xz.
fn assembly(mass_kg: f64, [x, z]: [f64; 2], [xx, yy, zz, xz]: [f64; 4]) -> Rna {
    Rna {
        mass_kg,
        center_m: [x, 0.0, z],
        inertia_kg_m2: Inertia::from([xx, yy, zz, 0.0, xz, 0.0]),
    }
}

/// The rotor-nacelle assembly of the NREL 5 MW turbine, whose rotor is locked.
fn nrel() -> Rna {
    assembly(
        349_606.489_917_915_7,
        [-0.407_834_697_071_625, 1.966_434_954_307_920_7],
        [
            38_391_424.197_636_15,
            23_355_460.146_962_136,
            25_207_387.610_267_304,
            -1_289_814.271_465_230_5,
        ],
    )
}

/// The foundation of a tower on a frame.
fn on(mut frame: FrameDescription, platform: RigidBody, has_weight: bool) -> Foundation {
    if let Some(transition) = &mut frame.transition {
        transition.is_held = false;
    }
    let frame = Frame::new(frame).expect("a frame of the manual");
    let mut foundation =
        FrameFoundation::new(frame, platform).expect("a transition piece of the manual");
    foundation.weight_on_members = has_weight;
    // The source leaves it out.
    foundation.buoyancy_on_members = false;
    Foundation::Frame(Box::new(foundation))
}

/// The effects that a model on a frame includes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effects {
    /// Water around members and in them, and marine growth.
    pub water: bool,
    /// Gravity on the tower.
    pub gravity: bool,
    /// Gravity also on the members.
    pub weight_on_members: bool,
}

impl Effects {
    fn gravity(self, gravity_m_per_s2: f64) -> f64 {
        if self.gravity { gravity_m_per_s2 } else { 0.0 }
    }
}

/// The OC3 monopile with the NREL 5 MW turbine.
pub fn oc3_monopile_turbine(effects: Effects) -> TowerDescription {
    let platform = RigidBody::massless(Inertia {
        zz: 1.534e6,
        ..Inertia::default()
    });
    let pile = oc3_monopile(effects.water);
    TowerDescription {
        foundation: on(pile, platform, effects.weight_on_members),
        ..tower(
            "OC3 monopile",
            &OC3_MONOPILE,
            nrel(),
            effects.gravity(9.80665),
        )
    }
}

/// The OC4 jacket with the NREL 5 MW turbine.
pub fn oc4_jacket_turbine(effects: Effects) -> TowerDescription {
    let frame = jacket(effects.water, false);
    TowerDescription {
        foundation: on(frame, transition_piece(), effects.weight_on_members),
        ..tower("OC4 jacket", &OC4_JACKET, nrel(), effects.gravity(9.80665))
    }
}

/// The IEA-15 turbine on its monopile, in air.
pub fn iea_15_monopile_turbine() -> TowerDescription {
    let platform = RigidBody::massless(Inertia {
        zz: 1e8,
        ..Inertia::default()
    });
    let rna = assembly(
        947_784.980_906_609,
        [-7.448_430_552_883_845, 4.612_743_846_953_831_6],
        [
            351_615_919.664_080_26,
            192_530_724.167_033_88,
            209_416_369.469_773_65,
            -14_946_662.523_631_297,
        ],
    );
    TowerDescription {
        foundation: on(iea_15_monopile(), platform, false),
        ..tower("IEA-15 monopile", &IEA_15_MONOPILE, rna, 9.81)
    }
}

/// The NREL 5 MW turbine on a floater.
fn nrel_floating(name: &str, platform: FloatingPlatform) -> TowerDescription {
    TowerDescription {
        foundation: Foundation::Floating(Box::new(platform)),
        ..tower(name, &OC3_HYWIND, nrel(), 9.80665)
    }
}

/// OC3-Hywind.
pub fn hywind_turbine() -> TowerDescription {
    nrel_floating("OC3-Hywind", hywind_platform())
}

/// The floater of OC4.
pub fn oc4_semi_turbine() -> TowerDescription {
    nrel_floating("OC4 semi", oc4_semi_platform())
}

/// VolturnUS-S with the IEA-15 turbine.
pub fn volturnus_turbine() -> TowerDescription {
    let rna = assembly(
        947_784.980_906_609,
        [-7.448_553_980_748_772, 4.612_768_581_962_569],
        [
            351_615_974.682_514_7,
            192_532_234.650_381_83,
            209_417_824.934_687_2,
            -14_946_379.414_481_524,
        ],
    );
    TowerDescription {
        foundation: Foundation::Floating(Box::new(volturnus_platform())),
        ..tower("VolturnUS-S", &VOLTURNUS, rna, 9.81)
    }
}

/// The tower of the OC3 monopile: height (m), kg/m, N m².
const OC3_MONOPILE: [[f64; 3]; 11] = [
    [10.0, 4306.51, 4.7449e11],
    [17.76, 4030.44, 4.1308e11],
    [25.52, 3763.45, 3.5783e11],
    [33.28, 3505.52, 3.083e11],
    [41.04, 3256.66, 2.6408e11],
    [48.8, 3016.86, 2.248e11],
    [56.56, 2786.13, 1.9006e11],
    [64.32, 2564.46, 1.5949e11],
    [72.08, 2351.87, 1.3277e11],
    [79.84, 2148.34, 1.0954e11],
    [87.6, 1953.87, 8.949e10],
];

/// The tower of OC3-Hywind and of the floater of OC4.
const OC3_HYWIND: [[f64; 3]; 11] = [
    [10.0, 4667.0, 6.03903e11],
    [17.76, 4345.28, 5.17644e11],
    [25.52, 4034.76, 4.40925e11],
    [33.28, 3735.44, 3.73022e11],
    [41.04, 3447.32, 3.13236e11],
    [48.8, 3170.4, 2.60897e11],
    [56.56, 2904.69, 2.15365e11],
    [64.32, 2650.18, 1.76028e11],
    [72.08, 2406.88, 1.42301e11],
    [79.84, 2174.77, 1.1363e11],
    [87.6, 1953.87, 8.9488e10],
];

/// The tower of the OC4 jacket.
const OC4_JACKET: [[f64; 3]; 22] = [
    [20.15, 4900.472786, 4.5556e11],
    [21.85, 4900.472786, 4.4419e11],
    [25.25, 4200.272421, 4.1707e11],
    [28.65, 4057.180384, 3.912e11],
    [32.05, 3915.575049, 3.6655e11],
    [35.45, 3770.476234, 3.4234e11],
    [38.85, 3626.859482, 3.1932e11],
    [42.25, 3477.860118, 2.9733e11],
    [45.65, 3291.027294, 2.7214e11],
    [49.05, 3102.11339, 2.4846e11],
    [52.45, 3123.48485, 2.2622e11],
    [55.85, 2969.643543, 2.0732e11],
    [59.25, 2639.437112, 1.9143e11],
    [62.65, 2517.768961, 1.7644e11],
    [66.05, 2398.659195, 1.6232e11],
    [69.45, 2282.133754, 1.4902e11],
    [72.85, 2173.8144, 1.3653e11],
    [76.25, 2344.181633, 1.4213e11],
    [79.65, 2687.066514, 1.5659e11],
    [83.05, 2971.054769, 1.687e11],
    [86.45, 3260.985159, 1.5955e11],
    [88.15, 3260.985159, 1.5481e11],
];

/// The tower of the IEA-15 turbine on its monopile.
const IEA_15_MONOPILE: [[f64; 3]; 20] = [
    [15.0, 10314.8444117336, 3065446681730.71],
    [28.0, 10314.8444117336, 3065446681730.71],
    [28.001, 9523.8185311774, 2832084716093.43],
    [41.0, 9453.08440571895, 2769450452002.75],
    [41.001, 8761.30605926184, 2568166429175.23],
    [54.0, 8333.52438853064, 2210055981076.24],
    [54.001, 7943.33950595919, 2107286870484.59],
    [67.0, 7428.45947667418, 1723500010954.97],
    [67.001, 7087.21416026668, 1644879215976.75],
    [80.0, 6538.09808262447, 1291405296742.77],
    [80.001, 6197.17486154813, 1224548874057.19],
    [93.0, 5616.51631486614, 911584975111.229],
    [93.001, 5253.47792343715, 853098044023.887],
    [106.0, 4910.27596999568, 696589258960.876],
    [106.001, 4334.16760320598, 615430994795.997],
    [119.0, 4232.81656525749, 573258971811.306],
    [119.001, 3673.38778983878, 497963935464.221],
    [132.0, 3577.28261238808, 459893782098.693],
    [132.001, 4120.14125317298, 529172386815.796],
    [144.386, 4074.83733142272, 511907882162.85],
];

/// The tower of VolturnUS-S.
const VOLTURNUS: [[f64; 3]; 10] = [
    [15.0, 23006.4213107425, 6770513741893.661],
    [29.414043687, 20389.26791017103, 6012509438660.999],
    [43.828087375, 17746.01273898164, 5243768263364.071],
    [58.242131062, 15062.80308193614, 4460141520157.67],
    [72.656174749, 12342.4077780147, 3662296012994.249],
    [87.070218436, 9633.099266285813, 2864340844739.592],
    [101.484262124, 7026.968999232271, 2093608918221.6],
    [115.898305811, 4645.483574127345, 1386599057692.824],
    [130.312349498, 2596.09348345098, 776106082282.2759],
    [144.386, 1715.031343116859, 348984425373.3395],
];
