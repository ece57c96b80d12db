//! The rotor-nacelle assembly, from the masses in the file.

use std::ops::Range;

use towermodes::{Inertia, MissingPart, Place, RigidBody, Rna};

use super::super::text::outline::{Outline, Version};
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::body::{NEW_KEYS, OLD_KEYS, body};
use super::given_masses::note_components;
use super::plausible::angle;
use super::rotor::{Hub, rotor};
use super::shaft::{is_upwind, shaft};
use super::speeds::{USUAL_BLADES, blade_count};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::number::Rounded;
use crate::places::TABLE;

/// The comment in written files whose drivetrain is the whole rotor-nacelle assembly.
pub(crate) const WHOLE_ASSEMBLY: &str =
    "# towermodes: the whole rotor-nacelle assembly, hub and blades included";

/// The bodies by the keys of version 1.
const OLDER: &str = "elastic_properties_mb";

/// The mass of the nacelle without the yaw system, as WISDEM writes it.
const ABOVE_YAW: &str = "above_yaw_mass";

/// The bodies found so far.
struct Assembly {
    bodies: Vec<(String, RigidBody)>,
    /// The bodies whose mass the file does not give, with their names in the file.
    missing: Vec<(MissingPart, &'static str)>,
    span: Range<usize>,
}

/// The bodies of the assembly combined, and the missing bodies; a note lists both.
pub(crate) fn rna(
    outline: &Outline,
    version: Version,
    reading: &mut Reading<'_>,
) -> Result<(Rna, Vec<MissingPart>), Diagnostic> {
    let mut assembly = Assembly {
        bodies: Vec::new(),
        missing: Vec::new(),
        span: 0..0,
    };
    match version {
        Version::One => assembly.read_nacelle_1(outline, reading)?,
        Version::Two => assembly.read_nacelle_2(outline, reading)?,
    }
    if assembly.bodies.is_empty()
        && let Some(whole) = whole(outline, reading)?
    {
        assembly.missing.clear();
        assembly.add("RNA", whole.body, &whole.span);
    } else {
        assembly.read_rotor(outline, version, reading)?;
    }
    // Files written by this program have the whole assembly in one place, and a comment on it.
    if reading.source.text.contains(WHOLE_ASSEMBLY) {
        assembly.missing.clear();
    }
    assembly.note(reading);
    let lacks = |part| assembly.missing.iter().any(|(missing, _)| *missing == part);
    note_components(outline, lacks, reading);
    let is_there = !assembly.bodies.is_empty() || has_machine(outline);
    let missing = assembly.missing.iter().filter(|_| is_there);
    let missing = missing.map(|(part, _)| *part).collect();
    for key in [TABLE, "mass", "center", "inertia"] {
        reading.remember(Place::Rna { key }, &assembly.span);
    }
    let bodies: Vec<RigidBody> = assembly.bodies.into_iter().map(|(_, body)| body).collect();
    let rna = match bodies[..] {
        [] => Rna::default(),
        [body] => body.into(),
        _ => RigidBody::combined(&bodies).into(),
    };
    Ok((rna, missing))
}

/// Whether the file describes a rotor-nacelle assembly on the tower, with or without masses.
fn has_machine(outline: &Outline) -> bool {
    let of_components = outline.components.as_ref().is_some_and(|c| {
        let nodes = [&c.rna, &c.hub, &c.nacelle, &c.drivetrain, &c.yaw];
        c.blade.is_some() || nodes.into_iter().any(Option::is_some)
    });
    of_components || matches!(blade_count(outline), Ok(Some(_)))
}

impl Assembly {
    fn add(&mut self, what: impl Into<String>, body: RigidBody, span: &Range<usize>) {
        if self.bodies.is_empty() {
            self.span = span.clone();
        }
        self.bodies.push((what.into(), body));
    }

    /// Version 2: drive train and yaw system, in axes at the tower top.
    fn read_nacelle_2(
        &mut self,
        outline: &Outline,
        reading: &mut Reading<'_>,
    ) -> Result<(), Diagnostic> {
        let components = outline.components.as_ref();
        let drivetrain = components.and_then(|c| c.drivetrain.as_ref());
        let yaw = components.and_then(|c| c.yaw.as_ref());
        for (node, what) in [(drivetrain, "drivetrain"), (yaw, "yaw system")] {
            if let Some(node) = node.and_then(|node| node.get("elastic_properties")) {
                self.add(what, body(node, NEW_KEYS, what, reading)?, &node.span);
            } else if what == "drivetrain" && !self.read_older_nacelle(outline, reading)? {
                // Many files count the yaw system in the drive train.
                let missing = (MissingPart::Nacelle, "nacelle (drivetrain)");
                self.missing.push(missing);
            }
        }
        Ok(())
    }

