"""The part of `pyworm run` about uncertain inputs: messages, solves, table and picture."""

import argparse
from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from pyworm.case.case import Case
from pyworm.cli.shared import drawn_pictures
from pyworm.io.terminal import print_message

if TYPE_CHECKING:
    from pyworm.batch.task import Task
    from pyworm.result.result import Result

PICTURE = "input_uncertainty.png"


@dataclass(frozen=True)
class UncertainRun:
    """Uncertain inputs of a run."""

    case: Case
    """Its case."""
    options: argparse.Namespace
    """Its options."""

    def announce(self) -> None:
        """Report that best estimates are used unless uncertainties are asked for; CaseError without any."""
        if self.options.inputs_uncertain:
            from pyworm.batch.uncertain_run import require_uncertain

            require_uncertain(self.case)
        elif keys := ", ".join(self.case.uncertain.values):
            print_message(
                f"{self.case.name}: best estimates are used of {keys}; --inputs-uncertain computes what "
                "their uncertainty does"
            )

    def completed(
        self,
        result: "Result",
        tasks: "Sequence[Task]",
        directory: Path,
        executor: Executor | None,
    ) -> "Result":
        """The result with the uncertainty by inputs, if that is asked for; as it is where a solve fails."""
        if not self.options.inputs_uncertain:
            return result
        from pyworm.batch.operating_points import NotSolvedError
        from pyworm.batch.uncertain_run import with_input_uncertainty
        from pyworm.io.console import progress_bar

        try:
            with progress_bar() as progress:
                return with_input_uncertainty(result, tasks, directory, executor, progress)
        except NotSolvedError as error:
            print_message(f"{self.case.name}: no uncertainty by inputs: {error}")
            return result

    def show(self, result: "Result") -> None:
        """Print the table, if there is one."""
        found = result.input_uncertainty
        if found is not None:
            from pyworm.io.console import Console
            from pyworm.report.console.input_uncertainty import uncertainty_tables

            for table in uncertainty_tables(found, result.body_names):
                Console().print(table)

    def pictures(self, result: "Result", directory: Path) -> list[str]:
        """Names of the pictures drawn of it."""
        found = result.input_uncertainty
        if found is None or self.options.pictures == "none":
            return []
        from pyworm.plots.input_uncertainty import draw_input_uncertainty
        from pyworm.plots.layout import write

        def draw(aside: Path) -> list[Path]:
            return [write(draw_input_uncertainty(found, self.case.name), aside / PICTURE)]

        return drawn_pictures(directory, draw)[0]
