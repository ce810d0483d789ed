#!/bin/sh
# Install the facade's module file, which meson leaves among the objects; usage: install_module.sh BUILD INCLUDE
set -eu
include=${DESTDIR:-}$2
mkdir -p "$include"
cp "$(find "$1" -name pyworm_contact.mod | head -n 1)" "$include/"
