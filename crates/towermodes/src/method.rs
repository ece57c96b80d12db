//! The methods: name, description, physics, order of convergence.

/// A discretization method.
///
/// # Example
/// ```
/// use towermodes::Method;
///
/// let method = Method::named("rmje-exact").expect("a method");
/// assert_eq!(method, Method::default());
/// assert_eq!(method.unit(), "segment");
/// assert!(!Method::Bmodes.has_rotary_inertia());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Method {
    /// One joint at the centre of flexibility of each segment; section properties integrated
    /// exactly.
    #[default]
    RmjeExact,
    /// The element of Nikolić & Šalinić as published, with its misprints corrected: prismatic
    /// segments, joints at L/4 and L/2.
    Rmje,
    /// Two hinges in each segment at the Gauss points of dz/EI; section properties integrated
    /// exactly.
    CardanicExact,
    /// The cardanic joint element after Zhao, Maißer & Wu: prismatic segments, two hinges at the
    /// same distance from both ends.
    Cardanic,
    /// Rigid half-segments joined by massless beam elements (BEAM in Adams): prismatic
    /// segments, all joints at L/2.
    Lumped,
    /// The 15-dof finite element of BModes: Euler-Bernoulli, sections constant over an element.
    Bmodes,
    /// Spectral elements, the reference solution of the beam equations: one element per linear
    /// piece, or more where the piece is steep; the polynomial degree is raised until the
    /// frequencies converge.
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

    /// The name on the command line and in results.
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

    /// Description in one line, for help texts, tables and reports.
    pub fn description(self) -> &'static str {
        match self {
            Self::RmjeExact => {
                "rigid bodies, one joint per segment at the centre of flexibility, sections integrated exactly"
            }
            Self::Rmje => {
                "rigid multibody joint element as published (Nikolić & Šalinić), prismatic segments"
            }
            Self::CardanicExact => {
                "rigid bodies, two hinges per segment at the Gauss points, sections integrated exactly"
            }
            Self::Cardanic => {
                "cardanic joint element (after Zhao, Maißer & Wu), prismatic segments"
            }
            Self::Lumped => {
                "rigid half-segments joined by massless beam elements (BEAM in Adams), prismatic segments"
            }
            Self::Bmodes => {
                "finite element of BModes (NREL): Euler-Bernoulli, no shear, no rotary inertia"
            }
            Self::Spectral => {
                "spectral elements, accurate to about ten digits: the reference solution"
            }
        }
    }

    /// Name of the parts of the mesh, `"segment"` (rigid bodies) or `"element"`
    /// (flexible).
    pub fn unit(self) -> &'static str {
        match self {
            Self::Bmodes | Self::Spectral => "element",
            Self::RmjeExact | Self::Rmje | Self::CardanicExact | Self::Cardanic | Self::Lumped => {
                "segment"
            }
        }
    }

    /// Whether its elements converge by their degree, and so need no other meshes.
    pub(crate) fn converges_by_degree(self) -> bool {
        match self {
            Self::Spectral => true,
            Self::RmjeExact
            | Self::Rmje
            | Self::CardanicExact
            | Self::Cardanic
            | Self::Lumped
            | Self::Bmodes => false,
        }
    }

    /// Whether the rotary inertia of the sections in bending is part of the method.
    pub fn has_rotary_inertia(self) -> bool {
        self != Self::Bmodes
    }

    /// Whether shear deformation is part of the method.
    pub fn has_shear(self) -> bool {
        self != Self::Bmodes
    }

    /// The method with this name, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// The leading powers p of the error n⁻ᵖ in bending; none for `spectral`, whose error decreases
    /// exponentially with the degree.
    ///
    /// With one joint per segment p is 2. With two hinges, and with BModes, p is 2 and 4: the
    /// hinges or the cubics give 4; prismatic sections or rotary inertia give 2, with a coefficient
    /// so small that both terms matter. With the published element of a tower with shear
    /// deformation p is 1 and 2: the translational joint is at L/4. Without shear the translation
    /// in a segment is O(n⁻³) and its position does not matter; shear makes it O(n⁻¹), so that the
    /// position causes an error of first order.
    pub fn bending_powers(self, shears: bool) -> &'static [i32] {
        match self {
            Self::Rmje if shears => &[1, 2],
            Self::Rmje | Self::RmjeExact | Self::Lumped => &[2],
            Self::Cardanic | Self::CardanicExact | Self::Bmodes => &[2, 4],
            Self::Spectral => &[],
        }
    }

    /// The leading powers p of the error n⁻ᵖ in torsion and axial motion: 2, with BModes 2 and 4,
    /// and 1 and 2 with the published element, whose joint for both is at L/4. On usual meshes the
    /// two terms can cancel, so both are needed to estimate the error.
    pub fn axial_powers(self) -> &'static [i32] {
        match self {
            Self::Rmje => &[1, 2],
            Self::Bmodes => &[2, 4],
            Self::Spectral => &[],
            Self::RmjeExact | Self::CardanicExact | Self::Cardanic | Self::Lumped => &[2],
        }
    }
}
