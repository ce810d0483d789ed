"""The quick start, the first page that anybody runs: every number on it is what its commands print."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
from folders import ROOT
from printed_rows import NUMBER, numbers, same_row

import pyworm
from pyworm.cli.main import main

PAGE = (ROOT / "docs/tutorials/quick-start.md").read_text()
CASE = ROOT / "cases/ball_pag_460.toml"

TABLE = re.compile(r"^```\n(.*?)^```$", re.M | re.S)
REFUSAL = re.compile(r"^    pyworm: (?!warning)(.*)$", re.M)
COMMENT = re.compile(r"^    pyworm run cases/ball_pag_460.toml (--\S+ \S+) +# (.*)$", re.M)


@pytest.fixture(scope="module", autouse=True)
def wide_terminal():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("COLUMNS", "110")
        yield


def printed_by(capsys, *words):
    assert main(list(map(str, words))) == 0
    return capsys.readouterr().out.splitlines()


def printed_row(name, lines):
    """The row of a table that begins with a name."""
    return next(line for line in lines if line.strip(" │").startswith(f"{name} "))


def test_check_prints_the_table_of_the_page(capsys):
    lines = printed_by(capsys, "check", CASE)
    head, *rows = TABLE.findall(PAGE)[0].splitlines()
    assert head.split() == printed_row("Effect", lines).split()
    for row in rows:
        found = printed_row(row.split()[0], lines)
        assert NUMBER.sub("#", found).split() == NUMBER.sub("#", row).split()
        assert numbers(found) == pytest.approx(numbers(row), rel=0.02), row
    judged = [line for line in lines if re.match(r" [a-z-]+ +(on|off) ", line)]
    count = {14: "fourteen"}[len(judged)]
    assert f"and so on for {count} effects" in PAGE
    pressure, across = re.search(r"\((\S+) MPa by Hertz, (\S+) mm across\)", PAGE).groups()
    assert f"{pressure} MPa" in printed_row("Maximum Hertz pressure", lines)
    width = numbers(printed_row("Hertz contact width", lines))[0]
    assert float(across) == pytest.approx(width, abs=6e-4)


def test_run_prints_the_table_of_the_page(tmp_path, capsys):
    lines = printed_by(capsys, "run", CASE, "--out", tmp_path)
    rows = TABLE.findall(PAGE)[1].splitlines()
    assert len(rows) == 8
    for row in rows:
        name = row.split("│")[1].strip()
        assert same_row(row, printed_row(name, lines)), printed_row(name, lines)
    shares = [numbers(row)[1] for row in rows if row.rstrip(" │").endswith("%")]
    assert max(shares) <= 3 / 8  # "an eighth of the accuracy asked for or less"
    pictures = sorted(path.stem for path in tmp_path.glob("*.png"))
    assert pictures == ["regimes", "scene_000_film", "scene_000_temperature"]
    said = re.search(r"all` draws (\w+)", PAGE)[1]
    plots = printed_by(capsys, "plot", tmp_path / "result.nc", "--pictures", "all")
    assert said == {10: "ten", 11: "eleven", 12: "twelve"}[sum(".png" in line for line in plots)]


@pytest.mark.parametrize(("option", "comment"), COMMENT.findall(PAGE))
def test_the_figures_beside_commands_are_printed(option, comment, tmp_path, capsys):
    lines = printed_by(capsys, "run", CASE, *option.split(), "--out", tmp_path)
    now = numbers(printed_row("Minimum film thickness", lines))
    film, *bar = numbers(comment)
    assert now[0] == pytest.approx(film, rel=1e-3)
    assert now[1 : 1 + len(bar)] == pytest.approx(bar, rel=0.02)


MISTAKES = {
    "contact.load": ('load = "60 N"', 'load = "60"'),
    "contact.laod": ('load = "60 N"', 'laod = "60 N"'),
    "bodies.body_1.density": ('density = "7900 kg/m^3"', 'density = "7.9 kg/m^3"'),
}


@pytest.mark.parametrize("sentence", REFUSAL.findall(PAGE))
def test_mistakes_are_refused_as_the_page_says(sentence, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    right, wrong = MISTAKES[re.match(r"ball.toml: (\S+?):? ", sentence)[1]]
    assert right in CASE.read_text()
    Path("ball.toml").write_text(CASE.read_text().replace(right, wrong, 1))
    assert main(["check", "ball.toml"]) == 2
    assert capsys.readouterr().err.strip() == f"pyworm: {sentence}"


def test_the_page_has_three_mistakes_and_two_comments():
    assert len(REFUSAL.findall(PAGE)) == 3
    assert len(COMMENT.findall(PAGE)) == 2


def test_an_unusual_value_gives_the_warning_of_the_page(tmp_path, capsys):
    case = tmp_path / "ball.toml"
    case.write_text(CASE.read_text().replace('roughness = "0.05 um"', 'roughness = "20 um"'))
    assert main(["check", str(case)]) == 0
    warning = re.search(r"^    (pyworm: warning: .*)$", PAGE, re.M)[1]
    assert warning in capsys.readouterr().err


def test_doctor_ends_in_the_lines_of_the_page(capsys):
    main(["doctor"])
    shown = re.search(r"its last lines are\n\n((?:    .*\n)+)", PAGE)[1].splitlines()
    printed = capsys.readouterr().out.splitlines()[-len(shown) :]
    for row, now in zip(shown, printed, strict=True):
        assert row.split()[:3] == now.split()[:3]
    gap, again = numbers(shown[0])[0], numbers(printed[0])[0]
    assert again == pytest.approx(gap, rel=0.02)


def test_the_script_prints_the_comment_of_the_page(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    script, comment = re.search(r"```python\n(.*?  # (.*?)\n)```", PAGE, re.S).groups()
    exec(compile(script, "quick-start.md", "exec"), {})
    printed = capsys.readouterr().out
    assert NUMBER.sub("#", printed).strip() == NUMBER.sub("#", comment)
    assert numbers(printed) == pytest.approx(numbers(comment), rel=0.02)


def test_the_oil_of_gold_s_law_makes_the_film_that_much_thicker():
    gold, given = map(
        float, re.search(r"law for this oil, (\S+) instead of (\S+)\s+1/GPa", PAGE).groups()
    )
    scene = pyworm.load(CASE).scene()
    assert scene.oil.viscosity.alpha * 1e9 == pytest.approx(given)
    assert pyworm.named_oil("PAG VG 460").alpha("60 degC") * 1e9 == pytest.approx(gold, abs=0.05)
    thick = pyworm.Roelands.from_alpha(scene.oil.viscosity.eta0, gold * 1e-9)
    other = replace(scene, oil=replace(scene.oil, viscosity=thick))
    films = [
        float(pyworm.solve(one, pyworm.plan(one, 0.03)).figures.film_min) for one in (scene, other)
    ]
    assert "seventh thicker" in PAGE.replace("\n", " ")
    assert films[1] / films[0] == pytest.approx(1 + 1 / 7, abs=0.01)
