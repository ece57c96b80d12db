//! Quantities of towers with a known usual range.

/// A quantity of a tower, given or computed from given values, with a known usual range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// A value of the tower file.
    Value {
        /// Its name in a sentence.
        name: &'static str,
        /// Its unit after a space; empty for none.
        unit: &'static str,
        /// Typical values, and the most likely reason of a value outside the range.
        likely_slip: &'static str,
    },
    /// Density of a material, kg/m³.
    Density,
    /// Young's modulus of a material, Pa.
    YoungsModulus,
    /// Poisson's ratio of a material.
    PoissonsRatio,
    /// Speed of sound √(E/ρ) of a material, m/s.
    MaterialWaveSpeed,
    /// The factor on the tower's mass.
    OutfittingFactor,
    /// Speed of sound √(EA/m) of a row of properties, m/s.
    AxialWaveSpeed,
    /// Speed of torsional waves √(GJ/polar inertia) of a row of properties, m/s.
    TorsionWaveSpeed,
    /// Speed of shear waves √(κGA/m) of a row of properties, m/s.
    ShearWaveSpeed,
    /// Radius of gyration √(EI/EA) of a row of properties, m.
    RadiusOfSection,
    /// The same where EA is not given: √(EI/m) over the speed of sound in steel, m.
    RadiusOfSectionByMass,
    /// EI side-side over EI fore-aft.
    PlaneRatio,
    /// Both rotary inertias over the polar inertia.
    PerpendicularAxes,
    /// Mass of the rotor-nacelle assembly over that of the tower.
    RnaShare,
    /// Mass of a point mass on a tower, kg.
    PointMass,
    /// Distance of a body's centre from where it is fixed to the tower, m.
    CentreDistance,
    /// Radius of gyration √(I/m) of a body, m.
    RadiusOfBody,
    /// Shear modulus of the soil under a footing, Pa.
    SoilShearModulus,
    /// Embedment of a footing over its radius.
    Embedment,
    /// Radius of a footing over that of the tower.
    FootingRadius,
    /// Half of the shorter side of a footing over the radius of the tower.
    FootingSide,
    /// Young's modulus of the soil at the depth of one diameter, Pa.
    SoilYoungsModulus,
    /// Diameter of a pile or caisson over that of the tower's base.
    PileDiameter,
    /// Diameter of a pile over its wall thickness.
    PileWall,
    /// Embedded length of a pile over its diameter.
    PileSlenderness,
    /// Rocking spring over EI/H of the tower.
    RockingStiffness,
    /// Lateral spring over EI/H³ of the tower.
    LateralStiffness,
    /// Torsion spring over GJ/H of the tower.
    TorsionStiffness,
    /// Frequency of the tower's mass on the lateral spring, Hz.
    LateralFrequency,
    /// Frequency of the tower's mass on the vertical spring, Hz.
    VerticalFrequency,
    /// √(rocking spring over lateral spring), m.
    SpringLever,
    /// Mass of a floating platform over the mass of tower and RNA.
    PlatformShare,
    /// Distance of a height of a floating platform from the tower's base, m.
    PlatformDepth,
    /// Heave frequency of a floating platform from water plane and moorings, Hz.
    HeaveFrequency,
    /// Surge or sway frequency of a floating platform from its moorings, Hz.
    SurgeFrequency,
    /// Length of tower in soil over the length (4EI/k)^¼ over which a beam bends in it.
    WinklerLengths,
    /// Soil spring in y over that in x.
    SoilPlaneRatio,
    /// Soil spring, N/m².
    SoilSpring,
    /// Effective unit weight of soil under water, N/m³.
    BuoyantUnitWeight,
    /// Unit weight of soil above water, N/m³.
    SoilUnitWeight,
    /// Diameter of a steel wire with the stiffness given, m.
    WireDiameter,
    /// Angle of wires from the horizontal, degrees.
    WireAngle,
    /// Acceleration of gravity, m/s².
    Gravity,
    /// Highest speed of the rotor, rpm.
    RotorSpeed,
}

