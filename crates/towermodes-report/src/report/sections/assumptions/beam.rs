//! Which beam the tower is taken for.

use towermodes::tower::Motion;
use towermodes::{Method, Shear, Tower};

use super::super::super::content::ReportContent;
use crate::number::given;

/// Which beam it is, why it lacks what other beams have, and which motions it has.
pub(super) fn beam(content: &ReportContent) -> String {
    let (tower, options) = (&content.tower, &content.options);
    let is_bmodes = options.method == Method::Bmodes;
    let shears = tower.shears() && !is_bmodes;
    let rotates = options.has_rotary_inertia() && tower.has_rotary_inertia();
    let theory = match (shears, rotates) {
        (true, true) => "a Timoshenko beam: shear deformation and rotary inertia of the sections",
        (true, false) => {
            "a beam with shear deformation but without rotary inertia of the sections in bending"
        }
        (false, true) => {
            "a Rayleigh beam: Euler-Bernoulli bending with rotary inertia of the sections, no shear deformation"
        }
        (false, false) => {
            "an Euler-Bernoulli beam: neither shear deformation nor rotary inertia of the sections"
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

/// Where the shear stiffness is from.
fn coefficient(content: &ReportContent, shears: bool) -> String {
    if !shears {
        return String::new();
    }
    if content.tower.stations().is_empty() {
        return "; the shear stiffness is that of the table".to_owned();
    }
    match content.description.shear {
        Shear::Cowper => {
            "; the shear coefficient is that of Cowper (1966) for each section's tube".to_owned()
        }
        Shear::Coefficient(kappa) => format!("; the shear coefficient is {}", given(kappa)),
        Shear::Rigid => String::new(),
    }
}

/// What the input or its kind would have, but the method or the user left out.
fn left_out(content: &ReportContent) -> &'static str {
    let (tower, options) = (&content.tower, &content.options);
    match (tower.has_rotary_inertia(), options.method, tower.shears()) {
        (true, Method::Bmodes, true) => {
            "The element of BModes has neither, so the input's rotary inertia and shear stiffness are left out."
        }
        (true, Method::Bmodes, false) => {
            "The element of BModes has no rotary inertia, so that of the input's sections is left out."
        }
        (false, Method::Bmodes, true) => {
            "The element of BModes has no shear deformation, so the input's shear stiffness is left out."
        }
        (true, ..) if !options.rotary_inertia => {
            "The rotary inertia of the input's sections is left out, as asked (--no-rotary-inertia)."
        }
        (false, ..) => "The input's table gives the sections no rotary inertia.",
        _ => "",
    }
}

/// Whether it twists and stretches.
fn other_motions(tower: &Tower) -> &'static str {
    let is_rigid = |motion| tower.is_rigid_in(motion);
    match (is_rigid(Motion::Torsion), is_rigid(Motion::Axial)) {
        (false, false) => "It also twists and stretches.",
        (true, false) => "It also stretches, but does not twist: its GJ is infinite.",
        (false, true) => "It also twists, but does not stretch: its EA is infinite.",
        (true, true) => "It neither twists nor stretches: its GJ and EA are infinite.",
    }
}
