"""Natural frequencies and mode shapes of wind turbine towers.

Each frequency has an error estimate, and a certificate proves that no mode is missing.

>>> import towermodes as tm
>>> tower = tm.read("examples/nrel-5mw.toml")
>>> solution = tower.solve(modes=4)
>>> solution.mode("fore-aft", 1).frequency_hz
0.3214632...
>>> solution.certified
True

`read` reads towers from any file that the program reads, `Tower` makes them from input
values; `Tower.solve` computes the modes. Units are part of the names: `height_m`, `frequency_hz`.
x is fore-aft (downwind), y side-side, z up.
"""

import atexit

from towermodes import _towermodes
from towermodes._campbell import Campbell
from towermodes._convert import Converted
from towermodes._damping import Damping
from towermodes._errors import Mistake, OptionError, SolveError, TowerError
from towermodes._first_order import FirstOrder
from towermodes._found import Calibration, Design
from towermodes._mooring import MooringAtRest, solve_mooring
from towermodes._picture import Picture
from towermodes._read import read
from towermodes._sensitivity import Sensitivities
from towermodes._solution import Mode, Solution
from towermodes._study import Agreement, Comparison, Examination
from towermodes._substructure import SubstructureModes, solve_substructure
from towermodes._sweep import SweepResult
from towermodes._tower import Tower
from towermodes._towermodes import VERSION as __version__
from towermodes._turbine import Turbine, TurbineCampbell, TurbineModes

__all__ = [
    "Agreement",
    "Calibration",
    "Campbell",
    "Comparison",
    "Converted",
    "Damping",
    "Design",
    "Examination",
    "FirstOrder",
    "Mistake",
    "Mode",
    "MooringAtRest",
    "OptionError",
    "Picture",
    "Sensitivities",
    "Solution",
    "SolveError",
    "SubstructureModes",
    "SweepResult",
    "Tower",
    "TowerError",
    "Turbine",
    "TurbineCampbell",
    "TurbineModes",
    "__version__",
    "read",
    "solve_mooring",
    "solve_substructure",
]



def __getattr__(name: str) -> object:
    # This module needs another package.
    if name == "openmdao":
        from importlib import import_module

        return import_module("towermodes.openmdao")
    message = f"module 'towermodes' has no attribute {name!r}"
    raise AttributeError(message)


# A thread that still computes then must not come back into an interpreter that has ended.
atexit.register(_towermodes.close)
