#!/usr/bin/env bash
# Runs one CLI test: run.sh RAVEL NN-name.sh. The script runs in an empty folder with `ravel` on the
# PATH; its stdout must be NN-name.stdout and its exit code the number in NN-name.exit (0 without one).
# With RAVEL_CLI_WRITE=1 the expected files are written instead; read the diff before committing it.
set -u
ravel=$(realpath "$1")
script=$(realpath "$2")
expected=${script%.sh}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/work"
ln -s "$ravel" "$folder/bin/ravel"

cd "$folder/work" || exit 1
PATH="$folder/bin:$PATH" LC_ALL=C bash -u "$script" >"$folder/stdout" 2>"$folder/stderr"
code=$?

if [ "${RAVEL_CLI_WRITE:-0}" = 1 ]; then
    cp "$folder/stdout" "$expected.stdout"
    rm -f "$expected.exit"
    [ $code = 0 ] || echo $code >"$expected.exit"
    exit 0
fi
wanted=0
[ -e "$expected.exit" ] && wanted=$(cat "$expected.exit")
failed=0
if ! diff -u "$expected.stdout" "$folder/stdout"; then
    failed=1
fi
if [ "$code" != "$wanted" ]; then
    echo "exit code $code, expected $wanted"
    failed=1
fi
if [ $failed = 1 ]; then
    echo "stderr was:"
    cat "$folder/stderr"
fi
exit $failed
