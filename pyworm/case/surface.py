"""`[bodies.NAME.surface]`: the topography of a body's surface, from files or generated."""

from collections.abc import Callable, Iterator
from dataclasses import replace
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
from pyworm.surfaces.from_profiles import profiles_along, sampled_surface
from pyworm.surfaces.generated import gaussian, self_affine
from pyworm.surfaces.parameters import Texture, texture
from pyworm.surfaces.part import cropped, masked
from pyworm.surfaces.plausible import require_plausible, require_plausible_profile
from pyworm.surfaces.preparing import MOST_MISSING, Outliers, SeparatedWaves, separate_waves
from pyworm.surfaces.profile import Profile, roughness_profile
from pyworm.surfaces.reading import IsProfileError, read_area, read_profile

Aspect = Annotated[float, Field(strict=True, ge=1 / 9, le=9)]

OF_SOURCE = {
    ("file", "across"): ("spacing", "height_unit"),
    ("file",): ("channel", "crop", "mask"),
    ("across",): ("along", "aspect", "seed"),
}
"""Sources -> keys that count with one of them only."""


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


Crop = tuple[units.PlaceInArea, units.PlaceInArea, units.PlaceInArea, units.PlaceInArea]


class SurfaceTable(Table):
    """`[bodies.NAME.surface]`: heights of a surface, in place of `roughness` and its figures.

    Files are named relative to the case file.
    """

    file: Text | None = None
    across: tuple[Text, ...] | None = None
    along: tuple[Text, ...] | None = None
    aspect: Aspect | None = None
    seed: Seed | None = None
    generated: (
        Annotated[GaussianTable | SelfAffineTable, Field(discriminator="spectrum")] | None
    ) = None
    spacing: units.Wave | None = None
    height_unit: Text | None = None
    nesting_index: units.Wave | None = None
    shortest_wave: units.Wave | None = None
    outliers: Outliers = "refuse"
    fill: Annotated[float, Field(strict=True, ge=0, lt=1)] = MOST_MISSING
    channel: Annotated[int, Field(strict=True, ge=1)] | Text | None = None
    crop: Crop | None = None
    mask: Text | None = None
    run_in: Annotated[float, Field(strict=True, gt=0, le=1)] | None = None
    x_direction: units.AngleOrZero = 0.0
    _directory: Path | None = PrivateAttr(default=None)

    def flaws(self) -> Iterator[str]:
        """Not one source, or keys of another one."""
        yield from self.unless_one("file", "across", "generated")
        for source, names in OF_SOURCE.items():
            for name in self.given(*names) if not set(self.given(*source)) else ():
                yield f"{name} has no effect without {' or '.join(source)}"
        if self.across is not None:
            if not self.across:
                yield "across names no file"
            yield from self.unless_one("along", "aspect")

    def lie_in(self, directory: Path) -> None:
        """Tell where the files lie; without, there is none to read (`case.case_again`)."""
        self._directory = directory.absolute()

    @property
    def files(self) -> dict[str, list[str]]:
        """Key -> files that it names."""
        single = {
            key: [name] for key in ("file", "mask") if (name := getattr(self, key)) is not None
        }
        return single | {key: list(getattr(self, key) or ()) for key in ("across", "along")}

    @property
    def found(self) -> bool:
        """Whether the heights can be had."""
        return not any(self.files.values()) or self._directory is not None

    @property
    def contents(self) -> dict[str, str | list[str]]:
        """Key -> digests of what its files hold, in the place of their names."""
        found = {
            key: [sha256(self._path(name).read_bytes()).hexdigest() for name in names]
            for key, names in self.files.items()
            if names
        }
        return {
            key: digests if key in ("across", "along") else digests[0]
            for key, digests in found.items()
        }

    def _path(self, name: str) -> Path:
        return present(self._directory, "directory") / name

    def _state(self) -> tuple[tuple[int, int], ...]:
        """Time and size of the files that there are, which change with their content."""
        paths = [self._path(name) for names in self.files.values() for name in names]
        states = [path.stat() for path in paths if path.is_file()]
        return tuple((state.st_mtime_ns, state.st_size) for state in states)

    def waves(self) -> SeparatedWaves:
        """Roughness and longer waves of the surface; ValueError with the key if there is no such surface."""
        if self.file is not None:
            return self._named(f'file = "{self.file}"', _of_file)
        if self.across is not None:
            return self._named("across", _of_profiles)
        return self._named("generated", _of_generated)

    def _named(self, key: str, waves: Callable[..., SeparatedWaves]) -> SeparatedWaves:
        """What a function of the table and its files finds, with the key in front of what it refuses."""
        try:
            found = waves(self, self._directory, self._state() if self._directory else ())
        except ValueError as error:
            kind = IsProfileError if isinstance(error, IsProfileError) else ValueError
            raise kind(f"surface.{key}: {error}") from None
        if self.run_in is None:
            return found
        return replace(found, roughness=found.roughness.run_in(self.run_in))

    def profiles(self) -> dict[str, list[Profile]]:
        """Profiles across and along the lay; ValueError as of `waves`."""
        across = [
            _profile(self, self._path(name), self.nesting_index) for name in self.across or ()
        ]

        def along(index: float | None) -> list[Profile]:
            paths = [self._path(name) for name in self.along or ()]
            return [_profile(self, path, index, by_class=False) for path in paths]

        return {"across": across, "along": list(profiles_along(along, across))}

    def topography(self) -> Topography:
        """The roughness, its x axis turned from the surface's own motion."""
        return self.waves().roughness.turned(self.x_direction)

    def long_waves(self) -> LongWaves | None:
        """The waves longer than those of the roughness, likewise; None where all waves are roughness."""
        if self.nesting_index is None or self.across is not None:
            return None
        return LongWaves(self.waves().long_waves.turned(self.x_direction))


