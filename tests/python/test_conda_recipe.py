"""The recipe for conda-forge asks for what the package asks for."""

import re
import tomllib

import yaml
from folders import ROOT

RECIPE = yaml.safe_load((ROOT / "tools/conda-forge/recipe.yaml").read_text())
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())

ELSEWHERE = {"matplotlib": "matplotlib-base"}
"""Package by its name for pip -> as conda-forge calls it."""


def test_it_runs_with_what_the_package_needs():
    wanted = set()
    for of in PROJECT["project"]["dependencies"]:
        name, least = of.lower().split(">=")
        wanted.add(f"{ELSEWHERE.get(name, name)} >={least}")
    assert set(RECIPE["requirements"]["run"]) == wanted | {"python"}


def test_it_skips_pythons_that_the_package_refuses():
    oldest = PROJECT["project"]["requires-python"].removeprefix(">=")
    assert f'match(python, "<{oldest}")' in RECIPE["build"]["skip"]


def test_the_kernel_is_for_any_processor_and_its_options_are_known():
    (script,) = RECIPE["build"]["script"]
    options = (ROOT / "meson_options.txt").read_text()
    for name in re.findall(r"setup-args=-D(\w+)=", script):
        assert f"option('{name}'" in options
    assert "native" not in script and "-Dmarch=" in script