    /// Version 1: the nacelle, in axes at the tower top.
    fn read_nacelle_1(
        &mut self,
        outline: &Outline,
        reading: &mut Reading<'_>,
    ) -> Result<(), Diagnostic> {
        if !self.read_older_nacelle(outline, reading)? {
            self.missing.push((MissingPart::Nacelle, "nacelle"));
        }
        Ok(())
    }

    /// The nacelle by the keys of version 1, under `nacelle` or, as WISDEM writes it, under
    /// `nacelle.drivetrain`; files of version 2 may contain them too. False if there is none.
    fn read_older_nacelle(
        &mut self,
        outline: &Outline,
        reading: &mut Reading<'_>,
    ) -> Result<bool, Diagnostic> {
        let components = outline.components.as_ref();
        let nacelle = components.and_then(|c| c.nacelle.as_ref());
        let of_nacelle = nacelle.and_then(|nacelle| {
            let own = nacelle.get(OLDER);
            own.or_else(|| nacelle.find(&["drivetrain", OLDER]))
        });
        let drivetrain = components.and_then(|c| c.drivetrain.as_ref());
        let found = of_nacelle.or_else(|| drivetrain?.get(OLDER));
        let Some(node) = found else {
            return Ok(false);
        };
        let keys = nacelle_keys(node, reading)?;
        let nacelle = body(node, keys, "nacelle", reading)?;
        self.add("nacelle", nacelle, &node.span);
        let yaw_kg = node.number_or("yaw_mass", "mass of the yaw system", 0.0)?;
        if yaw_kg != 0.0 {
            let yaw = RigidBody::point(yaw_kg, [0.0; 3]);
            self.add("yaw system", yaw, &node.span);
        }
        Ok(true)
    }

    /// Hub and blades, in axes at the rotor's apex along the shaft.
    fn read_rotor(
        &mut self,
        outline: &Outline,
        version: Version,
        reading: &mut Reading<'_>,
    ) -> Result<(), Diagnostic> {
        let is_upwind = is_upwind(outline, reading);
        let hub = hub(outline, version, reading)?;
        let blades = blades(outline, version, is_upwind, reading)?;
        let no_hub = hub.is_none().then_some((MissingPart::Hub, "hub"));
        let no_blades = (blades.is_none()).then_some((MissingPart::Blades, "blades"));
        self.missing.extend(no_hub.into_iter().chain(no_blades));
        if hub.is_none() && blades.is_none() {
            return Ok(());
        }
        let shaft = shaft(outline, version, is_upwind, reading)?;
        for (what, body, span) in hub.into_iter().chain(blades) {
            let placed = body.turned_about_y(shaft.tilt_rad).moved(shaft.apex_m);
            self.add(what, placed, &span);
        }
        Ok(())
    }

    /// The note on the bodies of the assembly, and on the missing ones.
    fn note(&self, reading: &mut Reading<'_>) {
        let list = |(what, body): &(String, RigidBody)| format!("{what} {:.0} kg", body.mass_kg);
        let bodies: Vec<String> = self.bodies.iter().map(list).collect();
        let total: f64 = self.bodies.iter().map(|(_, body)| body.mass_kg).sum();
        let missing: Vec<&str> = self.missing.iter().map(|(_, name)| *name).collect();
        let missing = missing.join(", ");
        let bodies = bodies.join(", ");
        if self.bodies.is_empty() {
            reading.note(Note::missing_part("NO ROTOR-NACELLE ASSEMBLY: the file does not give its mass, so the frequencies are those of the tower alone; add [rna] after `convert --to toml`"));
            return;
        }
        let note = match missing.is_empty() {
            true => Note::new(format!("rotor-nacelle assembly: {total:.0} kg ({bodies})")),
            false => Note::missing_part(format!(
                "INCOMPLETE ROTOR-NACELLE ASSEMBLY: {total:.0} kg ({bodies}); the file does not give the mass of {missing}, so the frequencies are too high unless the other masses include it; give the whole [rna] after `convert --to toml`"
            )),
        };
        reading.note_at(self.span.start, note);
    }
}

/// The whole assembly, including hub and blades.
struct Whole {
    body: RigidBody,
    span: Range<usize>,
}

/// The whole assembly under `RNA`, as in the first files of version 1: its inertia is about the
/// tower top.
fn whole(outline: &Outline, reading: &mut Reading<'_>) -> Result<Option<Whole>, Diagnostic> {
    let components = outline.components.as_ref();
    let Some(node) = components.and_then(|c| c.rna.as_ref()?.get(OLDER)) else {
        return Ok(None);
    };
    let keys = ["mass", "inertia", "center_mass"];
    let about_top = body(node, keys, "rotor-nacelle assembly", reading)?;
    let message = "the inertia of RNA is about the tower top, as WISDEM writes it";
    reading.note_at(node.span.start, Note::assumption(message));
    let (m, [x, y, z]) = (about_top.mass_kg, about_top.center_m);
    let own = about_top.inertia_kg_m2;
    let inertia_kg_m2 = match own == Inertia::default() {
        true => own,
        false => Inertia {
            xx: own.xx - m * (y * y + z * z),
            yy: own.yy - m * (x * x + z * z),
            zz: own.zz - m * (x * x + y * y),
            xy: own.xy + m * x * y,
            xz: own.xz + m * x * z,
            yz: own.yz + m * y * z,
        },
    };
    Ok(Some(Whole {
        body: RigidBody {
            inertia_kg_m2,
            ..about_top
        },
        span: node.span.clone(),
    }))
}

/// The key of the nacelle mass: `system_mass` as in the schema, or `above_yaw_mass` as WISDEM
/// writes it, without the yaw system. If a file has both, the latter is used, because `yaw_mass` is
/// added.
fn nacelle_keys<'k>(node: &Node, reading: &mut Reading<'_>) -> Result<[&'k str; 3], Diagnostic> {
    let [_, inertia, center] = OLD_KEYS;
    let Some(above) = node.get(ABOVE_YAW) else {
        return Ok(OLD_KEYS);
    };
    let above_kg = above.number("above_yaw_mass of the nacelle")?;
    let message = match node.get("system_mass") {
        None => format!(
            "the nacelle has above_yaw_mass = {} kg and no system_mass: above_yaw_mass is used as its mass, without the yaw system",
            Rounded(above_kg)
        ),
        Some(system) => format!(
            "the nacelle has above_yaw_mass = {} kg and system_mass = {} kg: above_yaw_mass plus yaw_mass is used",
            Rounded(above_kg),
            Rounded(system.number("system_mass of the nacelle")?)
        ),
    };
    reading.note_at(above.span.start, Note::assumption(message));
    Ok([ABOVE_YAW, inertia, center])
}