State = tuple[tuple[int, int], ...]
"""Time and size of files, which change with their content."""


@lru_cache(maxsize=8)
def _of_file(table: SurfaceTable, directory: Path, state: State) -> SeparatedWaves:
    """Waves of a file's content, of which time and size change with it."""
    path = directory / present(table.file, "file")
    heights, spacing = read_area(path, table.spacing, table.height_unit, table.channel)
    if table.mask is not None:
        heights = masked(heights, directory / table.mask)
    if table.crop is not None:
        heights = cropped(heights, spacing, table.crop)
    found = _separated(table, heights, spacing, periodic=False)
    require_plausible(found.all_waves)
    rough = found.roughness
    return replace(found, roughness=replace(rough, samples=rough.quarters))


def _profile(
    table: SurfaceTable, path: Path, index: float | None, by_class: bool = True
) -> Profile:
    """A profile of a file, prepared as the table has it; ValueError with its name.

    A nesting index [m] longer than a profile along the lay leaves all of its waves.
    """
    try:
        heights, spacing = read_profile(path, table.spacing, table.height_unit)
        if not by_class and index is not None and index > len(heights) * spacing:
            index = None
        found = roughness_profile(
            heights,
            spacing,
            nesting_index=index,
            shortest_wave=table.shortest_wave,
            outliers=table.outliers,
            fill=table.fill,
            by_class=by_class,
        )
        require_plausible_profile(found.height, found.spacing)
    except ValueError as error:
        raise ValueError(f"{path.name} {error}") from None
    return found


@lru_cache(maxsize=8)
def _of_profiles(table: SurfaceTable, directory: Path, state: State) -> SeparatedWaves:
    """A surface with the statistics of profiles; waves that filters removed are in none of it."""
    profiles = table.profiles()
    across, along = profiles["across"], profiles["along"]
    rough = sampled_surface(across, along, table.aspect, table.seed or 0)
    missing = max(profile.filled for profile in (*across, *along))
    return SeparatedWaves(rough, replace(rough, height=np.zeros_like(rough.height)), missing)


@lru_cache(maxsize=8)
def _of_generated(table: SurfaceTable, directory: Path, state: State) -> SeparatedWaves:
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
        fill=table.fill,
    )


@lru_cache(maxsize=8)
def texture_of(surface: Topography) -> Texture:
    """Figures of a surface, computed once."""
    return texture(surface)
