#!/bin/sh
# Install what building and running pyworm needs: system packages (only those missing), then a virtual
# environment with all the rest. Called by the Makefile; usage: tools/setup.sh PYTHON VENV
set -eu
python=$1
venv=$2

fail() {
    echo "pyworm: $*" >&2
    exit 1
}

# Debian names of what is missing. Asked of the tools themselves, not of the package manager: a compiler
# from elsewhere serves as well.
missing() {
    command -v gfortran >/dev/null || echo gfortran
    echo '#include <stdio.h>' | cc -E - >/dev/null 2>&1 || echo gcc libc6-dev
    if command -v pkg-config >/dev/null; then
        pkg-config --exists 'fftw3 >= 3.3' 'fftw3f >= 3.3' || echo libfftw3-dev
        pkg-config --exists openblas || echo libopenblas-dev
    else
        echo pkg-config libfftw3-dev libopenblas-dev
    fi
    "$python" -c 'import ensurepip, venv' 2>/dev/null || echo python3-venv
    "$python" -c '
import pathlib, sysconfig
raise SystemExit(not pathlib.Path(sysconfig.get_path("include"), "Python.h").is_file())
' || echo python3-dev
}

command -v "$python" >/dev/null || fail "there is no $python; install Python 3.11 or newer"
"$python" -c 'import sys; raise SystemExit(sys.version_info < (3, 11))' ||
    fail "$("$python" --version) is too old; name a newer one: make PYTHON=python3.11"

# shellcheck disable=SC2046,SC2116  lines become words
packages=$(echo $(missing))
if [ -n "$packages" ]; then
    by_hand="install $packages (their Debian names), then run make again"
    if ! command -v apt-get >/dev/null; then
        fail "$by_hand"
    elif [ "$(id -u)" = 0 ]; then
        root=
    elif ! command -v sudo >/dev/null; then
        fail "neither root nor sudo: let an administrator $by_hand"
    elif [ -t 0 ]; then
        root=sudo
    else
        root="sudo -n"
    fi
    echo "Installing $packages" >&2
    # shellcheck disable=SC2086  root and packages are lists of words
    {
        $root apt-get update -qq &&
            $root env DEBIAN_FRONTEND=noninteractive \
                apt-get install -qq -y --no-install-recommends $packages
    } || fail "apt-get failed: $by_hand"
    packages=$(echo $(missing))
    [ -z "$packages" ] || fail "for $(command -v "$python"), $by_hand"
fi

[ -x "$venv/bin/python" ] || "$python" -m venv "$venv"
PATH=$(cd "$venv/bin" && pwd):$PATH
pip() { "$venv/bin/python" -m pip --quiet --disable-pip-version-check "$@"; }

# An editable install rebuilds itself on import, for which what it was built with must stay: no isolation.
"$venv/bin/python" -c '
import tomllib
with open("pyproject.toml", "rb") as file:
    print(*tomllib.load(file)["build-system"]["requires"], "ninja", sep="\n")
' >"$venv/build-requirements.txt"
pip install --requirement "$venv/build-requirements.txt"
pip install --no-build-isolation --editable ".[dev]"
