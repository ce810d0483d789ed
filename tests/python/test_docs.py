"""README and docs: Python and commands print what pages show, command lines parse, named files exist."""

import re
import shlex
from functools import partial
from itertools import chain

import pytest
from folders import ROOT

from pyworm.cli.main import _parser, main

PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
LESSONS = [
    *sorted((ROOT / "docs/tutorials").glob("*.md")),
    ROOT / "docs/how-to/script.md",
]

PYTHON = re.compile(
    r"^```python\n(.*?)^```\n(?:\s*prints\s+(?:```\n(.*?)```|`([^`]*)`))?", re.M | re.S
)
"""A block of Python and, if the page says so right after it, what it prints."""

NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]\d+)?")

FENCED = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
INDENTED = re.compile(r"^ {4}\S.*$", re.M)
INLINE = re.compile(r"`([^`]+)`")

FILE = re.compile(
    r"(?<![\w/])(?:benchmarks|cases|docs|fortran|pyworm|tests|tools)/[\w./-]*\w\.\w+\b"
)
LINK = re.compile(r"\]\(([^)#\s]+)")

STAND_INS = {"P": "0.5", "SECONDS": "60", "$SLURM_ARRAY_TASK_ID/40": "1/40"} | {
    "{wildcards.i}/{SHARES}": "1/40"
}
"""What stands for a number in the synopses and scripts of the pages."""

EXAMPLE = ROOT / "examples/eccentric_cam"
"""A package whose files a page names from its own folder."""

LONG = "worm-from-its-drawing"
"""The page that takes half a minute."""

called = partial(pytest.mark.parametrize, ids=lambda page: page.relative_to(ROOT).as_posix())


@called(
    "page",
    [pytest.param(page, marks=pytest.mark.long if page.stem == LONG else ()) for page in LESSONS],
)
def test_python_runs_and_prints_what_the_page_says(page, tmp_path, monkeypatch, capsys):
    (tmp_path / "cases").symlink_to(ROOT / "cases")
    monkeypatch.chdir(tmp_path)
    text = page.read_text()
    blocks = list(PYTHON.finditer(text))
    assert blocks
    names = {"__name__": page.stem}
    for block in blocks:
        before = "\n" * (text[: block.start(1)].count("\n"))  # errors tell the line of the page
        exec(compile(before + block[1], page, "exec"), names)
        printed, said = capsys.readouterr().out, block[2] or block[3]
        if said is not None:
            assert NUMBER.sub("#", printed).strip() == NUMBER.sub("#", said).strip()
            assert _numbers(printed) == pytest.approx(_numbers(said), rel=0.02, abs=1e-6)


def test_the_readme_shows_what_run_prints(tmp_path, capsys, monkeypatch):
    """The table of the worm contact at mid-mesh: every row with its model's bar and its published value."""
    monkeypatch.setenv("COLUMNS", "100")
    text = (ROOT / "README.md").read_text()
    command = re.search(r"`pyworm (run [^`]*)` prints, among other lines", text)[1]
    shown = [row.strip() for row in re.findall(r"^    │.*│$", text, re.M)]
    assert len(shown) == 9
    words = command.replace("cases/", f"{ROOT}/cases/").split()
    assert main([*words, "--out", str(tmp_path)]) == 0
    printed = {
        _cells(row)[0]: _cells(row) for row in capsys.readouterr().out.splitlines() if "│" in row
    }
    for name, value, model, published in map(_cells, shown):
        _, now, uncertain, beside = printed[name]
        assert beside == published
        assert NUMBER.sub("#", now) == NUMBER.sub("#", value)
        figure, *bar = _numbers(value)
        assert _numbers(now)[0] == pytest.approx(figure, rel=1e-3), name
        assert _numbers(now)[1:] == pytest.approx(bar, rel=0.02), name
        assert _numbers(uncertain) == pytest.approx(_numbers(model), rel=0.05), name


