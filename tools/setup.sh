#!/bin/sh
# Install what building and running pyworm needs: system packages (only those missing), then a virtual
# environment with all the rest. Called by the Makefile; usage: tools/setup.sh PYTHON VENV [library | browser]
# With "library" what the kernel for Fortran and C programs needs alone: compilers, libraries, meson and ninja.
# With "browser" Chromium alone, for the tests of pages, which are skipped without it: its lack is no failure.
set -eu
python=$1
venv=$2
wanted=${3:-package}

fail() {
    echo "pyworm: $*" >&2
    [ "$wanted" != browser ] || exit 0
    exit 1
}

# Whether there is a browser for the tests of pages (tests/support/browser.py).
can_browse() {
    command -v chromium || command -v chromium-browser || command -v google-chrome
}

# Requirements of the build in pyproject.toml: all, or meson alone.
build_requirements() {
    "$python" -c '
import re, sys, tomllib
with open("pyproject.toml", "rb") as file:
    required = tomllib.load(file)["build-system"]["requires"]
print(*(one for one in required if re.match(sys.argv[1], one)), "ninja", sep="\n")
' "$1"
}

# Whether there are a meson as new as meson.build asks for, and ninja.
can_build() {
    command -v meson >/dev/null && command -v ninja >/dev/null || return 1
    meson --version | "$python" -c '
import re, sys
numbers = lambda text: tuple(map(int, re.findall(r"\d+", text)))[:2]
asked = re.search(r"meson_version: .>=([\d.]+)", open("meson.build").read())[1]
raise SystemExit(numbers(sys.stdin.read()) < numbers(asked))
'
}

# Debian names of what is missing. Asked of the tools themselves, not of the package manager: a compiler
# from elsewhere serves as well.
missing() {
    if [ "$wanted" = browser ]; then
        can_browse >/dev/null || echo chromium
        return
    fi
    command -v gfortran >/dev/null || echo gfortran
    echo '#include <stdio.h>' | cc -E - >/dev/null 2>&1 || echo gcc libc6-dev
    if command -v pkg-config >/dev/null; then
        pkg-config --exists 'fftw3 >= 3.3' 'fftw3f >= 3.3' || echo libfftw3-dev
        pkg-config --exists openblas || echo libopenblas-dev
    else
        echo pkg-config libfftw3-dev libopenblas-dev
    fi
    [ "$wanted" = library ] && can_build && return
    "$python" -c 'import ensurepip, venv' 2>/dev/null || echo python3-venv
    [ "$wanted" = library ] && return
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

[ "$wanted" = browser ] && exit 0
if [ "$wanted" = library ] && can_build; then
    exit 0
fi
[ -x "$venv/bin/python" ] || "$python" -m venv "$venv"
PATH=$(cd "$venv/bin" && pwd):$PATH
pip() { "$venv/bin/python" -m pip --quiet --disable-pip-version-check "$@"; }

if [ "$wanted" = library ]; then
    build_requirements 'meson[^-]' >"$venv/build-requirements.txt"
    pip install --requirement "$venv/build-requirements.txt"
    exit 0
fi
# An editable install rebuilds itself on import, for which what it was built with must stay: no isolation.
build_requirements '' >"$venv/build-requirements.txt"
pip install --requirement "$venv/build-requirements.txt"
# The kernel is for this machine alone.
pip install --no-build-isolation --editable ".[dev]" --config-settings=setup-args=-Dmarch=native
