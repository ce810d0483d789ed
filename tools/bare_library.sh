#!/bin/sh
# Try the Fortran library (try_library.sh) in a bare Debian that has the packages named in docs/reference/fortran.md and fpm, then
# compare what its examples print with the kernel called from Python here. As root, with debootstrap.
# Usage: tools/bare_library.sh PYTHON ROOT
set -eu
python=$1
root=$2

fail() {
    echo "pyworm: $*" >&2
    exit 1
}

[ "$(id -u)" = 0 ] || fail "a root for Debian needs root's rights"
command -v debootstrap >/dev/null || fail "install debootstrap"
packages=$(sed -n 's/^ *apt install //p' docs/reference/fortran.md | tr ' ' ',')
[ -n "$packages" ] || fail "docs/reference/fortran.md names no packages"

if [ ! -x "$root/usr/bin/gfortran" ]; then
    debootstrap --variant=minbase --include="$packages" bookworm "$root" >"$root.log" 2>&1 ||
        fail "debootstrap failed, see $root.log"
fi
# Debian has no fpm: its program out of the wheel.
if [ ! -x "$root/usr/local/bin/fpm" ]; then
    "$python" -m pip download --quiet --disable-pip-version-check --no-deps --dest "$root/opt" fpm
    "$python" -m zipfile -e "$root"/opt/fpm-*.whl "$root/opt/fpm"
    chmod +x "$root/opt/fpm/fpm/fpm"
    ln -sf /opt/fpm/fpm/fpm "$root/usr/local/bin/fpm"
fi

rm -rf "$root/pyworm"
mkdir "$root/pyworm"
tar -c fpm.toml meson.build meson_options.txt fortran examples tests/fortran tools docs/reference/fortran.md |
    tar -x -C "$root/pyworm"
mount --bind /proc "$root/proc" # for the processor's features
trap 'umount "$root/proc"' EXIT
env -i PATH=/usr/sbin:/usr/bin:/bin chroot "$root" sh -euc 'cd /pyworm && sh tools/try_library.sh python3 /pyworm/tried'
echo "--- the kernel called from Python"
"$python" -m pytest -q -n 0 tests/python/test_same_grid.py --printed "$root/pyworm/tried"
