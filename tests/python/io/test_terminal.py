"""The terminal: what files say is shown as data, in letters it has; who does not listen is no error."""

import io
import json
import os
import subprocess
import sys

import pytest
from folders import CASES

from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT
from pyworm.io.terminal import plain

BALL = CASES / "ball_pag_460.toml"
TITLE = 'title = "Steel ball on a bronze disc in an oil known by its name"'
PROGRAM = "import sys; from pyworm.cli.main import main; sys.exit(main())"


def titled(directory, title, name="case.toml"):
    """A case with another title, written as TOML has it."""
    text = BALL.read_text()
    assert TITLE in text
    path = directory / name
    path.write_text(text.replace(TITLE, f"title = {json.dumps(title)}"))
    return path


@pytest.mark.parametrize(
    "title", ["[/]", "[bold red]hot[/bold red]", ":smile: [link=x]y", "[/bold"]
)
def test_a_title_is_no_markup(tmp_path, capsys, title):
    assert main(["check", str(titled(tmp_path, title))]) == 0
    assert capsys.readouterr().out.startswith(f"{title}\n")


def test_control_characters_are_shown_by_their_code(tmp_path, capsys):
    path = titled(tmp_path, "a\x1b[31mb\rc\x9bd\u202ee\u200bf")
    assert main(["check", str(path)]) == 0
    assert capsys.readouterr().out.startswith("a\\x1b[31mb\\rc\\x9bd\\u202ee\\u200bf\n")


def test_a_refusal_is_one_line_whatever_it_quotes(tmp_path, capsys):
    path = titled(tmp_path, "t", "a\x1b]0;b\n\udcff[bold].toml")
    path.write_text(path.read_text().replace('load = "60 N"', 'load = "6\\u001b[2J\\n0 N"'))
    assert main(["check", str(path)]) == BAD_INPUT
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "\x1b" not in said
    assert "a\\x1b]0;b\\n\\udcff[bold].toml" in said and "6\\x1b[2J\\n0 N" in said


def test_a_wrong_option_is_quoted_likewise(capsys):
    with pytest.raises(SystemExit):
        main(["check", "case.toml", "--\x1b[31m"])
    assert "\x1b" not in capsys.readouterr().err


def ended(command, **how):
    """How a command line ends in a process of its own, what it printed and what it said."""
    environment = {key: value for key, value in os.environ.items() if key not in ("LC_ALL", "LANG")}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *map(str, command)],
        env=environment | how.pop("env", {}),
        capture_output=not how,
        check=False,
        **how,
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize("env", [{"PYTHONIOENCODING": "ascii"}, {"LANG": "C"}, {"LC_ALL": "C"}])
def test_a_terminal_without_letters_gets_ascii(tmp_path, env):
    path = titled(tmp_path, "Stößel µm ± 3 °C → 5 m² 漢")
    code, out, _ = ended(["check", path], env=env)
    assert code == 0
    text = out.decode("ascii")
    assert text.startswith("Stossel um +- 3 degC -> 5 m^2 ?\n")
    assert "spacing" in text and " um" in text and "| Load" in text


def test_standard_error_gets_ascii_too(tmp_path):
    code, _, said = ended(["check", tmp_path / "µ.toml"], env={"PYTHONIOENCODING": "ascii"})
    assert code == BAD_INPUT
    assert "u.toml: no such file" in said.decode("ascii")


def test_a_terminal_with_letters_keeps_them(tmp_path):
    code, out, _ = ended(["check", titled(tmp_path, "Stößel µm")], env={"LANG": "C.UTF-8"})
    assert code == 0
    assert out.decode("utf-8").startswith("Stößel µm\n") and "┃" in out.decode("utf-8")


@pytest.mark.parametrize(("text", "shown"), [("é", "é"), ("µ²", "µ²"), ("→漢", "->?")])
def test_characters_of_an_encoding_are_kept(text, shown):
    class Stream:
        encoding = "latin-1"

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LANG", "de_DE.ISO-8859-1")
        patch.delenv("LC_ALL", raising=False)
        assert plain(text, Stream()) == shown


def shell(script, *arguments):
    """A shell's line about `pyworm`, its exit code and what it left on both streams."""
    done = subprocess.run(
        ["bash", "-c", script, "bash", sys.executable, "-c", PROGRAM, *map(str, arguments)],
        capture_output=True,
        check=False,
    )
    return done.returncode, done.stdout.decode(), done.stderr.decode()


@pytest.mark.parametrize("arguments", [("check", BALL), ("oil", "list", "--json")])
def test_a_closed_pipe_is_quiet_and_no_failure(arguments):
    """A reader who leaves after the first byte; in the pipe there would be room for all of it."""
    gone = '"$@" | head -c 1 >/dev/null; exit ${PIPESTATUS[0]}'
    assert shell(gone, *arguments) == (0, "", "")
    closed = '"$@" > >(exec <&-; sleep 0.2); exit $?'
    assert shell(closed, *arguments) == (0, "", "")


def test_help_into_a_closed_pipe_is_quiet():
    assert shell('"$@" > >(exec <&-); exit $?', "run", "--help") == (0, "", "")


def test_a_help_text_longer_than_the_buffer_of_a_closed_pipe_is_quiet(monkeypatch):
    """Python 3.11.2 lets `argparse` raise then."""

    class Closed(io.StringIO):
        def write(self, text):
            raise BrokenPipeError

    monkeypatch.setattr("sys.stdout", Closed())
    with pytest.raises(SystemExit) as ended:
        main(["run", "--help"])
    assert ended.value.code == 0


def test_closed_streams_cost_nothing(tmp_path):
    out = tmp_path / "out"
    run = ("run", BALL, "--accuracy", "30%", "--effects", "isothermal", "--pictures", "none")
    run += ("--json", "--out", out)
    code, said, _ = shell('exec 2>&-; exec "$@"', *run)
    assert code == 0
    assert json.loads(said)["case"] == "ball_pag_460"
    assert sorted(path.suffix for path in out.iterdir()).count(".nc") == 1
    assert shell('exec 2>&- >&-; exec "$@"', *run) == (0, "", "")
    assert shell('exec 2>&- >&- <&-; exec "$@"', "check", tmp_path / "none.toml")[0] == BAD_INPUT


@pytest.mark.parametrize("buffer", ["unset PYTHONUNBUFFERED", "export PYTHONUNBUFFERED=1"])
def test_a_full_device_is_reported(buffer):
    code, _, said = shell(f'{buffer}; exec "$@" >/dev/full', "check", BALL)
    assert code == 1
    assert said.startswith("pyworm: ") and said.count("\n") == 1 and "No space left" in said
