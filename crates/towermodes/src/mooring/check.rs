//! The checks of a description, before anything is computed with it.

use super::description::{Attachment, Carrier, MooringDescription};
use super::error::{MooringError, MooringItem};

/// Largest magnitude of a quantity of a mooring system, in SI units: products of several quantities
/// stay far from the limits of double precision.
const MOST: f64 = 1e20;
/// Heights below the seabed by more than this fraction of the depth are under it.
const ROUNDED: f64 = 1e-9;

/// Returns the first error.
pub(super) fn check(mooring: &MooringDescription) -> Result<(), MooringError> {
    check_site(mooring)?;
    check_line_types(mooring)?;
    check_bodies(mooring)?;
    check_rods(mooring)?;
    check_points(mooring)?;
    check_lines(mooring)
}

fn check_site(mooring: &MooringDescription) -> Result<(), MooringError> {
    let site = Values(MooringItem::Site);
    site.positive("the depth", mooring.depth_m, " m")?;
    site.positive(
        "the density of the water",
        mooring.water_density_kg_per_m3,
        " kg/m3",
    )?;
    site.positive("gravity", mooring.gravity_m_per_s2, " m/s2")?;
    site.position("the reference point", mooring.reference_m)
}

fn check_line_types(mooring: &MooringDescription) -> Result<(), MooringError> {
    for (index, kind) in mooring.line_types.iter().enumerate() {
        let values = Values(MooringItem::LineType(index));
        values.not_negative("the diameter", kind.diameter_m, " m")?;
        values.not_negative("the mass per length", kind.mass_kg_per_m, " kg/m")?;
        values.positive("the axial stiffness", kind.axial_stiffness_n, " N")?;
        values.not_negative("the friction on the seabed", kind.seabed_friction, "")?;
    }
    Ok(())
}

fn check_bodies(mooring: &MooringDescription) -> Result<(), MooringError> {
    for (index, body) in mooring.bodies.iter().enumerate() {
        let values = Values(MooringItem::Body(index));
        values.position("the position", body.position_m)?;
        values.position("the centre of mass", body.center_m)?;
        for angle_rad in body.angles_rad {
            values.finite("an angle", angle_rad, " rad")?;
        }
        values.not_negative("the mass", body.mass_kg, " kg")?;
        values.not_negative("the volume", body.volume_m3, " m3")?;
        for inertia in body.inertia_kg_m2 {
            values.not_negative("an inertia", inertia, " kg m2")?;
        }
    }
    Ok(())
}

fn check_rods(mooring: &MooringDescription) -> Result<(), MooringError> {
    for (index, rod) in mooring.rods.iter().enumerate() {
        let values = Values(MooringItem::Rod(index));
        for end in rod.ends_m {
            values.position("an end", end)?;
        }
        values.not_negative("the diameter", rod.diameter_m, " m")?;
        values.not_negative("the mass per length", rod.mass_kg_per_m, " kg/m")?;
        if rod.ends_m[0] == rod.ends_m[1] {
            return Err(MooringError::RodWithoutLength { rod: index });
        }
    }
    Ok(())
}

fn check_points(mooring: &MooringDescription) -> Result<(), MooringError> {
    for (index, point) in mooring.points.iter().enumerate() {
        let item = MooringItem::Point(index);
        let values = Values(item);
        values.position("the position", point.position_m)?;
        values.not_negative("the mass", point.mass_kg, " kg")?;
        values.not_negative("the volume", point.volume_m3, " m3")?;
        match point.attachment {
            Attachment::Fixed | Attachment::Platform => {
                above_seabed(mooring, item, point.position_m[2])?;
            }
            Attachment::Free => check_connected(mooring, item)?,
            Attachment::Body(body) => {
                exists(item, MooringItem::Body(body), body, mooring.bodies.len())?;
            }
            Attachment::Rod(rod, _) => {
                exists(item, MooringItem::Rod(rod), rod, mooring.rods.len())?;
            }
        }
    }
    Ok(())
}

