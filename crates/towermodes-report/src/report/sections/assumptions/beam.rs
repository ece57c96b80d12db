//! The beam theory.

use towermodes::tower::Motion;
use towermodes::{Method, Shear, Tower};

use super::super::super::content::ReportContent;
use crate::number::given;

/// The beam theory, why it neglects an effect, and which motions it has.
pub(super) fn beam(content: &ReportContent) -> String {
    let (tower, options) = (&content.tower, &content.options);
    let is_bmodes = options.method == Method::Bmodes;
    let shears = tower.shears() && !is_bmodes;
    let rotates = options.has_rotary_inertia() && tower.has_rotary_inertia();
    let theory = match (shears, rotates) {
        (true, true) => {
            "a Timoshenko beam with shear deformation and rotary inertia of the sections"
        }
        (true, false) => {
            "a beam with shear deformation but without rotary inertia of the sections in bending"
        }
        (false, true) => {
            "a Rayleigh beam: Euler-Bernoulli bending with rotary inertia of the sections, without shear deformation"
        }
        (false, false) => {
            "an Euler-Bernoulli beam without shear deformation and rotary inertia of the sections"
        }
    };
    let sentences = [
        format!("The tower is {theory}{}.", coefficient(content, shears)),
        left_out(content).to_owned(),
        other_motions(tower).to_owned(),
    ];
    let said = sentences.into_iter().filter(|text| !text.is_empty());
    said.collect::<Vec<String>>().join(" ")
}

/// The source of the shear stiffness.
fn coefficient(content: &ReportContent, shears: bool) -> String {
    if !shears {
        return String::new();
    }
    if content.tower.stations().is_empty() {
        return "; the shear stiffness is given by the table".to_owned();
    }
    match content.description.shear {
        Shear::Cowper => {
            "; shear coefficient by Cowper (1966) for the tube of each section".to_owned()
        }
        Shear::Coefficient(kappa) => format!("; the shear coefficient is {}", given(kappa)),
        Shear::Rigid => String::new(),
    }
}

/// Effects that the method or the user neglects, or that the input does not contain.
fn left_out(content: &ReportContent) -> &'static str {
    let (tower, options) = (&content.tower, &content.options);
    match (tower.has_rotary_inertia(), options.method, tower.shears()) {
        (true, Method::Bmodes, true) => {
            "The element of BModes has neither: rotary inertia and shear stiffness of the input are neglected."
        }
        (true, Method::Bmodes, false) => {
            "The element of BModes has no rotary inertia: the rotary inertia of the input is neglected."
        }
        (false, Method::Bmodes, true) => {
            "The element of BModes has no shear deformation: the shear stiffness of the input is neglected."
        }
        (true, ..) if !options.rotary_inertia => {
            "The rotary inertia of the sections is neglected (--no-rotary-inertia)."
        }
        (false, ..) => "The table of the input has no rotary inertia.",
        _ => "",
    }
}

/// Whether torsion and axial deformation are included.
fn other_motions(tower: &Tower) -> &'static str {
    let is_rigid = |motion| tower.is_rigid_in(motion);
    match (is_rigid(Motion::Torsion), is_rigid(Motion::Axial)) {
        (false, false) => "Torsion and axial deformation are included.",
        (true, false) => "Axial deformation is included, torsion is not: GJ is infinite.",
        (false, true) => "Torsion is included, axial deformation is not: EA is infinite.",
        (true, true) => "Torsion and axial deformation are not included: GJ and EA are infinite.",
    }
}
