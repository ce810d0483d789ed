#!/bin/sh
# Try the Fortran library as a program outside finds it: install it, run the tests of the kernel's parts against it, compile as
# docs/reference/fortran.md says, and build the examples by meson, CMake and fpm, whose numbers must agree.
# Needs gfortran, pkg-config, FFTW and OpenBLAS; meson, ninja, CMake and fpm come from PyPI where the system has not all of them.
# Usage: try_library.sh PYTHON FOLDER
set -eu
python=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)
prefix=$folder/installed
tools=$folder/tools
system=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin

# Whether the system has all of these tools.
has() {
    for tool in "$@"; do
        PATH=$system command -v "$tool" >/dev/null || return 1
    done
}

if has meson ninja cmake fpm; then
    own_python=$python
else
    own_python=$tools/bin/python
    [ -x "$tools/bin/fpm" ] || {
        "$python" -m venv "$tools"
        "$own_python" -m pip install --quiet --disable-pip-version-check "meson>=1.4" ninja cmake fpm
    }
fi
# no other environment's tools, libraries or paths
[ "${TRIED_ALONE:-}" ] || exec env -i TRIED_ALONE=1 HOME="$folder" LANG=C.UTF-8 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 \
    PATH="$tools/bin:$system" sh "$0" "$own_python" "$folder"

# meson setup BUILD ...; a build of before takes the options anew.
configure() {
    build=$1
    shift
    [ ! -f "$build/build.ninja" ] || set -- --reconfigure "$@"
    meson setup "$build" "$@"
}

echo "--- the library, without a warning"
configure "$folder/build" -Dpython=false -Dkernel_modules=true --werror --prefix="$prefix" --libdir=lib >"$folder/library.log"
meson install -C "$folder/build" >>"$folder/library.log" || { tail -n 40 "$folder/library.log"; exit 1; }
nm -D --defined-only "$prefix/lib/libpyworm.so" | awk '{ print $3 }' >"$folder/symbols"
if grep -v '^pyworm_' "$folder/symbols" | grep -v -E '^__pyworm_contact_(MOD_pyworm_|description_MOD_)'; then
    echo "symbols that are not the interface's" >&2
    exit 1
fi
echo "$(grep -c '^pyworm_' "$folder/symbols") symbols for C, $(grep -c -v '^pyworm_' "$folder/symbols") of the Fortran modules"

echo "--- programs of the kernel's parts"
configure "$folder/tests" tests/fortran/installed --pkg-config-path "$prefix/lib/pkgconfig" >"$folder/tests.log"
meson test -C "$folder/tests" --print-errorlogs >>"$folder/tests.log" || { tail -n 60 "$folder/tests.log"; exit 1; }
grep -E '^(Ok|Fail):' "$folder/tests.log"

echo "--- the documented lines"
rm -rf "$folder/documented"
mkdir "$folder/documented"
cp examples/fortran/dry_hertz.f90 "$folder/documented/program.f90"
awk '/To compile a program:$/ { on = 1; next } on && /^    / { print substr($0, 5); next } on && NF { exit }' \
    docs/reference/fortran.md | sed "s|/opt/pyworm|$prefix|" >"$folder/documented/lines.sh"
grep -q gfortran "$folder/documented/lines.sh"
(cd "$folder/documented" && cat lines.sh && sh -eu lines.sh)

echo "--- the examples"
mkdir -p "$folder/sources/examples"
cp -r fpm.toml fortran "$folder/sources"
cp -r examples/fortran examples/c "$folder/sources/examples"
cd "$folder/sources/examples/fortran"
configure "$folder/by-meson" --pkg-config-path "$prefix/lib/pkgconfig" >"$folder/examples.log"
meson compile -C "$folder/by-meson" >>"$folder/examples.log"
cmake -B "$folder/by-cmake" -D CMAKE_PREFIX_PATH="$prefix" >>"$folder/examples.log"
cmake --build "$folder/by-cmake" >>"$folder/examples.log"
FPM_FC=gfortran fpm install --profile release --prefix "$folder/by-fpm" >>"$folder/examples.log" 2>&1 ||
    { tail -n 40 "$folder/examples.log"; exit 1; }
for name in line_film rough_line thinning_line load_pulse warming_line thermal_point; do
    "$folder/by-meson/$name" >"$folder/$name.meson"
    "$folder/by-cmake/$name" >"$folder/$name.cmake"
    "$folder/by-fpm/bin/$name" >"$folder/$name.fpm"
    printf '%s: ' "$name"
    "$python" -c '
import re, sys
first, *others = [list(map(float, re.findall(r"\d\.\d+E[-+]\d+", open(name).read()))) for name in sys.argv[1:]]
off = max(abs(b / a - 1) for other in others for a, b in zip(first, other, strict=True) if a)
print(f"{len(first)} numbers differ by {off:.1e} at most")
raise SystemExit(not first or off > 1e-7)
' "$folder/$name.meson" "$folder/$name.cmake" "$folder/$name.fpm"
done
"$folder/by-meson/point_from_c" >"$folder/c.meson"
"$folder/by-cmake/point_from_c" | diff "$folder/c.meson" -
echo "the library can be used"
