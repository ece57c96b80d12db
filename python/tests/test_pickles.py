"""Pickles of results: data that is not computed again."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import towermodes as tm

DESIGN = "crates/towermodes-cli/tests/inputs/design/mass.toml"
MEASURED = "crates/towermodes-cli/tests/inputs/measured/tower.toml"


def results(tower: tm.Tower) -> list[Any]:
    turbine = tm.read("examples/nrel-5mw-turbine.toml").turbine
    assert turbine is not None
    return [
        tower.solve(modes=3, points=11, heights_m=[10.0]),
        tower.campbell(margin=0.1),
        tower.damping({"tower": 0.004}, modes=2),
        tower.compare("rmje", segments=20, modes=2),
        tower.check(tower),
        tower.examine(),
        tower.convert("bmodes"),
        tower.design(DESIGN),
        tower.calibrate(MEASURED),
        tower.first_order("examples/studies/uncertainty.toml"),
        tower.sweep({"rna.mass": [3e5, -1.0]}),
        tower.sensitivities(["rna.mass"], modes=2),
        turbine.modes(6.0, 0.5),
        turbine.campbell([0.0, 6.0], limit_hz=0.5),
    ]


def values(result: Any) -> dict[str, Any]:
    """All public properties, and what methods without arguments return."""
    found = {}
    for name in dir(type(result)):
        if name.startswith("_") or name in ("tower", "turbine", "plot", "modes"):
            continue
        value = getattr(result, name)
        if not callable(value):
            found[name] = value
        elif name.startswith("to_"):
            found[name] = value()
    return found


def same(first: Any, second: Any) -> bool:
    if isinstance(first, dict):
        return first.keys() == second.keys() and all(same(first[k], second[k]) for k in first)
    if isinstance(first, np.ndarray):
        return np.array_equal(first, second, equal_nan=first.dtype.kind == "f")
    return repr(first) == repr(second)


def test_a_pickle_has_all_values_and_computes_nothing(
    nrel: tm.Tower, monkeypatch: pytest.MonkeyPatch
) -> None:
    for result in results(nrel):
        pickled = pickle.dumps(result)
        computes = type(result).__dict__.get("_compute")
        if computes is not None:
            monkeypatch.setattr(type(result), "_compute", None)
        again = pickle.loads(pickle.dumps(pickle.loads(pickled)))
        assert type(again) is type(result)
        assert repr(again) == repr(result)
        before, after = values(result), values(again)
        assert before.keys() == after.keys()
        for name, value in before.items():
            if isinstance(result, tm.Agreement) and name == "to_json":
                continue
            assert same(value, after[name]), (type(result), name)
        monkeypatch.undo()


def test_arrays_of_a_pickle_do_not_change(nrel: tm.Tower) -> None:
    solution = pickle.loads(pickle.dumps(nrel.solve(modes=2)))
    swept = pickle.loads(pickle.dumps(nrel.sweep({"rna.mass": [3e5]})))
    derived = pickle.loads(pickle.dumps(nrel.sensitivities(["rna.mass"])))
    for array in (
        solution.frequency_hz,
        solution.shape,
        solution.modes[0].shape,
        swept.frequency_hz,
        swept.inputs["rna.mass"],
        derived.hz_per_unit,
    ):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0.0


def test_the_picture_and_the_tower_of_a_pickle(nrel: tm.Tower) -> None:
    solution = nrel.solve(modes=2)
    again = pickle.loads(pickle.dumps(solution))
    assert again.plot() == solution.plot()
    assert again.mode("fore-aft", 1).shape.tolist() == solution.mode("fore-aft", 1).shape.tolist()
    design = nrel.design(DESIGN)
    found = pickle.loads(pickle.dumps(design)).tower
    assert found == design.tower
