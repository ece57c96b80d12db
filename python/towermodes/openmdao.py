"""Towers as components of OpenMDAO.

This module needs `openmdao`: `pip install ".[openmdao]"` in the root of the repository.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import openmdao.api as om
from openmdao.utils.units import valid_units

from towermodes import SolveError, Tower, TowerError
from towermodes._names import EXAMPLE, mode_name


class TowerModes(om.ExplicitComponent):  # type: ignore[misc]
    """Mass and natural frequencies of a tower as functions of its input values.

    Outputs are `mass_kg`, `Tower.structure_mass_kg` of the tower, and a
    frequency for each mode, with the name of its column in a sweep: `fore_aft_1_hz`, `surge_hz`.
    The frequencies are extrapolated, as `SweepResult.frequency_hz`. Partial derivatives are those
    of `Tower.sensitivities`, computed from the modes and not from differences of solved towers.

    Args:
        tower: The tower; its input values are the initial values of the inputs.
        inputs: Names of OpenMDAO variables, and the input value of the tower that each variable
            sets: `{"wall_base": "stations[0].wall", "walls": "scale(stations[*].wall)"}`. The
            initial value is 1 for a factor (`scale`) and 0 for an increment (`add`).
        modes: Names of modes: `[("fore-aft", 1), "side-side 1"]`.
        segments: Number of segments, 20 by default, as in `Tower.sweep`.

    Raises:
        ValueError: A mode has no such name; in the setup, if the tower has no such input value, or
            if an input would set several values that are not equal.
        AnalysisError: In a run, if the input values do not describe a tower that can be solved, or
            if a frequency has no derivative.

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
        self.options.declare("inputs", types=Mapping, check_valid=check_inputs)
        self.options.declare("modes", types=Sequence, check_valid=check_modes)
        self.options.declare("segments", types=int, default=20)

    def setup(self) -> None:
        """Declares inputs, outputs and partial derivatives."""
        tower: Tower = self.options["tower"]
        self._varied = {}
        for variable, change in self.options["inputs"].items():
            varied = self._varied[variable] = Varied.of(tower, change)
            self.add_input(variable, val=varied.initial(), units=unit_of(varied.unit))
        # Refuses changes that contradict each other.
        tower.with_({varied.change: varied.initial() for varied in self._varied.values()})
        self._frequencies = {}
        self.add_output("mass_kg", val=tower.structure_mass_kg, units="kg")
        for mode in self.options["modes"]:
            family, order, column = mode_name(mode)
            self._frequencies[f"{column}_hz"] = (family, order)
            self.add_output(f"{column}_hz", val=1.0, units="Hz")
        self.declare_partials("*", "*")

    def compute(self, inputs: Any, outputs: Any) -> None:
        """Solves the tower with the values of the inputs."""
        table = {varied.change: inputs[name] for name, varied in self._varied.items()}
        result = self.options["tower"].sweep(
            table,
            modes=list(self._frequencies.values()),
            segments=self.options["segments"],
            threads=1,
        )
        for _, reason in result.failures:
            raise om.AnalysisError(reason)
        outputs["mass_kg"] = result.mass_kg
        for output, mode in self._frequencies.items():
            outputs[output] = result.mode(*mode)

    def compute_partials(self, inputs: Any, partials: Any) -> None:
        """Derivatives of mass and frequencies for the values of the inputs."""
        changes = [
            (varied, float(inputs[variable].item())) for variable, varied in self._varied.items()
        ]
        weights = chain_rule(changes)
        try:
            tower = self.options["tower"].with_({varied.change: v for varied, v in changes})
            found = tower.sensitivities(
                sorted({name for terms in weights for name in terms}),
                modes=list(self._frequencies.values()),
                segments=self.options["segments"],
            )
        except (TowerError, SolveError) as error:
            raise om.AnalysisError(str(error)) from error
        rows = {name: row for row, name in enumerate(found.names)}
        for variable, terms in zip(self._varied, weights, strict=True):
            for number, mode, reason in found.missing:
                if terms.get(number):
                    message = f"the frequency of {mode[0]} {mode[1]} has no derivative with \
respect to {variable} ({number}): {reason}"
                    raise om.AnalysisError(message)
            partials["mass_kg", variable] = sum(
                weight * found.mass_kg_per_unit[rows[name]] for name, weight in terms.items()
            )
            for output, mode in self._frequencies.items():
                column = found.mode(*mode)
                partials[output, variable] = sum(
                    weight * column[rows[name]] for name, weight in terms.items() if weight
                )


