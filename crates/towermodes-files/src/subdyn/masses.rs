//! The table of concentrated masses: 5 columns, or 11 with products of inertia and an offset.

use towermodes::{Inertia, RigidBody};

use super::rows::{Ids, Row};
use crate::diagnostic::Diagnostic;

const MOMENTS: [&str; 4] = ["JMass", "JMXX", "JMYY", "JMZZ"];
const OTHERS: [&str; 6] = ["JMXY", "JMXZ", "JMYZ", "MCGX", "MCGY", "MCGZ"];

/// The bodies and their joints.
pub(super) fn masses(
    rows: &[Row<'_>],
    joints: &Ids,
) -> Result<Vec<(usize, RigidBody)>, Diagnostic> {
    rows.iter().map(|row| mass(row, joints)).collect()
}

fn mass(row: &Row<'_>, joints: &Ids) -> Result<(usize, RigidBody), Diagnostic> {
    let joint = joints.find(row, 0, "CMJointID")?;
    let [mass_kg, xx, yy, zz] = row.numbers_from(1, MOMENTS)?;
    let [xy, xz, yz, x, y, z] = match row.numbers() {
        5 => [0.0; 6],
        11.. => row.numbers_from(5, OTHERS)?,
        _ => {
            let hint = "a mass has CMJointID, JMass, JMXX, JMYY, JMZZ, and since OpenFAST 2.4 also JMXY, JMXZ, JMYZ, MCGX, MCGY, MCGZ";
            return Err(row.wrong_count("5 or 11", hint));
        }
    };
    let body = RigidBody {
        mass_kg,
        center_m: [x, y, z],
        inertia_kg_m2: Inertia::from([xx, yy, zz, xy, xz, yz]),
    };
    Ok((joint, body))
}
