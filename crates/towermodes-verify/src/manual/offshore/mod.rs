//! Structures in water.

mod fixed;
mod floating;
mod frames;
mod moorings;
mod summaries;

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "offshore",
    title: "Frames, moorings and floaters",
    introduction: "Substructures without tower, mooring systems at rest, and turbines on frames and floaters. The expected values are those of a \
        program written for this comparison, which assembles nodal elements into dense matrices: exact Timoshenko beams, the element of SubDyn, and \
        elastic catenaries solved by Newton's method. Only converged values are compared. Frequencies of SubDyn's own summaries follow at the \
        end. The models are those of the tests of FAST 8 (OC3 monopile, OC4 jacket, OC3-Hywind, OC4 semi-submersible) and of the IEA-15 turbine \
        (monopile, VolturnUS-S), with locked rotors and rigid blades. If the theory of that program differs from the theory of towermodes, the remark of the case describes the difference.",
};

const SOURCE: &str = "nodal elements, dense eigensolver";

pub(super) fn cases() -> Vec<Case> {
    let mut cases = frames::cases();
    cases.extend(fixed::cases());
    cases.extend(moorings::cases());
    cases.extend(floating::cases());
    cases.extend(summaries::cases());
    cases
}

/// A case of computed values in Hz or in the units of its quantities.
fn case(
    name: impl Into<String>,
    remark: &'static str,
    subject: Subject,
    expected: Vec<Expected>,
    allowance: f64,
) -> Case {
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: SOURCE,
        remark,
        subject,
        unit: Unit::HZ,
        digits: Digits::Computed,
        expected,
        runs: vec![Run::spectral().allowing(allowance)],
    }
}