class Varied(NamedTuple):
    """The input values of the tower that an input changes."""

    change: str
    """The text in the argument `inputs`."""
    operation: str
    """`set`, `scale` or `add`."""
    numbers: dict[str, float]
    """The names of the input values, and the values in the original tower."""
    unit: str
    """The unit of the input."""

    @classmethod
    def of(cls, tower: Tower, change: str) -> Varied:
        """The input values of a

        change. Raises:
            ValueError: There is no such input value, or the change sets values that are not equal.
        """
        operation, numbers, unit = tower._core.change(change)
        different = sorted({value for _, value in numbers})
        if operation == "set" and len(different) > 1:
            listed = ",".join(name for name, _ in numbers) if "," in change else change
            message = f"{change} would set numbers from {different[0]:g} to {different[-1]:g} to \
one value; use scale({listed}) or add({listed}) for all, or one input for each"
            raise ValueError(message)
        return cls(change, operation, dict(numbers), unit)

    def initial(self) -> float:
        """The value that leaves the tower unchanged."""
        neutral = {"scale": 1.0, "add": 0.0}
        return neutral.get(self.operation, next(iter(self.numbers.values())))


def chain_rule(changes: Sequence[tuple[Varied, float]]) -> list[dict[str, float]]:
    """For each input, the input values of the tower that it changes, and their change per unit.

    The derivative with respect to the input is the sum of the weights times the derivatives with
    respect to these input values. An input whose values no other input changes is differentiated
    as a whole, because heights at which two rows meet have a derivative only together.
    """
    values: dict[str, float] = {}
    weights: list[dict[str, float]] = []
    for varied, value in changes:
        own = {}
        for name, original in varied.numbers.items():
            before = values.get(name, original)
            own[name] = before if varied.operation == "scale" else 1.0
            if varied.operation == "scale":
                for earlier in weights:
                    if name in earlier:
                        earlier[name] *= value
            values[name] = {"set": value, "scale": before * value, "add": before + value}[
                varied.operation
            ]
        weights.append(own)
    uses = Counter(name for terms in weights for name in terms)
    for (varied, value), terms in zip(changes, weights, strict=True):
        if all(uses[name] == 1 for name in varied.numbers):
            if varied.operation != "scale":
                terms.clear()
                terms[varied.change] = 1.0
            elif value != 0.0:
                # The changed tower has the factor already.
                terms.clear()
                terms[varied.change] = 1.0 / value
    return weights


def check_inputs(name: str, value: Mapping[str, str]) -> None:
    """Refuses inputs that change nothing."""
    if not value:
        message = f'{name} is empty; name the numbers that vary: {{"rna_mass": "rna.mass"}}'
        raise ValueError(message)


def check_modes(name: str, value: Sequence[Any]) -> None:
    """Refuses unknown names of modes."""
    if isinstance(value, str) or not value:
        message = f"{name} is {value!r}; it must be a list of names of modes: {EXAMPLE}"
        raise ValueError(message)
    for mode in value:
        mode_name(mode)


def unit_of(unit: str) -> str | None:
    """A unit as OpenMDAO writes it: `N m` is `N*m`, `kg/m3` is `kg/m**3`."""
    written = re.sub(r"(?<=[a-z])(\d)", r"**\1", unit.replace(" ", "*")).replace("degrees", "deg")
    return written if written and valid_units(written) else None
