#!/usr/bin/env bash
# unchanged.sh RAVEL_GOLDEN GOLDENS: does this build pack and unpack as all others do?
set -uo pipefail
now=$(mktemp)
trap 'rm -f "$now"' EXIT
"$1" >"$now" || exit 1
# zstd's version stands in the first line; the sections before zstd do not depend on it.
if ! diff <(tail -n +2 "$2") <(tail -n +2 "$now"); then
    echo "The format or the encoder moved, or this machine packs otherwise. If it was meant to move:"
    echo "tests/golden/matrix --write"
    exit 1
fi
