//! The rotor-nacelle assembly of an ElastoDyn model as one rigid body.

use std::f64::consts::TAU;

use towermodes::{Inertia, RigidBody};

use super::super::main_input::main_file::MainFile;
use super::blade_file::BladeMasses;
use super::shaft::{Shaft, is_balanced};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::input::RotorLock;
use crate::note::Note;
use crate::source::Source;

/// Hub, blades, tip masses, generator, nacelle and yaw bearing as one body about the tower top: x
/// downwind, y lateral, z up.
///
/// The rotor's apex is at (OverHang cos τ, 0, Twr2Shft + OverHang sin τ) with τ = ShftTilt; the
/// first blade points up, and the others follow at equal angles clockwise as seen from upwind.
/// Blades are rods: only their mass along their axis is used. `NacYIner` is about the yaw axis; the
/// nacelle has no other inertia than the part of it that remains about its centre. With a locked
/// rotor the generator adds `GenIner` about the shaft, without the factor `GBRatio`²; with a free
/// rotor, rotor and generator together add J_r J_g (1 − q)²/(J_r + q² J_g) about the shaft, where
/// J_r is the rotor's inertia, J_g = `GenIner` and q = `GBRatio`.
///
/// Source: the kinematics of ElastoDyn (OpenFAST 5.0, `SetCoordSy`, `CalculatePositions`, `Coeff`
/// in `ElastoDyn.f90`).
pub fn lump_rna(main: &MainFile, blades: &[BladeMasses], lock: RotorLock) -> RigidBody {
    let mut rotor = rotor(main, blades);
    let shaft = Shaft::of(main, &rotor);
    rotor.inertia_kg_m2.xx += match lock {
        RotorLock::Locked => shaft.generator,
        RotorLock::Free => shaft.felt_by_nacelle(lock) - shaft.rotor,
    };
    // The shaft's downwind end rises with a positive tilt, and turning about y lowers it.
    let tilted = rotor.turned_about_y(-main.shaft_tilt_deg.to_radians());
    RigidBody::combined(&[
        tilted.moved([0.0, 0.0, main.tower_to_shaft_m]),
        nacelle(main),
        RigidBody::point(main.yaw_bearing_mass_kg, [0.0; 3]),
    ])
}

/// Hub, blades and tip masses on the shaft, which is x.
fn rotor(main: &MainFile, blades: &[BladeMasses]) -> RigidBody {
    let mut bodies = vec![hub(main)];
    let apex_m = apex_on_shaft_m(main);
    for (index, masses) in blades.iter().enumerate().take(3) {
        let azimuth_rad = TAU * index as f64 / blades.len().min(3) as f64;
        let tip = RigidBody::point(main.tip_masses_kg[index], [0.0, 0.0, main.tip_radius_m]);
        let blade = RigidBody::combined(&[blade(main, masses), tip]);
        let coned = blade.turned_about_y(main.precone_deg[index].to_radians());
        bodies.push(coned.turned_about_x(azimuth_rad).moved([apex_m, 0.0, 0.0]));
    }
    RigidBody::combined(&bodies)
}

/// Position where the blades' axes intersect, m along the shaft from the yaw axis.
fn apex_on_shaft_m(main: &MainFile) -> f64 {
    main.overhang_m - main.undersling_m
}

/// A blade along z from the apex.
fn blade(main: &MainFile, masses: &BladeMasses) -> RigidBody {
    let mass_kg = masses.mass_kg;
    let center_m = if mass_kg > 0.0 {
        masses.first_moment_kg_m / mass_kg
    } else {
        0.0
    };
    let about_center = masses.second_moment_kg_m2 - masses.first_moment_kg_m * center_m;
    RigidBody {
        mass_kg,
        center_m: [0.0, 0.0, main.hub_radius_m + center_m],
        inertia_kg_m2: Inertia {
            xx: about_center,
            yy: about_center,
            ..Inertia::default()
        },
    }
}

/// The hub on the shaft, which is x.
fn hub(main: &MainFile) -> RigidBody {
    let (about_shaft, about_teeter_axis) = hub_inertia_kg_m2(main);
    RigidBody {
        mass_kg: main.hub_mass_kg,
        center_m: [apex_on_shaft_m(main) + main.hub_center_m, 0.0, 0.0],
        inertia_kg_m2: Inertia {
            xx: about_shaft,
            yy: about_teeter_axis,
            ..Inertia::default()
        },
    }
}

