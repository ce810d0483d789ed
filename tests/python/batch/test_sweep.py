"""Sweeps: every scene checked before the first, values alike on every machine, a table with a row a scene."""

import csv
import json
import re
import tomllib

import numpy as np
import pytest
from folders import CASES
from hypothesis import given
from hypothesis import strategies as st

import pyworm.batch.task
from pyworm.batch.solved_scenes import Store
from pyworm.batch.sweep import load_sweep
from pyworm.case.case import case_of
from pyworm.case.sweep import DrawTable, RangeTable, SweepTable
from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT, CONVERGED, NOT_CONVERGED
from pyworm.io.number_with_unit import parse_in
from pyworm.kernel.core import KernelError
from pyworm.plots.sweep import draw_sweep
from pyworm.report.console.sweep import rows_table
from pyworm.result.sweep_result import SweepResult, open_sweep, sweep_table

SHIPPED = sorted((CASES / "sweeps").glob("*.toml"))

LINE = f"""
title = "Films of a line contact"
case = "{CASES}/line_m20_l10.toml"

[fixed]
accuracy = "5 %"

[[vary]]
"contact.load" = ["100 kN/m", "200 kN/m"]

[[vary]]
"motion.velocity_1" = {{ start = "0.5 m/s", stop = "2 m/s", count = 3, scale = "log" }}
"motion.velocity_2" = ["0.4 m/s", "0.9 m/s", "1.9 m/s"]
"""


def written(directory, text, *changes):
    """A sweep file with passages replaced, once each."""
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path = directory / "films.toml"
    path.write_text(text)
    return path


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_every_shipped_sweep_is_right(path):
    # a seventh of each: worm teeth take seconds to check
    assert load_sweep(path, share=(1, 7)).tasks


def test_the_manual_shows_a_shipped_sweep():
    manual = (CASES.parent / "docs" / "how-to" / "run-batches.md").read_text()
    shown = re.search(r"```toml\n(.*?)```", manual, re.DOTALL)[1]
    assert tomllib.loads(shown) == tomllib.loads(SHIPPED[0].read_text())


def test_tables_are_crossed_and_keys_of_one_go_together(tmp_path):
    sweep = load_sweep(written(tmp_path, LINE))
    scenes = [task.scene for task in sweep.tasks]
    assert [scene.load for scene in scenes] == pytest.approx([100e3] * 3 + [200e3] * 3)
    once = [(0.5, 0.4), (1.0, 0.9), (2.0, 1.9)]
    assert [scene.velocities for scene in scenes] == [pytest.approx(pair) for pair in once * 2]
    assert {task.accuracy for task in sweep.tasks} == {0.05}
    assert sweep.axes == [["contact.load"], ["motion.velocity_1", "motion.velocity_2"]]
    assert len({task.key for task in sweep.tasks}) == 6


def test_places_of_a_case_are_scenes_of_a_sweep(tmp_path):
    text = f"""
title = "A drive"
case = "{CASES}/zi_sharif_2001.toml"
effects = "isothermal"
fixed = {{ "operation.phases" = [0.4, 0.6], accuracy = "5 %" }}
vary = [{{ "drive.hob.swivel" = ["0.2 deg", "0.3 deg"] }}]
"""
    sweep = load_sweep(written(tmp_path, text))
    assert [task.place.phase for task in sweep.tasks] == [0.4, 0.6, 0.4, 0.6]
    swivels = [values["drive.hob.swivel"] for values in sweep.values]
    assert swivels == ["0.2 deg", "0.2 deg", "0.3 deg", "0.3 deg"]
    assert sweep.tasks[0].case.drive.hob.swivel == pytest.approx(np.radians(0.2))


def test_one_entry_of_a_list_varies(tmp_path):
    text = f"""
title = "Radii"
case = "{CASES}/point_m20_l10.toml"
vary = [{{ "contact.radii[1]" = ["10 mm", "2 cm"] }}]
"""
    sweep = load_sweep(written(tmp_path, text))
    radii = [task.scene.radii for task in sweep.tasks]
    assert radii == [pytest.approx((0.01, 0.01)), pytest.approx((0.01, 0.02))]


