//! The tower of a tower file in the model of ElastoDyn.

use towermodes::Planes;
use towermodes_analysis::elastodyn::{
    ConcentratedMass as ListedMass, PlaneModes, TowerModel, TowerPolynomial, TowerStation,
};

use super::tower_input::tower_file::{ConcentratedMass, TowerFile, TowerRow};
use crate::input::ModalValues;

impl TowerFile {
    /// The damping and the tuners of the modes.
    pub(super) fn modal_values(&self) -> ModalValues {
        ModalValues {
            damping_percent: Planes {
                fore_aft: self.fore_aft_damping_percent,
                side_side: self.side_side_damping_percent,
            },
            tuners: Planes {
                fore_aft: self.fore_aft_tuners,
                side_side: self.side_side_tuners,
            },
        }
    }

    /// The modes of the tower file.
    pub fn modes(&self) -> Planes<PlaneModes> {
        let [fa1, fa2, ss1, ss2] = self
            .coefficients
            .map(|coefficients| TowerPolynomial { coefficients });
        Planes {
            fore_aft: PlaneModes {
                shapes: [fa1, fa2],
                tuners: self.fore_aft_tuners,
                damping_percent: self.fore_aft_damping_percent,
            },
            side_side: PlaneModes {
                shapes: [ss1, ss2],
                tuners: self.side_side_tuners,
                damping_percent: self.side_side_damping_percent,
            },
        }
    }

    /// The model for a flexible length (m), a number of elements and a mass (kg) on top, without
    /// gravity.
    pub fn model(
        &self,
        flexible_length_m: f64,
        nodes: usize,
        tower_top_mass_kg: f64,
    ) -> TowerModel {
        let masses = self.concentrated_masses.iter().map(listed_mass);
        TowerModel {
            flexible_length_m,
            nodes,
            stations: self.rows_to_the_top().map(station).collect(),
            mass_factor: self.mass_factor,
            stiffness_factors: Planes {
                fore_aft: self.fore_aft_factor,
                side_side: self.side_side_factor,
            },
            concentrated_masses: masses.collect(),
            tower_top_mass_kg,
            gravity_m_per_s2: 0.0,
        }
    }
}

fn station(row: TowerRow) -> TowerStation {
    TowerStation {
        height_fraction: row.height_fraction,
        mass_kg_per_m: row.mass_kg_per_m,
        bending_n_m2: Planes {
            fore_aft: row.fore_aft_n_m2,
            side_side: row.side_side_n_m2,
        },
    }
}

fn listed_mass(mass: &ConcentratedMass) -> ListedMass {
    ListedMass {
        height_fraction: mass.height_fraction,
        mass_kg: mass.mass_kg,
    }
}
