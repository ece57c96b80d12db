//! A checked blade, and its properties between its sections.

use super::description::{BladeDescription, BladeSection};
use super::error::BladeError;
use crate::tower::Site;
use crate::tower::Warning;
use crate::tower::{Inertia, inertia_plausibility};

/// The radius of gyration of the body at the tip is at most this fraction of the blade length.
const TIP_REACH: f64 = 0.6;

/// A checked blade: every property is finite, and positive where it must be. It cannot be changed.
///
/// # Example
/// See [`Solver::blade`](crate::Solver::blade).
#[derive(Debug, Clone, PartialEq)]
pub struct Blade {
    description: BladeDescription,
}

impl Blade {
    /// Checks a description and makes the blade of it.
    ///
    /// # Errors
    /// [`BladeError`] for the first invalid value, with its numbers.
    pub fn new(description: BladeDescription) -> Result<Self, BladeError> {
        let (hub_m, tip_m) = (description.hub_radius_m, description.tip_radius_m);
        let numbers = [
            ("the radius of the hub", hub_m),
            ("the radius of the tip", tip_m),
            ("the speed of the rotor", description.rotor_speed_rad_per_s),
            ("the pitch", description.pitch_rad),
            ("the mass at the tip", description.tip.mass_kg),
        ];
        finite(numbers)?;
        if hub_m < 0.0 || tip_m <= hub_m {
            return Err(BladeError::NoLength { hub_m, tip_m });
        }
        check_tip(&description)?;
        for (index, section) in description.sections.iter().enumerate() {
            check_section(index, section)?;
            check_rigidity(index, section, &description.sections[0])?;
        }
        let spans: Vec<f64> = description.sections.iter().map(|s| s.span).collect();
        check_range("sections", &spans, |a, b| a <= b)?;
        check_range("borders of the elements", &description.borders, |a, b| {
            a < b
        })?;
        Ok(Self { description })
    }

    /// Its description.
    pub fn description(&self) -> &BladeDescription {
        &self.description
    }

    /// Probable mistakes in the values of the body at the tip.
    pub fn warnings(&self) -> Vec<Warning> {
        let (tip, site) = (&self.description.tip, Site::default());
        let mut warnings = Vec::new();
        if tip.mass_kg == 0.0 && tip.inertia_kg_m2 != Inertia::default() {
            warnings.push(Warning::InertiaWithoutMass { site });
        }
        let reach_m = TIP_REACH * self.length_m();
        inertia_plausibility(
            tip.mass_kg,
            &tip.inertia_kg_m2,
            reach_m,
            site,
            &mut warnings,
        );
        warnings
    }

    /// Length from the root to the tip, m.
    pub fn length_m(&self) -> f64 {
        self.description.tip_radius_m - self.description.hub_radius_m
    }

    /// Distance from the rotor axis at a fraction of the span, m.
    pub fn radius_m(&self, span: f64) -> f64 {
        self.description.hub_radius_m + span * self.length_m()
    }

    /// Mass without the body at the tip, kg: exact for sections that are linear between those
    /// given.
    pub fn mass_kg(&self) -> f64 {
        let pairs = self.description.sections.windows(2);
        let masses = pairs.map(|pair| {
            let mean = 0.5 * (pair[0].mass_kg_per_m + pair[1].mass_kg_per_m);
            mean * (pair[1].span - pair[0].span) * self.length_m()
        });
        masses.sum()
    }

    /// The section at a fraction of the span: mass, stiffnesses, squared radii of gyration (inertia
    /// over mass), offsets and twist are linear between the sections given, as BModes interpolates.
    pub fn section_at(&self, span: f64) -> BladeSection {
        let sections = &self.description.sections;
        let above = sections.partition_point(|section| section.span < span);
        let above = above.clamp(1, sections.len() - 1);
        let (a, b) = (&sections[above - 1], &sections[above]);
        // At a step nothing is interpolated.
        let s = if a.span == b.span {
            0.0
        } else {
            (span - a.span) / (b.span - a.span)
        };
        let blend = |value: fn(&BladeSection) -> f64| {
            let (a, b) = (value(a), value(b));
            // An infinite stiffness is infinite in all sections.
            if a == b { a } else { a + s * (b - a) }
        };
        let mass_kg_per_m = blend(|s| s.mass_kg_per_m);
        BladeSection {
            span,
            twist_rad: blend(|s| s.twist_rad),
            mass_kg_per_m,
            flap_inertia_kg_m: mass_kg_per_m * blend(|s| s.flap_inertia_kg_m / s.mass_kg_per_m),
            edge_inertia_kg_m: mass_kg_per_m * blend(|s| s.edge_inertia_kg_m / s.mass_kg_per_m),
            flap_n_m2: blend(|s| s.flap_n_m2),
            edge_n_m2: blend(|s| s.edge_n_m2),
            torsion_n_m2: blend(|s| s.torsion_n_m2),
            axial_n: blend(|s| s.axial_n),
            center_of_mass_m: blend(|s| s.center_of_mass_m),
            tension_center_m: blend(|s| s.tension_center_m),
        }
    }
}

