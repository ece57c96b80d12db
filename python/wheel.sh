#!/usr/bin/env bash
# Builds the wheel for any Linux since glibc 2.17 (2012) and any CPython since 3.10: target/wheels/*.whl. The linker is
# that of zig, which knows the symbols of old versions of glibc. Needs python/requirements-wheel.txt in target/python.
set -euo pipefail
cd "$(dirname "$0")/.."

export PATH=$PWD/target/python/bin:$PATH
texts=python/towermodes/THIRD-PARTY.txt
trap 'rm -f $texts' EXIT
.ci/licences texts $texts > /dev/null
# Only the wheel of this version stays.
rm -rf target/wheels
maturin build --profile dist --zig --compatibility manylinux_2_17 --out target/wheels
wheel=$(ls target/wheels/*.whl)
# All lines are read: a reader that stops early would end the listing with an error.
python3 -m zipfile -l "$wheel" | grep THIRD-PARTY.txt > /dev/null || { echo "$wheel has no THIRD-PARTY.txt"; exit 1; }
bytes=$(stat --format %s "$wheel")
echo "$wheel: $bytes bytes"
if [ "$bytes" -gt 8000000 ]; then
    echo "the wheel has more than 8 MB"
    exit 1
fi
