#!/bin/sh
# Install a wheel into a bare Debian without compiler, and run it there; as root, with debootstrap.
# Usage: tools/try_wheel.sh WHEEL ROOT
set -eu
wheel=$1
root=$2

fail() {
    echo "pyworm: $*" >&2
    exit 1
}

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

# Packages come through this machine's pip, so that the root needs no network settings of its own.
rm -rf "$root/wheels" "$root/try"
python3 -m pip download --quiet --disable-pip-version-check --only-binary=:all: --dest "$root/wheels" "$wheel"
mount --bind /proc "$root/proc" # for the processor's features
trap 'umount "$root/proc"' EXIT
mkdir "$root/try"
cp cases/point_m20_l10.toml cases/zi_sharif_2001.toml "$root/try"
env -i PATH=/usr/sbin:/usr/bin:/bin HOME=/try LANG=C.UTF-8 chroot "$root" sh -euc '
    cd /try
    python3 -m venv venv
    venv/bin/pip install --quiet --no-index --find-links /wheels pyworm
    venv/bin/pyworm doctor
    venv/bin/pyworm run point_m20_l10.toml --accuracy 10% --out out
    venv/bin/pyworm run zi_sharif_2001.toml --phase 0.5 --accuracy 10% --out zi
'
