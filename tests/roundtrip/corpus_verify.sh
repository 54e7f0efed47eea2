#!/usr/bin/env bash
# Packs, unpacks and compares every real mesh, and winds it onto one strip per component.
#   corpus_verify.sh RAVEL FOLDER      FOLDER holds quad/ and tet/; exit code 77 where it does not exist
# Prints one line a mesh and a summary; RAVEL_JOBS (2) meshes at a time.
set -u

check_one() {
    local ravel=$1 mesh=$2 out problems="" start=$SECONDS
    for options in --lossless "--position-bits 14"; do
        # shellcheck disable=SC2086
        out=$("$ravel" -q verify "$mesh" $options --json 2>&1)
        [ $? = 0 ] && grep -q '"equal": true' <<<"$out" || problems+=" verify $options: $(tail -1 <<<"$out");"
    done
    out=$("$ravel" -q strip "$mesh" --json 2>&1)
    [ $? = 0 ] || problems+=" strip: $(tail -1 <<<"$out");"
    local strips components added
    strips=$(sed -n 's/^ *"strips": \([0-9]*\),*$/\1/p' <<<"$out")
    components=$(sed -n 's/^ *"components": \([0-9]*\),*$/\1/p' <<<"$out")
    added=$(sed -n 's/^ *"added_cells_percent": \([0-9.e+-]*\),*$/\1/p' <<<"$out")
    [ -n "$strips" ] && [ "$strips" = "$components" ] || problems+=" $strips strips in $components components;"
    if [ -z "$problems" ]; then
        echo "ok     $(basename "$mesh"): equal twice, $strips strips, $(printf %.3f "$added") % cells added, $((SECONDS - start)) s"
    else
        echo "FAILED $(basename "$mesh"):$problems"
    fi
}

if [ "$1" = --one ]; then
    check_one "$2" "$3"
    exit 0
fi

ravel=$1
folder=${2:-}
if [ -z "$folder" ] || [ ! -d "$folder/quad" ]; then
    echo "SKIPPED: there are no real meshes here (set RAVEL_CORPUS to the folder with their unpack script)"
    exit 77
fi
# A TetGen mesh is its .ele file; .node and .face come along.
report=$(mktemp)
trap 'rm -f "$report"' EXIT
find "$folder/quad" "$folder/tet" -type f ! -name '*.node' ! -name '*.face' ! -name '*.edge' |
    LC_ALL=C sort | xargs -d '\n' -P "${RAVEL_JOBS:-2}" -n 1 "$0" --one "$ravel" | tee "$report"
total=$(grep -c . "$report")
failed=$(grep -c '^FAILED' "$report")
echo "$((total - failed)) of $total real meshes come back equal on one strip per component"
[ "$failed" = 0 ] && [ "$total" -gt 0 ]
