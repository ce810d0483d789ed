"""Bad input to commands: case texts changed, and the one sentence with which a command refuses."""

from pyworm.cli.main import main
from pyworm.cli.shared import BAD_INPUT


def changed(text, *changes):
    """A case file with passages replaced, once each."""
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return text


def refusal(arguments, directory, capsys):
    """The sentence with which a command is refused; nothing else may happen."""
    before = sorted(directory.rglob("*"))
    try:
        code = main(arguments)
    except SystemExit as end:  # how argparse ends
        code = end.code
    said = capsys.readouterr()
    assert code == BAD_INPUT
    assert said.out == ""
    assert said.err.startswith("pyworm: ")
    assert said.err.count("\n") == 1
    assert sorted(directory.rglob("*")) == before
    return said.err
