#!/usr/bin/env bash
# Makes the type stubs of the module in Rust, python/towermodes/_towermodes.pyi.
#
#   python/stubs.sh          writes them
#   python/stubs.sh check    compares them with those in the repository
set -euo pipefail
cd "$(dirname "$0")/.."

stubs=python/towermodes/_towermodes.pyi
maturin=$(command -v target/python/bin/maturin || command -v maturin)
new=$(mktemp -d)
trap 'rm -rf "$new"' EXIT
"$maturin" generate-stubs --features stubs --out "$new" > /dev/null
made=$(find "$new" -name '*.pyi')
{
    echo "# Made by python/stubs.sh; do not edit."
    cat "$made"
} > "$new/stubs"
if [ "${1:-}" = check ]; then
    diff -u "$stubs" "$new/stubs" || { echo "$stubs is not up to date; run python/stubs.sh"; exit 1; }
else
    cp "$new/stubs" "$stubs"
fi