def test_ranges_reach_both_ends_in_even_steps():
    linear = RangeTable(start="1 kN", stop="1500 N", count=3).values("load", None)
    assert linear == ["1 kN", "1.25 kN", "1.5 kN"]
    warm = RangeTable(start="40 degC", stop="80 degC", count=3).values("heat", None)
    assert warm == ["40 degC", "60 degC", "80 degC"]
    even = RangeTable(start=0.01, stop=100.0, count=5, scale="log").values("x", None)
    assert even == [0.01, 0.1, 1.0, 10.0, 100.0]
    assert RangeTable(start=3, stop=1, count=3).values("threads", None) == [3, 2, 1]
    assert all(isinstance(n, int) for n in RangeTable(start=1, stop=3, count=3).values("n", None))


@given(
    low=st.floats(1e-6, 1e6),
    ratio=st.floats(1.001, 1e4),
    seed=st.integers(0, 2**40),
    kind=st.sampled_from(["uniform", "log-uniform"]),
)
def test_draws_keep_to_their_ends_and_their_seed(low, ratio, seed, kind):
    def drawn(key="load", seed=seed, count=20):
        ends = {"low": f"{low!r} N", "high": f"{low * ratio!r} N"}
        texts = DrawTable(draw=kind, count=count, **ends).values(key, seed)
        return [parse_in(text, "N")[0] for text in texts]

    values = drawn()
    slack = 1e-11
    assert low * (1 - slack) <= min(values) and max(values) <= low * ratio * (1 + slack)
    assert values == drawn()
    assert drawn(count=50)[:20] == values
    assert drawn(key="speed") != values
    assert drawn(seed=seed + 1) != values


def test_draws_are_spread_as_they_say():
    """Quarters of the interval, of its logarithm, hold a quarter each: within 4 sigma of 4000 draws."""
    for kind, scale in (("uniform", lambda x: (x - 1) / 99), ("log-uniform", np.log10)):
        values = DrawTable(draw=kind, low=1.0, high=100.0, count=4000).values("x", 7)
        shares = scale(np.array(values)) / scale(100.0)
        counts = np.histogram(shares, bins=4, range=(0, 1))[0]
        assert abs(counts - 1000).max() < 4 * np.sqrt(4000 * 0.25 * 0.75)


def test_keys_of_one_table_fill_their_ranges_together():
    """Of 16 Sobol points each quarter of one range meets each quarter of the other once."""
    ends = {"draw": "sobol", "low": "1 N", "high": "16 N", "count": 16}
    speed = ends | {"low": 0.0, "high": 4.0}
    vary = [{"load": ends | {"scale": "log"}, "speed": speed}, {"x": [1, 2]}]
    tables = SweepTable(title="t", case="c", seed=4, vary=vary)
    (design, _) = tables.axes()
    loads = np.log2([float(load.removesuffix(" N")) for load in design["load"]])
    cells = {(int(load), int(speed)) for load, speed in zip(loads, design["speed"], strict=True)}
    assert len(cells) == 16
    assert tables.axes() == SweepTable(title="t", case="c", seed=4, vary=vary).axes()
    with pytest.raises(ValueError, match="count = 3: must be a power of two"):
        SweepTable(title="t", case="c", seed=4, vary=[{"load": ends | {"count": 3}}])


def test_draws_are_alike_on_every_machine():
    """A change of these numbers would silently orphan every sweep that was drawn before it."""
    drawn = DrawTable(draw="uniform", low="0 N", high="1 N", count=3).values("contact.load", 1)
    assert drawn == ["0.985843704632 N", "0.34558255994 N", "0.801501910173 N"]