/// The hub's inertia about its centre: about the shaft and about the teeter axis, kg m².
///
/// For two blades the inertia about the teeter pin is transformed to the centre, and before
/// OpenFAST 4.2 it applies to both axes.
pub(crate) fn hub_inertia_kg_m2(main: &MainFile) -> (f64, f64) {
    if main.blade_count != 2 {
        return (main.hub_inertia_kg_m2, 0.0);
    }
    let arm_m = main.undersling_m - main.hub_center_m;
    let cosine = main.delta3_deg.to_radians().cos();
    let about_center =
        |about_pin: f64| (about_pin - main.hub_mass_kg * arm_m * arm_m) / (cosine * cosine);
    match main.hub_teeter_inertia_kg_m2 {
        Some(about_pin) => (main.hub_inertia_kg_m2, about_center(about_pin)),
        None => (
            about_center(main.hub_inertia_kg_m2),
            about_center(main.hub_inertia_kg_m2),
        ),
    }
}

/// The nacelle; in ElastoDyn its only inertia is that about the yaw axis.
pub(crate) fn nacelle(main: &MainFile) -> RigidBody {
    let [x, y, _] = main.nacelle_center_m;
    let zz = main.nacelle_yaw_inertia_kg_m2 - main.nacelle_mass_kg * (x * x + y * y);
    RigidBody {
        mass_kg: main.nacelle_mass_kg,
        center_m: main.nacelle_center_m,
        inertia_kg_m2: Inertia {
            zz,
            ..Inertia::default()
        },
    }
}

/// Refuses a free rotor whose rotation moves the nacelle.
pub(crate) fn check_free_rotor(main: &MainFile, blades: &[BladeMasses]) -> Result<(), Diagnostic> {
    let rotor = rotor(main, blades);
    if is_balanced(&rotor, main.tip_radius_m) {
        return Ok(());
    }
    let [_, y, z] = rotor.center_m;
    let kind = DiagnosticKind::Unsupported(format!(
        "the free rotor is not balanced: its centre of mass is {:.4} m off the shaft, or the shaft is not a principal axis",
        y.hypot(z)
    ));
    let hint = "a free rotor needs two or three equal blades; use --rotor locked";
    Err(Diagnostic::new(main.place("NumBl"), kind).with_hint(hint))
}

/// The notes on the assumptions of a single rigid body.
pub(crate) fn notes(
    main: &MainFile,
    source: &Source,
    blades: &[BladeMasses],
    lock: RotorLock,
) -> Vec<Note> {
    let mut notes = Vec::new();
    if main.blade_count != 3 {
        let message = format!(
            "the inertia of a rotor of {} blades depends on its position: the first blade is assumed to point up",
            main.blade_count
        );
        notes.push(Note::assumption(message));
    }
    notes.extend(
        on_inertia(&lump_rna(main, blades, lock))
            .map(|note| note.at(source, main.place("NacYIner").start)),
    );
    let at = main.place("GenIner").start;
    let message = rotor_message(&Shaft::of(main, &rotor(main, blades)), lock);
    notes.push(Note::rigid_rotor(message).at(source, at));
    if main.furling {
        notes.push(Note::left_out("the furling model (FurlFile) is left out"));
    }
    notes
}

/// The note that the moments of inertia are not those of a real body, because the nacelle has only
/// one.
fn on_inertia(rna: &RigidBody) -> Option<Note> {
    let [least, middle, largest] = rna.inertia_kg_m2.principal_kg_m2();
    let message = "NacYIner, about the yaw axis, is the only moment of inertia of the nacelle in ElastoDyn; therefore the moments of inertia of the rotor-nacelle assembly are not those of a real body, which is not an input error";
    (largest > least + middle).then(|| Note::new(message))
}

/// The state of the rotor, with the inertia that acts on the nacelle.
fn rotor_message(shaft: &Shaft, lock: RotorLock) -> String {
    let [locked, felt] = [RotorLock::Locked, lock].map(|lock| match shaft.felt_by_nacelle(lock) {
        0.0 => "0 kg m2".to_owned(),
        inertia => format!("{inertia:.4e} kg m2"),
    });
    match lock {
        RotorLock::Locked => {
            let has_factor = shaft.generator != 0.0 && shaft.ratio.abs() != 1.0;
            let once = match has_factor {
                true => ", in which GenIner counts once, without the factor GBRatio^2",
                false => "",
            };
            format!(
                "the rotor is parked (locked to the nacelle): the inertia about the shaft is {locked}{once}; use --rotor free for a rotor that rotates freely on its shaft"
            )
        }
        RotorLock::Free => format!(
            "the rotor is free: the inertia about the shaft is {felt} instead of {locked} of a parked rotor, so the RNA is not one rigid body"
        ),
    }
}
