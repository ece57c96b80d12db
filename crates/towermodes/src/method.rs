//! The methods by name, and the orders of their errors.

/// A discretization of a tower.
///
/// # Example
/// ```
/// use towermodes::Method;
///
/// assert_eq!(Method::named("rmje"), Some(Method::Rmje));
/// assert_eq!(Method::Rmje.bending_powers(false), [2]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Method {
    /// One joint at the elastic centre of each segment, exact section integrals.
    #[default]
    RmjeExact,
    /// The element of Nikolić & Šalinić as published, with its misprints corrected: prismatic
    /// segments, joints at L/4 and L/2.
    Rmje,
    /// Two hinges in each segment at the Gauss points of dz/EI, exact section integrals.
    CardanicExact,
    /// The cardanic joint element after Zhao, Maißer & Wu: prismatic segments, two hinges at kL and
    /// (1−k)L.
    Cardanic,
    /// Rigid half-segments joined by massless beam springs, as Adams models a beam: prismatic
    /// segments, all joints at L/2.
    Lumped,
    /// The 15-dof finite element of BModes: Euler-Bernoulli, sections constant over an element.
    Bmodes,
    /// Spectral elements: one per linear piece, or more where it is steep, with polynomials of a
    /// degree that increases until the modes converge. The reference beam solution.
    Spectral,
}

impl Method {
    /// All methods, those with exact sections before their published forms.
    pub const ALL: [Self; 7] = [
        Self::RmjeExact,
        Self::Rmje,
        Self::CardanicExact,
        Self::Cardanic,
        Self::Lumped,
        Self::Bmodes,
        Self::Spectral,
    ];

    /// Its name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::RmjeExact => "rmje-exact",
            Self::Rmje => "rmje",
            Self::CardanicExact => "cardanic-exact",
            Self::Cardanic => "cardanic",
            Self::Lumped => "lumped",
            Self::Bmodes => "bmodes",
            Self::Spectral => "spectral",
        }
    }

    /// The method with a [name](Self::name), if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// The leading powers p of its error n⁻ᵖ in bending with n segments; none for the spectral
    /// method, whose error decreases exponentially with the degree.
    ///
    /// 2 where there is one joint in a segment. 1 and 2 for the published element of a tower with
    /// shear deformation: its translational joint is at L/4; without shear the deflection of that
    /// joint is O(n⁻³) and its place does not matter, but shear makes it O(n⁻¹), and its place an
    /// error of first order. 2 and 4 for two hinges and for BModes: 4 from the hinges or the cubics, 2 from
    /// prismatic sections or from rotary inertia, small enough that neither can be left out.
    pub fn bending_powers(self, shears: bool) -> &'static [i32] {
        match self {
            Self::Rmje if shears => &[1, 2],
            Self::Rmje | Self::RmjeExact | Self::Lumped => &[2],
            Self::Cardanic | Self::CardanicExact | Self::Bmodes => &[2, 4],
            Self::Spectral => &[],
        }
    }

    /// The leading powers p of its error n⁻ᵖ in torsion and axially: 2, with BModes 2 and 4, but 1
    /// and 2 for the published element, whose joint for both sits at L/4. The two can cancel on
    /// usual meshes, so both are needed for the estimate of the error.
    pub fn axial_powers(self) -> &'static [i32] {
        match self {
            Self::Rmje => &[1, 2],
            Self::Bmodes => &[2, 4],
            Self::Spectral => &[],
            Self::RmjeExact | Self::CardanicExact | Self::Cardanic | Self::Lumped => &[2],
        }
    }
}