BAD = [
    ("title =", "titel =", "titel: no such key; did you mean title?"),
    ('"contact.load" =', '"contact.lod" =', "contact.lod: no such key; did you mean load?"),
    ('"200 kN/m"]', '"-2 kN/m"]', 'with contact.load = "-2 kN/m", motion.velocity_1 = "0.5 m/s", '),
    ('"200 kN/m"]', '"-2 kN/m"]', 'contact.load = "-2 kN/m": must be a force per length greater'),
    ('"200 kN/m"]', '"2 kN"]', 'contact.load = "2 kN": must be a force per length with its unit'),
    (', "200 kN/m"', ', "1e20 kN/m"', "between 1e-3 N/m and 1e6 kN/m"),
    ('["100 kN/m", "200 kN/m"]', "[]", "vary[0].contact.load = []: has too few entries, at least"),
    ('["100 kN/m", "200 kN/m"]', "3", "vary[0].contact.load = 3: must be a list"),
    (
        ', "1.9 m/s"]',
        "]",
        "vary[1]: motion.velocity_1 has 3 values, motion.velocity_2 has 2 values",
    ),
    ("count = 3", "count = 0", "vary[1].motion.velocity_1.count = 0: must be greater than 0"),
    ("count = 3,", "", "vary[1].motion.velocity_1.count is missing"),
    ("count", "cuont", "vary[1].motion.velocity_1.cuont: no such key; did you mean count?"),
    ('"log"', '"cubic"', 'vary[1].motion.velocity_1.scale = "cubic": must be "linear" or "log"'),
    (
        'stop = "2 m/s"',
        'stop = "2 mm"',
        '0.5 m/s, 2 mm: must be in a unit of the same kind as "m/s',
    ),
    (
        'start = "0.5 m/s"',
        "start = 0.5",
        "start, stop = 0.5, 2 m/s: must be a number with its unit",
    ),
    ('"0.5 m/s"', '"-0.5 m/s"', "start, stop must be greater than zero on a logarithmic scale"),
    ("start =", 'draw = "uniform", low = "1 m/s", high = "2 m/s", start =', "no such key; valid"),
    (
        'start = "0.5 m/s", stop = "2 m/s", count = 3, scale = "log"',
        'draw = "uniform", low = "1 m/s", high = "2 m/s", count = 3',
        "seed is missing; motion.velocity_1 is drawn, give one such as seed = 1",
    ),
    (
        'start = "0.5 m/s", stop = "2 m/s", count = 3, scale = "log"',
        'draw = "uniform", low = "1 m/s", high = "2 m/s", count = 3, scale = "log"',
        'scale has no effect with draw = "uniform"',
    ),
    ("line_m20", "lime_m20", "lime_m20_l10.toml: no such file"),
    ("accuracy =", '"contact.load" = "1 N"\naccuracy =', "contact.load is given twice"),
    ('"5 %"', '"99 %"', "accuracy = 0.99: must be a relative error between 1e-5 and 0.5"),
    ('"contact.load"', '"contact..load"', 'must be a dotted key, such as "motion.velocity_1[0]"'),
    ('"contact.load"', '"contact.load[2]"', "the case has no list with a place [2] there"),
    ('"contact.load"', '"contact.load.x"', "the case has no table with x there"),
    (
        "[fixed]",
        'effects = "hot"\n[fixed]',
        'effects = "hot": hot is none of auto, all, isothermal',
    ),
    ("[[vary]]", "[[vary", "not a TOML file"),
]


@pytest.mark.parametrize(("old", "new", "sentence"), BAD)
def test_a_bad_sweep_is_refused_in_one_sentence(tmp_path, monkeypatch, capsys, old, new, sentence):
    monkeypatch.chdir(tmp_path)
    path = written(tmp_path, LINE, (old, new))
    before = sorted(tmp_path.rglob("*"))
    assert main(["sweep", str(path)]) == BAD_INPUT
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith(f"pyworm: {path}: ")
    assert said.err.count("\n") == 1
    assert sentence in said.err
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize("share", ["0/2", "3/2", "1", "a/b", "1/0"])
def test_a_bad_share_is_refused(tmp_path, capsys, share):
    with pytest.raises(SystemExit) as end:
        main(["sweep", str(written(tmp_path, LINE)), "--share", share])
    assert end.value.code == BAD_INPUT
    assert f"{share}: must be a share such as 1/40" in capsys.readouterr().err


def test_a_share_is_checked_by_itself_and_the_whole_by_many(tmp_path, capsys):
    path = written(tmp_path, LINE, ('"200 kN/m"]', '"-2 kN/m"]'))
    assert [task.scene.load for task in load_sweep(path, (2, 6)).tasks] == [pytest.approx(100e3)]
    for arguments in (["-j", "2"], ["--share", "4/6"]):
        assert main(["sweep", str(path), "--out", str(tmp_path / "out"), *arguments]) == BAD_INPUT
        assert 'with contact.load = "-2 kN/m", motion.velocity_1 = "0.5' in capsys.readouterr().err
    assert main(["sweep", str(path), "--share", "7/7"]) == BAD_INPUT
    assert "has no share 7/7, there are fewer cases" in capsys.readouterr().err


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """A solved sweep: its file and its directory."""
    directory = tmp_path_factory.mktemp("sweep")
    path = written(directory, LINE)
    assert main(["sweep", str(path), "--out", str(directory / "out")]) == CONVERGED
    return path, directory / "out"


