#!/usr/bin/env bash
# Installs the libraries of a build elsewhere, moves them, and builds somebody else's project against
# them: by find_package, by pkg-config, and from source by add_subdirectory without the encoder.
#   consumer_test.sh BUILD SOURCE CXX C
set -euo pipefail
build=$1 source=$2 cxx=$3 c=$4
here=$source/tests/api/consumer
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

configure() {  # FOLDER arguments...
    local folder=$1
    shift
    cmake -S "$here" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_C_COMPILER="$c" \
        -DCMAKE_BUILD_TYPE=Debug "$@" >"$folder.log" 2>&1 || { cat "$folder.log"; return 1; }
    cmake --build "$folder" >>"$folder.log" 2>&1 || { cat "$folder.log"; return 1; }
}
expect() {  # SENTENCE command...
    local sentence=$1 got
    shift
    got=$("$@" 2>&1) || true
    [ "$got" = "$sentence" ] || { echo "expected: $sentence"; echo "got: $got"; exit 1; }
}

cmake --install "$build" --component library --prefix "$work/first" >install.log
mv first prefix # nothing may remember where it was installed

configure found -DCMAKE_PREFIX_PATH="$work/prefix"
found/write_cpp quad.ravel
expect "4 points, 1 cells" found/read_c quad.ravel
expect "not_a_ravel_file: this is not a ravel file (its first bytes are not \"Rav1\")" found/read_c

PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name ravel.pc)")
export PKG_CONFIG_PATH
if command -v pkg-config >/dev/null; then
    "$c" "$here/read_c.c" -o by_pc $(pkg-config --cflags --libs ravel_decode)
    expect "4 points, 1 cells" ./by_pc quad.ravel
    "$cxx" -std=c++20 "$here/write_cpp.cpp" -o write_by_pc $(pkg-config --cflags --libs ravel)
    ./write_by_pc again.ravel
    cmp quad.ravel again.ravel
else
    echo "no pkg-config here: ravel.pc is not tried"
fi

configure subfolder -DRAVEL_SOURCE="$source" -DREADER_ONLY=ON
expect "4 points, 1 cells" subfolder/read_c quad.ravel
[ ! -e subfolder/ravel/codec/encode ] || { echo "the reader alone has built the encoder"; exit 1; }
echo "a consumer builds and runs by find_package, pkg-config and add_subdirectory"
