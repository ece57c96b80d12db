//! The foundation of a tower of a deck.

use std::ops::Range;

use towermodes::space::{SpatialMatrix, add_scaled};
use towermodes::{
    FloatingPlatform, Foundation, Inertia, Place, ReferredMatrix, StiffnessFoundation,
};

use super::super::records::deck::{Deck, HubConnection, MatrixValue, Offshore};
use super::building::{Building, MAIN};
use super::matrix::{about_base, asymmetry, symmetrized, without_axial_and_torsion};
use super::notes::Notes;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::places::TABLE;

/// Sets the foundation: the support of the base.
pub(crate) fn foundation(
    deck: &Deck,
    building: &mut Building,
    notes: &mut Notes,
) -> Result<(), Diagnostic> {
    let hub = &deck.general.hub;
    building.foundation_at(TABLE, &hub.span);
    let offshore = deck.support.offshore.as_deref();
    building.description.foundation = match (hub.value, offshore) {
        (HubConnection::Clamped, _) => Foundation::Clamped,
        (_, None) => on_springs(hub.value, StiffnessFoundation::default()),
        (HubConnection::Free, Some(offshore)) if offshore.mass_kg.value > 0.0 => {
            building.remember_platform(offshore);
            let platform = Platform::of(offshore, notes)?.floating(offshore);
            Foundation::Floating(Box::new(platform))
        }
        (_, Some(offshore)) => {
            building.foundation_at("matrix", &offshore.mooring_stiffness.span());
            building.foundation_at("mass", &offshore.hydro_mass.span());
            let base_m = building.ends.base_m;
            let about_base = Platform::of(offshore, notes)?.about_base(offshore, base_m);
            check_finite(&about_base, offshore)?;
            on_springs(hub.value, about_base)
        }
    };
    Ok(())
}

impl Building {
    fn foundation_at(&mut self, key: &'static str, span: &Range<usize>) {
        self.places
            .remember(Place::Foundation { key }, MAIN, span.clone());
    }

    fn remember_platform(&mut self, offshore: &Offshore) {
        self.foundation_at("mass", &offshore.mass_kg.span);
        self.foundation_at("center", &offshore.cm_depth_m.span);
        self.foundation_at("inertia", &offshore.inertia_kg_m2.span());
        self.foundation_at("added_mass", &offshore.hydro_mass.span());
        self.foundation_at("hydrostatic", &offshore.hydro_stiffness.span());
        self.foundation_at("mooring", &offshore.mooring_stiffness.span());
    }
}

/// The matrices of an offshore block, symmetric.
struct Platform {
    inertia: [[f64; 3]; 3],
    added_mass: SpatialMatrix,
    hydrostatic: SpatialMatrix,
    mooring: SpatialMatrix,
}

impl Platform {
    fn of(offshore: &Offshore, notes: &mut Notes) -> Result<Self, Diagnostic> {
        Ok(Self {
            inertia: symmetric(&offshore.inertia_kg_m2, "i_matrix_pform", notes)?,
            added_mass: symmetric(&offshore.hydro_mass, "hydro_M", notes)?,
            hydrostatic: symmetric(&offshore.hydro_stiffness, "hydro_K", notes)?,
            mooring: symmetric(&offshore.mooring_stiffness, "mooring_K", notes)?,
        })
    }

    fn floating(self, offshore: &Offshore) -> FloatingPlatform {
        let height_m = 0.0 - offshore.reference_depth_m.value;
        let referred = |matrix| ReferredMatrix { matrix, height_m };
        FloatingPlatform {
            mass_kg: offshore.mass_kg.value,
            center_m: [0.0, 0.0, 0.0 - offshore.cm_depth_m.value],
            inertia_kg_m2: Inertia::from_tensor(self.inertia),
            added_mass: referred(self.added_mass),
            added_mass_by_frequency: None,
            hydrostatic: referred(self.hydrostatic),
            mooring: referred(self.mooring),
            mooring_lines: None,
            buoyancy: None,
            at_equilibrium: false,
        }
    }

    /// All stiffness and all inertia about the tower's base.
    fn about_base(self, offshore: &Offshore, base_m: f64) -> StiffnessFoundation {
        let reference_m = 0.0 - offshore.reference_depth_m.value;
        let mut stiffness = self.hydrostatic;
        add_scaled(&mut stiffness, 1.0, &self.mooring);
        let mut body = SpatialMatrix::default();
        for i in 0..3 {
            body[i][i] = offshore.mass_kg.value;
            body[3 + i][3..].copy_from_slice(&self.inertia[i]);
        }
        let mut inertia = about_base(body, 0.0 - offshore.cm_depth_m.value, base_m);
        let added_mass = about_base(self.added_mass, reference_m, base_m);
        add_scaled(&mut inertia, 1.0, &added_mass);
        StiffnessFoundation {
            stiffness: about_base(stiffness, reference_m, base_m),
            inertia,
        }
    }
}

/// Springs and inertia at the base; with `hub_conn` 3 vertical motion and torsion are fixed.
fn on_springs(hub: HubConnection, about_base: StiffnessFoundation) -> Foundation {
    let mut foundation = about_base;
    if hub == HubConnection::AxiallyAndInTorsion {
        foundation.stiffness = without_axial_and_torsion(&foundation.stiffness);
        foundation.inertia = without_axial_and_torsion(&foundation.inertia);
        foundation.stiffness[2][2] = f64::INFINITY;
        foundation.stiffness[5][5] = f64::INFINITY;
    }
    Foundation::Stiffness(Box::new(foundation))
}

/// A matrix made symmetric, with a note if it was not.
fn symmetric<const N: usize>(
    matrix: &MatrixValue<N>,
    name: &str,
    notes: &mut Notes,
) -> Result<[[f64; N]; N], Diagnostic> {
    let symmetric = symmetrized(matrix, name)?;
    if let Some(pair) = asymmetry(&matrix.rows) {
        let message = format!(
            "{name} is not symmetric (row {i}, column {j} is {}, row {j}, column {i} is {}); BModes 3.00 uses the asymmetric matrix; here the mean of both entries is used, because the matrix of a linear spring or mass is symmetric",
            pair.upper,
            pair.lower,
            i = pair.row,
            j = pair.column,
        );
        notes.at(
            matrix.spans[pair.column - 1].start,
            Note::compatibility(message),
        );
    }
    Ok(symmetric)
}

/// Infinity means that the base is fixed; an overflow must not become infinity.
fn check_finite(foundation: &StiffnessFoundation, offshore: &Offshore) -> Result<(), Diagnostic> {
    let matrices = [
        (
            &foundation.stiffness,
            &offshore.mooring_stiffness,
            "stiffness",
        ),
        (&foundation.inertia, &offshore.hydro_mass, "inertia"),
    ];
    for (matrix, written, what) in matrices {
        if matrix.iter().flatten().any(|entry| !entry.is_finite()) {
            let what = format!("the {what} about the tower's base");
            return Err(Diagnostic::new(
                written.span(),
                DiagnosticKind::Overflow { what },
            ));
        }
    }
    Ok(())
}
