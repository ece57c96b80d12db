"""The program `towermodes`: `python -m towermodes` and the command of the package."""

from __future__ import annotations

import os
import signal
import sys

from towermodes._towermodes import run


def main() -> int:
    """Runs the program with the arguments of this process and returns its exit code."""
    _behave_as_a_program()
    return run(["towermodes", *sys.argv[1:]])


def _behave_as_a_program() -> None:
    # Ctrl-C ends the process; Python would wait for the end of the computation.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    # A closed stream becomes /dev/null, as in a program of Rust, so that no file gets its number.
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)


if __name__ == "__main__":
    sys.exit(main())
