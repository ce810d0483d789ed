"""The part of `pyworm run` about sensitivities: table and file."""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyworm.io.atomic import atomic_directory
from pyworm.io.terminal import print_message, print_result

if TYPE_CHECKING:
    from pyworm.batch.task import Task
    from pyworm.result.key_sensitivities import KeySensitivities
    from pyworm.result.result import Result

TABLE = "sensitivities.json"


@dataclass
class SensitiveRun:
    """Sensitivities of a run, if they are asked for."""

    options: argparse.Namespace
    """Its options."""
    found: "KeySensitivities | None" = None
    """The sensitivities."""
    seconds: float = 0.0
    """CPU time of them [s]."""

    def completed(self, result: "Result", tasks: "Sequence[Task]", directory: Path) -> "Result":
        """The result with them, in its file and one of their own, if they are asked for."""
        if not self.options.sensitivities or not result.sound.solutions:
            return result
        from pyworm.batch.overrun import processor_seconds
        from pyworm.batch.run_sensitivities import sensitivities_of_run, with_sensitivities
        from pyworm.io.console import progress_bar
        from pyworm.io.json import as_json

        began = processor_seconds()
        with progress_bar() as progress:
            self.found = sensitivities_of_run(result, tasks, progress, print_message)
        self.seconds = processor_seconds() - began
        with atomic_directory(directory) as aside:
            (aside / TABLE).write_text(as_json(self.found.summary()), encoding="utf-8")
        return with_sensitivities(result, self.found, directory)

    def show(self, directory: Path) -> None:
        """Print the table, if there is one."""
        if self.found is not None:
            from pyworm.io.console import Console
            from pyworm.report.console.key_sensitivities import sensitivities_tables

            for table in sensitivities_tables(self.found):
                Console().print(table)
            print_result(f"Sensitivities  {directory / TABLE}")

    @property
    def summary(self) -> dict[str, Any]:
        """Entry of the object under `--json`."""
        return {} if self.found is None else {"sensitivities": self.found.summary()}
