"""Towers as components of OpenMDAO.

This module needs `openmdao`: `pip install ".[openmdao]"` in the root of the repository.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import openmdao.api as om
from openmdao.utils.units import valid_units

from towermodes import Tower

#: Relative step of the central differences: frequencies have about ten digits in common between
#: neighbouring towers, so the differences have seven.
STEP = 1e-4

#: Families with one mode each, so the columns of a sweep have no order.
RIGID = ("surge", "sway", "heave", "roll", "pitch", "yaw")


class TowerModes(om.ExplicitComponent):  # type: ignore[misc]
    """Mass and natural frequencies of a tower as functions of its numbers.

    Outputs are `mass_kg`, the mass of the tower without the rotor-nacelle assembly, and a
    frequency for each mode, with the name of its column in a sweep: `fore_aft_1_hz`, `surge_hz`.
    The frequencies are extrapolated, as `SweepResult.frequency_hz`. Partial derivatives are central
    differences.

    Args:
        tower: The tower; its numbers are the initial values of the inputs.
        inputs: Names of OpenMDAO variables, and the number of the tower that each one sets:
            `{"wall_base": "stations[0].wall", "walls": "scale(stations[*].wall)"}`. The initial
            value is 1 for a factor (`scale`) and 0 for an increment (`add`).
        modes: Names of modes: `[("fore-aft", 1), ("side-side", 1)]`.
        segments: Number of segments, 20 by default, as in `Tower.sweep`.

    Raises:
        ValueError: In the setup, if the tower has no such number.
        AnalysisError: In a run, if the numbers do not describe a tower that can be solved.

    >>> import openmdao.api as om
    >>> import towermodes as tm
    >>> from towermodes.openmdao import TowerModes
    >>> problem = om.Problem(reports=False)
    >>> component = TowerModes(
    ...     tower=tm.read("examples/nrel-5mw.toml"),
    ...     inputs={"rna_mass": "rna.mass"},
    ...     modes=[("fore-aft", 1)],
    ... )
    >>> _ = problem.model.add_subsystem("tower", component)
    >>> _ = problem.setup()
    >>> problem.run_model()
    >>> print(round(problem.get_val("tower.fore_aft_1_hz").item(), 4))
    0.3215
    """

    def initialize(self) -> None:
        """Declares the options."""
        self.options.declare("tower", types=Tower, recordable=False)
        self.options.declare("inputs", types=Mapping)
        self.options.declare("modes", types=Sequence)
        self.options.declare("segments", types=int, default=20)

    def setup(self) -> None:
        """Declares inputs, outputs and partial derivatives."""
        tower: Tower = self.options["tower"]
        values, units = tower.parameters, tower.parameter_units
        neutral = {}
        for variable, change in self.options["inputs"].items():
            neutral[change], unit = initial(change, values, units)
            self.add_input(variable, val=neutral[change], units=unit)
        # Refuses unknown names and changes that contradict each other.
        tower.with_(neutral)
        self.add_output("mass_kg", val=tower.mass_kg, units="kg")
        for mode in self.options["modes"]:
            self.add_output(output(mode), val=1.0, units="Hz")
        self.declare_partials("*", "*", method="fd", form="central", step=STEP, step_calc="rel")

    def compute(self, inputs: Any, outputs: Any) -> None:
        """Solves the tower with the values of the inputs."""
        changes = self.options["inputs"]
        modes = list(self.options["modes"])
        table = {change: inputs[variable] for variable, change in changes.items()}
        result = self.options["tower"].sweep(
            table, modes=modes, segments=self.options["segments"], threads=1
        )
        for _, reason in result.failures:
            raise om.AnalysisError(reason)
        outputs["mass_kg"] = result.mass_kg
        for mode in modes:
            outputs[output(mode)] = result.mode(*mode)


def output(mode: tuple[str, int]) -> str:
    """The output of a mode: `("fore-aft", 1)` is `fore_aft_1_hz`, `("surge", 1)` is `surge_hz`."""
    family, order = mode
    if family in RIGID:
        return f"{family}_hz"
    return f"{family.replace('-', '_')}_{order}_hz"


def initial(
    change: str, values: Mapping[str, float], units: Mapping[str, str]
) -> tuple[float, str | None]:
    """The value and the unit of a change that leaves the tower as it is."""
    operation, name = re.fullmatch(r"(?:(scale|add)\()?(.*?)\)?", change).groups()  # type: ignore[union-attr]
    every = re.compile(re.escape(name).replace(r"\*", r"\d+"))
    found = [number for number in values if every.fullmatch(number)]
    if operation == "scale":
        return 1.0, None
    unit = unit_of(units[found[0]]) if found else None
    return (0.0 if operation == "add" or not found else values[found[0]]), unit


def unit_of(unit: str) -> str | None:
    """A unit as OpenMDAO writes it: `N m` is `N*m`, `kg/m3` is `kg/m**3`."""
    written = re.sub(r"(?<=[a-z])(\d)", r"**\1", unit.replace(" ", "*")).replace("degrees", "deg")
    return written if written and valid_units(written) else None