fn check_lines(mooring: &MooringDescription) -> Result<(), MooringError> {
    if mooring.lines.is_empty() {
        return Err(MooringError::NoLines);
    }
    for (index, line) in mooring.lines.iter().enumerate() {
        let item = MooringItem::Line(index);
        Values(item).positive("the length", line.length_m, " m")?;
        let kind = line.line_type;
        exists(
            item,
            MooringItem::LineType(kind),
            kind,
            mooring.line_types.len(),
        )?;
        for point in line.points {
            exists(item, MooringItem::Point(point), point, mooring.points.len())?;
        }
        if line.points[0] == line.points[1] {
            let point = line.points[0];
            return Err(MooringError::SamePoint { line: index, point });
        }
    }
    for (index, body) in mooring.bodies.iter().enumerate() {
        if body.carrier == Carrier::Free {
            check_connected(mooring, MooringItem::Body(index))?;
        }
    }
    for (index, rod) in mooring.rods.iter().enumerate() {
        if rod.carrier == Carrier::Free {
            check_connected(mooring, MooringItem::Rod(index))?;
        }
    }
    Ok(())
}

/// Whether a line ends at a free part.
fn check_connected(mooring: &MooringDescription, item: MooringItem) -> Result<(), MooringError> {
    let mut ends = mooring.lines.iter().flat_map(|line| line.points);
    let is_there = |end: usize| match mooring.points.get(end).map(|point| point.attachment) {
        Some(Attachment::Free) => item == MooringItem::Point(end),
        Some(Attachment::Body(body)) => item == MooringItem::Body(body),
        Some(Attachment::Rod(rod, _)) => item == MooringItem::Rod(rod),
        Some(Attachment::Fixed | Attachment::Platform) | None => false,
    };
    match ends.any(is_there) {
        true => Ok(()),
        false => Err(MooringError::Unconnected { item }),
    }
}

fn above_seabed(
    mooring: &MooringDescription,
    item: MooringItem,
    z_m: f64,
) -> Result<(), MooringError> {
    let depth_m = mooring.depth_m;
    match z_m >= -depth_m * (1.0 + ROUNDED) {
        true => Ok(()),
        false => Err(MooringError::UnderSeabed { item, z_m, depth_m }),
    }
}

fn exists(
    item: MooringItem,
    missing: MooringItem,
    index: usize,
    count: usize,
) -> Result<(), MooringError> {
    match index < count {
        true => Ok(()),
        false => Err(MooringError::Unknown {
            item,
            missing,
            count,
        }),
    }
}

/// The part to which the values belong.
struct Values(MooringItem);

impl Values {
    fn finite(
        &self,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Result<(), MooringError> {
        let item = self.0;
        if !value.is_finite() {
            return Err(MooringError::NotFinite {
                item,
                quantity,
                value,
            });
        }
        if value.abs() > MOST {
            let most = MOST;
            return Err(MooringError::TooLarge {
                item,
                quantity,
                value,
                unit,
                most,
            });
        }
        Ok(())
    }

    fn not_negative(
        &self,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Result<(), MooringError> {
        self.finite(quantity, value, unit)?;
        let item = self.0;
        match value >= 0.0 {
            true => Ok(()),
            false => Err(MooringError::Negative {
                item,
                quantity,
                value,
                unit,
            }),
        }
    }

    fn positive(
        &self,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Result<(), MooringError> {
        self.finite(quantity, value, unit)?;
        let item = self.0;
        match value > 0.0 {
            true => Ok(()),
            false => Err(MooringError::NotPositive {
                item,
                quantity,
                value,
                unit,
            }),
        }
    }

    fn position(&self, quantity: &'static str, position_m: [f64; 3]) -> Result<(), MooringError> {
        let mut all = position_m.into_iter();
        all.try_for_each(|coordinate| self.finite(quantity, coordinate, " m"))
    }
}
