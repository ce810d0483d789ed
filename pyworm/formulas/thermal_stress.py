"""What the thermal stress of a half-space depends on (`fortran/stress/thermal_stress.f90`)."""

from dataclasses import dataclass


@dataclass(frozen=True)
class ThermalSolid:
    """What the thermal stress of a body depends on."""

    youngs_modulus: float
    """Young's modulus [Pa]."""
    poisson_ratio: float
    """Poisson's ratio [-]."""
    expansion: float
    """Linear thermal expansion [1/K]."""
    diffusivity: float
    """Thermal diffusivity [m2/s]."""
    bulk_temperature: float
    """Temperature far below the surface, where there is no thermal stress [K]."""

    @property
    def restrained(self) -> float:
        """Pressure along the surface of a body that is warmed and cannot expand along it [Pa/K]."""
        return self.youngs_modulus * self.expansion / (1 - self.poisson_ratio)
