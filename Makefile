# Everything from a fresh clone: each target installs what it needs and is missing.

PYTHON ?= python3
VENV := .venv
INSTALLED := $(VENV)/.installed
DEBUG := build/debug
SANITIZED := build/sanitized
DOCS := $(VENV)/.docs-installed
PREFIX ?= $(CURDIR)/build/installed
WHEEL_PYTHONS ?= $(shell $(PYTHON) tools/pythons.py)
BARE ?= $(CURDIR)/build/bare
MARCH ?=
CLUSTER := $(VENV)/.cluster-installed
CONTACT := zi_sharif_2001
DRIVE := zi_drive

# The virtual environment's tools first: meson, ninja (which an editable install calls on import), pyworm.
export PATH := $(CURDIR)/$(VENV)/bin:$(PATH)
# One thread unless asked otherwise: times are comparable, and two libraries do not fight for the cores.
export OMP_NUM_THREADS ?= 1
export OPENBLAS_NUM_THREADS ?= 1

.PHONY: help install wheel try-wheel test-cluster fortran-library try-library bare-library fortran-docs demo test test-long test-fortran test-python browser sanitized hard mutants docs evidence lint tested release clean

help:
	@echo "make install  what the other targets need and is missing"
	@echo "make fortran-library  install the kernel for Fortran and C programs under PREFIX ($(PREFIX)), without Python"
	@echo "make try-library  install it apart, run the kernel's tests against it, build the examples by meson, CMake and fpm"
	@echo "make bare-library  as root: the same in a bare Debian with the documented packages alone, its films against Python's"
	@echo "make wheel    wheels that need no compiler, in dist/, for every Python found (WHEEL_PYTHONS for others)"
	@echo "make try-wheel  as root: install each of them in a bare Debian without compiler, and run it"
	@echo "make demo     run cases/$(CONTACT).toml at mid-mesh, then cases/$(DRIVE).toml over its whole cycle"
	@echo "make test     run the Fortran and the Python tests; installs Chromium for those of pages, by apt"
	@echo "make test-long  run the Python tests that take long, which make test leaves out"
	@echo "make test-cluster  as root: batches on a one-node Slurm, by Snakemake and dask-jobqueue; installs these"
	@echo "make sanitized  run the Fortran tests with checks of addresses and of undefined behaviour"
	@echo "make hard     run the suite of hard scenes; resumes (SCENE=thermal:37 for one, SEED=7 for others)"
	@echo "make hard SCENE=drive  random gear drives, run as a user does (drive:0-9 some; commands: through all commands)"
	@echo "make hard SCENE=explore, SCENE=killed  pages of 1000 mutated result files; a batch killed twenty times"
	@echo "make mutants  how many one-line mutations of the program tests see; resumes (MUTANT=name for one)"
	@echo "make docs     build the documentation as a site, build/docs/index.html; a warning fails it"
	@echo "make evidence  redo the short studies behind docs/evidence (DATA=name for those of some data)"
	@echo "make fortran-docs  build the documentation of the kernel by FORD, build/fortran-docs/index.html"
	@echo "make lint     run the linters"
	@echo "make release  check that this commit can be released: versions, changelog, date, tests, wheels"
	@echo "make clean    remove the virtual environment and all that was built (results stay)"

install: $(INSTALLED)

# Sources need no rule: the editable install rebuilds itself on import when they change.
$(INSTALLED): pyproject.toml meson.build tools/setup.sh
	tools/setup.sh $(PYTHON) $(VENV)
	@touch $@

# Needs meson, ninja, gfortran, FFTW and OpenBLAS alone; its own build, since the package's has the interpreter in it.
# MARCH=native is a library for this processor alone.
fortran-library:
	tools/setup.sh $(PYTHON) $(VENV) library
	meson setup build/library -Dpython=false -Dmarch=$(MARCH) --prefix=$(abspath $(PREFIX)) --libdir=lib \
	    $(if $(wildcard build/library/build.ninja),--reconfigure)
	meson install -C build/library

try-library:
	tools/setup.sh $(PYTHON) $(VENV) library
	tools/try_library.sh $(PYTHON) build/try-library

bare-library: $(INSTALLED)
	tools/bare_library.sh python $(BARE)-library

wheel: $(INSTALLED)
	set -e; for python in $(WHEEL_PYTHONS); do tools/wheel.sh $$python dist; done

try-wheel:
	set -e; for python in $(WHEEL_PYTHONS); do tools/try_wheel.sh $$python dist $(BARE); done

demo: $(INSTALLED)
	pyworm run cases/$(CONTACT).toml --phase 0.5 --out results/$(CONTACT)
	pyworm run cases/$(DRIVE).toml -j 2 --out results/$(DRIVE)

test: test-fortran test-python

$(DEBUG)/build.ninja: $(INSTALLED)
	meson setup $(DEBUG) --buildtype=debug --reconfigure

test-long: $(INSTALLED) browser
	python -m pytest -n 2 --dist loadfile -m long

test-fortran: $(DEBUG)/build.ninja
	meson test -C $(DEBUG) --suite fortran --print-errorlogs

$(SANITIZED)/build.ninja: $(INSTALLED)
	meson setup $(SANITIZED) --buildtype=debug -Db_sanitize=address,undefined -Db_lundef=false --reconfigure

# Checked code is slow: ten times the usual time for a test.
sanitized: $(SANITIZED)/build.ninja
	meson test -C $(SANITIZED) --suite fortran --timeout-multiplier 10 --print-errorlogs

# Where there is no Chromium and none can be installed, the tests of pages in a browser are skipped.
browser: $(INSTALLED)
	tools/setup.sh $(PYTHON) $(VENV) browser

test-python: $(INSTALLED) browser
	python -m pytest -n 2 --dist loadfile

$(CLUSTER): $(INSTALLED)
	apt-get install -qq -y --no-install-recommends slurmctld slurmd slurm-client munge
	python -m pip install --quiet --disable-pip-version-check \
	    dask-jobqueue snakemake snakemake-executor-plugin-cluster-generic
	@touch $@

test-cluster: $(CLUSTER)
	python -m pytest -rA tests/cluster

hard: $(INSTALLED)
	python tests/hard $(SCENE) $(if $(SEED),--seed $(SEED))

mutants: $(INSTALLED)
	python tests/mutants $(MUTANT)

$(DOCS): $(INSTALLED)
	python -m pip install --quiet --disable-pip-version-check --no-build-isolation --editable ".[docs]"
	@touch $@

docs: $(DOCS)
	mkdocs build

# What all studies take is listed in docs/evidence/reproduce.md.
evidence: $(INSTALLED)
	python benchmarks/evidence/reproduce.py $(DATA)

# FORD and mkdocs ask for different versions of Markdown.
build/ford/bin/ford: pyproject.toml
	$(PYTHON) -m venv build/ford
	build/ford/bin/python -m pip install --quiet --disable-pip-version-check "ford>=7"
	@touch $@

fortran-docs: build/ford/bin/ford
	build/ford/bin/ford fortran/ford.md

lint: $(INSTALLED)
	ruff check .
	ruff format --check .
	mypy
	basedpyright
	fortitude check fortran pyworm/kernel examples/fortran tests/fortran

# What .ci/run ends with, and make release asks for.
tested: $(INSTALLED)
	python tools/release.py --tested

release: $(INSTALLED)
	python tools/release.py

clean:
	rm -rf $(VENV) build .pytest_cache .ruff_cache .mypy_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
