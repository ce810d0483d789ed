"""`[bodies.NAME.surface]`: the topography of a body's surface, from a file or generated."""

from collections.abc import Iterator
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, PrivateAttr, model_validator

from pyworm.case.table import Table
from pyworm.io import units
from pyworm.io.plain_values import Seed, Text
from pyworm.io.present import present
from pyworm.materials.long_waves import LongWaves
from pyworm.materials.topography import Topography
from pyworm.surfaces.generated import gaussian, self_affine
from pyworm.surfaces.parameters import Texture, texture
from pyworm.surfaces.plausible import require_plausible
from pyworm.surfaces.preparing import Outliers, SeparatedWaves, separate_waves
from pyworm.surfaces.reading import read_heights

Aspect = Annotated[float, Field(strict=True, ge=1 / 9, le=9)]


class GaussianTable(Table):
    """`generated` with spectrum = "gaussian": waves of about one length."""

    spectrum: Literal["gaussian"]
    roughness: units.Roughness
    correlation_length: units.Wave
    aspect: Aspect = 1.0
    seed: Seed

    def topography(self) -> Topography:
        """The surface."""
        return gaussian(self.roughness, self.correlation_length, self.aspect, self.seed)


class SelfAffineTable(Table):
    """`generated` with spectrum = "self-affine": waves of all lengths between two."""

    spectrum: Literal["self-affine"]
    roughness: units.Roughness
    hurst: Annotated[float, Field(strict=True, gt=0, le=1)]
    longest_wave: units.Wave
    shortest_wave: units.Wave
    aspect: Aspect = 1.0
    seed: Seed

    @model_validator(mode="after")
    def _waves_fit(self) -> Self:
        self.topography()
        return self

    def topography(self) -> Topography:
        """The surface."""
        return self_affine(
            self.roughness,
            self.hurst,
            self.longest_wave,
            self.shortest_wave,
            self.aspect,
            self.seed,
        )


class SurfaceTable(Table):
    """`[bodies.NAME.surface]`: heights of a surface, in place of `roughness` and its figures.

    A file is named relative to the case file.
    """

    file: Text | None = None
    generated: (
        Annotated[GaussianTable | SelfAffineTable, Field(discriminator="spectrum")] | None
    ) = None
    spacing: units.Wave | None = None
    height_unit: Text | None = None
    nesting_index: units.Wave | None = None
    shortest_wave: units.Wave | None = None
    outliers: Outliers = "refuse"
    x_direction: units.AngleOrZero = 0.0
    _directory: Path | None = PrivateAttr(default=None)

    def flaws(self) -> Iterator[str]:
        """Not one source, or keys of a file without one."""
        yield from self.unless_either("file", "generated")
        for name in self.given("spacing", "height_unit") if self.file is None else ():
            yield f"{name} has no effect without file"

    def lie_in(self, directory: Path) -> None:
        """Tell where the file lies; without, there is none to read (`case.case_again`)."""
        self._directory = directory.absolute()

    @property
    def found(self) -> bool:
        """Whether the heights can be had."""
        return self.file is None or self._directory is not None

    @property
    def content(self) -> str:
        """Digest of what the file holds."""
        return sha256(self._path.read_bytes()).hexdigest()

    @property
    def _path(self) -> Path:
        return present(self._directory, "directory") / present(self.file, "file")

    def waves(self) -> SeparatedWaves:
        """Roughness and longer waves of the surface; ValueError with the key if there is no such surface."""
        try:
            if self.file is None:
                return _of_generated(self)
            state = self._path.stat() if self._path.is_file() else None
            return _of_file(self, self._path, state and (state.st_mtime_ns, state.st_size))
        except ValueError as error:
            key = "generated" if self.file is None else f'file = "{self.file}"'
            raise ValueError(f"surface.{key}: {error}") from None

    def topography(self) -> Topography:
        """The roughness, its x axis turned from the surface's own motion."""
        return self.waves().roughness.turned(self.x_direction)

    def long_waves(self) -> LongWaves | None:
        """The waves longer than those of the roughness, likewise; None where all waves are roughness."""
        if self.nesting_index is None:
            return None
        return LongWaves(self.waves().long_waves.turned(self.x_direction))


@lru_cache(maxsize=8)
def _of_file(table: SurfaceTable, path: Path, state: tuple[int, int] | None) -> SeparatedWaves:
    """Waves of a file's content, of which time and size change with it."""
    heights, spacing = read_heights(path, table.spacing, table.height_unit)
    found = _separated(table, heights, spacing, periodic=False)
    require_plausible(found.all_waves)
    return found


@lru_cache(maxsize=8)
def _of_generated(table: SurfaceTable) -> SeparatedWaves:
    if table.generated is None:
        raise ValueError("generated is missing")
    topography = table.generated.topography()
    return _separated(table, topography.height, topography.spacing, periodic=True)


def _separated(
    table: SurfaceTable,
    heights: np.ndarray,
    spacing: tuple[float, float],
    *,
    periodic: bool,
) -> SeparatedWaves:
    return separate_waves(
        heights,
        spacing,
        periodic=periodic,
        nesting_index=table.nesting_index,
        shortest_wave=table.shortest_wave,
        outliers=table.outliers,
    )


@lru_cache(maxsize=8)
def texture_of(surface: Topography) -> Texture:
    """Figures of a surface, computed once."""
    return texture(surface)