fn finite<const N: usize>(values: [(&'static str, f64); N]) -> Result<(), BladeError> {
    match values.into_iter().find(|(_, value)| !value.is_finite()) {
        None => Ok(()),
        Some((quantity, value)) => Err(BladeError::NotFinite { quantity, value }),
    }
}

fn check_tip(description: &BladeDescription) -> Result<(), BladeError> {
    let (mass_kg, inertia) = (description.tip.mass_kg, &description.tip.inertia_kg_m2);
    if mass_kg < 0.0 {
        return Err(BladeError::NegativeTip { mass_kg });
    }
    let [x, y, z] = description.tip.center_m;
    finite([
        ("an offset at the tip", x),
        ("an offset at the tip", y),
        ("an offset at the tip", z),
    ])?;
    for value in inertia.tensor().into_iter().flatten() {
        finite([("an inertia at the tip", value)])?;
    }
    let principal = inertia.principal_kg_m2();
    if principal[0] < -1e-9 * principal[2].abs() {
        let moment_kg_m2 = principal[0];
        return Err(BladeError::NegativeTipInertia { moment_kg_m2 });
    }
    Ok(())
}

fn check_section(section: usize, values: &BladeSection) -> Result<(), BladeError> {
    finite([
        ("a section's place", values.span),
        ("a section's twist", values.twist_rad),
        ("a section's centre of mass", values.center_of_mass_m),
        ("a section's tension centre", values.tension_center_m),
        ("a section's flap inertia", values.flap_inertia_kg_m),
        ("a section's edge inertia", values.edge_inertia_kg_m),
    ])?;
    let positive = [
        ("the mass per length", values.mass_kg_per_m),
        ("the flap stiffness", values.flap_n_m2),
        ("the edge stiffness", values.edge_n_m2),
        ("the axial stiffness", or_one_if_infinite(values.axial_n)),
        (
            "the torsional stiffness",
            or_one_if_infinite(values.torsion_n_m2),
        ),
    ];
    for (quantity, value) in positive {
        finite([(quantity, value)])?;
        if value <= 0.0 {
            return Err(BladeError::NotPositive {
                quantity,
                section,
                value,
            });
        }
    }
    check_polar_inertia(section, values)?;
    check_inertias(section, values)?;
    check_tension_center(section, values)
}

/// A section of a blade with torsion needs a polar inertia; without torsion it may be zero, but not
/// negative.
fn check_polar_inertia(section: usize, values: &BladeSection) -> Result<(), BladeError> {
    let quantity = "the sum of both inertias";
    let value = values.flap_inertia_kg_m + values.edge_inertia_kg_m;
    finite([(quantity, value)])?;
    let is_rigid = values.torsion_n_m2 == f64::INFINITY;
    if value > 0.0 || (is_rigid && value == 0.0) {
        return Ok(());
    }
    Err(BladeError::NotPositive {
        quantity,
        section,
        value,
    })
}

/// Without negative inertias and with enough for its centre of mass the blade's mass matrix is not
/// indefinite.
fn check_inertias(section: usize, values: &BladeSection) -> Result<(), BladeError> {
    for (quantity, value) in [
        ("the flap inertia", values.flap_inertia_kg_m),
        ("the edge inertia", values.edge_inertia_kg_m),
    ] {
        if value < 0.0 {
            return Err(BladeError::Negative {
                quantity,
                section,
                value,
            });
        }
    }
    match values.inertia_suits_center_of_mass() {
        true => Ok(()),
        false => Err(BladeError::CenterOfMass {
            section,
            offset_m: values.center_of_mass_m,
            mass_kg_per_m: values.mass_kg_per_m,
            edge_inertia_kg_m: values.edge_inertia_kg_m,
        }),
    }
}

/// EI about the elastic axis includes EA a² of the offset a of the tension centre, so it must be
/// larger than this part.
fn check_tension_center(section: usize, values: &BladeSection) -> Result<(), BladeError> {
    let (offset_m, axial_n, edge_n_m2) =
        (values.tension_center_m, values.axial_n, values.edge_n_m2);
    if offset_m == 0.0 || axial_n * offset_m * offset_m < edge_n_m2 {
        return Ok(());
    }
    Err(BladeError::TensionCenter {
        section,
        offset_m,
        axial_n,
        edge_n_m2,
    })
}

/// Replaces an infinite stiffness, which means that the deformation is excluded, by 1.
fn or_one_if_infinite(stiffness: f64) -> f64 {
    if stiffness == f64::INFINITY {
        1.0
    } else {
        stiffness
    }
}

/// Torsional and axial stiffness must be infinite in all sections or in none.
fn check_rigidity(
    section: usize,
    values: &BladeSection,
    first: &BladeSection,
) -> Result<(), BladeError> {
    let stiffnesses = [
        (
            "the torsional stiffness",
            values.torsion_n_m2,
            first.torsion_n_m2,
        ),
        ("the axial stiffness", values.axial_n, first.axial_n),
    ];
    let differs = |(_, value, first): &(&str, f64, f64)| value.is_infinite() != first.is_infinite();
    match stiffnesses.into_iter().find(differs) {
        None => Ok(()),
        Some((quantity, value, first)) => Err(BladeError::RigidInSomeSections {
            quantity,
            section,
            value,
            first,
        }),
    }
}

/// Checks that positions along the span begin at 0, end at 1 and increase.
fn check_range(
    what: &'static str,
    spans: &[f64],
    rises: impl Fn(f64, f64) -> bool,
) -> Result<(), BladeError> {
    let ends = (spans.first().copied(), spans.last().copied());
    if ends != (Some(0.0), Some(1.0)) {
        let (first, last) = (ends.0.unwrap_or(f64::NAN), ends.1.unwrap_or(f64::NAN));
        return Err(BladeError::NotWhole { what, first, last });
    }
    // With NaN as a position, the list does not increase.
    match spans.windows(2).find(|pair| !rises(pair[0], pair[1])) {
        None => Ok(()),
        Some(pair) => Err(BladeError::NotRising {
            what,
            span: pair[1],
        }),
    }
}
