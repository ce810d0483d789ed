"""What all tests stand on."""

import signal
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from linked_programs import LIBRARY, Linker, Printed
from undrawn_pages import undrawn_pages

# a busy machine is no failure: examples count, not the time in which they are drawn
settings.register_profile("pyworm", deadline=None, suppress_health_check=[HealthCheck.too_slow])
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


@pytest.fixture(autouse=True)
def unhurried(monkeypatch):
    """A busy machine adds no lines about long stages to what commands say."""
    monkeypatch.setattr("pyworm.io.stage.PATIENCE", 1000.0)


@pytest.fixture
def undrawn():
    """Pictures of report pages are not drawn, for tests of what is written beside them."""
    with undrawn_pages():
        yield


@pytest.fixture(scope="session")
def linked(request, tmp_path_factory):
    """What compiles and runs a program with the library of the package's own build."""
    if folder := request.config.getoption("--printed"):
        return Printed(folder)
    if not LIBRARY.is_file():
        pytest.skip("an installed package has no library beside its extension")
    return Linker(tmp_path_factory.mktemp("programs"))
