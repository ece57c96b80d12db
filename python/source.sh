#!/usr/bin/env bash
# Checks that the source package is complete: it is built in an empty folder, installed and used.
set -euo pipefail
cd "$(dirname "$0")/.."

maturin=$(command -v target/python/bin/maturin || command -v maturin)
empty=$(mktemp -d)
trap 'rm -rf "$empty"' EXIT
"$maturin" sdist --out "$empty" 2> /dev/null
cp examples/nrel-5mw.toml "$empty"
cd "$empty"
python3 -m venv environment
# What is left out of the package is missed here.
environment/bin/pip install --quiet --disable-pip-version-check ./*.tar.gz
environment/bin/towermodes solve nrel-5mw.toml > /dev/null
environment/bin/python -c '
import towermodes as tm
assert tm.read("nrel-5mw.toml").solve().certified
'
echo "the source package is complete"