/// A body of the rotor in axes at the apex along the shaft: its name, the body, its place in the
/// file.
type RotorBody = (String, RigidBody, Range<usize>);

fn hub(
    outline: &Outline,
    version: Version,
    reading: &mut Reading<'_>,
) -> Result<Option<RotorBody>, Diagnostic> {
    let hub = outline.components.as_ref().and_then(|c| c.hub.as_ref());
    let newer = hub.and_then(|hub| hub.get("elastic_properties"));
    let newer = newer.filter(|_| version == Version::Two);
    let older = hub.and_then(|hub| hub.get(OLDER));
    let found = newer.map(|node| (node, NEW_KEYS));
    let Some((node, keys)) = found.or(older.map(|node| (node, OLD_KEYS))) else {
        return Ok(None);
    };
    let body = body(node, keys, "hub", reading)?;
    Ok(Some(("hub".to_owned(), body, node.span.clone())))
}

fn blades(
    outline: &Outline,
    version: Version,
    is_upwind: bool,
    reading: &mut Reading<'_>,
) -> Result<Option<RotorBody>, Diagnostic> {
    let components = outline.components.as_ref();
    let both = components.and_then(|c| c.blade.as_ref().zip(c.hub.as_ref()));
    let Some((blade, hub)) = both else {
        return Ok(None);
    };
    let hub = hub_of(hub, outline, version, is_upwind, reading)?;
    let span = blade.inertia_matrix().map(|node| node.span.clone());
    let Some((body, span)) = rotor(blade, &hub)?.zip(span) else {
        return Ok(None);
    };
    if hub.blades < 3.0 {
        let message =
            "the rotor has fewer than three blades: its inertia is the mean over a revolution";
        reading.note(Note::approximation(message));
    }
    Ok(Some((format!("{} blades", hub.blades), body, span)))
}

fn hub_of(
    hub: &Node,
    outline: &Outline,
    version: Version,
    is_upwind: bool,
    reading: &mut Reading<'_>,
) -> Result<Hub, Diagnostic> {
    let shape = hub.get("outer_shape_bem").unwrap_or(hub);
    let diameter = shape.require("diameter", "hub")?;
    let diameter_m = diameter.number("hub diameter")?;
    if diameter_m < 0.0 {
        let kind = DiagnosticKind::out_of_range_in("hub diameter", diameter_m, "m", "non-negative");
        return Err(Diagnostic::new(diameter.span.clone(), kind));
    }
    let cone_rad = match shape.get("cone_angle") {
        Some(node) => angle(node, "cone_angle", version, reading)?,
        None => 0.0,
    };
    let blades = blade_count(outline)?.unwrap_or(USUAL_BLADES);
    Ok(Hub {
        radius_m: 0.5 * diameter_m,
        cone_rad,
        blades: blades as f64,
        is_upwind,
    })
}
