"""`[running_in]`: a programme by which new flanks are smoothed before they carry their load."""

from collections.abc import Iterator

from pyworm.case.table import Table
from pyworm.drives.run_in_programme import RunInStage
from pyworm.io import units

SERVICE = 100 * 3600.0
"""Time at the case's own load after a programme [s]."""


class RunInStageTable(Table, RunInStage):
    """One of `[[running_in.stages]]`: torque of the wheel or gear, speed of the worm or pinion."""


class RunningInTable(Table):
    """`[running_in]`: stages in order, and for how long the case's own load follows, also without them."""

    service: units.Span = SERVICE
    stages: tuple[RunInStageTable, ...] = ()

    def flaws(self) -> Iterator[str]:
        """No stage."""
        if not self.stages:
            yield "stages is missing: give [[running_in.stages]] with torque, speed and duration"
