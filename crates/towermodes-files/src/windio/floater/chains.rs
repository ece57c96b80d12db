//! Mass and stiffness of chains and ropes from their diameter, if the file gives no values.
//!
//! Source: Orcina (2023), OrcaFlex documentation, properties of chain, rope and wire from their
//! nominal diameter; WISDEM uses the same numbers.

use towermodes::mooring::LineType;

/// A kind: its names in files, and the factors on d² for mass (kg/m³) and stiffness (Pa).
type Known = (&'static [&'static str], f64, f64);

const KINDS: [Known; 7] = [
    (&["chain"], 19.9e3, 8.54e10),
    (&["chain_stud"], 21.9e3, 1.01e11),
    (&["nylon"], 0.6476e3, 1.18e8),
    (&["polyester"], 0.7978e3, 1.09e9),
    (&["polypropylene"], 0.4526e3, 1.06e9),
    (&["wire", "fiber", "wire_fiber"], 3.6109e3, 3.67e10),
    (&["wire_wire", "iwrc"], 3.9897e3, 4.04e10),
];

/// The diameter of a cylinder that displaces as much water as a chain, as a multiple of the nominal
/// diameter of the chain.
const CHAIN_VOLUME: f64 = 1.8;
/// Largest bar diameter of a chain, m.
const LARGEST_CHAIN_M: f64 = 0.25;

/// A line type from its kind and diameter (m), and a text on how it was computed; none for an
/// unknown kind.
pub(super) fn by_diameter(kind: &str, diameter_m: f64) -> Option<(LineType, String)> {
    let plain = kind.to_ascii_lowercase();
    let (names, mass, stiffness) = KINDS
        .iter()
        .find(|known| known.0.contains(&plain.as_str()))?;
    let is_chain = names[0].starts_with("chain");
    let is_volume = is_chain && diameter_m > LARGEST_CHAIN_M;
    let (nominal_m, volume_m) = match (is_chain, is_volume) {
        (true, true) => (diameter_m / CHAIN_VOLUME, diameter_m),
        (true, false) => (diameter_m, CHAIN_VOLUME * diameter_m),
        (false, _) => (diameter_m, diameter_m),
    };
    let reading = match (is_chain, is_volume) {
        (true, true) => format!(
            "no chain is made of bars of {diameter_m} m, so this is the diameter of equal volume and the nominal one is {nominal_m:.4} m"
        ),
        (true, false) => {
            format!(
                "taken as the nominal diameter; the diameter of equal volume is {volume_m:.4} m"
            )
        }
        (false, _) => "the nominal diameter".to_owned(),
    };
    let square = nominal_m * nominal_m;
    let line_type = LineType::new(volume_m, mass * square, stiffness * square);
    Some((line_type, reading))
}
