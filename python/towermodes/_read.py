"""Reads towers."""

from __future__ import annotations

from os import fsdecode

from towermodes import _towermodes as _rust
from towermodes._checks import number_or_none, whole, word
from towermodes._tower import Tower

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os
    from typing import Literal


def read(
    path: str | bytes | os.PathLike[str],
    *,
    part: Literal["all", "tower", "monopile"] = "all",
    no_rna: bool = False,
    no_gravity: bool = False,
    clamped: bool = False,
    equilibrium: bool = False,
    rotor: Literal["locked", "free"] = "locked",
    member_ends: Literal["balance", "cut", "whole"] = "balance",
    bmodes_quirks: bool = False,
    tower_height_m: float | None = None,
    tower_base_m: float | None = None,
    subset: tuple[int, int] | None = None,
) -> Tower:
    """Reads a tower from a file; the format is recognized by content and name.

    The formats are those of the program: tower file (.toml), BModes deck (.bmi), ElastoDyn main or
    tower file (.dat, or the .fst that refers to it), windIO turbine (.yaml), HAWC2 _st.dat.

    Args:
        path: The file.
        part: The part of a windIO turbine that is read.
        no_rna: Omit the rotor-nacelle assembly.
        no_gravity: Omit gravity (no geometric stiffness); not for a floating tower, because
            buoyancy exists only with gravity.
        clamped: Clamp a tower of OpenFAST at its base, without the structure below it.
        equilibrium: Give the mooring lines of a floating platform their stiffness at the
            equilibrium of weights, buoyancy and lines, instead of the reference position.
        rotor: Whether the rotor of an ElastoDyn model, or of a tower file with `[drivetrain]`, is
            locked or free to rotate.
        member_ends: Ends of the members of the floating platform of a windIO turbine that begin at
            the axis of another member: at its surface (cut), at its axis (whole), or whole
            only if the sum of weight, buoyancy and mooring force is then closer to zero
            (balance). The file does not contain this choice.
        bmodes_quirks: Interpret a BModes deck exactly as BModes 3.00 does, with its known errors.
        tower_height_m: Height of the tower top above ground or sea level, m, of an ElastoDyn tower
            file that is read without its main file.
        tower_base_m: Height of the tower base, m, for such a file or a HAWC2 file.
        subset: Set and subset of a HAWC2 file.

    Returns:
        The tower. `Tower.notes` has the assumptions made when the file was read, and omitted data.

    Raises:
        TowerError: The file has mistakes; the exception has their places.
        ValueError: An option is unknown or has no effect on a file of this format.
        OSError: The file cannot be read.

    >>> import towermodes as tm
    >>> tm.read("examples/nrel-5mw.yaml", part="tower").height_m
    87.6
    """
    options: dict[str, object] = {
        "part": word("part", part),
        "no_rna": bool(no_rna),
        "no_gravity": bool(no_gravity),
        "clamped": bool(clamped),
        "equilibrium": bool(equilibrium),
        "rotor": word("rotor", rotor),
        "member_ends": word("member_ends", member_ends),
        "bmodes_quirks": bool(bmodes_quirks),
        "tower_height_m": number_or_none("tower_height_m", tower_height_m),
        "tower_base_m": number_or_none("tower_base_m", tower_base_m),
        "subset": None if subset is None else tuple(whole("subset", n, 1) for n in subset),
    }
    return Tower._of(_rust.read(fsdecode(path), options))
