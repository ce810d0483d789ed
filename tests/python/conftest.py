"""What all tests stand on."""

import signal
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from linked_programs import LIBRARY, Linker, Printed
from undrawn_pages import plain_pages, undrawn_pages
from zi_drives import shared_springs

# a busy machine is no failure: examples count, not the time in which they are drawn
settings.register_profile(
    "pyworm", deadline=None, max_examples=50, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("pyworm")


def pytest_addoption(parser):
    """`--printed FOLDER`: what the examples printed on another machine, in place of running them here."""
    parser.addoption("--printed", type=Path)


@pytest.fixture(autouse=True, scope="session")
def interrupts():
    """Ctrl-C interrupts, here and in processes started, also where tests run in the background of a shell."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(autouse=True, scope="session")
def springs():
    """The tests solve the same worm drives again and again, whose springs take most of their time."""
    with pytest.MonkeyPatch.context() as patch:
        shared_springs(patch)
        yield


@pytest.fixture(autouse=True)
def unhurried(monkeypatch):
    """A busy machine adds no lines about long stages to what commands say."""
    monkeypatch.setattr("pyworm.io.stage.PATIENCE", 1000.0)


@pytest.fixture
def undrawn():
    """Pictures of report pages are not drawn, for tests of what is written beside them."""
    with undrawn_pages():
        yield


@pytest.fixture
def plain():
    """Report pages without pictures and without what follows from other oils and mountings."""
    with plain_pages():
        yield


@pytest.fixture(scope="session")
def linked(request, tmp_path_factory):
    """What compiles and runs a program with the library of the package's own build."""
    if folder := request.config.getoption("--printed"):
        return Printed(folder)
    if not LIBRARY.is_file():
        pytest.skip("an installed package has no library beside its extension")
    return Linker(tmp_path_factory.mktemp("programs"))
