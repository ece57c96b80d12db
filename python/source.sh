#!/usr/bin/env bash
# Builds the source package, target/wheels/*.tar.gz, and checks that it is complete: it is installed and used in an
# empty folder.
set -euo pipefail
cd "$(dirname "$0")/.."

target/python/bin/maturin sdist --out target/wheels 2> /dev/null
empty=$(mktemp -d)
trap 'rm -rf "$empty"' EXIT
cp target/wheels/*.tar.gz examples/nrel-5mw.toml "$empty"
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
