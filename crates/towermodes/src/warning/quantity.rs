//! Quantities that towers have within a known range.

/// A quantity of a tower, given or computed from what is given, that is known to lie within a
/// range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
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
    /// Mass of a floating platform over what it carries.
    PlatformShare,
    /// Distance of a height of a floating platform from the tower's base, m.
    PlatformDepth,
    /// Frequency of a floater in heave on its water plane and moorings, Hz.
    HeaveFrequency,
    /// Frequency of a floater in surge or sway on its moorings, Hz.
    SurgeFrequency,
    /// Length of tower in soil over the length (4EI/k)^¼ over which a beam bends in it.
    WinklerLengths,
    /// Soil spring in y over that in x.
    SoilPlaneRatio,
    /// Soil spring, N/m².
    SoilSpring,
    /// Diameter of a steel wire with the stiffness given, m.
    WireDiameter,
    /// Number of wires in a set.
    WireCount,
    /// Angle of wires from the horizontal, degrees.
    WireAngle,
    /// Acceleration of gravity, m/s².
    Gravity,
    /// Density of the water, kg/m³.
    WaterDensity,
    /// Added mass coefficient.
    AddedMassCoefficient,
    /// Highest speed of the rotor, rpm.
    RotorSpeed,
}

impl Quantity {
    /// What it is called in a sentence.
    pub fn name(self) -> &'static str {
        self.words().0
    }

    /// Its unit after a space; nothing if it has none.
    pub fn unit(self) -> &'static str {
        self.words().1
    }

    /// What a value outside its range most likely comes from.
    pub fn likely_slip(self) -> &'static str {
        self.words().2
    }

    /// Name, unit, likely slip.
    #[rustfmt::skip]
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Density => ("the density", " kg/m3",
                "steel has 7850, concrete 2400; the unit is kg/m3"),
            Self::YoungsModulus => ("Young's modulus", " Pa",
                "steel has 2.1e11, concrete 3e10; the unit is Pa"),
            Self::PoissonsRatio => ("Poisson's ratio", "",
                "steel has 0.3, concrete 0.2; it follows from both moduli where the shear modulus is given"),
            Self::MaterialWaveSpeed => ("the speed of sound sqrt(E/density)", " m/s",
                "steel has 5200, concrete 3800; modulus and density are not of one material, or one has a wrong digit"),
            Self::OutfittingFactor => ("the outfitting factor", "",
                "it multiplies the mass, so 7 % more is 1.07"),
            Self::AxialWaveSpeed => ("the speed of sound sqrt(EA/mass)", " m/s",
                "steel has about 5000, concrete 3800; look at the units and exponents of EA and of the mass"),
            Self::TorsionWaveSpeed => ("the speed of torsional waves sqrt(GJ/polar inertia)", " m/s",
                "steel has about 3200, concrete 2400; look at the units and exponents of GJ and of the polar inertia"),
            Self::ShearWaveSpeed => ("the speed of shear waves sqrt(kappa GA/mass)", " m/s",
                "a steel tube has about 2200; look at the unit and the exponent of the shear stiffness, which is in N"),
            Self::RadiusOfSection => ("the radius of gyration sqrt(EI/EA)", " m",
                "a tube has about a third of its diameter; look at the units and exponents of EI and EA"),
            Self::RadiusOfSectionByMass => ("the radius of gyration sqrt(EI/mass)/(5000 m/s)", " m",
                "a tube of steel has about a third of its diameter; look at the units and exponents of EI and of the mass"),
            Self::PlaneRatio => ("EI side-side, divided by EI fore-aft,", "",
                "a tower is about as stiff in both planes; look at the exponent of one of them"),
            Self::PerpendicularAxes => ("the sum of both rotary inertias, divided by the polar inertia,", "",
                "it is 1 for any flat section"),
            Self::RnaShare => ("the mass of the rotor-nacelle assembly, divided by that of the tower,", "",
                "machines weigh tonnes; the unit is kg"),
            Self::CentreDistance => ("the distance of the centre of mass from the tower's top along one axis", " m",
                "it is measured from the tower top, not from the ground; the unit is m"),
            Self::RadiusOfBody => ("the radius of gyration sqrt(inertia/mass)", " m",
                "look at the unit and the exponent of the inertia, which is in kg m2, and at the mass, which is in kg"),
            Self::SoilShearModulus => ("the soil's shear modulus", " Pa",
                "soft clay has about 5e6, dense sand 1e8, rock 1e10; the unit is Pa"),
            Self::Embedment => ("the footing's embedment, divided by its radius,", "",
                "the formulas are for shallow footings"),
            Self::FootingRadius => ("the footing's radius, divided by that of the tower on it,", "",
                "a footing is wider than the tower; the unit is m"),
            Self::RockingStiffness => ("the rocking stiffness, divided by EI/H of the tower,", "",
                "foundations have 1 to 100; the unit is N m, not kN m, and lateral and rocking must not be exchanged"),
            Self::LateralStiffness => ("the lateral stiffness, divided by EI/H^3 of the tower,", "",
                "foundations have 100 to 1e5; the unit is N/m, not kN/m"),
            Self::TorsionStiffness => ("the torsion stiffness, divided by GJ/H of the tower,", "",
                "foundations have 1 to 100; the unit is N m, not kN m"),
            Self::LateralFrequency => ("the frequency of the tower's mass on the lateral stiffness", " Hz",
                "foundations have 2 to 20; the unit is N/m, not kN/m"),
            Self::VerticalFrequency => ("the frequency of the tower's mass on the vertical stiffness", " Hz",
                "foundations have 5 to 50; the unit is N/m, not kN/m"),
            Self::SpringLever => ("the lever sqrt(rocking stiffness/lateral stiffness)", " m",
                "it is about the radius of a footing, and more for a pile; lateral and rocking may be exchanged"),
            Self::PlatformShare => ("the mass of the platform, divided by what it carries,", "",
                "platforms are heavier than the turbines on them; the unit is kg"),
            Self::PlatformDepth => ("the distance from the tower's base", " m",
                "heights are in the datum of the stations; the unit is m"),
            Self::HeaveFrequency => ("the frequency in heave on water plane and moorings", " Hz",
                "floaters have 0.02 to 1; the unit is N/m, not kN/m"),
            Self::SurgeFrequency => ("the frequency in surge or sway on the moorings", " Hz",
                "floaters have 0.004 to 0.05; the unit is N/m, not kN/m"),
            Self::WinklerLengths => ("the length in soil, divided by the length (4EI/k)^(1/4) over which a beam bends in it,", "",
                "a pile that soil holds has more than 1; the unit of the springs is N/m2, not kN/m2"),
            Self::SoilPlaneRatio => ("the soil spring in y, divided by that in x,", "",
                "soil is about as stiff in both directions; look at the exponent of one of them"),
            Self::SoilSpring => ("the soil spring", " N/m2",
                "sand has about 1e8, rock 1e10; the unit is N/m2: N/m per metre of tower"),
            Self::WireDiameter => ("the diameter of a steel wire of this stiffness and length", " m",
                "stays have 0.01 to 0.1; the unit of the stiffness EA/L is N/m, not kN/m"),
            Self::WireCount => ("the number of wires in the set", "",
                "a set has 3 to 12"),
            Self::WireAngle => ("the angle from the horizontal", " degrees",
                "wires have 20 to 70; the unit is degrees: 0.785 rad are 45"),
            Self::Gravity => ("the acceleration of gravity", " m/s2",
                "on Earth it is 9.81"),
            Self::WaterDensity => ("the water's density", " kg/m3",
                "sea water has 1025; the unit is kg/m3"),
            Self::AddedMassCoefficient => ("the added mass coefficient", "",
                "a cylinder has about 1"),
            Self::RotorSpeed => ("the highest speed of the rotor", " rpm",
                "rotors on towers of more than 20 m turn at 5 to 60 rpm; the unit is turns per minute, 1 rad/s is 9.55 rpm"),
        }
    }
}
