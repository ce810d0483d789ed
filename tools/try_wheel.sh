#!/bin/sh
# Install the wheel for one Python into a bare Debian without compiler, and run it there; as root, with debootstrap.
# Usage: tools/try_wheel.sh PYTHON DIRECTORY ROOT
set -eu
python=$1
directory=$2
root=$3

fail() {
    echo "pyworm: $*" >&2
    exit 1
}

tag=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
wheel=$(echo "$directory"/pyworm-*-"$tag"-*.whl)
[ -f "$wheel" ] || fail "one wheel for $tag is needed in $directory: make wheel; there is $wheel"
[ "$(id -u)" = 0 ] || fail "a root for Debian needs root's rights"
command -v debootstrap >/dev/null || fail "install debootstrap"

# From where this machine has its own packages.
site=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
    awk '$2 !~ /-/ && $3 == "main" { print $2, $1; exit }')
if [ ! -x "$root/usr/bin/python3" ]; then
    # shellcheck disable=SC2086  name and address are two words
    debootstrap --variant=minbase --include=python3-venv,ca-certificates ${site% *} "$root" ${site#* } \
        >"$root.log" 2>&1 || fail "debootstrap failed, see $root.log"
fi
! chroot "$root" sh -c 'command -v gfortran gcc cc pkg-config' || fail "there is a compiler in $root"
! find "$root/usr/lib" -name 'libgfortran*' -o -name 'libfftw3*' -o -name 'libopenblas*' | grep . ||
    fail "$root has libraries of the wheel's own"

# Debian's own Python, or this machine's where the version is another one, in the same place.
version=$("$python" -c 'import sys; print("python%d.%d" % sys.version_info[:2])')
there=/usr/bin/$version
if [ ! -x "$root$there" ]; then
    prefix=$("$python" -c 'import sys; print(sys.base_prefix)')
    there=$prefix/bin/$version
    mkdir -p "$root$prefix"
    [ -x "$root$there" ] || cp -a "$prefix/." "$root$prefix"
fi
echo "--- $wheel, $there"

# Packages come through this machine's pip, so that the root needs no network settings of its own.
rm -rf "$root/wheels" "$root/try"
"$python" -m pip download --quiet --disable-pip-version-check --only-binary=:all: --dest "$root/wheels" "$wheel"
mount --bind /proc "$root/proc" # for the processor's features
trap 'umount "$root/proc"' EXIT
mkdir "$root/try"
cp cases/point_m20_l10.toml cases/zi_sharif_2001.toml "$root/try"
env -i PATH=/usr/sbin:/usr/bin:/bin HOME=/try LANG=C.UTF-8 chroot "$root" sh -euc '
    cd /try
    "$1" -m venv venv
    venv/bin/pip install --quiet --no-index --find-links /wheels pyworm
    venv/bin/pyworm doctor
    venv/bin/pyworm run point_m20_l10.toml --accuracy 10% --out out
    venv/bin/pyworm run zi_sharif_2001.toml --phase 0.5 --accuracy 10% --out zi
    venv/bin/pyworm explore zi/result.nc
' sh "$there"