impl Quantity {
    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        self.words().0
    }

    /// Its unit after a space; nothing if it has none.
    pub fn unit(self) -> &'static str {
        self.words().1
    }

    /// Typical values, and the most likely reason of a value outside the range.
    pub fn likely_slip(self) -> &'static str {
        self.words().2
    }

    /// Name, unit, typical values and likely mistake.
    #[rustfmt::skip]
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Value { name, unit, likely_slip } => (name, unit, likely_slip),
            Self::Density => ("the density", " kg/m3",
                "steel has 7850, concrete 2400; the unit is kg/m3"),
            Self::YoungsModulus => ("Young's modulus", " Pa",
                "steel has 2.1e11, concrete 3e10; the unit is Pa"),
            Self::PoissonsRatio => ("Poisson's ratio", "",
                "steel has 0.3, concrete 0.2; it follows from both moduli where the shear modulus is given"),
            Self::MaterialWaveSpeed => ("the wave speed sqrt(E/density)", " m/s",
                "steel has 5200, concrete 3800; modulus and density do not belong to the same material, or one has a wrong digit"),
            Self::OutfittingFactor => ("the outfitting factor", "",
                "it is a factor on the mass; 7 % more is 1.07"),
            Self::AxialWaveSpeed => ("the wave speed sqrt(EA/mass)", " m/s",
                "steel has about 5000, concrete 3800; check units and exponents of EA and mass"),
            Self::TorsionWaveSpeed => ("the torsional wave speed sqrt(GJ/polar inertia)", " m/s",
                "steel has about 3200, concrete 2400; check units and exponents of GJ and polar inertia"),
            Self::ShearWaveSpeed => ("the shear wave speed sqrt(kappa GA/mass)", " m/s",
                "a steel tube has about 2200; check unit (N) and exponent of the shear stiffness"),
            Self::RadiusOfSection => ("the radius of gyration sqrt(EI/EA)", " m",
                "a tube has about one third of its diameter; check units and exponents of EI and EA"),
            Self::RadiusOfSectionByMass => ("the radius of gyration sqrt(EI/mass)/(5000 m/s)", " m",
                "a steel tube has about one third of its diameter; check units and exponents of EI and mass"),
            Self::PlaneRatio => ("EI side-side, divided by EI fore-aft,", "",
                "towers are about equally stiff in both planes; check the exponents"),
            Self::PerpendicularAxes => ("the sum of both rotary inertias, divided by the polar inertia,", "",
                "it is 1 for every plane section"),
            Self::RnaShare => ("the mass of the rotor-nacelle assembly, divided by the mass of the tower,", "",
                "rotor-nacelle assemblies weigh many tonnes; the unit is kg"),
            Self::PointMass => ("the mass", " kg",
                "flanges and platforms have 1000 to 20000; the unit is kg, not t"),
            Self::CentreDistance => ("the distance of the centre of mass from the tower top along one axis", " m",
                "it is measured from the tower top, not from the ground; the unit is m"),
            Self::RadiusOfBody => ("the radius of gyration sqrt(inertia/mass)", " m",
                "check unit and exponent of the inertia (kg m2) and of the mass (kg)"),
            Self::SoilShearModulus => ("the shear modulus of the soil", " Pa",
                "soft clay has about 5e6, dense sand 1e8, rock 1e10; the unit is Pa"),
            Self::Embedment => ("the embedment of the footing, divided by its radius,", "",
                "the formulas apply only to shallow footings"),
            Self::FootingRadius => ("the radius of the footing, divided by the radius of the tower,", "",
                "a footing is wider than the tower; the unit is m"),
            Self::FootingSide => ("half of the shorter side of the footing, divided by the radius of the tower,", "",
                "a footing is wider than the tower; the unit is m"),
            Self::SoilYoungsModulus => ("Young's modulus of the soil", " Pa",
                "soft clay has about 5e6, dense sand 1e8 to 3e8 at small strains; the unit is Pa, not kPa"),
            Self::PileDiameter => ("the diameter of the foundation, divided by the diameter of the tower base,", "",
                "a pile is about as wide as the tower, a caisson wider; the unit is m"),
            Self::PileWall => ("the diameter of the pile, divided by its wall thickness,", "",
                "monopiles have 60 to 160; the unit of both is m"),
            Self::PileSlenderness => ("the embedded length of the pile, divided by its diameter,", "",
                "monopiles have 3 to 8; the unit of both is m"),
            Self::RockingStiffness => ("the rocking stiffness, divided by EI/H of the tower,", "",
                "typical: 1 to 100; check the unit (N m, not kN m) and that lateral and rocking are not exchanged"),
            Self::LateralStiffness => ("the lateral stiffness, divided by EI/H^3 of the tower,", "",
                "typical: 100 to 1e5; the unit is N/m, not kN/m"),
            Self::TorsionStiffness => ("the torsion stiffness, divided by GJ/H of the tower,", "",
                "typical: 1 to 100; the unit is N m, not kN m"),
            Self::LateralFrequency => ("the frequency of the tower's mass on the lateral stiffness", " Hz",
                "typical: 2 to 20 Hz; the unit is N/m, not kN/m"),
            Self::VerticalFrequency => ("the frequency of the tower's mass on the vertical stiffness", " Hz",
                "typical: 5 to 50 Hz; the unit is N/m, not kN/m"),
            Self::SpringLever => ("sqrt(rocking stiffness/lateral stiffness)", " m",
                "typically the footing radius, more for piles; check that lateral and rocking are not exchanged"),
            Self::PlatformShare => ("the mass of the floating platform, divided by the mass of tower and RNA,", "",
                "floating platforms are heavier than the turbine; the unit is kg"),
            Self::PlatformDepth => ("the distance from the tower base", " m",
                "all heights use the datum of the stations; the unit is m"),
            Self::HeaveFrequency => ("the heave frequency from hydrostatic and mooring stiffness", " Hz",
                "floating platforms have 0.02 to 1; the unit is N/m, not kN/m"),
            Self::SurgeFrequency => ("the surge or sway frequency from the mooring stiffness", " Hz",
                "typical: 0.004 to 0.05 Hz; the unit is N/m, not kN/m"),
            Self::WinklerLengths => ("the embedded length, divided by the characteristic length (4EI/k)^(1/4) of the pile with the soil springs k per length,", "",
                "a pile supported by soil has more than 1; the unit of the springs is N/m2, not kN/m2"),
            Self::SoilPlaneRatio => ("the soil spring in y, divided by the soil spring in x,", "",
                "soil is about equally stiff in both directions; check the exponents"),
            Self::SoilSpring => ("the soil spring", " N/m2",
                "sand has about 1e8, rock 1e10; the unit is N/m2: N/m per metre of tower"),
            Self::BuoyantUnitWeight => ("the effective unit weight under water", " N/m3",
                "typical: 6000 to 11000: the weight of the saturated soil minus the weight of water; the unit is N/m3, not kN/m3"),
            Self::SoilUnitWeight => ("the unit weight above water", " N/m3",
                "typical: 15000 to 21000; the unit is N/m3, not kN/m3"),
            Self::WireDiameter => ("the diameter of a steel wire with this stiffness and length", " m",
                "typical: 0.01 to 0.1 m; the unit of the stiffness EA/L is N/m, not kN/m"),
            Self::WireAngle => ("the angle of the guy wires from the horizontal", " degrees",
                "typical: 20 to 70 degrees; the unit is degrees (0.785 rad is 45 degrees)"),
            Self::Gravity => ("the acceleration of gravity", " m/s2",
                "on Earth it is 9.81"),
            Self::RotorSpeed => ("the highest rotor speed", " rpm",
                "typical for towers higher than 20 m: 5 to 60 rpm; the unit is revolutions per minute (1 rad/s is 9.55 rpm)"),
        }
    }
}
