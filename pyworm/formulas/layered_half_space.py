"""Elastic half-space with a bonded layer on its surface, wave by wave.

Below a wave of the tractions the layer and what it lies on are in plane strain with Airy's function
f(z) exp(i k x'), f = (a + b z) exp(-k z) + (c + d z) exp(k (z - h)), and in antiplane shear. The surface
bears the tractions; displacements and stresses are continuous at the depth h (Burmister 1945; O'Sullivan and
King 1988).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.plane_waves import Amplitudes, Waves, WaveStress

WAVES_OF_HERTZ = np.linspace(0.05, 40, 800)
"""Wave numbers over the half-width of the contact by which its energy is summed."""

MEAN_NUMBER = 0.1
"""Wave number of the mean traction over that of the longest wave: its stress hardly depends on it."""


@dataclass(frozen=True)
class Layer:
    """A layer and the half-space below it."""

    thickness: float
    """Thickness of the layer [m]."""
    moduli: tuple[float, float]
    """Young's modulus of the layer and of the half-space [Pa]."""
    poisson_ratios: tuple[float, float]
    """Poisson's ratio of the layer and of the half-space [-]."""

    @property
    def shear_moduli(self) -> tuple[float, float]:
        """Shear modulus of the layer and of the half-space [Pa]."""
        layer, below = (
            modulus / (2 * (1 + ratio))
            for modulus, ratio in zip(self.moduli, self.poisson_ratios, strict=True)
        )
        return layer, below

    def compliance(self, number: Array) -> Array:
        """Normal displacement of the surface over pressure times wave number, for waves above zero [1/Pa].

        That of a half-space is 2 (1 - nu^2)/E.
        """
        unknowns = _in_plane(self, number * self.thickness)[..., 0]
        return _displacement(
            unknowns, self.shear_moduli[0], self.poisson_ratios[0], number * self.thickness, 0.0
        )[..., 1]

    def contact_compliance(self, half_width: float) -> float:
        """Compliance (1 - nu^2)/E of a half-space with the same elastic energy under Hertz's pressure [1/Pa].

        Of a circle of a half-width [m], whose pressure has the waves (sin ka - ka cos ka)/(ka)^3.
        """
        size = WAVES_OF_HERTZ
        pressure = ((np.sin(size) - size * np.cos(size)) / size**3) ** 2
        compliance = self.compliance(size / half_width) / 2
        return float(np.trapezoid(pressure * compliance, size) / np.trapezoid(pressure, size))


def layered_stress(
    tractions: Sequence[Array], spacing: Sequence[float], layer: Layer, depth: float
) -> Array:
    """Stress [Pa] at a depth below pressure and shear tractions, less that without the layer.

    Components xx, yy, zz, xy, xz, yz along the first axis. The difference dies out with the distance from the
    tractions, which the periodic waves of the grid need: give them room. Add the stress of the half-space.

    Args:
        tractions: Pressure and shear stress along each direction of the grid [Pa], shape (nx, ny) or (nx,).
        spacing: Grid spacing along each direction [m].
        layer: The layer.
        depth: Depth [m].
    """
    waves, acting = _along_waves(tractions, spacing)
    bare = Layer(layer.thickness, layer.moduli[1:] * 2, layer.poisson_ratios[1:] * 2)
    mean = (0,) * tractions[0].ndim
    number = waves.number.copy()
    number[mean] = MEAN_NUMBER * number[number > 0].min()
    found, alone = (_stress(solid, number, acting, depth) for solid in (layer, bare))
    change = {
        name: np.asarray(getattr(found, name) - getattr(alone, name))
        for name in ("along", "across", "normal", "shear", "twist", "antiplane")
    }
    if tractions[0].ndim > 1:  # the mean is that of waves of all directions
        isotropic = (change["along"][mean] + change["across"][mean]) / 2
        change["along"][mean] = change["across"][mean] = isotropic
    return waves.stress(WaveStress(**change))


def wave_stress(
    tractions: Sequence[Array], spacing: Sequence[float], layer: Layer, depth: float
) -> Array:
    """Stress [Pa] at a depth below tractions that repeat themselves, less that of their mean.

    Arguments and components are those of `layered_stress`.
    """
    waves, acting = _along_waves([traction - traction.mean() for traction in tractions], spacing)
    number = np.where(waves.number > 0, waves.number, waves.number.max())
    return waves.stress(_stress(layer, number, acting, depth))


def _along_waves(
    tractions: Sequence[Array], spacing: Sequence[float]
) -> tuple[Waves, tuple[Amplitudes, Amplitudes, Amplitudes]]:
    """Waves of a grid, and of its tractions: pressure, shear along and shear across each."""
    waves = Waves(tractions[0].shape, spacing)
    spectra = [waves.spectrum(traction) for traction in tractions]
    c, s = waves.directions
    along_y = spectra[2] if len(spectra) > 2 else np.zeros_like(spectra[1])
    acting = spectra[0], c * spectra[1] + s * along_y, c * along_y - s * spectra[1]
    return waves, acting


