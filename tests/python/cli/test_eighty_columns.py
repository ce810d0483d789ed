"""What commands print fits a terminal of 80 columns, without a broken word."""

import re
from dataclasses import fields
from functools import partial

import pytest
from swept_cycle import cycle_result
from zi_drives import quickly_described

from pyworm.batch.wear_run import WearFigures
from pyworm.cli import wear
from pyworm.cli.main import main
from pyworm.io.console import Console
from pyworm.ratings.standard_loss import NoStandard, StandardLoss
from pyworm.report.console.mesh_cycle import cycle_table, loss_table
from pyworm.report.console.summary import summary_table
from pyworm.result.mesh_cycle import drive_cycle

RULES = re.compile(r"[─━┃│┏┓┗┛┡┩└┘┳┻┴╇]+")

SWEEP = """
title = "Film over load"
case = "{root}/cases/point_m20_l10.toml"
effects = "isothermal"

[fixed]
accuracy = "20 %"

[[vary]]
"contact.load" = ["2 N", "4 N"]
"""


def words(text):
    """Words of a printed text, without the lines of tables."""
    return set(RULES.sub(" ", text).split())


def printed_at(width, print_it, monkeypatch, capsys):
    """What is printed on a terminal of a width."""
    monkeypatch.setenv("COLUMNS", str(width))
    capsys.readouterr()
    print_it()
    return capsys.readouterr().out


def fits(print_it, monkeypatch, capsys):
    """See that no line is longer than 80 letters, and that every word is one of the widest terminal's."""
    wide = printed_at(400, print_it, monkeypatch, capsys)
    narrow = printed_at(80, print_it, monkeypatch, capsys)
    lines = [line.rstrip() for line in narrow.splitlines()]
    assert not [
        line for line in lines if len(line) > 80 and not line.startswith(("Results", "Pic"))
    ]
    assert words(narrow) - words(wide) == set()
    return narrow


@pytest.mark.parametrize(
    ("case", "options"),
    [
        ("point_m20_l10", ["--accuracy", "10%"]),
        ("zi_sharif_2001", ["--accuracy", "20%", "--phase", "0.5"]),
    ],
)
def test_a_contact(case, options, tmp_path, monkeypatch, capsys, request):
    quickly_described(monkeypatch)
    arguments = ["run", str(request.config.rootpath / f"cases/{case}.toml"), *options]
    arguments += ["--pictures", "none", "--out", str(tmp_path)]
    said = fits(partial(main, arguments), monkeypatch, capsys)
    order = ["Lubrication regime", "Minimum film thickness", "riction coefficient", "Neglected"]
    assert sorted(map(said.index, order)) == list(map(said.index, order))
    assert said.index("Neglected") < said.index("Load ")


def test_a_sweep(tmp_path, monkeypatch, capsys, request):
    path = tmp_path / "loads.toml"
    path.write_text(SWEEP.format(root=request.config.rootpath))
    fits(partial(main, ["sweep", str(path), "--out", str(tmp_path)]), monkeypatch, capsys)


@pytest.mark.parametrize("case", ["oil_zi", "errichello_speed_increaser"])
def test_ratings(case, monkeypatch, capsys, request):
    arguments = ["rate", str(request.config.rootpath / f"cases/{case}.toml")]
    fits(partial(main, arguments), monkeypatch, capsys)


@pytest.mark.parametrize("standard", [NoStandard("none"), StandardLoss(0.03, 0.88, 567.8, "book")])
def test_a_mesh_cycle(standard, monkeypatch, capsys):
    result = cycle_result((0.1, 0.3, 0.5, 0.7, 0.9))
    cycle = drive_cycle(result)

    def show():
        console = Console()
        console.print(summary_table(result.solutions, cycle, None))
        console.print(cycle_table(cycle, ("worm", "wheel")))
        console.print(loss_table(cycle, standard, None))

    said = fits(show, monkeypatch, capsys)
    assert said.index("Efficiency") < said.index("Whole mesh cycle")


def test_wear(monkeypatch, capsys):
    steps = [
        WearFigures(**{field.name: size for field in fields(WearFigures)} | {"hours": hours})
        for size, hours in ((1.234e-6, 0.5), (5.678e-5, 12345.0))
    ]
    fits(partial(wear._show, steps), monkeypatch, capsys)
