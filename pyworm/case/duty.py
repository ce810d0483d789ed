"""`[duty]`: what a gear unit does over time, as blocks or as a file."""

import csv
from collections.abc import Iterator
from math import isfinite
from pathlib import Path
from typing import Literal

from pyworm.case.table import Table, plain
from pyworm.drives.duty_cycle import DutyBlock, DutyCycle
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS
from pyworm.io.input_error import CaseError
from pyworm.io.plain_values import Text

COLUMNS = "torque_N_m", "speed_rpm", "time_s", "ambient_C"
"""Columns of a file of blocks: as the keys of a block, the time its length; the last may be missing."""

MAX_BLOCKS = 2000
"""Largest number of blocks: a day by minutes has 1440."""


class DutyBlockTable(Table, DutyBlock):
    """One of `[[duty.blocks]]`: torque of the wheel or gear, speed of the worm or pinion, for some time."""

    name: Text | None = None

    def flaws(self) -> Iterator[str]:
        """A gear set that turns without load."""
        if self.running and self.torque == 0:
            yield "torque must be above 0 where speed is; at rest give speed = 0"


class DutyTable(Table):
    """`[duty]`: blocks in order, or a CSV file of them.

    Repeated for ever ("periodic"), or once from a start as cold as the surroundings ("cold").
    """

    start: Literal["periodic", "cold"] = "periodic"
    blocks: tuple[DutyBlockTable, ...] = ()
    file: Text | None = None

    def flaws(self) -> Iterator[str]:
        """Neither blocks nor a file, both, or none that turns."""
        if bool(self.blocks) == (self.file is not None):
            yield "give either blocks or file, one of the two"
        if self.blocks and not any(block.running for block in self.blocks):
            yield "blocks: none of them has a speed"

    def cycle(self, directory: Path) -> DutyCycle:
        """The blocks; CaseError of a file that has none."""
        blocks = tuple(plain(block, DutyBlock) for block in self.blocks)
        given = [block.name for block in self.blocks]
        if self.file is not None:
            try:
                blocks = read_blocks(directory / self.file)
            except ValueError as error:
                raise CaseError(f'duty.file = "{self.file}": {error}') from None
            given = [None] * len(blocks)
        names = tuple(name or f"block {number}" for number, name in enumerate(given, 1))
        return DutyCycle(blocks, names, self.start == "periodic")


def read_blocks(path: Path) -> tuple[DutyBlock, ...]:
    """Blocks of a CSV file with the columns `COLUMNS`; ValueError of another file."""
    if not path.is_file():
        raise ValueError("no such file")
    with path.open(newline="", encoding="utf-8-sig", errors="replace") as file:
        lines = csv.reader(file)
        head = tuple(name.strip() for name in next(lines, []))
        if head not in (COLUMNS, COLUMNS[:3]):
            raise ValueError(
                f"its first line is {', '.join(head)[:60] or 'empty'}; it must be {','.join(COLUMNS)}"
            )
        blocks = []
        for line in filter(None, lines):
            blocks.append(_block(line, len(head), lines.line_num))
            if len(blocks) > MAX_BLOCKS:
                raise ValueError(f"it has more than {MAX_BLOCKS} blocks")
    if not any(block.running for block in blocks):
        raise ValueError("it has no block with a speed")
    return tuple(blocks)


def _block(line: list[str], count: int, number: int) -> DutyBlock:
    """The block of a line of so many numbers."""
    try:
        values = [float(cell) for cell in line]
    except ValueError:
        values = []
    if len(values) != count or not all(map(isfinite, values)):
        raise ValueError(
            f"line {number} is {','.join(line)[:60]}; {count} numbers with points and commas between are "
            "needed"
        )
    torque, rpm, seconds = values[:3]
    if torque < 0 or rpm < 0 or seconds <= 0 or (rpm > 0 and torque == 0):
        raise ValueError(
            f"line {number}: torque and speed must not be negative, time above 0, and torque above 0 where "
            "speed is"
        )
    ambient = values[3] + ZERO_CELSIUS if count > len(COLUMNS) - 1 else None
    return DutyBlock(torque=torque, speed=rpm / RPM, duration=seconds, ambient=ambient)