def _stress(layer: Layer, number: Array, acting: Sequence[Amplitudes], depth: float) -> WaveStress:
    """Stress at a depth below waves of pressure and of shear along and across them."""
    pressure, shear, across = acting
    thick, deep = number * layer.thickness, number * depth
    unit = _in_plane(layer, thick)
    # the shear's Airy function is imaginary: i q at a real unit solution
    weights = unit[..., 0] * pressure[..., None] - 1j * unit[..., 1] * shear[..., None]
    inside = depth <= layer.thickness
    poisson_ratio = layer.poisson_ratios[0 if inside else 1]
    if inside:
        f, slope, bend = _airy(weights, thick, deep)
    else:
        f, slope, bend = _airy_below(weights, deep - thick)
    twist, antiplane = _antiplane(layer, thick, deep, across)
    return WaveStress(bend, poisson_ratio * (bend - f), -f, -1j * slope, twist, antiplane)


def _in_plane(layer: Layer, thick: Array) -> Array:
    """Six constants of Airy's function for unit pressure, and unit shear over -i, along the last axis.

    a, b, c, d of the layer and a, b below, for depths over wave length by 2 pi: z k.
    """
    none = np.zeros_like(thick)
    system = np.zeros((*thick.shape, 6, 6))
    columns = np.eye(6)
    surface = [_airy(columns[j] + 0 * thick[..., None], thick, none) for j in range(4)]
    for j, (f, slope, _) in enumerate(surface):
        system[..., 0, j], system[..., 1, j] = f, slope
    for j in range(4):
        f, slope, _ = _airy(columns[j] + 0 * thick[..., None], thick, thick)
        moved = _displacement(
            columns[j] + 0 * thick[..., None],
            layer.shear_moduli[0],
            layer.poisson_ratios[0],
            thick,
            thick,
        )
        _fill(system, j, (f, slope, moved * layer.shear_moduli[0]))
    for j, column in enumerate(np.eye(2)):
        weights = np.concatenate([np.zeros(4), column]) + 0 * thick[..., None]
        f, slope, _ = _airy_below(weights, none)
        moved = _displacement_below(weights, layer.shear_moduli[1], layer.poisson_ratios[1])
        _fill(system, 4 + j, (-f, -slope, -moved * layer.shear_moduli[0]))
    sides = np.zeros((*thick.shape, 6, 2))
    sides[..., 0, 0] = 1  # sigma_zz = -f is -p
    sides[..., 1, 1] = 1
    return np.asarray(np.linalg.solve(system, sides))


def _fill(system: Array, column: int, parts: tuple[Array, Array, Array]) -> None:
    """A column of the conditions at the layer's lower face."""
    system[..., 2, column], system[..., 3, column] = parts[:2]
    system[..., 4, column], system[..., 5, column] = parts[2][..., 0], parts[2][..., 1]


def _airy(weights: Amplitudes, thick: Array, z: Array) -> tuple[Amplitudes, ...]:
    """Airy's function in the layer and its first two derivatives by z k."""
    a, b, c, d = (weights[..., j] for j in range(4))
    down, up = np.exp(-z), np.exp(z - thick)
    f = (a + b * z) * down + (c + d * z) * up
    slope = (b - a - b * z) * down + (c + d * z + d) * up
    bend = (a + b * z - 2 * b) * down + (c + d * z + 2 * d) * up
    return f, slope, bend


def _airy_below(weights: Amplitudes, z: Array) -> tuple[Amplitudes, ...]:
    """Airy's function below the layer and its first two derivatives, by z k from the lower face."""
    a, b = weights[..., 4], weights[..., 5]
    down = np.exp(-z)
    return (a + b * z) * down, (b - a - b * z) * down, (a + b * z - 2 * b) * down


def _displacement(
    weights: Array, shear_modulus: float, poisson_ratio: float, thick: Array, z: Array | float
) -> Array:
    """Displacements in the layer along the wave, over -i, and along z, times the wave number, last axis."""
    a, b, c, d = (weights[..., j] for j in range(4))
    f, _, bend = _airy(weights, thick, np.asarray(z))
    along = (1 - poisson_ratio) * bend + poisson_ratio * f
    down, up = np.exp(-z), np.exp(z - thick)
    turn = 1 - 2 * poisson_ratio
    normal = (a + b * (z + turn)) * down - (c + d * (z - turn)) * up
    return np.stack([along, normal], axis=-1) / (2 * shear_modulus)


def _displacement_below(weights: Array, shear_modulus: float, poisson_ratio: float) -> Array:
    """Displacements at the upper face of the half-space below the layer, as of `_displacement`."""
    a, b = weights[..., 4], weights[..., 5]
    along = (1 - poisson_ratio) * (a - 2 * b) + poisson_ratio * a
    normal = a + b * (1 - 2 * poisson_ratio)
    return np.stack([along, normal], axis=-1) / (2 * shear_modulus)


def _antiplane(
    layer: Layer, thick: Array, deep: Array, traction: Amplitudes
) -> tuple[Amplitudes, Amplitudes]:
    """sigma_x'y' and sigma_y'z at a depth below waves of shear across them."""
    stiff, soft = layer.shear_moduli
    back = (stiff - soft) / (stiff + soft)  # of the wave that returns from the lower face
    down = traction / (1 - back * np.exp(-2 * thick))
    if (deep <= thick).all():
        returned = back * np.exp(deep - 2 * thick)
        going = np.exp(-deep)
        return 1j * down * (going + returned), -down * (going - returned)
    through = down * (1 - back) * np.exp(-deep)
    return 1j * through, -through
