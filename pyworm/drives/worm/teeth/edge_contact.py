"""Misaligned worm and wheel, which touch at an edge of a tooth."""

from dataclasses import dataclass
from math import degrees

from pyworm.drives.worm.drawing.design import AS_DESIGNED, Assembly


@dataclass(frozen=True)
class EdgeContact:
    """Where misaligned flanks touch without load."""

    phase: float
    """Phase of the mesh cycle."""
    face: float
    """Place along the wheel's face from its middle [m]."""
    radius: float
    """Distance of the place from the wheel's axis [m]."""
    boundary: str
    """Nearest boundary of the teeth."""
    depth: float
    """Depth by which flanks touching at their contact point would cross there [m]; 0 off the teeth."""
    assembly_under_load: Assembly
    """Where the worm runs."""

    @property
    def words(self) -> str:
        """The contact at the edge, as an assumption."""
        apart = (
            f"they stand {self.depth * 1e6:.2g} µm off their contact point"
            if self.depth
            else "they have no contact point on the teeth"
        )
        return (
            f"{self._why} the flanks without load touch first near an edge ({self.boundary}, "
            f"{self.face * 1e3:+.1f} mm from the middle of the face on a radius of "
            f"{self.radius * 1e3:.1f} mm at phase {self.phase:g}): {apart}. Load sharing, contacts and films "
            "are those of this edge contact."
        )

    @property
    def warning(self) -> str:
        """The contact at the edge, as a warning that begins with the table at fault."""
        table = "hob" if self.assembly_under_load == AS_DESIGNED else "assembly"
        return (
            f"{table}: worm and wheel touch at an edge ({self.boundary}), where the pressure is higher than "
            f"on the flank; {self._remedy}"
        )

    @property
    def _why(self) -> str:
        errors = self.assembly_under_load
        if errors == AS_DESIGNED:
            return "As the hob is set up"
        return (
            f"With the worm {errors.centre_distance * 1e3:+.3g} mm farther from the wheel, "
            f"{errors.axial_shift * 1e3:+.3g} mm along the wheel's axis and "
            f"{degrees(errors.shaft_angle):+.3g} deg tilted"
        )

    @property
    def _remedy(self) -> str:
        if self.assembly_under_load == AS_DESIGNED:
            return "another swivel, a larger hob or a smaller wheel.face_width is needed"
        return "pyworm check prints the errors that the teeth allow, pyworm setup --shim the wheel's shift"