def _cells(row: str) -> list[str]:
    return [cell.strip() for cell in row.strip().strip("│").split("│")]


def _numbers(text: str) -> list[float]:
    return [float(number) for number in NUMBER.findall(text)]


@called("page", PAGES)
def test_command_lines_parse(page, capsys):
    for words in _commands(page.read_text()):
        try:
            _parser().parse_args(words)
        except SystemExit as stop:
            assert stop.code == 0, f"pyworm {shlex.join(words)}: {capsys.readouterr().err}"


def test_command_lines_are_found():
    readme = (ROOT / "README.md").read_text()
    assert ["run", "cases/zi_sharif_2001.toml", "--accuracy", "1%", "--phase", "0.5"] in _commands(
        readme
    )
    batches = (ROOT / "docs/how-to/run-batches.md").read_text()
    assert ["run", "cases/traction_steel.toml", "-j", "2"] in _commands(batches)


def _commands(text: str) -> list[list[str]]:
    """The command lines of a page, without the program; those that are only named end in --help."""
    fenced = [block[2] for block in FENCED.finditer(text) if block[1] != "toml"]
    prose = FENCED.sub("", text)
    lines = chain.from_iterable(part.splitlines() for part in (*fenced, *INDENTED.findall(prose)))
    shown = [words for line in lines for words in _spoken(line)]
    named = [words for code in INLINE.findall(prose) for words in _spoken(" ".join(code.split()))]
    return shown + [words if _has_arguments(words) else [*words, "--help"] for words in named]


def _has_arguments(words: list[str]) -> bool:
    return len(words) > (2 if words[0] == "oil" else 1)


def _spoken(line: str) -> list[list[str]]:
    """The command lines in a line of code: without comments, optional parts in, alternatives apart."""
    found = re.search(r'(^|[\s"/])pyworm (?=[a-z])', line)
    if found is None:
        return []
    said = line[found.end() :]
    if found[1] == '"':
        said = said.partition('"')[0]
    said = re.split(r"\s{2,}| # | \|\| ", said)[0]
    said = re.sub(r" \.\.\.|[][]", "", said)
    first, *others = said.split(" | ")
    prefix = first.rpartition(" ")[0]
    return [
        [STAND_INS.get(word, word) for word in shlex.split(one)]
        for one in (first, *(f"{prefix} {other}" for other in others))
    ]


@called("page", PAGES)
def test_files_that_are_named_exist(page):
    text = page.read_text()
    built = {file.relative_to(EXAMPLE).as_posix() for file in EXAMPLE.rglob("*.*")}
    named = {ROOT / name for name in FILE.findall(text) if "NAME" not in name and name not in built}
    linked = {page.parent / link for link in LINK.findall(text) if "://" not in link}
    assert not [str(path) for path in named | linked if not path.exists()]


def _site() -> list[str]:
    return sorted(
        path.relative_to(ROOT / "docs").as_posix() for path in (ROOT / "docs").rglob("*.md")
    )


def test_every_page_has_its_place_in_the_site():
    placed = re.findall(r"\S+\.md$", (ROOT / "mkdocs.yml").read_text(), re.M)
    assert sorted(placed) == _site()


def test_the_readme_cites_as_the_citation_file():
    citation = (ROOT / "CITATION.cff").read_text()
    title = re.search(r'^title: "(.*)"$', citation, re.M)[1]
    author = re.search(r"^  - name: (.*)$", citation, re.M)[1]
    licence = re.search(r"^license: (.*)$", citation, re.M)[1]
    version = re.search(r"^version: (.*)$", citation, re.M)[1]
    line = f"> {author}, *{title}*, version {version}, software, {licence}."
    assert line in (ROOT / "README.md").read_text()


def test_the_overview_links_every_page():
    linked = LINK.findall((ROOT / "docs/index.md").read_text())
    assert sorted({"index.md", *(link for link in linked if "://" not in link)} & set(_site())) == (
        _site()
    )
