#!/usr/bin/env bash
# Builds the wheel for any Linux since glibc 2.17 (2012) and any CPython since 3.10.
#
# `zig` is the linker that knows the symbols of old versions of glibc; it comes from PyPI.
set -euo pipefail
cd "$(dirname "$0")/.."

# Zig is started in the folder of a crate: its path must not depend on the folder.
bin=$(realpath "$(dirname "$(command -v target/python/bin/maturin || command -v maturin)")")
PATH=$bin:$PATH
rustup target add "$(uname -m)-unknown-linux-gnu" 2> /dev/null || true
# Only the wheel of this version stays.
rm -rf target/wheels
maturin build --profile dist --zig --compatibility manylinux_2_17 --out target/wheels
wheel=$(ls target/wheels/*.whl)
bytes=$(stat --format %s "$wheel")
echo "$wheel: $bytes bytes"
if [ "$bytes" -gt 8000000 ]; then
    echo "the wheel has more than 8 MB"
    exit 1
fi
