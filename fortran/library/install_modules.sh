#!/bin/sh
# Install module files, which meson leaves among the objects; usage: install_modules.sh BUILD INCLUDE facade|all
set -eu
include=${DESTDIR:-}$2
mkdir -p "$include"
facade=$(find "$1" -name pyworm_contact.mod | head -n 1)
cp "$facade" "$include/"
[ "$3" = all ] || exit 0
mkdir -p "$include/pyworm-kernel"
cp "$(dirname "$facade")"/*.mod "$include/pyworm-kernel/"