def test_a_sweep_writes_a_table_and_a_picture(solved, capsys, monkeypatch):
    path, out = solved
    assert sorted(file.name for file in out.iterdir()) == [
        *("scenes", "sweep.csv", "sweep.nc", "sweep.png"),
    ]
    result = open_sweep(out / "sweep.nc")
    table = result.table
    assert table["contact.load"].values.tolist() == [100] * 3 + [200] * 3
    assert table["contact.load"].attrs["units"] == "kN/m"
    assert table["motion.velocity_1"].values == pytest.approx([0.5, 1, 2] * 2)
    # what a line contact's film does: exponents of Moes' formula lie around these
    film = table["film_central_m"].values.reshape(2, 3)
    assert np.diff(np.log(film[0])) / np.diff(np.log([0.45, 0.95, 1.95])) == pytest.approx(
        0.7, abs=0.1
    )
    assert (film[1] < film[0]).all() and (film[1] > 0.8 * film[0]).all()
    assert (table["film_central_error"] < 0.05).all() and result.converged.all()
    with (out / "sweep.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [float(row["contact.load [kN/m]"]) for row in rows] == [100] * 3 + [200] * 3
    assert [float(row["film_min_m"]) for row in rows] == table["film_min_m"].values.tolist()
    assert {f"{row['key']}.json" for row in rows} == {
        file.name for file in (out / "scenes").iterdir()
    }
    monkeypatch.setattr("pyworm.batch.task.solve", None)
    capsys.readouterr()
    assert main(["sweep", str(path), "--out", str(out), "--json"]) == CONVERGED
    said = capsys.readouterr()
    assert "6 of 6 contacts were solved before" in said.err
    content = json.loads(said.out)
    assert content["scenes"][4]["film_min_m"] == table["film_min_m"].values[4]
    (out / "sweep.png").unlink()
    assert main(["plot", str(out / "sweep.nc")]) == CONVERGED
    assert capsys.readouterr().out == f"{out / 'sweep.png'}\n"
    assert (out / "sweep.png").exists()


def test_the_table_of_many_processes_and_shares_has_the_same_bits(solved, tmp_path, capsys):
    path, out = solved
    expected = open_sweep(out / "sweep.nc").table.drop_vars(["seconds", "convolutions"])
    arguments = ["sweep", str(path), "--out", str(tmp_path)]
    assert main([*arguments, "--share", "2/2", "-j", "2"]) == CONVERGED
    assert not (tmp_path / "sweep.nc").exists()
    assert main([*arguments, "--share", "1/2"]) == CONVERGED
    log = capsys.readouterr().err.splitlines()
    assert [line for line in log if "ended" in line] == [
        f"pyworm: share {share}/2: ended, 3 of 3 contacts solved" for share in (2, 1)
    ]
    assert "pyworm: share 2/2: 0 %, 0 of 3 contacts" in log
    assert main([*arguments, "-j", "2"]) == CONVERGED
    assert "6 of 6" in capsys.readouterr().err
    table = open_sweep(tmp_path / "sweep.nc").table.drop_vars(["seconds", "convolutions"])
    assert table.identical(expected)


def test_a_longer_sweep_solves_what_is_new_and_keeps_fields_if_asked(solved, tmp_path, capsys):
    longer = written(tmp_path, LINE, ('"200 kN/m"]', '"150 kN/m", "200 kN/m"]'))
    _, out = solved
    (tmp_path / "scenes").symlink_to(out / "scenes")
    arguments = ["sweep", str(longer), "--out", str(tmp_path)]
    assert main(arguments) == CONVERGED
    assert "6 of 9 contacts were solved before" in capsys.readouterr().err
    assert main([*arguments, "--fields"]) == CONVERGED
    assert capsys.readouterr().err == ""
    table = open_sweep(tmp_path / "sweep.nc").table
    full = tmp_path / "scenes" / f"{table['key'].values[0]}.nc"
    assert main(["plot", str(full), "--out", str(tmp_path / "one")]) == CONVERGED
    assert (tmp_path / "one" / "scene_000_profiles.png").exists()


def test_a_scene_without_solution_is_a_row_with_its_reason(tmp_path, capsys, monkeypatch):
    solve = pyworm.batch.task.solve

    def half(scene, plan, *how):
        if scene.load > 150e3:
            raise KernelError(2)
        return solve(scene, plan, *how)

    monkeypatch.setattr("pyworm.batch.task.solve", half)
    path = written(tmp_path, LINE)
    arguments = ["sweep", str(path), "--out", str(tmp_path / "out")]
    assert main(arguments) == NOT_CONVERGED
    reason = "a field holds a value that is not finite"
    printed = capsys.readouterr()
    assert f"3 of 6 contacts did not converge: {reason}" in printed.out
    assert f"3 of 6 contacts did not converge: {reason}" in printed.err
    table = open_sweep(tmp_path / "out" / "sweep.nc").table
    assert table["stop_reason"].values[3:].tolist() == [reason] * 3
    assert np.isnan(table["film_min_m"].values).tolist() == [False] * 3 + [True] * 3
    assert table["converged"].values.tolist() == [1, 1, 1, 0, 0, 0]
    monkeypatch.undo()
    assert main([*arguments, "--json"]) == CONVERGED
    said = capsys.readouterr()
    assert "3 of 6 contacts were solved before" in said.err
    assert all(scene["converged"] for scene in json.loads(said.out)["scenes"])


def made_up(axes, pairs):
    """A sweep over pairs of numbers or texts that was never solved."""
    rows = [
        {
            "converged": number != 1,
            "accurate": number != 1,
            "stop_reason": "",
            "film_min_m": 1e-7 * (1 + number),
            "film_min_error": 0.02,
            "film_central_m": 2e-7 * (1 + number) if number != 1 else None,
            "film_central_error": 0.02,
            "pressure_max_Pa": 1e9,
            "pressure_max_error": 0.02,
        }
        for number in range(len(pairs))
    ]
    values = [{"oil.a": one, "oil.b": other} for one, other in pairs]
    table = sweep_table(values, rows, ["key"] * len(pairs))
    return SweepResult("made-up", "A sweep", axes, table, {})


CROSSED = [["oil.a"], ["oil.b"]]


def test_errors_one_at_a_time_are_distinguished():
    sweep = made_up([["oil.a", "oil.b"]], [(0, 0), (-1, 0), (1, 0), (0, -2), (0, 2)])
    assert {"oil.a", "oil.b"} <= {panel.get_xlabel() for panel in draw_sweep(sweep).axes}
    table = rows_table(sweep)
    cells = [list(table.column(number)) for number in (0, 1)]
    assert cells == [["0", "-1", "1", "0", "0"], ["0", "0", "0", "-2", "2"]]


@pytest.mark.parametrize(
    ("axes", "pairs", "labels"),
    [
        ([["oil.a", "oil.b"]], [(n, 2 * n) for n in range(8)], {"oil.a and oil.b"}),
        (CROSSED, [(n, f"{m} N") for n in range(8) for m in (1, 2)], {"oil.a"}),
        (CROSSED, [(n, f"{m} N") for n in range(8) for m in range(7)], {"oil.a", "oil.b / N"}),
        (CROSSED, [(n, n * n) for n in range(8)], {"oil.a", "oil.b"}),
        (CROSSED, [("mineral", 1), ("polyglycol", 1)], {"oil.a"}),
    ],
    ids=["a line", "lines", "maps", "clouds", "names"],
)
def test_the_picture_shows_what_varies(axes, pairs, labels):
    figure = draw_sweep(made_up(axes, pairs))
    shown = {panel.get_xlabel() for panel in figure.axes} | {
        panel.get_ylabel() for panel in figure.axes
    }
    assert labels <= shown
    texts = "|".join(text.get_text() for text in figure.findobj() if hasattr(text, "get_text"))
    for words in (
        r"minimum film thickness $h_\mathrm{min}$ / µm",
        r"central film thickness $h_\mathrm{c}$ / µm",
        r"maximum pressure $p_\mathrm{max}$ / MPa",
    ):
        assert words in texts
    assert "not converged" in texts
    figure.canvas.draw()


def test_scenes_solved_before_are_not_made_again(tmp_path, monkeypatch):
    """What a table of many scenes waits for is the making of their contacts."""
    path = tmp_path / "films.toml"
    path.write_text(
        f'title = "t"\ncase = "{CASES}/line_m20_l10.toml"\neffects = "isothermal"\n'
        'fixed = { accuracy = "10 %" }\nvary = [{ "contact.load" = ["50 kN/m", "100 kN/m"] }]\n'
    )
    store = Store(tmp_path / "out" / "scenes", fields=False)
    first, second = load_sweep(path, store=store).tasks
    store.keep(first, first.solved())
    built = []
    monkeypatch.setattr(
        "pyworm.batch.sweep.case_of", lambda *given: built.append(given[1]) or case_of(*given)
    )
    again = load_sweep(path, store=store)
    assert [task.key for task in again.tasks] == [first.key, second.key]
    assert built == ['films: contact.load = "100 kN/m"']
