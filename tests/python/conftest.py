"""What all tests stand on."""

import signal

import pytest


@pytest.fixture(autouse=True, scope="session")
def interrupts():
    """Ctrl-C interrupts, here and in processes started, also where tests run in the background of a shell."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
